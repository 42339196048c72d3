#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_FOUND_HEAD_FEATURES_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_FOUND_HEAD_FEATURES_H

#include <Shape_characteristics/head_features/Head_feature.h>
#include <Shape_characteristics/head_features/internal/Head_surface.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// What was found on a `Head_surface`: places on it, and vertices.
struct Found_head_features
{
  struct Point
  {
    Surface_point place; // not valid: not found
    double confidence = 0.;
    bool is_found() const { return place.is_valid(); }
    const Eigen::Vector3d& position() const { return place.position; }
  };

  struct Region
  {
    std::vector<Head_surface::Index> vertices; // none: not found
    double confidence = 0.;
    bool is_found() const { return !vertices.empty(); }
  };

  std::array<Point, number_of_head_features> points;
  std::array<Region, number_of_head_regions> regions;

  Point& operator[](Head_feature f) { return points[static_cast<std::size_t>(f)]; }
  const Point& operator[](Head_feature f) const { return points[static_cast<std::size_t>(f)]; }
  Region& operator[](Head_region r) { return regions[static_cast<std::size_t>(r)]; }
  const Region& operator[](Head_region r) const { return regions[static_cast<std::size_t>(r)]; }
};

// the same feature of the left or of the right side, `first` being the left one of the first
inline Head_feature left_or_right(Head_feature left, Head_feature right, int side)
{
  return side < 0 ? left : right;
}

// How well a place agrees with where the proportions of heads have it: 1 there, .61 at the distance `spread`.
inline double plausibility(double distance, double spread)
{
  const double x = distance / spread;
  return std::exp(-.5 * x * x);
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_FOUND_HEAD_FEATURES_H
