#include "variants.h"

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/descriptors/Descriptor_matrix.h>
#include <Shape_characteristics/descriptors/Fpfh_descriptor.h>
#include <Shape_characteristics/descriptors/compute_descriptors.h>
#include <Shape_characteristics/registration/Correspondence.h>
#include <Shape_characteristics/registration/Oriented_points.h>
#include <Shape_characteristics/registration/assess_registration.h>
#include <Shape_characteristics/registration/fast_global_registration.h>
#include <Shape_characteristics/registration/match_descriptors.h>
#include <Shape_characteristics/registration/register_partial_scans.h>
#include <Shape_characteristics/registration/tuple_test.h>
#include <Shape_characteristics/sampling/Neighborhood.h>
#include <Shape_characteristics/sampling/Point_set_samples.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <stdexcept>
#include <utility>

namespace registration {
namespace {

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Point_and_normal = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using SC::Correspondence;
using SC::Descriptor_matrix;
using SC::Oriented_points;
using SC::Point_set_samples;

double now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// in which a neighborhood has so many other points on average over both parts
double radius_of(const Split& split, std::size_t neighbors)
{
  constexpr std::size_t centers = 200;
  std::vector<double> distances;
  for(const Scan* scan : {&split.target, &split.source})
  {
    const std::size_t step = scan->points.size() / centers + 1;
    for(std::size_t i = 0; i < scan->points.size(); i += step)
    {
      std::vector<double> from_here;
      for(std::size_t j = 0; j < scan->points.size(); ++j)
        if(j != i)
          from_here.push_back((scan->points[i] - scan->points[j]).norm());
      const std::size_t kept = (std::min)(8 * neighbors, from_here.size());
      std::nth_element(from_here.begin(), from_here.begin() + std::ptrdiff_t(kept) - 1, from_here.end());
      from_here.resize(kept);
      distances.insert(distances.end(), from_here.begin(), from_here.end());
    }
  }
  std::size_t used = 0;
  for(const Scan* scan : {&split.target, &split.source})
  {
    const std::size_t step = scan->points.size() / centers + 1;
    used += (scan->points.size() + step - 1) / step;
  }
  const std::size_t rank = (std::min)(used * neighbors, distances.size() - 1);
  std::nth_element(distances.begin(), distances.begin() + std::ptrdiff_t(rank), distances.end());
  return distances[rank];
}

Point_set_samples samples_of(const Scan& scan, double radius)
{
  Point_set_samples samples(scan.points, CGAL::Identity_property_map<Eigen::Vector3d>(),
                            SC::Neighborhood::ball(radius));
  samples.set_normals(scan.normals);
  return samples;
}

struct Descriptors
{
  Descriptor_matrix values, mirrored;
};

using Fpfh = SC::Fpfh_descriptor<Point_set_samples>;

Descriptors fpfh(const Point_set_samples& samples)
{
  const Fpfh descriptor(samples, SC::Fpfh_variant::OPEN3D, CGAL::Sequential_tag());
  Descriptors result;
  result.values = SC::compute_descriptors<CGAL::Sequential_tag>(descriptor, samples.size());
  result.mirrored = result.values;
  for(Eigen::Index i = 0; i < result.values.values.rows(); ++i)
    Fpfh::mirrored(result.values.values.row(i).data(), result.mirrored.values.row(i).data());
  return result;
}

// The share of correspondences that belong to the mirrored position: the model's plane of symmetry is x = 0 in the place of the
// target.
double mirrored_share(const Split& split, const std::vector<Correspondence>& inliers)
{
  const double near = 5. * split.spacing;
  std::size_t mirrored = 0;
  for(const Correspondence& c : inliers)
  {
    const Eigen::Vector3d right = split.motion * split.source.points[c.source];
    const Eigen::Vector3d image(-right.x(), right.y(), right.z());
    const Eigen::Vector3d& found = split.target.points[c.target];
    if((found - image).norm() < near && (found - right).norm() >= near)
      ++mirrored;
  }
  return inliers.empty() ? 0. : double(mirrored) / double(inliers.size());
}

Trial_result run_steps(const Split& split,
                       std::size_t neighbors,
                       bool tests_mirrored,
                       bool tests_orientation,
                       bool tests_normals)
{
  Trial_result result;
  const double start = now();
  const double radius = radius_of(split, neighbors);
  const Point_set_samples source_samples = samples_of(split.source, radius),
                          target_samples = samples_of(split.target, radius);
  const Descriptors of_source = fpfh(source_samples), of_target = fpfh(target_samples);
  const double described = now();

  const std::vector<Correspondence> matches =
      tests_mirrored ? SC::match_descriptors<CGAL::Sequential_tag>(
                           of_source.values, of_target.values,
                           SC::parameters::mirrored_target_descriptors(std::cref(of_target.mirrored)))
                     : SC::match_descriptors<CGAL::Sequential_tag>(of_source.values, of_target.values);
  const double matched = now();

  const Oriented_points source{split.source.points, split.source.normals},
      target{split.target.points, split.target.normals};
  const std::vector<Correspondence> tuples = SC::tuple_test(
      source, target, matches,
      SC::parameters::orientation_is_tested(tests_orientation).normals_are_tested(tests_normals));
  const SC::Rigid_alignment alignment = SC::fast_global_registration(source, target, tuples);
  const double solved = now();

  // a failure is no motion at all
  const Eigen::Isometry3d motion =
      is_estimated(alignment.status) ? alignment.transformation : Eigen::Isometry3d::Identity();
  result.error = registration_error(split, motion);
  result.mirrored = mirrored_share(split, alignment.inliers);
  const SC::Registration_quality quality = SC::assess_registration(source, target, motion);
  result.agreement = quality.agreement;
  result.near = quality.overlap;
  result.correlation = quality.curvature_correlation;
  result.describe = described - start;
  result.match = matched - described;
  result.solve = solved - matched;
  return result;
}

std::vector<Point_and_normal> as_range(const Scan& scan)
{
  std::vector<Point_and_normal> range;
  for(std::size_t i = 0; i < scan.points.size(); ++i)
  {
    const Eigen::Vector3d &p = scan.points[i], &n = scan.normals[i];
    range.emplace_back(Kernel::Point_3(p.x(), p.y(), p.z()), Kernel::Vector_3(n.x(), n.y(), n.z()));
  }
  return range;
}

Trial_result run_pipeline(const Split& split, std::size_t neighbors)
{
  const std::vector<Point_and_normal> source = as_range(split.source), target = as_range(split.target);
  const auto maps = SC::parameters::point_map(CGAL::First_of_pair_property_map<Point_and_normal>())
                        .normal_map(CGAL::Second_of_pair_property_map<Point_and_normal>());
  const double start = now();
  const SC::Registration_result<Kernel> found = SC::register_partial_scans<CGAL::Sequential_tag>(
      source, target, maps.number_of_neighbors(neighbors), maps);
  Trial_result result;
  result.solve = now() - start;
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  for(int row = 0; row < 3; ++row)
    for(int column = 0; column < 4; ++column)
      motion.matrix()(row, column) = found.transformation.m(row, column);
  result.error = registration_error(split, motion);
  result.agreement = found.quality.agreement;
  result.near = found.quality.overlap;
  result.correlation = found.quality.curvature_correlation;
  result.verdict = found.verdict == SC::Registration_verdict::SUCCESS     ? "success"
                   : found.verdict == SC::Registration_verdict::AMBIGUOUS ? "ambiguous"
                                                                          : "failed";
  return result;
}

} // namespace

const std::vector<Variant>& variants()
{
  static const std::vector<Variant> all = {
      {"base", "FPFH and fast global registration"},
      {"orient", "the same, triples of matches must not be mirrored"},
      {"orient_ppf", "the same, and their normals must agree"},
      {"mirror_orient_ppf", "the same, and matches must not suit the mirrored descriptor better"},
      {"pipeline", "register_partial_scans()"},
  };
  return all;
}

Trial_result run_variant(const std::string& name, const Split& split, std::size_t neighbors)
{
  Trial_result result;
  if(name == "pipeline")
    result = run_pipeline(split, neighbors);
  else if(name == "base")
    result = run_steps(split, neighbors, false, false, false);
  else if(name == "orient")
    result = run_steps(split, neighbors, false, true, false);
  else if(name == "orient_ppf")
    result = run_steps(split, neighbors, false, true, true);
  else if(name == "mirror_orient_ppf")
    result = run_steps(split, neighbors, true, true, true);
  else
    throw std::invalid_argument("no variant " + name);
  result.overlap = split.overlap;
  return result;
}

} // namespace registration
