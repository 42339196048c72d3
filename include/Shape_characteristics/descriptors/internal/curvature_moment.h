#ifndef SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_CURVATURE_MOMENT_H
#define SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_CURVATURE_MOMENT_H

#include <Shape_characteristics/internal/scale_to_range.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// Whatever is smaller than this share of what it is made of is a rounding error.
constexpr double smallest_share = 1e-10;

// how many samples of the neighborhood of sample `i`, itself among them, have a value
template <typename Index>
std::size_t number_of_values(std::size_t i, const std::vector<Index>& neighbors, const std::vector<double>& f)
{
  std::size_t count = std::isfinite(f[i]) ? 1 : 0;
  for(const Index j : neighbors)
    count += std::isfinite(f[j]) ? 1 : 0;
  return count;
}

// Where a quantity grows around sample `i`: the sum of w (X - P) (f - mean of f) over the neighborhood, in the tangent plane and
// in units of the radius, with the weights w = (1 - |X - P|^2 / r^2)^2. f is in some unit that `unit`, its natural size, determines.
// Samples whose value isn't finite don't take part. Zero if there is nothing but rounding errors, that is, if f varies little
// compared to itself or to `unit`.
template <typename SampledSurface, typename Index>
Eigen::Vector3d tangential_moment(const SampledSurface& surface,
                                  std::size_t i,
                                  const std::vector<Index>& neighbors,
                                  double radius,
                                  const std::vector<double>& f,
                                  double unit)
{
  const Eigen::Vector3d &p = surface.point(i), &n = surface.normal(i);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), weighted_sum = Eigen::Vector3d::Zero();
  const bool counts = std::isfinite(f[i]);
  const double scale = scale_to_range(
      unit); // squares of curvatures are out of the range of numbers sooner than those of lengths
  double weights = counts ? 1. : 0., mean = counts ? scale * f[i] : 0., size = 0.;
  for(const Index j : neighbors)
    if(std::isfinite(f[j]))
    {
      const Eigen::Vector3d d = (surface.point(j) - p) / radius;
      const double near = (std::max)(1. - d.squaredNorm(), 0.), weight = near * near;
      const double value = scale * f[j];
      sum += weight * d;
      weighted_sum += weight * value * d;
      weights += weight;
      mean += weight * value;
      size += weight * ((std::max)(std::abs(value), scale * unit));
    }
  if(!(weights > 0.))
    return Eigen::Vector3d(Eigen::Vector3d::Zero());
  Eigen::Vector3d moment = weighted_sum - mean / weights * sum;
  moment -= n.dot(moment) * n;
  return moment.norm() > smallest_share * size ? moment : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_CURVATURE_MOMENT_H
