#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_SCAN_REGISTRAR_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_SCAN_REGISTRAR_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/descriptors/Descriptor_matrix.h>
#include <Shape_characteristics/descriptors/Fpfh_descriptor.h>
#include <Shape_characteristics/descriptors/compute_descriptors.h>
#include <Shape_characteristics/internal/Rounded_distance.h>
#include <Shape_characteristics/internal/lexicographically_smaller.h>
#include <Shape_characteristics/registration/Correspondence.h>
#include <Shape_characteristics/registration/Oriented_points.h>
#include <Shape_characteristics/registration/Registration_quality.h>
#include <Shape_characteristics/registration/Registration_verdict.h>
#include <Shape_characteristics/registration/Rigid_alignment.h>
#include <Shape_characteristics/registration/fast_global_registration.h>
#include <Shape_characteristics/registration/internal/Registration_assessor.h>
#include <Shape_characteristics/registration/internal/centroid.h>
#include <Shape_characteristics/registration/internal/moved_scan.h>
#include <Shape_characteristics/registration/internal/scan_scale.h>
#include <Shape_characteristics/registration/internal/thin_out.h>
#include <Shape_characteristics/registration/internal/usable_points.h>
#include <Shape_characteristics/registration/iterative_closest_point.h>
#include <Shape_characteristics/registration/match_descriptors.h>
#include <Shape_characteristics/registration/tuple_test.h>
#include <Shape_characteristics/sampling/Neighborhood.h>
#include <Shape_characteristics/sampling/Point_set_samples.h>

#include <CGAL/property_map.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// A motion that may be the right one. It begins with a reflection at x = 0 if `is_reflection`.
struct Registration_hypothesis
{
  Eigen::Affine3d motion = Eigen::Affine3d::Identity();
  Registration_quality quality;
  bool is_reflection = false;
};

struct Registration_outcome
{
  Registration_verdict verdict = Registration_verdict::FAILED;
  Registration_obstacle obstacle = Registration_obstacle::FEW_SAMPLES;
  double confidence = 0.;
  double scale_ratio = 1.;
  // the best one first; none if there was nothing to try
  std::vector<Registration_hypothesis> hypotheses;
};

struct Registration_options
{
  std::size_t maximum_number_of_samples = 6000;
  std::size_t number_of_neighbors = 60;
  std::uint64_t seed = 0;
  std::function<bool(double)> callback;
};

