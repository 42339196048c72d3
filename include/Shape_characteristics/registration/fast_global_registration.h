#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_FAST_GLOBAL_REGISTRATION_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_FAST_GLOBAL_REGISTRATION_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/internal/whole_number.h>
#include <Shape_characteristics/registration/Correspondence.h>
#include <Shape_characteristics/registration/Oriented_points.h>
#include <Shape_characteristics/registration/Rigid_alignment.h>
#include <Shape_characteristics/registration/internal/Scan_frame.h>
#include <Shape_characteristics/registration/internal/check_oriented_points.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// Graduated non-convexity over pairs of points of size 1.
class Graduated_registration
{
public:
  struct Pair
  {
    Eigen::Vector3d p, q;
  };

  Graduated_registration(const std::vector<Pair>& pairs) : m_pairs(pairs), m_weights(pairs.size(), 1.) {}

  const Eigen::Isometry3d& motion() const noexcept { return m_motion; }
  double squared_distance(const Pair& pair) const { return (m_motion * pair.p - pair.q).squaredNorm(); }

  // The motion that brings the points together best under the weights of the moment, in closed form (Kabsch 1976; Umeyama
  // 1991): other than a step of Gauss-Newton, it doesn't depend on the motion before. Returns the length of the step.
  double move()
  {
    double sum = 0.;
    Eigen::Vector3d p = Eigen::Vector3d::Zero(), q = Eigen::Vector3d::Zero();
    for(std::size_t i = 0; i < m_pairs.size(); ++i)
    {
      sum += m_weights[i];
      p += m_weights[i] * m_pairs[i].p;
      q += m_weights[i] * m_pairs[i].q;
    }
    p /= sum;
    q /= sum;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for(std::size_t i = 0; i < m_pairs.size(); ++i)
      covariance.noalias() += (m_weights[i] * (m_pairs[i].q - q)) * (m_pairs[i].p - p).transpose();
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Matrix3d u = svd.matrixU();
    if((u * svd.matrixV().transpose()).determinant() < 0.) // a rotation, never a reflection
      u.col(2) = -u.col(2);
    const Eigen::Isometry3d before = m_motion;
    m_motion.linear() = u * svd.matrixV().transpose();
    m_motion.translation() = q - m_motion.linear() * p;
    return (m_motion.linear() - before.linear()).norm() +
           (m_motion.translation() - before.translation()).norm();
  }

  // the weights that the estimator of Geman and McClure gives the distances: the line process in closed form
  void weigh(double mu)
  {
    for(std::size_t i = 0; i < m_pairs.size(); ++i)
    {
      const double root = mu / (mu + squared_distance(m_pairs[i]));
      m_weights[i] = root * root;
    }
  }

private:
  const std::vector<Pair>& m_pairs;
  std::vector<double> m_weights;
  Eigen::Isometry3d m_motion = Eigen::Isometry3d::Identity();
};

