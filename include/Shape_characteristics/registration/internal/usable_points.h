#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_USABLE_POINTS_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_USABLE_POINTS_H

#include <Shape_characteristics/registration/Oriented_points.h>

#include <cstddef>

namespace Shape_characteristics {
namespace internal {

// the points that can be used, with new numbers
inline Oriented_points usable_points(const Oriented_points& all)
{
  Oriented_points result;
  for(std::size_t i = 0; i < all.size(); ++i)
    if(all.is_usable(i))
    {
      result.points.push_back(all.points[i]);
      result.normals.push_back(all.normals[i]);
    }
  return result;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_USABLE_POINTS_H