// What the pipeline does with two scans, in coordinates in which both have their centroids in the origin.
template <typename ConcurrencyTag>
class Scan_registrar
{
public:
  static Registration_outcome
  run(const Oriented_points& source, const Oriented_points& target, const Registration_options& options)
  {
    Registration_outcome outcome;
    if(is_stopped(options, 0.))
      return failure(outcome, Registration_obstacle::CANCELLED);
    const double unit = scan_scale(source, target);
    const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    const Oriented_points s = in_order(moved_scan(usable_points(source), origin, unit)),
                          t = in_order(moved_scan(usable_points(target), origin, unit));
    const Eigen::Vector3d source_center = centroid(s.points), target_center = centroid(t.points);
    const Oriented_points centered_source = moved_scan(s, source_center, 1.);
    const Oriented_points centered_target = moved_scan(t, target_center, 1.);
    if(s.size() < s_few || t.size() < s_few)
      return outcome;

    // The same object in other units has another size and, by the same factor, other distances of points.
    const double ratio = radius(centered_source) / radius(centered_target);
    const bool has_other_size =
        std::isfinite(ratio) && ratio > 0. && (ratio > s_other_unit || ratio < 1. / s_other_unit);
    const double searches = has_other_size ? 3. : 2.;
    double done = 0.; // searches
    const auto search = [&](const Oriented_points& scan)
    {
      Registration_options part = options;
      if(options.callback)
        part.callback = [&](const double advancement)
        { return options.callback((done + advancement) / searches); };
      const Registration_outcome found = Scan_registrar(scan, centered_target, part).run();
      ++done;
      return found;
    };

    double scale = 1.;
    outcome = search(centered_source);
    const auto goes_on = [&]
    {
      return outcome.verdict == Registration_verdict::FAILED &&
             outcome.obstacle != Registration_obstacle::CANCELLED &&
             outcome.obstacle != Registration_obstacle::DIFFERENT_UNITS;
    };
    if(goes_on() && has_other_size)
    {
      const Registration_outcome other = search(moved_scan(s, source_center, 1. / ratio));
      if(other.verdict != Registration_verdict::FAILED)
      {
        outcome = failure(other, Registration_obstacle::DIFFERENT_UNITS);
        outcome.scale_ratio = ratio;
        scale = 1. / ratio;
      }
      // the smaller one has few samples as far apart as those of the larger one, unless both are of one size
      else if(other.obstacle == Registration_obstacle::CANCELLED ||
              outcome.obstacle == Registration_obstacle::FEW_SAMPLES)
        outcome.obstacle = other.obstacle;
    }
    if(goes_on())
    {
      Registration_outcome other = search(mirrored(centered_source));
      if(other.verdict != Registration_verdict::FAILED)
      {
        for(Registration_hypothesis& h : other.hypotheses)
        {
          h.motion.linear().col(0) *= -1.;
          h.is_reflection = true;
        }
        outcome = other;
        outcome.verdict = Registration_verdict::AMBIGUOUS;
        outcome.obstacle = Registration_obstacle::REFLECTION;
        outcome.confidence = 0.;
      }
      else if(other.obstacle == Registration_obstacle::CANCELLED)
        outcome.obstacle = Registration_obstacle::CANCELLED;
    }
    if(outcome.obstacle != Registration_obstacle::CANCELLED && is_stopped(options, 1.))
      outcome = failure(outcome, Registration_obstacle::CANCELLED);
    for(Registration_hypothesis& h : outcome.hypotheses)
    {
      h.motion.linear() *= scale;
      h.motion.translation() =
          (target_center + (h.motion.translation() - h.motion.linear() * source_center)) / unit;
      if(!h.motion.matrix().allFinite())
        return Registration_outcome();
    }
    return outcome;
  }

private:
  static constexpr std::size_t s_few = 10;         // points or matches that say nothing
  static constexpr double s_other_unit = 2.5;      // ratio of sizes: inches are 2.54 centimeters
  static constexpr double s_agreement = .25;       // least share of near points that meet
  static constexpr double s_missing = .15;         // share of near points that needn't meet without noise
  static constexpr double s_missing_by_noise = 3.; // by the share that doesn't meet its own scan
  static constexpr double s_clear_agreement = .7;  // that needs no other evidence
  static constexpr double s_correlation = .12;     // of curvatures that are alike
  static constexpr double s_different = .1; // mean distance between two motions, in radii of the source
  static constexpr double s_as_good = .85;  // agreement of another motion, relative to the best
  static constexpr double s_slack = .05;    // eigenvalues below which a motion is tried out

  static constexpr double s_whole = .6;        // overlap of objects that may be their own after a rotation
  static constexpr double s_few_matches = .25; // share of matches that such an object's motion explains
  static constexpr std::size_t s_enough_to_refine = 2000; // points
  static constexpr std::size_t s_enough_to_try = 300;     // points, of each start of many

  using Twist = Eigen::Matrix<double, 6, 1>;

  Scan_registrar(const Oriented_points& source,
                 const Oriented_points& target,
                 const Registration_options& options)
    : m_options(options),
      m_source(thin_out_to(source, options.maximum_number_of_samples)),
      m_target(thin_out_to(target, options.maximum_number_of_samples)),
      m_spacing(make_equally_dense()),
      m_sparse_source(every(m_source, m_source.size() / s_enough_to_refine + 1)),
      m_radius(radius(m_source)),
      m_assessor(m_source, m_target, m_spacing)
  {}

