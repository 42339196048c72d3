#ifndef SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_DRAWABLE_POINT_SET_H
#define SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_DRAWABLE_POINT_SET_H

#include "Drawable.h"

#include <CGAL/number_utils.h>

namespace support {

/// The points of a `CGAL::Point_set_3` in their order, with their normals if they have any, without scalars.
template <typename PointSet>
Drawable drawable_point_set(const PointSet& points)
{
  Drawable shape;
  for(const auto& i : points)
  {
    const auto& p = points.point(i);
    shape.points.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
    if(!points.has_normal_map())
      continue;
    const auto& n = points.normal(i);
    shape.normals.push_back({CGAL::to_double(n.x()), CGAL::to_double(n.y()), CGAL::to_double(n.z())});
  }
  return shape;
}

} // namespace support

#endif
