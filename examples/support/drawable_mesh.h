#ifndef SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_DRAWABLE_MESH_H
#define SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_DRAWABLE_MESH_H

#include "Drawable.h"

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

namespace support {

/// The vertices of a FaceGraph in the order of `vertices(mesh)` and its faces, cut into triangles, without
/// normals and scalars. What is computed per vertex is in the same order:
///
///     Drawable shape = drawable_mesh(mesh);
///     for(auto v : vertices(mesh))
///       shape.scalars.push_back(get(mean_curvature_map, v));
template <typename FaceGraph>
Drawable drawable_mesh(const FaceGraph& mesh)
{
  Drawable shape;
  const auto point_map = get(CGAL::vertex_point, mesh);
  const auto index_map = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
  for(auto v : vertices(mesh))
  {
    const auto& p = get(point_map, v);
    put(index_map, v, shape.points.size());
    shape.points.push_back({CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])});
  }
  for(auto f : faces(mesh))
  {
    std::vector<std::size_t> corners;
    for(auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      corners.push_back(get(index_map, v));
    for(std::size_t i = 2; i < corners.size(); ++i)
      shape.triangles.push_back({corners[0], corners[i - 1], corners[i]});
  }
  return shape;
}

} // namespace support

#endif