  // From the centroid outwards, and by coordinates where that says nothing: what is chosen among points, by their place in the row or by
  // chance, then depends neither on the order in which they are given nor on how the scan lies in space, and sums are rounded alike.
  static Oriented_points in_order(const Oriented_points& scan)
  {
    std::vector<std::size_t> order(scan.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(),
              [&](const std::size_t i, const std::size_t j)
              {
                return scan.points[i] == scan.points[j]
                           ? lexicographically_smaller(scan.normals[i], scan.normals[j])
                           : lexicographically_smaller(scan.points[i], scan.points[j]);
              });
    Oriented_points result = selected(scan, order);
    const Eigen::Vector3d center = centroid(result.points);
    double largest = 0.;
    for(const Eigen::Vector3d& p : result.points)
      largest = (std::max)(largest, (p - center).squaredNorm());
    const Rounded_distance rounded(largest);
    std::vector<std::pair<double, std::size_t> > keys;
    for(std::size_t i = 0; i < result.size(); ++i)
      keys.emplace_back(rounded((result.points[i] - center).squaredNorm()), i);
    std::sort(keys.begin(), keys.end());
    for(std::size_t i = 0; i < keys.size(); ++i)
      order[i] = keys[i].second;
    return selected(result, order);
  }

  static Oriented_points selected(const Oriented_points& scan, const std::vector<std::size_t>& chosen)
  {
    Oriented_points result;
    for(const std::size_t i : chosen)
    {
      result.points.push_back(scan.points[i]);
      result.normals.push_back(scan.normals[i]);
    }
    return result;
  }

  // the first of each `step` points
  static Oriented_points every(const Oriented_points& scan, std::size_t step)
  {
    std::vector<std::size_t> chosen;
    for(std::size_t i = 0; i < scan.size(); i += step)
      chosen.push_back(i);
    return selected(scan, chosen);
  }

  static Oriented_points mirrored(const Oriented_points& scan)
  {
    Oriented_points result = scan;
    for(std::vector<Eigen::Vector3d>* vectors : {&result.points, &result.normals})
      for(Eigen::Vector3d& v : *vectors)
        v.x() = -v.x();
    return result;
  }

  static bool is_stopped(const Registration_options& options, double advancement)
  {
    return options.callback && !options.callback(advancement);
  }

  static Registration_outcome failure(Registration_outcome outcome, Registration_obstacle obstacle)
  {
    outcome.verdict = Registration_verdict::FAILED;
    outcome.obstacle = obstacle;
    outcome.confidence = 0.;
    return outcome;
  }

  static double radius(const Oriented_points& scan)
  {
    double result = 0.;
    for(const Eigen::Vector3d& p : scan.points)
      result = (std::max)(result, p.norm());
    return result;
  }

  // Neighborhoods of the same size must hold the same of the surface.
  double make_equally_dense()
  {
    constexpr double tolerance = 1.25;
    double of_source = Registration_assessor::spacing(m_source);
    double of_target = Registration_assessor::spacing(m_target);
    for(int k = 0; k < 3; ++k)
    {
      Oriented_points& dense = of_source < of_target ? m_source : m_target;
      double& of_dense = of_source < of_target ? of_source : of_target;
      const double wanted = (std::max)(of_source, of_target);
      if(!(of_dense > 0.) || wanted <= tolerance * of_dense)
        break;
      // points that are thinned out have their 6 nearest ones at 1.3 times the least distance
      dense = thin_out(dense, wanted / 1.3, dense.size());
      of_dense = Registration_assessor::spacing(dense);
    }
    return (std::max)(of_source, of_target);
  }

