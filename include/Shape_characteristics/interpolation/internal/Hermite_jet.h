#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_JET_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_JET_H

#include <Eigen/Core>

namespace Shape_characteristics {
namespace internal {

// value, gradient and Hessian matrix of a function at a point
struct Hermite_jet
{
  double value = 0.;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_JET_H
