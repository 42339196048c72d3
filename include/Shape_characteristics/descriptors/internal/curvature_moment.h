#ifndef SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_CURVATURE_MOMENT_H
#define SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_CURVATURE_MOMENT_H

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
// in units of the radius, with the weights w = (1 - |X - P|^2 / r^2)^2. Samples whose value isn't finite don't take part. Zero if
// there is nothing but rounding errors, that is, if f varies little compared to itself or to `unit`, its natural size.
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
  double weights = counts ? 1. : 0., mean = counts ? f[i] : 0., size = 0.;
  for(const Index j : neighbors)
    if(std::isfinite(f[j]))
    {
      const Eigen::Vector3d d = (surface.point(j) - p) / radius;
      const double near = (std::max)(1. - d.squaredNorm(), 0.), weight = near * near;
      sum += weight * d;
      weighted_sum += weight * f[j] * d;
      weights += weight;
      mean += weight * f[j];
      size += weight * ((std::max)(std::abs(f[j]), unit));
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
