// Principal curvatures of a torus by biquadratic patches through points, and how far they are from the truth.
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/razdan_bae_curvatures.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

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
  double largest_of_all = 0.;
  for(const unsigned int rings : {2u, 3u})
  {
    const std::size_t failures =
        SC::razdan_bae_curvatures(mesh, SC::parameters::vertex_normal_map(normals)
                                            .vertex_principal_curvatures_and_directions_map(curvatures)
                                            .number_of_rings(rings));
    double largest = 0.;
    for(const auto v : mesh.vertices())
      largest = std::max({largest, std::abs(curvatures[v].min_curvature - truth[v]),
                          std::abs(curvatures[v].max_curvature - 1. / tube)});
    std::cout << rings << " rings: largest error " << largest << ", " << failures << " failures\n";
    largest_of_all = std::max(largest_of_all, largest);
  }
  return largest_of_all < .05 ? EXIT_SUCCESS : EXIT_FAILURE;
}