// The smallest eigenvalue of the normal matrix of point pairs by the largest, with their points' root mean square distance
// to the centroid as unit: translations have the eigenvalue 1, rotations the sum of two of the scatter matrix's three.
inline double conditioning_of_points(const std::vector<Eigen::Vector3d>& points)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for(const Eigen::Vector3d& p : points)
    mean += p / double(points.size());
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for(const Eigen::Vector3d& p : points)
    scatter += (p - mean) * (p - mean).transpose();
  const double trace = scatter.trace();
  if(!(trace > 0.))
    return 0.;
  // 1 minus the largest would lose the digits of points nearly on a line
  const Eigen::Vector3d values =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter / trace, Eigen::EigenvaluesOnly).eigenvalues();
  return (std::max)(values[0] + values[1], 0.);
}

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsRegistration

  computes the rigid motion on which most correspondences agree, whatever the start position of the surfaces: the
  fast global registration of Zhou, Park and Koltun \cgalCite{fgr}.

  Minimized is the sum of the robust estimator of Geman and McClure, \f$ \mu r^2 / (\mu + r^2) \f$, over the distances
  \f$ r \f$ of corresponding points. For a large \f$ \mu \f$ that is a sum of squares with one minimum; \f$ \mu \f$ is then
  divided by 1.4 after every fourth step, from the square of the surfaces' radius down to the square of
  `maximum_correspondence_distance`, where wrong correspondences weigh nothing any more. It differs from the paper in two
  ways: \f$ \mu \f$ is relative to the size of the surfaces, so that the result doesn't depend on the unit of length; and
  each step takes the exact minimum under the weights of the moment, in closed form, instead of a step of Gauss and Newton, so that
  the result doesn't depend on how the surfaces are turned in the beginning, either.

  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param source the source; normals are not needed
  \param target the target; normals are not needed
  \param correspondences between points of `source` and `target`, as from `tuple_test()`. One that comes several times
         weighs as much more.
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{maximum_correspondence_distance}
      \cgalParamDescription{how far apart the points of right correspondences may be, in units of the larger surface's radius
                            (the largest distance of a point from the centroid), in (0, 1]}
      \cgalParamType{`double`}
      \cgalParamDefault{`0.025`}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_iterations}
      \cgalParamDescription{how many steps are made at most. Some 4 ln(1/`maximum_correspondence_distance`\f$ ^2 \f$)/ln 1.4
                            are needed, 88 by default, and those to converge thereafter.}
      \cgalParamType{an integer type}
      \cgalParamDefault{`300`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return the motion of the source; which correspondences agree with it to `maximum_correspondence_distance`, in the order
          of `correspondences`; and how well they determine it. The status is `FEW_NEIGHBOURS` if there are less than three
          (different) correspondences, or less than three agree, and `DEGENERATE` if those that agree lie on a line.

  \throws std::invalid_argument if a correspondence names a point that isn't there, or a parameter is out of its range

  Of exact correspondences, the motion is exact up to rounding. Up to half of them may be wrong in any way, and more if they are
  wrong at random; wrong ones that agree with each other, as the two sides of a symmetric object do, are what
  `tuple_test()` removes.

  Complexity: linear in the number of correspondences and of points.

  \cgalExample{registration/registration_steps.cpp}
*/
template <typename NamedParameters = parameters::Default_named_parameters>
Rigid_alignment fast_global_registration(const Oriented_points& source,
                                         const Oriented_points& target,
                                         const std::vector<Correspondence>& correspondences,
                                         const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const double distance =
      choose_parameter(get_parameter(np, internal_np::maximum_correspondence_distance), 0.025);
  const std::int64_t limit = internal::whole_number(np, internal_np::number_of_iterations, std::int64_t(300),
                                                    "number_of_iterations");
  if(!(distance > 0. && distance <= 1.))
    throw std::invalid_argument("Shape_characteristics: maximum_correspondence_distance must be in (0, 1]");
  if(limit < 1)
    throw std::invalid_argument("Shape_characteristics: number_of_iterations must be positive");
  internal::check_correspondences(source, target, correspondences);

  Rigid_alignment result;
  const internal::Scan_frame frame(source, target);
  std::vector<internal::Graduated_registration::Pair> pairs;
  std::vector<Correspondence> usable;
  for(const Correspondence& c : correspondences)
    if(source.points[c.source].allFinite() && target.points[c.target].allFinite())
    {
      pairs.push_back({frame.source(source.points[c.source]), frame.target(target.points[c.target])});
      usable.push_back(c);
    }
  const auto has_three = [](std::vector<Correspondence> c)
  {
    std::sort(c.begin(), c.end());
    return std::unique(c.begin(), c.end()) - c.begin() >= 3;
  };
  if(!has_three(usable))
    return result;
  result.status = Estimation_status::DEGENERATE;
  if(!frame.is_valid())
    return result;

  constexpr double division_factor = 1.4, rounding = 1e-14;
  constexpr std::int64_t steps_per_mu = 4;
  internal::Graduated_registration registration(pairs);
  registration.move();
  result.number_of_iterations = 1;
  double mu = 1.;
  for(std::int64_t step = 1; step < limit && !result.has_converged; ++step)
  {
    registration.weigh(mu);
    const double length = registration.move();
    result.number_of_iterations = std::size_t(step) + 1;
    if(mu <= distance * distance)
      result.has_converged = length <= rounding;
    else if(step % steps_per_mu == 0)
      mu = (std::max)(mu / division_factor, distance * distance);
  }

  std::vector<Correspondence> inliers;
  std::vector<Eigen::Vector3d> points;
  double sum = 0.;
  for(std::size_t i = 0; i < pairs.size(); ++i)
    if(const double d = registration.squared_distance(pairs[i]); d <= distance * distance)
    {
      inliers.push_back(usable[i]);
      points.push_back(pairs[i].p);
      sum += d;
    }
  if(!has_three(inliers))
  {
    result.status = Estimation_status::FEW_NEIGHBOURS;
    return result;
  }
  constexpr double on_a_line = 1e-14; // the square of the width by the length: rounding of coordinates
  const double conditioning = internal::conditioning_of_points(points);
  if(!(conditioning > on_a_line))
    return result;
  result.status = Estimation_status::ESTIMATED;
  result.transformation = frame.outside(registration.motion());
  result.inliers = std::move(inliers);
  result.residual = frame.size() * std::sqrt(sum / double(points.size()));
  result.conditioning = conditioning;
  return result;
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_FAST_GLOBAL_REGISTRATION_H
