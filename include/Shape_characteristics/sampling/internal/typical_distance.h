#ifndef SHAPE_CHARACTERISTICS_SAMPLING_INTERNAL_TYPICAL_DISTANCE_H
#define SHAPE_CHARACTERISTICS_SAMPLING_INTERNAL_TYPICAL_DISTANCE_H

#include <Shape_characteristics/internal/scale_to_range.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// About how far points are from each other, in orders of magnitude: the extent of them all, or, if that is an extraordinary number,
// of the half of them in the middle, as a single point may have made it so. 0 if there are none.
inline double typical_distance(const std::vector<Eigen::Vector3d>& points)
{
  Eigen::AlignedBox3d box;
  std::size_t number = 0;
  for(const Eigen::Vector3d& p : points)
    if(p.allFinite())
    {
      box.extend(p);
      ++number;
    }
  if(number == 0)
    return 0.;
  // halves: no difference overflows
  const double extent = (.5 * box.max() - .5 * box.min()).maxCoeff();
  if(scale_to_range(extent) == 1.)
    return extent;
  double result = 0.;
  std::vector<double> coordinates;
  for(int c = 0; c < 3; ++c)
  {
    coordinates.clear();
    for(const Eigen::Vector3d& p : points)
      if(p.allFinite())
        coordinates.push_back(p[c]);
    const auto at = [&](std::size_t k) { return coordinates.begin() + std::ptrdiff_t(k); };
    std::nth_element(at(0), at(number / 4), at(number));
    const double first = *at(number / 4);
    std::nth_element(at(0), at(number - 1 - number / 4), at(number));
    result = (std::max)(result, .5 * *at(number - 1 - number / 4) - .5 * first);
  }
  return result > 0. ? result : extent;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SAMPLING_INTERNAL_TYPICAL_DISTANCE_H
