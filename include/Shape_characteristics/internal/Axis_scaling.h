#ifndef SHAPE_CHARACTERISTICS_INTERNAL_AXIS_SCALING_H
#define SHAPE_CHARACTERISTICS_INTERNAL_AXIS_SCALING_H

#include <Eigen/Core>

namespace Shape_characteristics {
namespace internal {

// Multiplies by a factor what of a vector is along an axis.
struct Axis_scaling
{
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX(); // of unit length
  double factor = 1.;

  bool is_identity() const noexcept { return factor == 1.; }
  Axis_scaling inverse() const { return {axis, 1. / factor}; }

  Eigen::Vector3d operator()(const Eigen::Vector3d& v) const
  {
    if(is_identity())
      return v;
    return v + ((factor - 1.) * axis.dot(v)) * axis;
  }

  // of a quadratic form: with the gradients of a function, its Hessian matrix
  Eigen::Matrix3d operator()(const Eigen::Matrix3d& form) const
  {
    if(is_identity())
      return form;
    const Eigen::Vector3d image = form * axis;
    const double part = factor - 1.;
    return form + part * (axis * image.transpose() + image * axis.transpose()) +
           (part * part * axis.dot(image)) * (axis * axis.transpose());
  }
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_AXIS_SCALING_H
