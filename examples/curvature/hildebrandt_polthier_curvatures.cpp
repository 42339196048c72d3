// Principal curvatures of a torus from positions alone, with balls that shrink more slowly than the edges.
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/hildebrandt_polthier_curvatures.h>

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
  const double center = 2., tube = 1.;
  double before = 0.;
  for(const unsigned int across : {16u, 48u})
  {
    const unsigned int around = 2 * across;
    Mesh mesh;
    auto truth = mesh.add_property_map<Mesh::Vertex_index, double>("v:truth").first;
    for(unsigned int i = 0; i < around; ++i)
      for(unsigned int j = 0; j < across; ++j)
      {
        const double u = 2. * CGAL_PI * i / around, v = 2. * CGAL_PI * j / across;
        const double distance = center + tube * std::cos(v);
        const auto vertex = mesh.add_vertex(
            Kernel::Point_3(distance * std::cos(u), distance * std::sin(u), tube * std::sin(v)));
        truth[vertex] = std::cos(v) / distance; // the smaller one; the other one is 1 / tube
      }
    const auto vertex = [=](unsigned int i, unsigned int j)
    { return Mesh::Vertex_index((i % around) * across + j % across); };
    for(unsigned int i = 0; i < around; ++i)
      for(unsigned int j = 0; j < across; ++j)
      {
        mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
        mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
      }

    auto curvatures = mesh.add_property_map<Mesh::Vertex_index, Curvatures>("v:curvatures").first;
    const double radius = 4. / std::sqrt(double(across));
    const std::size_t failures = SC::hildebrandt_polthier_curvatures(
        mesh,
        SC::parameters::vertex_principal_curvatures_and_directions_map(curvatures).neighbor_radius(radius));
    double largest = 0.;
    for(const auto v : mesh.vertices())
      largest = std::max({largest, std::abs(curvatures[v].min_curvature - truth[v]),
                          std::abs(curvatures[v].max_curvature - 1. / tube)});
    std::cout << mesh.number_of_vertices() << " vertices, radius " << radius << ": largest error " << largest
              << ", " << failures << " failures\n";
    if(failures > 0 || (before > 0. && !(largest < .5 * before)))
      return EXIT_FAILURE;
    before = largest;
  }
  return EXIT_SUCCESS;
}
