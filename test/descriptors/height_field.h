#ifndef SHAPE_CHARACTERISTICS_TEST_DESCRIPTORS_HEIGHT_FIELD_H
#define SHAPE_CHARACTERISTICS_TEST_DESCRIPTORS_HEIGHT_FIELD_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstdint>
#include <functional>

namespace height_field_test {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// a grid over [-a, a] x [-b, b] with an odd number of vertices in each row and column: one is in the middle
inline Mesh height_field(double a, double b, int cells, const std::function<double(double, double)>& z)
{
  Mesh mesh;
  for(int i = 0; i <= cells; ++i)
    for(int j = 0; j <= cells; ++j)
    {
      const double x = a * (2. * i / cells - 1.), y = b * (2. * j / cells - 1.);
      mesh.add_vertex(Kernel::Point_3(x, y, z(x, y)));
    }
  const auto vertex = [&](int i, int j) { return Mesh::Vertex_index(std::uint32_t(i * (cells + 1) + j)); };
  for(int i = 0; i < cells; ++i)
    for(int j = 0; j < cells; ++j)
      if((i + j) % 3 == 0)
      {
        mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
        mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
      }
      else
      {
        mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i, j + 1));
        mesh.add_face(vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
      }
  return mesh;
}

// a height field that no symmetry maps to itself
inline double wave(double x, double y)
{
  return .2 * std::sin(3. * x + 1.) * std::cos(2. * y) + .2 * x * x * y;
}

} // namespace height_field_test

#endif // SHAPE_CHARACTERISTICS_TEST_DESCRIPTORS_HEIGHT_FIELD_H
