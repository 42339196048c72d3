#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_ITERATIVE_CLOSEST_POINT_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_ITERATIVE_CLOSEST_POINT_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/internal/median.h>
#include <Shape_characteristics/internal/whole_number.h>
#include <Shape_characteristics/registration/Correspondence.h>
#include <Shape_characteristics/registration/Oriented_points.h>
#include <Shape_characteristics/registration/Rigid_alignment.h>
#include <Shape_characteristics/registration/internal/Plane_distances.h>
#include <Shape_characteristics/registration/internal/Scan_frame.h>
#include <Shape_characteristics/registration/internal/check_oriented_points.h>
#include <Shape_characteristics/sampling/Nearest_point_search.h>
#include <Shape_characteristics/sampling/for_each_sample.h>

#include <CGAL/tags.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// Pairs of a moving point and the nearest one of the target, in the coordinates of a `Scan_frame`.
class Closest_points
{
public:
  using Term = Plane_distances::Term;

  Closest_points(const Oriented_points& source,
                 const Oriented_points& target,
                 const Scan_frame& frame,
                 double minimum_cosine)
    : m_target_points(in_frame(target, [&](const Eigen::Vector3d& p) { return frame.target(p); })),
      m_target_normals(target.normals),
      m_search(m_target_points),
      m_minimum_cosine(minimum_cosine)
  {
    for(std::size_t i = 0; i < source.size(); ++i)
      if(source.is_usable(i))
      {
        m_points.push_back(frame.source(source.points[i]));
        m_normals.push_back(source.normals[i]);
        m_numbers.push_back(std::uint32_t(i));
      }
    m_terms.resize(m_points.size());
    m_partners.resize(m_points.size());
  }

  // the pairs under a motion; those farther apart than `limit` get the weight 0, the others 1
  template <typename ConcurrencyTag>
  void find(const Eigen::Isometry3d& motion, double limit)
  {
    for_each_sample<ConcurrencyTag, No_workspace>(
        m_points.size(),
        [&](const std::size_t i, No_workspace&)
        {
          Term& term = m_terms[i];
          term = Term{motion * m_points[i], Eigen::Vector3d::Zero(), 0., 0.};
          const auto j = m_search.nearest(term.point, limit);
          m_partners[i] = j;
          if(j == Nearest_point_search::none)
            return;
          term.normal = m_target_normals[j];
          if((motion.linear() * m_normals[i]).dot(term.normal) < m_minimum_cosine)
            return;
          term.distance = term.normal.dot(term.point - m_target_points[j]);
          term.weight = 1.;
        });
  }

  // Tukey's weights, of a width that follows the median of the distances but isn't below `narrowest`
  void weigh(double narrowest)
  {
    m_distances.clear();
    for(const Term& t : m_terms)
      if(t.weight > 0.)
        m_distances.push_back(std::abs(t.distance));
    if(m_distances.empty())
      return;
    // 95 % efficient for normally distributed distances, of which the median is 1 / 1.4826 of the standard deviation
    const double width = (std::max)(4.685 * 1.4826 * median(m_distances), narrowest);
    for(Term& t : m_terms)
      if(t.weight > 0.)
      {
        const double x = t.distance / width;
        t.weight = std::abs(x) < 1. ? (1. - x * x) * (1. - x * x) : 0.;
      }
  }

  const std::vector<Term>& terms() const noexcept { return m_terms; }

  std::vector<Correspondence> inliers() const
  {
    std::vector<Correspondence> result;
    for(std::size_t i = 0; i < m_terms.size(); ++i)
      if(m_terms[i].weight > 0.)
        result.push_back({m_numbers[i], m_partners[i]});
    return result;
  }

  // median distance of (at most) 1000 points of the target, spread evenly over their range, to the nearest one elsewhere
  double spacing() const
  {
    const std::size_t step = (std::max)(m_target_points.size() / 1000, std::size_t(1));
    std::vector<double> distances;
    for(std::size_t i = 0; i < m_target_points.size(); i += step)
      if(const auto j = m_search.nearest_elsewhere(i); j != Nearest_point_search::none)
        distances.push_back((m_target_points[i] - m_target_points[j]).norm());
    return distances.empty() ? 0. : median(distances);
  }

private:
  // points without a normal are nobody's partner
  template <typename Function>
  static std::vector<Eigen::Vector3d> in_frame(const Oriented_points& points, const Function& place)
  {
    std::vector<Eigen::Vector3d> result;
    result.reserve(points.size());
    for(std::size_t i = 0; i < points.size(); ++i)
      result.push_back(points.is_usable(i) ? place(points.points[i])
                                           : Eigen::Vector3d::Constant(std::nan("")).eval());
    return result;
  }