  Registration_outcome run()
  {
    Registration_outcome outcome;
    if(m_source.size() < s_few || m_target.size() < s_few || !(m_spacing > 0.) || !(m_radius > 0.))
      return outcome;
    outcome.obstacle = Registration_obstacle::FEW_CORRESPONDENCES;

    std::vector<Registration_hypothesis> found;
    // other sizes of neighborhoods, and matches that the mirrored descriptors would forbid, where the first don't do
    const std::size_t n = m_options.number_of_neighbors;
    std::vector<std::pair<std::size_t, bool> > attempts = {{n, true}};
    for(const std::size_t other : {60, 150, 30})
      if(other != n)
        attempts.emplace_back(other, true);
    attempts.emplace_back((std::max)(n, std::size_t(60)), false);
    constexpr double part_of_attempts = .9;
    double done = 0.;
    bool is_cancelled = false;
    for(const auto& [neighbors, uses_mirrored] : attempts)
    {
      const double part = part_of_attempts / double(attempts.size());
      try_features(
          neighbors, uses_mirrored,
          [&](const double advancement)
          {
            is_cancelled = is_stopped(m_options, done + part * advancement);
            return is_cancelled;
          },
          found, outcome.obstacle);
      done += part;
      if(is_cancelled || (!found.empty() && passes(found[0].quality)))
        break;
    }
    if(!is_cancelled)
    {
      if(found.empty() || !passes(found[0].quality))
        try_frames(found);
      is_cancelled = is_stopped(m_options, part_of_attempts);
    }
    if(found.empty() && !is_cancelled)
      return outcome;
    outcome.hypotheses = found;
    if(is_cancelled)
      return failure(outcome, Registration_obstacle::CANCELLED);
    const Registration_hypothesis best = found[0];
    if(!passes(best.quality))
      return outcome;
    try_sliding(best, found);
    if(!m_slides && best.quality.overlap > s_whole && m_share_of_matches < s_few_matches)
      try_rotations(best, found);
    outcome.hypotheses = {best};
    for(const Registration_hypothesis& h : found)
      if(is_as_good(h.quality, best.quality) &&
         std::all_of(outcome.hypotheses.begin(), outcome.hypotheses.end(),
                     [&](const Registration_hypothesis& other)
                     { return is_different(h.motion, other.motion); }))
        outcome.hypotheses.push_back(h);
    outcome.confidence = confidence(best.quality);
    if(outcome.hypotheses.size() == 1)
    {
      outcome.verdict = Registration_verdict::SUCCESS;
      outcome.obstacle = Registration_obstacle::NONE;
    }
    else
    {
      outcome.verdict = Registration_verdict::AMBIGUOUS;
      outcome.obstacle = m_slides ? Registration_obstacle::SLIDING : Registration_obstacle::SEVERAL_MOTIONS;
      outcome.confidence /= double(outcome.hypotheses.size());
    }
    return outcome;
  }

  // Most of the near points must meet. How many don't for all that grows with the noise, and faster than for points of one and
  // the same scan. Where many don't, curvatures must be alike, too: those of wrong registrations are not.
  static bool passes(const Registration_quality& q)
  {
    const double missing = s_missing + s_missing_by_noise * (1. - q.expected_agreement);
    return q.number_of_near_points >= s_few && q.agreement >= (std::max)(s_agreement, 1. - missing) &&
           (q.agreement >= s_clear_agreement || q.curvature_correlation >= s_correlation);
  }

  static bool is_as_good(const Registration_quality& q, const Registration_quality& best)
  {
    return passes(q) && q.agreement >= s_as_good * best.agreement && q.overlap >= .7 * best.overlap;
  }

  static double score(const Registration_quality& q)
  {
    // few points agree by chance
    return q.agreement * std::sqrt(q.overlap);
  }

  static double confidence(const Registration_quality& q)
  {
    return (std::min)(1., q.agreement / (std::max)(q.expected_agreement, s_agreement));
  }

  bool is_different(const Eigen::Affine3d& a, const Eigen::Affine3d& b) const
  {
    double sum = 0.;
    for(const Eigen::Vector3d& p : m_source.points)
      sum += (a * p - b * p).norm();
    return sum > s_different * m_radius * double(m_source.size());
  }

  void keep(const Eigen::Isometry3d& motion, std::vector<Registration_hypothesis>& found) const
  {
    Registration_hypothesis h;
    h.motion = motion;
    h.quality = m_assessor(motion);
    const auto rank = [](const Registration_hypothesis& x)
    { return std::make_pair(passes(x.quality), score(x.quality)); };
    const auto place = std::upper_bound(found.begin(), found.end(), h,
                                        [&](const Registration_hypothesis& a,
                                            const Registration_hypothesis& b) { return rank(a) > rank(b); });
    found.insert(place, h);
  }

  struct Features
  {
    Descriptor_matrix values, mirrored;
  };

  Features features(const Oriented_points& scan, std::size_t neighbors) const
  {
    // a disc of the radius has as many points if they lie as evenly as they can
    const double reach = m_spacing * std::sqrt(double(neighbors) * .2757);
    Point_set_samples samples(scan.points, CGAL::Identity_property_map<Eigen::Vector3d>(),
                              Neighborhood::ball(reach));
    samples.set_normals(scan.normals);
    using Descriptor = Fpfh_descriptor<Point_set_samples>;
    const Descriptor descriptor(samples, Fpfh_variant::OPEN3D, ConcurrencyTag());
    Features result;
    result.values = compute_descriptors<ConcurrencyTag>(descriptor, samples.size());
    result.mirrored = result.values;
    for(Eigen::Index i = 0; i < result.values.values.rows(); ++i)
      Descriptor::mirrored(result.values.values.row(i).data(), result.mirrored.values.row(i).data());
    return result;
  }

