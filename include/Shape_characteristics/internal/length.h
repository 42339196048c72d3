#ifndef SHAPE_CHARACTERISTICS_INTERNAL_LENGTH_H
#define SHAPE_CHARACTERISTICS_INTERNAL_LENGTH_H

#include <Eigen/Core>

#include <cmath>

namespace Shape_characteristics {
namespace internal {

// The Euclidean norm without overflow or underflow. Not Eigen's stableNorm(): its last bit depends on where the
// vector lies in memory.
inline double length(const Eigen::Vector3d& v)
{
  return std::hypot(v.x(), v.y(), v.z());
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_LENGTH_H