  std::vector<Eigen::Vector3d> m_target_points;
  const std::vector<Eigen::Vector3d>& m_target_normals;
  Nearest_point_search m_search;
  double m_minimum_cosine;
  std::vector<Eigen::Vector3d> m_points, m_normals; // of the source, those that are usable
  std::vector<std::uint32_t> m_numbers;             // theirs in the source
  std::vector<Term> m_terms;                        // for each of them
  std::vector<std::uint32_t> m_partners;
  std::vector<double> m_distances;
};

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsRegistration

  refines the alignment of two surfaces that overlap in part: iterative closest points, with distances to planes
  \cgalCite{chen_medioni} and robust weights.

  Each step pairs every point of the source with the nearest point of the target, and makes the motion that minimizes the
  weighted squares of the distances of the points from the tangent planes of their partners. Pairs whose normals differ, or that
  are far apart, as where the surfaces don't overlap, are left out; the others get Tukey's weights of a width that follows the
  median of the distances. Both limits are wide in the beginning and shrink by the factor 0.7 in each step: the one of
  the distance from `maximum_correspondence_distance` to three times the spacing of the target's points, the width of
  the weights to a tenth of that spacing, or what the median asks for.

  \scConcurrencyTag
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param source the source
  \param target the target
  \param start the motion of the source to begin with, as from `fast_global_registration()`
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{maximum_correspondence_distance}
      \cgalParamDescription{how far apart the points of a pair may be in the beginning, in units of the larger surface's radius
                            (the largest distance of a point from the centroid); positive}
      \cgalParamType{`double`}
      \cgalParamDefault{`0.1`}
    \cgalParamNEnd
    \cgalParamNBegin{minimum_normal_cosine}
      \cgalParamDescription{the smallest cosine of the angle between the normals of a pair, in [-1, 1)}
      \cgalParamType{`double`}
      \cgalParamDefault{`0.7`}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_iterations}
      \cgalParamDescription{how many steps are made at most}
      \cgalParamType{an integer type}
      \cgalParamDefault{`50`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return the motion of the source, `start` included; the pairs of the last step that have a weight; and how well they determine
          the motion. Of surfaces that can slide on themselves (planes, spheres, cylinders) the motion is one of many, and
          Rigid_alignment::conditioning is near 0. The status is `FEW_NEIGHBOURS` if there are less than six pairs, and
          `DEGENERATE` if they are all in one point, or `start` isn't finite. The motion has converged when the limits have shrunk to
          the end, and a step is shorter than 1e-7 of the radius.

  \throws std::invalid_argument if there are more or less normals than points or one is neither 0 nor of unit length, `start` stretches
          or mirrors, or a parameter is out of its range

  The result depends neither on the unit of length nor on the position of the surfaces, up to rounding.

  Complexity: \f$ O((m + k n) \log m) \f$ for \f$ k \f$ steps, \f$ n \f$ points of the source and \f$ m \f$ of the target.

  \cgalExample{registration/registration_steps.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename NamedParameters = parameters::Default_named_parameters>
Rigid_alignment iterative_closest_point(const Oriented_points& source,
                                        const Oriented_points& target,
                                        const Eigen::Isometry3d& start,
                                        const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  double distance = choose_parameter(get_parameter(np, internal_np::maximum_correspondence_distance), 0.1);
  const double cosine = choose_parameter(get_parameter(np, internal_np::minimum_normal_cosine), 0.7);
  const std::int64_t limit =
      internal::whole_number(np, internal_np::number_of_iterations, std::int64_t(50), "number_of_iterations");
  if(!(distance > 0.))
    throw std::invalid_argument("Shape_characteristics: maximum_correspondence_distance must be positive");
  if(!(cosine >= -1. && cosine < 1.))
    throw std::invalid_argument("Shape_characteristics: minimum_normal_cosine must be in [-1, 1)");
  if(limit < 1)
    throw std::invalid_argument("Shape_characteristics: number_of_iterations must be positive");
  internal::check_normals(source, target);
  internal::check_motion(start);

  Rigid_alignment result;
  const internal::Scan_frame frame(source, target);
  if(!frame.is_valid() || !start.matrix().allFinite())
  {
    if(source.size() > 0 && target.size() > 0)
      result.status = Estimation_status::DEGENERATE;
    return result;
  }
  internal::Closest_points pairs(source, target, frame, cosine);
  const double spacing = pairs.spacing();

  Eigen::Isometry3d motion = frame.inside(start);
  // No points are farther apart than this; a limit of infinity wouldn't shrink.
  distance = (std::min)(distance, 4. + motion.translation().norm());
  const double smallest_distance = (std::min)(3. * spacing, distance), narrowest = 0.1 * spacing;
  double shrinkage = 1.;
  for(std::int64_t step = 0; step < limit && !result.has_converged; ++step, shrinkage *= 0.7)
  {
    const double wide = shrinkage * distance;
    pairs.find<ConcurrencyTag>(motion, (std::max)(wide, smallest_distance));
    pairs.weigh((std::max)(wide, narrowest));
    result.inliers = pairs.inliers();
    if(result.inliers.size() < 6)
      break;
    const internal::Plane_distances planes(pairs.terms());
    if(!planes.is_valid())
    {
      result.status = Estimation_status::DEGENERATE;
      result.conditioning = std::numeric_limits<double>::quiet_NaN(); // that of an earlier step
      result.inliers.clear();
      return result;
    }
    const Eigen::Isometry3d move = planes.solve();
    motion = move * motion;
    // products of rotations drift from being one
    motion.linear() = Eigen::Quaterniond(motion.linear()).normalized().toRotationMatrix();
    result.number_of_iterations = std::size_t(step) + 1;
    result.conditioning = planes.conditioning();
    const double length = (move.linear() - Eigen::Matrix3d::Identity()).norm() + (move.translation()).norm();
    result.has_converged = wide <= narrowest && length < 1e-7;
  }
  if(result.inliers.size() < 6)
  {
    Rigid_alignment none;
    none.number_of_iterations = result.number_of_iterations;
    return none;
  }

  double sum = 0.;
  for(const Correspondence& c : result.inliers)
  {
    const Eigen::Vector3d p = motion * frame.source(source.points[c.source]);
    const double d = target.normals[c.target].dot(p - frame.target(target.points[c.target]));
    sum += d * d;
  }
  result.status = Estimation_status::ESTIMATED;
  result.transformation = frame.outside(motion);
  result.residual = frame.size() * std::sqrt(sum / double(result.inliers.size()));
  return result;
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_ITERATIVE_CLOSEST_POINT_H
