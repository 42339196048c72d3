// In a file of its own: Open3D's headers are slow to compile.
#include "open3d_registration.h"

#ifdef SHAPE_CHARACTERISTICS_BENCHMARK_OPEN3D

#include <open3d/geometry/KDTreeSearchParam.h>
#include <open3d/geometry/PointCloud.h>
#include <open3d/pipelines/registration/FastGlobalRegistration.h>
#include <open3d/pipelines/registration/Feature.h>
#include <open3d/pipelines/registration/Registration.h>
#include <open3d/utility/Logging.h>
#include <open3d/utility/Random.h>

#include <ctime>

namespace registration {
namespace {

double now()
{
  return double(std::clock()) / CLOCKS_PER_SEC;
}

open3d::geometry::PointCloud to_open3d(const Open3d_cloud& cloud)
{
  open3d::geometry::PointCloud result;
  for(const auto& p : cloud.points)
    result.points_.emplace_back(p[0], p[1], p[2]);
  for(const auto& n : cloud.normals)
    result.normals_.emplace_back(n[0], n[1], n[2]);
  return result;
}

} // namespace

bool has_open3d()
{
  return true;
}

Open3d_result open3d_registration(const Open3d_cloud& source, const Open3d_cloud& target, double radius)
{
  namespace registration = open3d::pipelines::registration;
  open3d::utility::SetVerbosityLevel(open3d::utility::VerbosityLevel::Error);
  const open3d::geometry::PointCloud s = to_open3d(source), t = to_open3d(target);
  Open3d_result result;
  open3d::utility::random::Seed(1);
  const double start = now();
  const open3d::geometry::KDTreeSearchParamRadius search(radius);
  const auto of_source = registration::ComputeFPFHFeature(s, search);
  const auto of_target = registration::ComputeFPFHFeature(t, search);
  const double described = now();
  const registration::RegistrationResult found =
      registration::FastGlobalRegistrationBasedOnFeatureMatching(s, t, *of_source, *of_target);
  result.describe = described - start;
  result.match_and_solve = now() - described;
  for(int row = 0; row < 4; ++row)
    for(int column = 0; column < 4; ++column)
      result.motion[std::size_t(row)][std::size_t(column)] = found.transformation_(row, column);
  for(const Eigen::Vector2i& c : found.correspondence_set_)
    result.inliers.push_back({std::size_t(c[0]), std::size_t(c[1])});
  return result;
}

} // namespace registration

#else

namespace registration {

bool has_open3d()
{
  return false;
}

Open3d_result open3d_registration(const Open3d_cloud&, const Open3d_cloud&, double)
{
  return {};
}

} // namespace registration

#endif
