// Interpolated corrected curvatures of CGAL 6, in any unit of length.
#include <Shape_characteristics/curvature/interpolated_corrected_curvatures.h>

#include <cstdlib>
#include <iostream>

#ifndef SHAPE_CHARACTERISTICS_HAS_INTERPOLATED_CORRECTED_CURVATURES
int main()
{
  std::cout << "This needs CGAL 6.\n";
  return EXIT_SUCCESS;
}
#else

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Curvatures = SC::Principal_curvatures_and_directions<Kernel>;

int main()
{
  bool is_right = true;
  for(const double unit : {1., 1e-6, 1e6})
  {
    // a valley z = x^2 / 2, with curvature -1 across its bottom
    Mesh mesh;
    const int n = 20;
    for(int i = -n; i <= n; ++i)
      for(int j = -n; j <= n; ++j)
      {
        const double x = 0.05 * i, y = 0.05 * j;
        mesh.add_vertex(Kernel::Point_3(unit * x, unit * y, unit * x * x / 2));
      }
    const auto vertex = [&](int i, int j) { return Mesh::Vertex_index(unsigned(i * (2 * n + 1) + j)); };
    for(int i = 0; i < 2 * n; ++i)
      for(int j = 0; j < 2 * n; ++j)
      {
        mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
        mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
      }

    auto curvatures = mesh.add_property_map<Mesh::Vertex_index, Curvatures>("v:curvatures").first;
    SC::interpolated_corrected_curvatures(
        mesh, SC::parameters::vertex_principal_curvatures_and_directions_map(curvatures));
    const Curvatures& c = curvatures[vertex(n, n)];
    std::cout << "curvatures at the bottom: " << c.min_curvature << " along " << c.min_direction << " and "
              << c.max_curvature << '\n';
    is_right = is_right && std::abs(c.min_curvature * unit + 1) < 0.01 &&
               std::abs(c.max_curvature * unit) < 1e-6 && std::abs(c.min_direction.x()) > 0.999;
  }
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
#endif
