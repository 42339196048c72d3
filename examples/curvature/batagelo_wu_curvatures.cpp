// Curvatures of a polygon mesh, and of its vertices as a point set, from the changes of the normals.
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/batagelo_wu_curvatures.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Curvatures = SC::Principal_curvatures_and_directions<Kernel>;

int main()
{
  // a torus of quadrilaterals with the normals of the formula
  const double center = 2., tube = 1.;
  const unsigned int around = 96, across = 48;
  Mesh mesh;
  auto normals = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
  auto truth = mesh.add_property_map<Mesh::Vertex_index, double>("v:truth").first;
  for(unsigned int i = 0; i < around; ++i)
    for(unsigned int j = 0; j < across; ++j)
    {
      const double u = 2. * CGAL_PI * i / around, v = 2. * CGAL_PI * j / across;
      const double distance = center + tube * std::cos(v);
      const auto vertex = mesh.add_vertex(
          Kernel::Point_3(distance * std::cos(u), distance * std::sin(u), tube * std::sin(v)));
      normals[vertex] = Kernel::Vector_3(std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v));
      truth[vertex] = std::cos(v) / distance; // the smaller one; the other one is 1 / tube
    }
  const auto vertex = [=](unsigned int i, unsigned int j)
  { return Mesh::Vertex_index((i % around) * across + j % across); };
  for(unsigned int i = 0; i < around; ++i)
    for(unsigned int j = 0; j < across; ++j)
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));

  auto curvatures = mesh.add_property_map<Mesh::Vertex_index, Curvatures>("v:curvatures").first;
  const auto largest_error = [&]()
  {
    double largest = 0.;
    for(const auto v : mesh.vertices())
      largest = std::max({largest, std::abs(curvatures[v].min_curvature - truth[v]),
                          std::abs(curvatures[v].max_curvature - 1. / tube)});
    return largest;
  };

  std::size_t failures = SC::batagelo_wu_curvatures(
      mesh,
      SC::parameters::vertex_normal_map(normals).vertex_principal_curvatures_and_directions_map(curvatures));
  const double of_mesh = largest_error();
  failures +=
      SC::batagelo_wu_curvatures(mesh.vertices(), SC::parameters::point_map(mesh.points())
                                                      .normal_map(normals)
                                                      .principal_curvatures_and_directions_map(curvatures)
                                                      .number_of_neighbors(6));
  const double of_points = largest_error();
  std::cout << "largest error: " << of_mesh << " as a mesh, " << of_points << " as a point set; " << failures
            << " failures\n";
  return failures == 0 && std::max(of_mesh, of_points) < .05 ? EXIT_SUCCESS : EXIT_FAILURE;
}
