#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_RIGID_ALIGNMENT_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_RIGID_ALIGNMENT_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/registration/Correspondence.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <limits>
#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsRegistration

  holds the rigid motion that brings a source to a target, and how well the data determine it. It is taken for the motion
  where one is wanted.
*/
struct Rigid_alignment
{
  /// `ESTIMATED`; `FEW_NEIGHBOURS`: too few correspondences agree; `DEGENERATE`: they lie on a line, or in one point. Without
  /// an estimate the motion and the numbers are quiet NaN: it is no identity.
  Estimation_status status = Estimation_status::FEW_NEIGHBOURS;
  /// the motion of the source
  Eigen::Isometry3d transformation =
      Eigen::Isometry3d(Eigen::Matrix4d(Eigen::Matrix4d::Constant(std::numeric_limits<double>::quiet_NaN())));
  /// the correspondences that agree with the motion
  std::vector<Correspondence> inliers;
  /// root mean square of what is minimized, over the inliers: distances between points
  /// (`fast_global_registration()`) or to planes (`iterative_closest_point()`), in the unit of the points
  double residual = std::numeric_limits<double>::quiet_NaN();
  /// how firmly the inliers hold the surfaces in place, in [0, 1]: the ratio of the smallest eigenvalue of the normal matrix
  /// to the largest, with the root mean square distance to the centroid of the inliers as unit of length. 0 means that
  /// there is a motion that changes nothing: about the line on which all points are, or, if distances to planes are
  /// minimized, that of a plane, a sphere, a cylinder in itself.
  double conditioning = std::numeric_limits<double>::quiet_NaN();
  /// number of steps made
  std::size_t number_of_iterations = 0;
  /// whether the last step was so short that more of them would change nothing that matters; otherwise the limit of their
  /// number was reached
  bool has_converged = false;

  /// the motion
  operator const Eigen::Isometry3d&() const noexcept { return transformation; }
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_RIGID_ALIGNMENT_H
