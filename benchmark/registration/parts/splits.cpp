#include "splits.h"

#include "Random.h"
#include "heads.h"

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace registration {
namespace {

using benchmark_support::Random;

Eigen::Matrix3d random_rotation(Random& random)
{
  Eigen::Vector4d q;
  do
    for(int k = 0; k < 4; ++k)
      q[k] = random.gaussian();
  while(!(q.norm() > 1e-6));
  q.normalize();
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
}

// the points for which `is_in` says so, and the triangles that have no others
template <typename Predicate>
Scan part(const Scan& scan, const Predicate& is_in)
{
  constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();
  // a vertex whose triangles all go belongs to no mesh
  std::vector<bool> is_used(scan.points.size(), scan.triangles.empty());
  for(const auto& t : scan.triangles)
    if(is_in(scan.points[t[0]]) && is_in(scan.points[t[1]]) && is_in(scan.points[t[2]]))
      is_used[t[0]] = is_used[t[1]] = is_used[t[2]] = true;
  Scan result;
  std::vector<std::uint32_t> number(scan.points.size(), none);
  for(std::size_t i = 0; i < scan.points.size(); ++i)
    if(is_used[i] && is_in(scan.points[i]))
    {
      number[i] = std::uint32_t(result.points.size());
      result.points.push_back(scan.points[i]);
      if(!scan.normals.empty())
        result.normals.push_back(scan.normals[i]);
    }
  for(const auto& t : scan.triangles)
    if(number[t[0]] != none && number[t[1]] != none && number[t[2]] != none && is_in(scan.points[t[0]]) &&
       is_in(scan.points[t[1]]) && is_in(scan.points[t[2]]))
      result.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  return result;
}

void make_noisy(Scan& scan, double relative_noise, Random& random)
{
  const double sigma =
      relative_noise * (scan.triangles.empty() ? mean_nearest_distance(scan.points) : mean_edge_length(scan));
  for(Eigen::Vector3d& p : scan.points)
    for(int k = 0; k < 3; ++k)
      p[k] += sigma * random.gaussian();
  if(scan.triangles.empty())
    estimate_point_normals(scan);
  else
    set_mesh_normals(scan);
}

} // namespace

Split split(const Scan& first, const Scan& second, const Split_protocol& protocol, std::uint64_t seed)
{
  Random random(seed);
  Eigen::Vector3d center;
  const double radius = radius_about_centroid(first.points, center);
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  for(int axis = 0; axis < 3; ++axis)
  {
    const double angle = random.uniform(-protocol.angle, protocol.angle) * CGAL_PI / 180.;
    rotation = Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit(axis)).toRotationMatrix() * rotation;
  }
  const Eigen::Vector3d normal = rotation * Eigen::Vector3d::UnitX();
  const double band = radius * random.uniform(protocol.least_band, protocol.largest_band);
  const auto height = [&](const Eigen::Vector3d& p) { return normal.dot(p - center); };

  Split result;
  result.target = part(first, [&](const Eigen::Vector3d& p) { return height(p) <= band; });
  result.source = part(second, [&](const Eigen::Vector3d& p) { return height(p) >= -band; });
  std::size_t common = 0;
  for(const Eigen::Vector3d& p : result.source.points)
    common += height(p) <= band ? 1 : 0;
  result.overlap = double(common) / double(result.source.points.size());
  const auto spacing = [](const Scan& scan)
  { return scan.triangles.empty() ? mean_nearest_distance(scan.points) : mean_edge_length(scan); };
  result.spacing = .5 * (spacing(result.target) + spacing(result.source));

  make_noisy(result.target, protocol.noise, random);
  make_noisy(result.source, protocol.noise, random);

  Eigen::Isometry3d there = Eigen::Isometry3d::Identity();
  there.linear() = random_rotation(random);
  for(int k = 0; k < 3; ++k)
    there.translation()[k] = radius * random.uniform(-2., 2.);
  for(Eigen::Vector3d& p : result.source.points)
    p = there * p;
  for(Eigen::Vector3d& n : result.source.normals)
    n = there.linear() * n;
  result.motion = there.inverse();
  return result;
}

double registration_error(const Split& split, const Eigen::Isometry3d& motion)
{
  Eigen::Vector3d center;
  const double radius = radius_about_centroid(split.source.points, center);
  double sum = 0.;
  for(const Eigen::Vector3d& p : split.source.points)
    sum += (motion * p - split.motion * p).norm();
  return sum / double(split.source.points.size()) / radius;
}

} // namespace registration
