#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_MOVED_SCAN_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_MOVED_SCAN_H

#include <Shape_characteristics/registration/Oriented_points.h>

#include <Eigen/Core>

namespace Shape_characteristics {
namespace internal {

// the scan in coordinates with the origin `center`, in which what has the length 1 has the length `scale`
inline Oriented_points moved_scan(Oriented_points scan, const Eigen::Vector3d& center, double scale)
{
  for(Eigen::Vector3d& p : scan.points)
    p = scale * (p - center);
  return scan;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_MOVED_SCAN_H
