#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_CENTROID_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_CENTROID_H

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// the mean of the points that are finite; the origin if there are none
inline Eigen::Vector3d centroid(const std::vector<Eigen::Vector3d>& points)
{
  // relative to a point: otherwise digits are lost far from the origin
  const auto first =
      std::find_if(points.begin(), points.end(), [](const Eigen::Vector3d& p) { return p.allFinite(); });
  if(first == points.end())
    return Eigen::Vector3d::Zero();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  std::size_t number = 0;
  for(const Eigen::Vector3d& p : points)
    if(p.allFinite())
    {
      sum += p - *first;
      ++number;
    }
  return *first + sum / double(number);
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_CENTROID_H
