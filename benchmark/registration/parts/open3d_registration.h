#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_OPEN3D_REGISTRATION_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_OPEN3D_REGISTRATION_H

#include <array>
#include <cstddef>
#include <vector>

// No type of a library goes from the one side to the other: they are compiled for different processors.
namespace registration {

/// points with unit normals
struct Open3d_cloud
{
  std::vector<std::array<double, 3>> points, normals;
};

/// whether Open3D was found: without it there are no results
[[gnu::visibility("default")]] bool has_open3d();

struct Open3d_result
{
  std::array<std::array<double, 4>, 4> motion{};   ///< row by row
  std::vector<std::array<std::size_t, 2>> inliers; ///< of the source, of the target
  double describe = 0., match_and_solve = 0.;      ///< seconds of the processor
};

/// `ComputeFPFHFeature` with the points within `radius`, and `FastGlobalRegistrationBasedOnFeatureMatching`, with all else as
/// Open3D chooses it; the generator of its random tuples is seeded.
[[gnu::visibility("default")]] Open3d_result
open3d_registration(const Open3d_cloud& source, const Open3d_cloud& target, double radius);

} // namespace registration

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_OPEN3D_REGISTRATION_H
