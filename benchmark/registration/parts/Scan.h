#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_SCAN_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_SCAN_H

#include <Shape_characteristics/sampling/Point_set_samples.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace registration {

using Points = std::vector<Eigen::Vector3d>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// A triangle mesh, or a point set (without triangles).
struct Scan
{
  Points points;
  Points normals; ///< of unit length, one per point, or none yet
  Triangles triangles;
};

/// mean length of the edges of the triangles, each counted as often as it has triangles
double mean_edge_length(const Scan& scan);

/// mean distance to the nearest other point
double mean_nearest_distance(const Points& points);

/// the largest distance from the centroid, which is returned in `center`
double radius_about_centroid(const Points& points, Eigen::Vector3d& center);

/// the points as samples, with their normals, whose neighbors are those within `radius`
Shape_characteristics::Point_set_samples samples_of(const Scan& scan, double radius);

} // namespace registration

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_SCAN_H