  // `is_cancelled` is asked with the advancement in [0, 1]
  template <typename IsCancelled>
  void try_features(std::size_t neighbors,
                    bool uses_mirrored,
                    const IsCancelled& is_cancelled,
                    std::vector<Registration_hypothesis>& found,
                    Registration_obstacle& obstacle)
  {
    const Features of_source = features(m_source, neighbors);
    if(is_cancelled(.2))
      return;
    const Features of_target = features(m_target, neighbors);
    if(is_cancelled(.4))
      return;
    std::vector<Correspondence> matches =
        uses_mirrored ? match_descriptors<ConcurrencyTag>(
                            of_source.values, of_target.values,
                            parameters::mirrored_target_descriptors(std::cref(of_target.mirrored)))
                      : match_descriptors<ConcurrencyTag>(of_source.values, of_target.values);
    // Then what the first motion leaves over: objects that are their own after a rotation have several.
    for(int round = 0; round < 2; ++round)
    {
      if(is_cancelled(.6 + .2 * round) || matches.size() < s_few)
        return;
      const std::vector<Correspondence> tuples =
          tuple_test(m_source, m_target, matches, parameters::random_seed(m_options.seed));
      if(tuples.size() < s_few)
        return;
      const Rigid_alignment coarse = fast_global_registration(m_source, m_target, tuples);
      if(!is_estimated(coarse.status))
        return;
      obstacle = Registration_obstacle::SURFACES_DISAGREE;
      refine(coarse.transformation, found);
      if(found.empty() || !passes(found[0].quality))
        return;
      const Eigen::Affine3d& motion = found[0].motion;
      const double far = 6. * m_spacing;
      const std::size_t before = matches.size();
      matches.erase(
          std::remove_if(matches.begin(), matches.end(),
                         [&](const Correspondence& c) {
                           return (motion * m_source.points[c.source] - m_target.points[c.target]).norm() <
                                  far;
                         }),
          matches.end());
      if(round == 0)
        m_share_of_matches = 1. - double(matches.size()) / double(before);
    }
  }

  void refine(const Eigen::Isometry3d& start, std::vector<Registration_hypothesis>& found) const
  {
    const Rigid_alignment fine = iterative_closest_point<ConcurrencyTag>(m_sparse_source, m_target, start);
    keep(is_estimated(fine.status) ? fine.transformation : start, found);
  }

  // the 24 rotations of a cube
  static std::vector<Eigen::Matrix3d> rotations()
  {
    static constexpr int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    std::vector<Eigen::Matrix3d> result;
    for(int k = 0; k < 48; ++k)
    {
      Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
      for(int r = 0; r < 3; ++r)
        m(r, orders[k / 8][r]) = (k >> r & 1) != 0 ? -1. : 1.;
      if(m.determinant() > 0.)
        result.push_back(m);
    }
    return result;
  }

  // Without features, whole objects lie on each other in one of the 24 positions of their principal axes.
  void try_frames(std::vector<Registration_hypothesis>& found) const
  {
    const Eigen::Matrix3d of_source = axes(m_source), of_target = axes(m_target);
    std::vector<Eigen::Isometry3d> starts;
    for(const Eigen::Matrix3d& r : rotations())
      starts.push_back(Eigen::Isometry3d(of_target * r * of_source.transpose()));
    try_roughly(starts, found);
  }

  // The source turned about its centroid, from where it fits.
  void try_rotations(const Registration_hypothesis& best, std::vector<Registration_hypothesis>& found) const
  {
    const Eigen::Matrix3d frame = axes(m_source);
    std::vector<Eigen::Isometry3d> starts;
    for(const Eigen::Matrix3d& r : rotations())
      if(!r.isIdentity())
        starts.push_back(Eigen::Isometry3d(best.motion.matrix()) *
                         Eigen::Isometry3d(frame * r * frame.transpose()));
    try_roughly(starts, found);
  }

