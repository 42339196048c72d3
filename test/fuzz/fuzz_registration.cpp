#include "fuzzed_points.h"
#include "oriented_point_maps.h"

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/registration/Correspondence.h>
#include <Shape_characteristics/registration/Oriented_points.h>
#include <Shape_characteristics/registration/Registration_quality.h>
#include <Shape_characteristics/registration/Registration_result.h>
#include <Shape_characteristics/registration/Rigid_alignment.h>
#include <Shape_characteristics/registration/assess_registration.h>
#include <Shape_characteristics/registration/fast_global_registration.h>
#include <Shape_characteristics/registration/iterative_closest_point.h>
#include <Shape_characteristics/registration/register_partial_scans.h>
#include <Shape_characteristics/registration/tuple_test.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace {

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Scan = std::vector<test_support::Oriented_point>;

SC::Oriented_points oriented_points(const Scan& scan)
{
  return SC::Oriented_points::of(
      SC::sampled_surface(scan, SC::Neighborhood::nearest(1), test_support::oriented_point_maps()));
}

bool is_share(double x)
{
  return x >= 0. && x <= 1.;
}

bool is_finite(const SC::Registration_quality& q)
{
  return is_share(q.overlap) && is_share(q.agreement) && is_share(q.expected_agreement) &&
         std::abs(q.curvature_correlation) <= 1. + 1e-9 && is_share(q.opposition) && is_share(q.penetration);
}

// whether the linear part is a rotation, a reflection, or one of both with a factor
bool is_motion(const CGAL::Aff_transformation_3<Kernel>& t)
{
  Eigen::Matrix3d linear;
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 3; ++j)
      linear(i, j) = t.cartesian(i, j);
  if(!linear.allFinite() || !std::isfinite(t.cartesian(0, 3)) || !std::isfinite(t.cartesian(1, 3)) ||
     !std::isfinite(t.cartesian(2, 3)))
    return false;
  const double factor = linear.col(0).stableNorm();
  return factor > 0. &&
         ((linear / factor).transpose() * (linear / factor) - Eigen::Matrix3d::Identity()).norm() < 1e-9;
}

// whether what is said of an alignment fits together
void check(const char* name, const SC::Rigid_alignment& alignment)
{
  if(!SC::is_estimated(alignment.status))
    return;
  const Eigen::Matrix3d linear = alignment.transformation.linear();
  fuzz::require(alignment.transformation.matrix().allFinite() &&
                    (linear.transpose() * linear - Eigen::Matrix3d::Identity()).norm() < 1e-9 &&
                    linear.determinant() > 0.,
                name, "the motion isn't rigid");
  fuzz::require(std::isfinite(alignment.residual) && alignment.residual >= 0., name, "there is no residual");
  fuzz::require(is_share(alignment.conditioning), name, "there is no conditioning");
}

void register_scans(FuzzedDataProvider& data, const Scan& source, const Scan& target)
{
  const auto maps = test_support::oriented_point_maps();
  const auto result = SC::register_partial_scans(source, target,
                                                 maps.maximum_number_of_samples(100u).number_of_neighbors(
                                                     data.ConsumeIntegralInRange<unsigned int>(8, 20)),
                                                 maps);
  const char* const name = "register_partial_scans";
  using Verdict = SC::Registration_verdict;
  fuzz::require((result.verdict == Verdict::SUCCESS) == (result.obstacle == SC::Registration_obstacle::NONE),
                name, "verdict and obstacle contradict each other");
  fuzz::require(result.obstacle != SC::Registration_obstacle::CANCELLED, name, "nobody cancelled anything");
  fuzz::require(is_motion(result.transformation), name, "the motion isn't one");
  fuzz::require(is_finite(result.quality), name, "the quality isn't finite");
  fuzz::require(is_share(result.confidence), name, "the confidence isn't in [0, 1]");
  fuzz::require(result.verdict != Verdict::FAILED || result.confidence == 0., name, "a failure is confident");
  fuzz::require(result.scale_ratio > 0. && std::isfinite(result.scale_ratio), name, "there is no scale");
  for(const auto& other : result.alternatives)
    fuzz::require(is_motion(other.transformation) && is_finite(other.quality), name,
                  "an alternative isn't a motion");
}

void align(FuzzedDataProvider& data, const Scan& source_scan, const Scan& target_scan)
{
  const SC::Oriented_points source = oriented_points(source_scan), target = oriented_points(target_scan);
  std::vector<SC::Correspondence> pairs;
  if(source.size() > 0 && target.size() > 0)
    for(int k = data.ConsumeIntegralInRange<int>(0, 30); k > 0; --k)
    {
      const auto i = data.ConsumeIntegralInRange<std::size_t>(0, source.size() - 1);
      const auto j = data.ConsumeBool() ? (std::min)(i, target.size() - 1)
                                        : data.ConsumeIntegralInRange<std::size_t>(0, target.size() - 1);
      pairs.push_back({std::uint32_t(i), std::uint32_t(j)});
    }
  const auto kept = SC::tuple_test(source, target, pairs);
  fuzz::require(kept.size() % 3 == 0, "tuple_test", "triples aren't whole");
  const SC::Rigid_alignment global = SC::fast_global_registration(source, target, pairs);
  check("fast_global_registration", global);
  const SC::Rigid_alignment refined = SC::iterative_closest_point(
      source, target,
      SC::is_estimated(global.status) ? global.transformation : Eigen::Isometry3d::Identity());
  check("iterative_closest_point", refined);
  fuzz::require(is_finite(SC::assess_registration(source, target, refined.transformation)),
                "assess_registration", "the quality isn't finite");
}

} // namespace

// Two scans, of which one may be the other one moved, through registration or its steps.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  FuzzedDataProvider data(bytes, size);
  const bool is_whole = data.ConsumeBool();
  Scan source = fuzz::points<test_support::Oriented_point>(data, 60), target;
  if(data.ConsumeBool())
  {
    const Eigen::AngleAxisd turn(fuzz::number(data), Eigen::Vector3d(1., 2., 3.).normalized());
    const Eigen::Matrix3d rotation = turn.toRotationMatrix();
    const double factor = data.ConsumeBool() ? 1. : fuzz::number(data);
    for(const auto& [p, n] : source)
    {
      const Eigen::Vector3d q = factor * (rotation * Eigen::Vector3d(p.x(), p.y(), p.z())),
                            m = rotation * Eigen::Vector3d(n.x(), n.y(), n.z());
      target.push_back({Kernel::Point_3(q.x(), q.y(), q.z()), Kernel::Vector_3(m.x(), m.y(), m.z())});
    }
  }
  else
    target = fuzz::points<test_support::Oriented_point>(data, 60);
  if(is_whole)
    register_scans(data, source, target);
  else
    align(data, source, target);
  return 0;
}
