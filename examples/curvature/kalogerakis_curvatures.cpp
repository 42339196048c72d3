// Curvatures beside the edges of a faceted cylinder: by robust statistics, and by least squares, which see across the edges.
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/batagelo_wu_curvatures.h>
#include <Shape_characteristics/curvature/kalogerakis_curvatures.h>

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
  // a column of eight flat sides, with eight squares across each side
  const unsigned int sides = 8, across = 8, around = sides * across, rows = 12;
  Mesh mesh;
  for(unsigned int row = 0; row <= rows; ++row)
    for(unsigned int i = 0; i < around; ++i)
    {
      const double a = 2. * CGAL_PI * (i / across) / sides, b = 2. * CGAL_PI * (i / across + 1) / sides;
      const double t = double(i % across) / across;
      mesh.add_vertex(Kernel::Point_3((1. - t) * std::cos(a) + t * std::cos(b),
                                      (1. - t) * std::sin(a) + t * std::sin(b), .1 * row));
    }
  for(unsigned int row = 0; row < rows; ++row)
    for(unsigned int i = 0; i < around; ++i)
    {
      const auto vertex = [=](unsigned int r, unsigned int k)
      { return Mesh::Vertex_index(r * around + k % around); };
      mesh.add_face(vertex(row, i), vertex(row, i + 1), vertex(row + 1, i + 1));
      mesh.add_face(vertex(row, i), vertex(row + 1, i + 1), vertex(row + 1, i));
    }

  auto curvatures = mesh.add_property_map<Mesh::Vertex_index, Curvatures>("v:curvatures").first;
  // of the vertices two squares from an edge of the column, which are on a flat side
  const auto largest = [&]()
  {
    double k = 0.;
    for(const auto v : mesh.vertices())
      if(v.idx() % across == 2)
        k = (std::max)(k, std::abs(curvatures[v].max_curvature));
    return k;
  };
  const auto np =
      SC::parameters::vertex_principal_curvatures_and_directions_map(curvatures).number_of_rings(2);
  std::size_t failures = SC::batagelo_wu_curvatures(mesh, np);
  const double of_least_squares = largest();
  failures += SC::kalogerakis_curvatures(mesh, np);
  const double robust = largest();
  std::cout << "curvature of a flat side, beside an edge: " << robust << " by robust statistics, "
            << of_least_squares << " by least squares; " << failures << " failures\n";
  return failures == 0 && robust < .2 * of_least_squares ? EXIT_SUCCESS : EXIT_FAILURE;
}
