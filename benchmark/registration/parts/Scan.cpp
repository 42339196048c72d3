#include "Scan.h"

#include <Shape_characteristics/sampling/Neighborhood.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>

namespace registration {

namespace SC = Shape_characteristics;

double mean_edge_length(const Scan& scan)
{
  double sum = 0.;
  for(const auto& t : scan.triangles)
    for(std::size_t k = 0; k < 3; ++k)
      sum += (scan.points[t[k]] - scan.points[t[(k + 1) % 3]]).norm();
  return scan.triangles.empty() ? 0. : sum / double(3 * scan.triangles.size());
}

double mean_nearest_distance(const Points& points)
{
  using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
  std::vector<Point_3> copies;
  copies.reserve(points.size());
  for(const Eigen::Vector3d& p : points)
    copies.emplace_back(p.x(), p.y(), p.z());
  const SC::Point_set_samples samples(copies, CGAL::Identity_property_map<Point_3>(),
                                      SC::Neighborhood::nearest(1));
  SC::Point_set_samples::Workspace workspace;
  double sum = 0.;
  for(std::size_t i = 0; i < points.size(); ++i)
    for(const auto j : samples.neighbors(i, 0, workspace))
      sum += (points[i] - points[j]).norm();
  return points.empty() ? 0. : sum / double(points.size());
}

double radius_about_centroid(const Points& points, Eigen::Vector3d& center)
{
  center.setZero();
  for(const Eigen::Vector3d& p : points)
    center += p / double(points.size());
  double radius = 0.;
  for(const Eigen::Vector3d& p : points)
    radius = (std::max)(radius, (p - center).norm());
  return radius;
}

SC::Point_set_samples samples_of(const Scan& scan, double radius)
{
  SC::Point_set_samples samples(scan.points, CGAL::Identity_property_map<Eigen::Vector3d>(),
                                SC::Neighborhood::ball(radius));
  samples.set_normals(scan.normals);
  return samples;
}

} // namespace registration
