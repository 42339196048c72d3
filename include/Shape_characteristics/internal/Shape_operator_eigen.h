#ifndef SHAPE_CHARACTERISTICS_INTERNAL_SHAPE_OPERATOR_EIGEN_H
#define SHAPE_CHARACTERISTICS_INTERNAL_SHAPE_OPERATOR_EIGEN_H

#include <Eigen/Core>

#include <cmath>
#include <limits>

namespace Shape_characteristics {
namespace internal {

// Principal curvatures (convex positive, min <= max) and unit directions, orthogonal to each other and to the normal.
// All members are NaN if the input was not finite or didn't determine a tangent plane.
struct Shape_operator_eigen
{
  double min_curvature = std::numeric_limits<double>::quiet_NaN();
  double max_curvature = std::numeric_limits<double>::quiet_NaN();
  Eigen::Vector3d min_direction = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  Eigen::Vector3d max_direction = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());

  bool is_finite() const noexcept
  {
    return std::isfinite(min_curvature) && std::isfinite(max_curvature) && min_direction.allFinite() &&
           max_direction.allFinite();
  }
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_SHAPE_OPERATOR_EIGEN_H
