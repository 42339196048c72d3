#include "fuzzed_geometry.h"

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <stdexcept>
#include <vector>

namespace {

using bad_inputs::Mesh;
using Vertex = Mesh::Vertex_index;

// A sheet of a grid, or vertices at random; then faces wherever a halfedge data structure has room for them.
Mesh fuzzed_mesh(FuzzedDataProvider& data)
{
  Mesh mesh;
  const double scale = fuzz::scale(data);
  if(data.ConsumeBool())
  {
    const unsigned columns = data.ConsumeIntegralInRange<unsigned>(2, 6),
                   rows = data.ConsumeIntegralInRange<unsigned>(2, 6);
    for(unsigned i = 0; i < rows; ++i)
      for(unsigned j = 0; j < columns; ++j)
        mesh.add_vertex(
            bad_inputs::Point_3(scale * i, scale * j, scale * (data.ConsumeIntegral<std::int8_t>() / 128.)));
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
          bad_inputs::Point_3(scale * fuzz::number(data), scale * fuzz::number(data),
                              scale * fuzz::number(data));
  }
  else
    for(unsigned n = data.ConsumeIntegralInRange<unsigned>(0, 30); n > 0; --n)
      mesh.add_vertex(bad_inputs::Point_3(scale * fuzz::number(data), scale * fuzz::number(data),
                                          scale * fuzz::number(data)));
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

} // namespace

// Meshes with holes, bow ties, isolated and removed vertices through one of the estimators.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  static const auto estimators = bad_inputs::estimators<Mesh>();

  FuzzedDataProvider data(bytes, size);
  const auto& estimator = estimators[data.ConsumeIntegralInRange<std::size_t>(0, estimators.size() - 1)];
  const Mesh mesh = fuzzed_mesh(data);
  if(estimator.needs_triangles && !CGAL::is_triangle_mesh(mesh))
  {
    try
    {
      estimator.all(mesh);
    }
    catch(const std::invalid_argument&)
    {
      return 0;
    }
    fuzz::require(estimator.name, "a face that isn't a triangle was accepted");
  }
  fuzz::require(estimator.name, bad_inputs::complaint(estimator.all(mesh), mesh));
  if(estimator.one && mesh.number_of_vertices() > 0)
    fuzz::require(estimator.name + ", one vertex",
                  bad_inputs::complaint(estimator.one(*mesh.vertices().begin(), mesh)));
  return 0;
}
