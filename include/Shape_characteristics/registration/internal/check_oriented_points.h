#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_CHECK_ORIENTED_POINTS_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_CHECK_ORIENTED_POINTS_H

#include <Shape_characteristics/registration/Correspondence.h>
#include <Shape_characteristics/registration/Oriented_points.h>

#include <stdexcept>
#include <vector>

namespace Shape_characteristics {
namespace internal {

inline void check_normals(const Oriented_points& source, const Oriented_points& target)
{
  if(source.normals.size() != source.points.size() || target.normals.size() != target.points.size())
    throw std::invalid_argument("Shape_characteristics: each of the oriented points needs a normal");
}

inline void check_correspondences(const Oriented_points& source,
                                  const Oriented_points& target,
                                  const std::vector<Correspondence>& correspondences)
{
  for(const Correspondence& c : correspondences)
    if(c.source >= source.size() || c.target >= target.size())
      throw std::invalid_argument("Shape_characteristics: a correspondence names a point that isn't there");
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_CHECK_ORIENTED_POINTS_H
