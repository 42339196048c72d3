#ifndef SHAPE_CHARACTERISTICS_TEST_FUZZ_FUZZED_MESH_H
#define SHAPE_CHARACTERISTICS_TEST_FUZZ_FUZZED_MESH_H

#include "fuzzed_data.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <vector>

namespace fuzz {

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

// A sheet of a grid, of `largest` vertices along a side at most, or vertices at random; then faces wherever a halfedge data
// structure has room for them: with holes, bow ties, isolated and removed vertices.
inline Mesh mesh(FuzzedDataProvider& data, unsigned int largest = 6)
{
  using Vertex = Mesh::Vertex_index;
  Mesh mesh;
  const double factor = scale(data);
  if(data.ConsumeBool())
  {
    const unsigned columns = data.ConsumeIntegralInRange<unsigned>(2, largest),
                   rows = data.ConsumeIntegralInRange<unsigned>(2, largest);
    for(unsigned i = 0; i < rows; ++i)
      for(unsigned j = 0; j < columns; ++j)
        mesh.add_vertex(
            Point_3(factor * i, factor * j, factor * (data.ConsumeIntegral<std::int8_t>() / 128.)));
    for(unsigned i = 0; i + 1 < rows; ++i)
      for(unsigned j = 0; j + 1 < columns; ++j)
      {
        const Vertex a(i * columns + j), b(a + columns), c(b + 1), d(a + 1);
        if(data.ConsumeIntegralInRange<int>(0, 15) == 0)
          continue;
        mesh.add_face(a, b, c);
        mesh.add_face(a, c, d);
      }
    for(int k = data.ConsumeIntegralInRange<int>(0, 3); k > 0; --k)
      mesh.point(Vertex(data.ConsumeIntegralInRange<unsigned>(0, mesh.number_of_vertices() - 1))) =
          Point_3(factor * number(data), factor * number(data), factor * number(data));
  }
  else
    for(unsigned n = data.ConsumeIntegralInRange<unsigned>(0, 30); n > 0; --n)
      mesh.add_vertex(Point_3(factor * number(data), factor * number(data), factor * number(data)));
  if(mesh.number_of_vertices() < 3)
    return mesh;
  for(int k = 0; k < 60 && data.remaining_bytes() > 3; ++k)
  {
    std::vector<Vertex> corners(data.ConsumeIntegralInRange<int>(0, 31) == 0 ? 4 : 3);
    for(Vertex& v : corners)
      v = Vertex(data.ConsumeIntegralInRange<unsigned>(0, mesh.number_of_vertices() - 1));
    if(CGAL::Euler::can_add_face(corners, mesh))
      CGAL::Euler::add_face(corners, mesh);
  }
  if(data.ConsumeIntegralInRange<int>(0, 7) == 0 && mesh.number_of_faces() > 0)
  {
    const Mesh::Face_index f(data.ConsumeIntegralInRange<unsigned>(0, mesh.number_of_faces() - 1));
    CGAL::Euler::remove_face(halfedge(f, mesh), mesh);
  }
  return mesh;
}

} // namespace fuzz

#endif // SHAPE_CHARACTERISTICS_TEST_FUZZ_FUZZED_MESH_H
