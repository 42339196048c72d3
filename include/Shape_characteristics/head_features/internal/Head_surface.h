#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_HEAD_SURFACE_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_HEAD_SURFACE_H

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// A triangle mesh in the frame of a head.
struct Head_surface
{
  using Index = std::uint32_t;

  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<Index, 3> > triangles;
};

// A place on the surface: where it is, and in which triangle.
struct Surface_point
{
  static constexpr std::size_t no_triangle = std::size_t(-1);

  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  std::size_t triangle = no_triangle;

  bool is_valid() const { return triangle != no_triangle; }
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_HEAD_SURFACE_H
