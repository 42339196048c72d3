#ifndef SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_FITTED_SAMPLE_H
#define SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_FITTED_SAMPLE_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/curvature/internal/shape_operator.h>
#include <Shape_characteristics/curvature/internal/write_curvatures.h>
#include <Shape_characteristics/interpolation/Local_hermite_rbf.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// What a fit says of the surface at a sample: where it is, its normal, and how the normal turns.
struct Fitted_sample
{
  Estimation_status status = Estimation_status::CANCELLED;
  Eigen::Vector3d displacement = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  std::array<double, 6> shape; // xx, xy, xz, yy, yz, zz of the shape operator (convex positive)

  Fitted_sample() { shape.fill(std::numeric_limits<double>::quiet_NaN()); }

  explicit Fitted_sample(const Local_implicit_surface& local) : Fitted_sample()
  {
    status = local.status;
    if(!is_estimated(status))
      return;
    const double length = local.gradient.norm();
    normal = local.gradient / length;
    displacement = local.displacement;
    // P H P / |gradient| with the projection P = I - n n^T onto the tangent plane
    const Eigen::Vector3d image = local.hessian * normal;
    const double along_normal = normal.dot(image);
    const auto entry = [&](const Eigen::Index i, const Eigen::Index j)
    {
      return (local.hessian(i, j) - normal[i] * image[j] - image[i] * normal[j] +
              along_normal * normal[i] * normal[j]) /
             length;
    };
    shape = {entry(0, 0), entry(0, 1), entry(0, 2), entry(1, 1), entry(1, 2), entry(2, 2)};
    if(!(length > 0.) || !normal.allFinite() || !displacement.allFinite() ||
       !std::all_of(shape.begin(), shape.end(), [](const double x) { return std::isfinite(x); }))
      *this = Fitted_sample(Estimation_status::DEGENERATE);
  }

  // the change of the normal along `d`, to first order
  Eigen::Vector3d turn(const Eigen::Vector3d& d) const
  {
    return {shape[0] * d.x() + shape[1] * d.y() + shape[2] * d.z(),
            shape[1] * d.x() + shape[3] * d.y() + shape[4] * d.z(),
            shape[2] * d.x() + shape[4] * d.y() + shape[5] * d.z()};
  }

  Curvature_estimate estimate() const
  {
    if(!is_estimated(status))
      return Curvature_estimate(status);
    Eigen::Matrix3d hessian;
    hessian << shape[0], shape[1], shape[2], shape[1], shape[3], shape[4], shape[2], shape[4], shape[5];
    return Curvature_estimate(status, curvatures_of_implicit(normal, hessian));
  }

  // for weighted means of fits to one sample: sums, of which this one is the first
  void add(const Fitted_sample& other, double weight)
  {
    displacement += weight * other.displacement;
    normal += weight * other.normal;
    for(std::size_t k = 0; k < shape.size(); ++k)
      shape[k] += weight * other.shape[k];
  }

  // by the sum of weights; the normal is a unit vector again
  void divide(double weight)
  {
    displacement /= weight;
    normal.normalize();
    for(double& entry : shape)
      entry /= weight;
  }

private:
  explicit Fitted_sample(Estimation_status status) : Fitted_sample() { this->status = status; }
};

using Fitted_field = std::vector<Fitted_sample>;

// Frobenius' norm of a shape operator
inline double norm_of_shape(const std::array<double, 6>& s)
{
  return std::sqrt(s[0] * s[0] + s[3] * s[3] + s[5] * s[5] + 2. * (s[1] * s[1] + s[2] * s[2] + s[4] * s[4]));
}

// that of the difference of two
inline double distance_of_shapes(const std::array<double, 6>& s, const std::array<double, 6>& t)
{
  std::array<double, 6> difference;
  for(std::size_t k = 0; k < 6; ++k)
    difference[k] = s[k] - t[k];
  return norm_of_shape(difference);
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_FITTED_SAMPLE_H
