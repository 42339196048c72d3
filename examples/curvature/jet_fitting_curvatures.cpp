// Curvatures of a mesh, of one of its vertices, and of points with normals, by fitting polynomials.
#include <Shape_characteristics/curvature/jet_fitting_curvatures.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/property_map.h>
#include <CGAL/subdivision_method_3.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <vector>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// a point with all that belongs to it
struct Sample
{
  Kernel::Point_3 point;
  Kernel::Vector_3 normal;
  double mean_curvature;
};

struct Point_map
{
  using key_type = Sample;
  using value_type = Kernel::Point_3;
  using reference = const Kernel::Point_3&;
  using category = boost::lvalue_property_map_tag;
  friend reference get(Point_map, const Sample& s) { return s.point; }
};

struct Normal_map
{
  using key_type = Sample;
  using value_type = Kernel::Vector_3;
  using reference = const Kernel::Vector_3&;
  using category = boost::lvalue_property_map_tag;
  friend reference get(Normal_map, const Sample& s) { return s.normal; }
};

struct Mean_curvature_map
{
  using key_type = Sample;
  using value_type = double;
  using reference = double&;
  using category = boost::writable_property_map_tag;
  friend void put(Mean_curvature_map, Sample& s, double value) { s.mean_curvature = value; }
};

int main()
{
  // a sphere of radius 2
  const double radius = 2;
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Kernel::Point_3(0, 0, 0));
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(3));
  std::vector<Sample> samples;
  for(const auto v : mesh.vertices())
  {
    Kernel::Vector_3 n = mesh.point(v) - CGAL::ORIGIN;
    n = n / std::sqrt(n.squared_length());
    mesh.point(v) = CGAL::ORIGIN + radius * n;
    samples.push_back({mesh.point(v), n, 0});
  }

  auto mean_curvature = mesh.add_property_map<Mesh::Vertex_index, double>("v:mean_curvature").first;
  std::size_t failures =
      SC::jet_fitting_curvatures(mesh, SC::parameters::vertex_mean_curvature_map(mean_curvature));

  const Mesh::Vertex_index v(100);
  double of_one_vertex = 0;
  SC::jet_fitting_curvatures(v, mesh, SC::parameters::vertex_mean_curvature(std::ref(of_one_vertex)));

  failures += SC::jet_fitting_curvatures(samples, SC::parameters::point_map(Point_map())
                                                      .normal_map(Normal_map())
                                                      .mean_curvature_map(Mean_curvature_map())
                                                      .number_of_neighbors(24));

  std::cout << "mean curvature at a vertex: " << mean_curvature[v] << ", by itself: " << of_one_vertex
            << ", without the mesh: " << samples[v].mean_curvature << ", expected: " << 1 / radius << '\n';
  const bool is_right = failures == 0 && mean_curvature[v] == of_one_vertex &&
                        std::abs(mean_curvature[v] - 1 / radius) < 0.001 &&
                        std::abs(samples[v].mean_curvature - 1 / radius) < 0.001;
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
