#include "variants.h"

#include "Mesh.h"
#include "open3d_registration.h"
#include "register_scans.h"
#include "signals.h"

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/descriptors/Descriptor_matrix.h>
#include <Shape_characteristics/descriptors/Fpfh_descriptor.h>
#include <Shape_characteristics/descriptors/compute_descriptors.h>
#include <Shape_characteristics/registration/Correspondence.h>
#include <Shape_characteristics/registration/Oriented_points.h>
#include <Shape_characteristics/registration/assess_registration.h>
#include <Shape_characteristics/registration/fast_global_registration.h>
#include <Shape_characteristics/registration/match_descriptors.h>
#include <Shape_characteristics/registration/tuple_test.h>
#include <Shape_characteristics/sampling/Point_set_samples.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <ctime>
#include <functional>
#include <stdexcept>

namespace registration {
namespace {

namespace SC = Shape_characteristics;
using SC::Correspondence;
using SC::Descriptor_matrix;
using SC::Oriented_points;
using SC::Point_set_samples;

double now()
{
  return double(std::clock()) / CLOCKS_PER_SEC; // of the processor: others may be at work
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

void add_quality(Trial_result& result, const SC::Registration_quality& quality)
{
  result.agreement = quality.agreement;
  result.near = quality.overlap;
  result.expected = quality.expected_agreement;
  result.correlation = quality.curvature_correlation;
}

// What the steps do; `features`: 0 for FPFH alone, 1 to 4 for the thesis's vectors (10.1.3), 5 for chirality appended.
struct Steps
{
  bool tests_mirrored = false, tests_orientation = false, tests_normals = false;
  int features = 0;
};

// The heads are some 34 cm high; signals as printed have the unit of length.
constexpr double millimeters = 342.;

Descriptors with_signals(const Descriptors& plain, const Signals& signals, int features)
{
  std::vector<const std::vector<float>*> appended;
  if(features == 1 || features == 3)
    appended.push_back(&signals.flux);
  if(features >= 2 && features <= 4)
    appended.push_back(&signals.mean_volume);
  if(features == 3 || features == 4)
    appended.push_back(&signals.Gaussian_volume);
  if(features == 5)
    appended.push_back(&signals.chirality);
  constexpr float weight_of_chirality = 40.f;
  Descriptors result = plain;
  for(Descriptor_matrix* matrix : {&result.values, &result.mirrored})
  {
    const float sign = matrix == &result.values ? 1.f : -1.f;
    const Eigen::Index rows = matrix->values.rows(), columns = matrix->values.cols();
    matrix->values.conservativeResize(rows, columns + Eigen::Index(appended.size()));
    for(Eigen::Index i = 0; i < rows; ++i)
    {
      if(features <= 4)
        matrix->values.row(i).head(columns) *= sign * signals.flux[std::size_t(i)];
      for(std::size_t k = 0; k < appended.size(); ++k)
        matrix->values(i, columns + Eigen::Index(k)) =
            (features == 5 ? weight_of_chirality : 1.f) * sign * (*appended[k])[std::size_t(i)];
    }
  }
  return result;
}

Trial_result run_steps(const Split& split, std::size_t neighbors, const Steps& steps)
{
  const auto [tests_mirrored, tests_orientation, tests_normals, features] = steps;
  Trial_result result;
  const double radius = radius_of(split, neighbors);
  const double start = now();
  const Point_set_samples source_samples = samples_of(split.source, radius),
                          target_samples = samples_of(split.target, radius);
  Descriptors of_source = fpfh(source_samples), of_target = fpfh(target_samples);
  if(features != 0)
  {
    const double large = features == 5 ? radius_of(split, 400) : radius;
    of_source = with_signals(of_source, signals_of(split.source, radius, large, millimeters), features);
    of_target = with_signals(of_target, signals_of(split.target, radius, large, millimeters), features);
  }
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
  add_quality(result, SC::assess_registration(source, target, motion));
  result.describe = described - start;
  result.match = matched - described;
  result.solve = solved - matched;
  return result;
}

Open3d_cloud to_open3d(const Scan& scan)
{
  const auto copy = [](const Points& points)
  {
    std::vector<std::array<double, 3> > copies;
    for(const Eigen::Vector3d& p : points)
      copies.push_back({p.x(), p.y(), p.z()});
    return copies;
  };
  return {copy(scan.points), copy(scan.normals)};
}

Trial_result run_open3d(const Split& split, std::size_t neighbors)
{
  const Open3d_result found =
      open3d_registration(to_open3d(split.source), to_open3d(split.target), radius_of(split, neighbors));
  Trial_result result;
  result.describe = found.describe;
  result.solve = found.match_and_solve;
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  for(int row = 0; row < 3; ++row)
    for(int column = 0; column < 4; ++column)
      motion.matrix()(row, column) = found.motion[std::size_t(row)][std::size_t(column)];
  result.error = registration_error(split, motion);
  std::vector<Correspondence> inliers;
  for(const auto& [s, t] : found.inliers)
    inliers.push_back({std::uint32_t(s), std::uint32_t(t)});
  result.mirrored = mirrored_share(split, inliers);
  add_quality(result, SC::assess_registration({split.source.points, split.source.normals},
                                              {split.target.points, split.target.normals}, motion));
  return result;
}

Trial_result run_pipeline(const Split& split, std::size_t neighbors)
{
  Trial_result result;
  const auto run = [&](const auto& source, const auto& target)
  {
    const double start = now();
    const Registration_result found = register_scans(source, target, neighbors);
    result.solve = now() - start;
    return found;
  };
  const Registration_result found = split.source.triangles.empty()
                                        ? run(to_range(split.source), to_range(split.target))
                                        : run(to_mesh(split.source), to_mesh(split.target));
  result.error = registration_error(split, motion(found));
  add_quality(result, found.quality);
  result.verdict = to_string(found.verdict);
  return result;
}

} // namespace

const std::vector<Variant>& variants()
{
  static const std::vector<Variant> all = []
  {
    std::vector<Variant> result = {
        {"base", "FPFH and fast global registration"},
        {"thesis1", "the thesis's first feature vector: FPFH times flux, and the flux; in millimeters"},
        {"thesis2", "the second: FPFH times flux, and the signed volume of mean curvature"},
        {"thesis3", "the third: FPFH times flux, the flux and both volumes"},
        {"thesis4", "the fourth: FPFH times flux, and both volumes"},
        {"orient", "FPFH, triples of matches must not be mirrored"},
        {"orient_ppf", "the same, and their normals must agree"},
        {"mirror_orient_ppf", "the same, and matches must not suit the mirrored descriptor better"},
        {"chi_orient_ppf", "FPFH and chirality, triples tested as for `orient_ppf`"},
        {"pipeline", "register_partial_scans()"},
    };
    if(has_open3d())
      result.push_back({"open3d", "Open3D's FPFH and fast global registration"});
    return result;
  }();
  return all;
}

Trial_result run_variant(const std::string& name, const Split& split, std::size_t neighbors)
{
  Trial_result result;
  if(name == "pipeline")
    result = run_pipeline(split, neighbors);
  else if(name == "open3d" && has_open3d())
    result = run_open3d(split, neighbors);
  else if(name == "base")
    result = run_steps(split, neighbors, {});
  else if(name == "orient")
    result = run_steps(split, neighbors, {false, true, false, 0});
  else if(name == "orient_ppf")
    result = run_steps(split, neighbors, {false, true, true, 0});
  else if(name == "mirror_orient_ppf")
    result = run_steps(split, neighbors, {true, true, true, 0});
  else if(name == "chi_orient_ppf")
    result = run_steps(split, neighbors, {false, true, true, 5});
  else if(name.size() == 7 && name.rfind("thesis", 0) == 0 && name[6] >= '1' && name[6] <= '4')
    result = run_steps(split, neighbors, {false, false, false, name[6] - '0'});
  else
    throw std::invalid_argument("no variant " + name);
  result.overlap = split.overlap;
  return result;
}

} // namespace registration
