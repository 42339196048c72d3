#ifndef SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_NEIGHBORHOOD_EXTENT_H
#define SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_NEIGHBORHOOD_EXTENT_H

#include <Shape_characteristics/internal/scale_to_range.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// The radius of the neighborhood of sample `i`: that of the ball, or the distance of the farthest neighbor. `neighbors` are
// those of `i`, at least one.
template <typename SampledSurface, typename Index>
double neighborhood_radius(const SampledSurface& surface, std::size_t i, const std::vector<Index>& neighbors)
{
  if(surface.neighborhood().kind() == Neighborhood::Kind::BALL)
    return surface.neighborhood().radius();
  const Eigen::Vector3d d = surface.point(neighbors.back()) - surface.point(i);
  const double scale = scale_to_range(d.cwiseAbs().maxCoeff());
  return (scale * d).norm() / scale;
}

// What coordinates around `p` are off by because they are rounded, where differences of `radius` are looked at.
inline double rounding_error(const Eigen::Vector3d& p, double radius)
{
  return 16. * std::numeric_limits<double>::epsilon() * (p.cwiseAbs().maxCoeff() + radius);
}

// Whether no neighbor is off the line through sample `i` and the farthest one, but for rounding errors: then there is no
// surface. `neighbors` are those of `i`, at least one.
template <typename SampledSurface, typename Index>
bool is_collinear(const SampledSurface& surface, std::size_t i, const std::vector<Index>& neighbors)
{
  const Eigen::Vector3d& p = surface.point(i);
  Eigen::Vector3d line = surface.point(neighbors.back()) - p;
  const double scale = scale_to_range(line.cwiseAbs().maxCoeff());
  line *= scale;
  const double length = line.norm();
  const double tolerance = 2. * rounding_error(scale * p, length) * length;
  for(const Index j : neighbors)
    if((scale * (surface.point(j) - p)).cross(line).norm() > tolerance)
      return false;
  return true;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_NEIGHBORHOOD_EXTENT_H
