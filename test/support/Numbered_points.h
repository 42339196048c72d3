#ifndef SHAPE_CHARACTERISTICS_TEST_SUPPORT_NUMBERED_POINTS_H
#define SHAPE_CHARACTERISTICS_TEST_SUPPORT_NUMBERED_POINTS_H

#include "Curvature_estimates.h"
#include "analytic_surfaces.h"

#include <Shape_characteristics/Named_function_parameters.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace test_support {

/// Points with normals whose range is one of numbers, as that of a `CGAL::Point_set_3` is.
struct Numbered_points
{
  using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
  using Vector_3 = CGAL::Simple_cartesian<double>::Vector_3;

  std::vector<Point_3> points;
  std::vector<Vector_3> normals;

  Numbered_points() = default;

  /// The vertices of a surface, with exact normals.
  explicit Numbered_points(const Analytic_surface& s)
  {
    for(std::size_t i = 0; i < s.points.size(); ++i)
    {
      const Vector &p = s.points[i], &n = s.exact[i].normal;
      push_back(Point_3(p[0], p[1], p[2]), Vector_3(n[0], n[1], n[2]));
    }
  }

  void push_back(const Point_3& point, const Vector_3& normal)
  {
    points.push_back(point);
    normals.push_back(normal);
  }

  std::size_t size() const { return points.size(); }

  /// What `estimate(numbers, np)` returns and writes into the maps of `np`.
  template <typename Estimate>
  Curvature_estimates estimates(const Estimate& estimate) const
  {
    namespace parameters = Shape_characteristics::parameters;
    std::vector<std::size_t> numbers(size());
    std::iota(numbers.begin(), numbers.end(), std::size_t(0));
    // what is not written is seen: it is neither an estimate nor the NaN of what has none
    const double unwritten = (std::numeric_limits<double>::max)();
    const Vector_3 unwritten_direction(unwritten, unwritten, unwritten);
    Curvature_estimates result;
    result.curvatures.assign(size(), {unwritten, unwritten, unwritten_direction, unwritten_direction});
    result.mean.assign(size(), unwritten);
    result.Gaussian.assign(size(), unwritten);
    result.status.assign(size(), Shape_characteristics::Estimation_status::CANCELLED);
    result.failures = estimate(
        numbers, parameters::point_map(CGAL::make_property_map(points))
                     .normal_map(CGAL::make_property_map(normals))
                     .principal_curvatures_and_directions_map(CGAL::make_property_map(result.curvatures))
                     .mean_curvature_map(CGAL::make_property_map(result.mean))
                     .Gaussian_curvature_map(CGAL::make_property_map(result.Gaussian))
                     .status_map(CGAL::make_property_map(result.status)));
    return result;
  }
};

} // namespace test_support

#endif // SHAPE_CHARACTERISTICS_TEST_SUPPORT_NUMBERED_POINTS_H