  // Many starts, with few points; the best three of them with all.
  void try_roughly(const std::vector<Eigen::Isometry3d>& starts,
                   std::vector<Registration_hypothesis>& found) const
  {
    const std::size_t step = m_source.size() / s_enough_to_try + 1;
    const Oriented_points few = every(m_source, step);
    std::vector<Eigen::Isometry3d> tried;
    // numbers, for motions in a buffer of std::stable_sort() may lack alignment
    std::vector<std::pair<double, std::size_t> > order;
    for(const Eigen::Isometry3d& start : starts)
    {
      const Rigid_alignment fine = iterative_closest_point<ConcurrencyTag>(
          few, m_target, start, parameters::number_of_iterations(20).maximum_correspondence_distance(.3));
      if(!is_estimated(fine.status))
        continue;
      order.emplace_back(-score(m_assessor(fine.transformation, step)), tried.size());
      tried.push_back(fine.transformation);
    }
    std::sort(order.begin(), order.end());
    for(std::size_t k = 0; k < (std::min)(order.size(), std::size_t(3)); ++k)
      refine(tried[order[k].second], found);
  }

  static Eigen::Matrix3d axes(const Oriented_points& scan)
  {
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for(const Eigen::Vector3d& p : scan.points)
      scatter += p * p.transpose() / double(scan.size());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
    Eigen::Matrix3d result = solver.eigenvectors();
    result.col(2) = result.col(0).cross(result.col(1));
    return result;
  }

  // Moves the source along the target where nothing seems to hold it.
  void try_sliding(const Registration_hypothesis& best, std::vector<Registration_hypothesis>& found)
  {
    Eigen::Vector3d center = best.motion * centroid(m_source.points);
    const double size = m_radius;
    Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
    for(std::size_t i = 0; i < m_source.size(); ++i)
    {
      const Eigen::Vector3d p = best.motion * m_source.points[i],
                            n = best.motion.linear() * m_source.normals[i];
      if(!m_assessor.is_near(p))
        continue;
      Twist row;
      row << ((p - center) / size).cross(n), n;
      matrix += row * row.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(matrix);
    for(int k = 0; k < 3; ++k)
    {
      if(solver.eigenvalues()[k] > s_slack * solver.eigenvalues()[5])
        break;
      for(const double sign : {-1., 1.})
      {
        const Twist twist = sign * solver.eigenvectors().col(k);
        Registration_hypothesis moved;
        moved.motion = slid(best.motion, twist, center, size);
        const std::size_t before = found.size();
        refine(Eigen::Isometry3d(moved.motion.matrix()), found);
        if(found.size() == before)
          continue;
        for(const Registration_hypothesis& h : found)
          if(is_different(h.motion, best.motion) && is_as_good(h.quality, best.quality))
          {
            m_slides = true;
            return;
          }
      }
    }
  }

  // Moves points by 1.5 times the distance from which on motions are different, on average.
  Eigen::Affine3d
  slid(const Eigen::Affine3d& motion, const Twist& twist, const Eigen::Vector3d& center, double size) const
  {
    const auto step = [&](const double length)
    {
      const Eigen::Vector3d axis = length * twist.head<3>();
      Eigen::Affine3d result = Eigen::Affine3d::Identity();
      if(axis.norm() > 0.)
        result.linear() = Eigen::AngleAxisd(axis.norm(), axis.normalized()).toRotationMatrix();
      result.translation() = center + size * length * twist.tail<3>() - result.linear() * center;
      return result;
    };
    constexpr double small = 1e-3;
    double sum = 0.;
    for(const Eigen::Vector3d& p : m_source.points)
      sum += (step(small) * (motion * p) - motion * p).norm() / double(m_source.size());
    // Points on a line stay where they are when it is the axis.
    constexpr double rounding = 1e-8;
    return sum > rounding * small * size ? step(small * 1.5 * s_different * m_radius / sum) * motion : motion;
  }

  const Registration_options& m_options;
  Oriented_points m_source, m_target;
  double m_spacing;
  Oriented_points m_sparse_source;
  double m_radius;
  Registration_assessor m_assessor;
  double m_share_of_matches = 0.; // those that the best motion explains
  bool m_slides = false;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_SCAN_REGISTRAR_H
