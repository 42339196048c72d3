#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_BUILD_FACE_GRAPH_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_BUILD_FACE_GRAPH_H

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace benchmark_support {

/// Builds a model of `MutableFaceGraph` from arrays, in the order of the arrays: vertex i of the mesh is
/// `points[i]`, face j is `faces[j]` (any range of indices).
/// \throws std::runtime_error if a face has no place in a halfedge data structure (third face at an edge,
/// inconsistent orientation)
template <typename Mesh, typename Points, typename Faces>
Mesh build_face_graph(const Points& points, const Faces& faces)
{
  using Traits = boost::graph_traits<Mesh>;
  using Vertex = typename Traits::vertex_descriptor;
  Mesh mesh;
  const auto point_map = get(CGAL::vertex_point, mesh);
  using Point = typename boost::property_traits<std::decay_t<decltype(point_map)>>::value_type;

  std::vector<Vertex> vertices;
  vertices.reserve(points.size());
  for(const auto& p : points)
  {
    vertices.push_back(add_vertex(mesh));
    put(point_map, vertices.back(), Point(p[0], p[1], p[2]));
  }
  std::size_t number = 0;
  std::vector<Vertex> corners;
  for(const auto& face : faces)
  {
    corners.clear();
    for(std::size_t i : face)
      corners.push_back(vertices.at(i));
    if(CGAL::Euler::add_face(corners, mesh) == Traits::null_face())
      throw std::runtime_error("build_face_graph: face " + std::to_string(number) + " can't be added");
    ++number;
  }
  return mesh;
}

} // namespace benchmark_support

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_BUILD_FACE_GRAPH_H
