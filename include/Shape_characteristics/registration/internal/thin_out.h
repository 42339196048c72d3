#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_THIN_OUT_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_THIN_OUT_H

#include <Shape_characteristics/registration/Oriented_points.h>
#include <Shape_characteristics/registration/internal/Point_grid.h>
#include <Shape_characteristics/registration/internal/centroid.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// Points of which no two are nearer to each other than `distance`, the first ones if there is a choice. If there are more
// than `enough`, they aren't all of them. All points have to be usable.
inline Oriented_points thin_out(const Oriented_points& all, double distance, std::size_t enough)
{
  Oriented_points result;
  Point_grid grid(all.points, centroid(all.points), distance);
  for(std::size_t i = 0; i < all.size() && result.size() <= enough; ++i)
  {
    if(grid.has_nearer_than(all.points[i], distance))
      continue;
    grid.insert(std::uint32_t(i));
    result.points.push_back(all.points[i]);
    result.normals.push_back(all.normals[i]);
  }
  return result;
}

// At most `enough` points, evenly spread, and not much fewer where there are more. All points have to be usable.
//
// Complexity: linear in the number of points.
inline Oriented_points thin_out_to(const Oriented_points& all, std::size_t enough)
{
  if(all.size() <= enough)
    return all;
  Eigen::Vector3d lowest = all.points[0], highest = lowest;
  for(const Eigen::Vector3d& p : all.points)
  {
    lowest = lowest.cwiseMin(p);
    highest = highest.cwiseMax(p);
  }
  const double size = (highest - lowest).norm();
  if(!(size > 0.) || !std::isfinite(size))
    return {{all.points[0]}, {all.normals[0]}};
  constexpr int tries = 12;
  double too_small = 0., large_enough = size, distance = size / std::sqrt(double(enough));
  Oriented_points best{{all.points[0]}, {all.normals[0]}};
  for(int k = 0; k < tries && best.size() < enough - enough / 8; ++k)
  {
    Oriented_points kept = thin_out(all, distance, enough);
    if(kept.size() > enough)
    {
      too_small = distance;
      distance = (std::min)(1.25 * distance, .5 * (distance + large_enough));
    }
    else
    {
      large_enough = distance;
      // as many points as fit a surface grow with the inverse square of their distance
      const double wanted = distance * std::sqrt(double(kept.size()) / (double(enough) * .95));
      distance = wanted > too_small && wanted < distance ? wanted : .5 * (too_small + distance);
      best = std::move(kept);
    }
  }
  return best;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_THIN_OUT_H
