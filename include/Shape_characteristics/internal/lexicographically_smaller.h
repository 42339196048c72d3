#ifndef SHAPE_CHARACTERISTICS_INTERNAL_LEXICOGRAPHICALLY_SMALLER_H
#define SHAPE_CHARACTERISTICS_INTERNAL_LEXICOGRAPHICALLY_SMALLER_H

#include <Eigen/Core>

#include <cmath>

namespace Shape_characteristics {
namespace internal {

// a strict weak order of all points; NaN comes last
inline bool lexicographically_smaller(const Eigen::Vector3d& p, const Eigen::Vector3d& q)
{
  for(int c = 0; c < 3; ++c)
  {
    if(p[c] < q[c])
      return true;
    if(q[c] < p[c])
      return false;
    if(std::isnan(p[c]) != std::isnan(q[c]))
      return std::isnan(q[c]);
  }
  return false;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_LEXICOGRAPHICALLY_SMALLER_H
