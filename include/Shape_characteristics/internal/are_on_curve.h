#ifndef SHAPE_CHARACTERISTICS_INTERNAL_ARE_ON_CURVE_H
#define SHAPE_CHARACTERISTICS_INTERNAL_ARE_ON_CURVE_H

#include <Shape_characteristics/internal/determinant.h>
#include <Shape_characteristics/internal/tangent_basis.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace Shape_characteristics {
namespace internal {

// Whether the neighbors of a sample lie with it on one curve, as in a point set of rows that are far apart. They tell nothing of
// the curvature across: what a chord turns from the tangent of the curve is as large as what its normals are off. How small
// the angles between the chords are doesn't tell: those of long triangles are small, too, but aren't explained by a parabola.
//
// `for_each(f)` calls `f(x, y)` for the place of each neighbor in the tangent plane, in units of the neighborhood's size.
template <typename ForEach>
bool are_on_curve(const ForEach& for_each)
{
  constexpr double smallest =
      .002; // of half the mean square of sines between directions, 0.25 all around; of one in 60 across, .008
  double p = 0., q = 0., r = 0.;
  for_each(
      [&](const double x, const double y)
      {
        if(const double square = x * x + y * y; square > 0.)
        {
          p += x * x / square;
          q += x * y / square;
          r += y * y / square;
        }
      });
  const double angle = .5 * std::atan2(2. * q, p - r), cosine = std::cos(angle), sine = std::sin(angle);

  // along the directions that most have, and across, where the parabola is fitted
  double s_2 = 0., s_3 = 0., s_4 = 0., of_slope = 0., of_bend = 0.;
  for_each(
      [&](const double x, const double y)
      {
        const double s = cosine * x + sine * y, t = cosine * y - sine * x;
        s_2 += s * s;
        s_3 += s * s * s;
        s_4 += s * s * s * s;
        of_slope += s * t;
        of_bend += s * s * t;
      });
  const double d = determinant(s_2, s_3, s_4);
  if(!(d > 1e-6 * s_2 * s_4)) // too few to tell a parabola
    return false;
  const double slope = (s_4 * of_slope - s_3 * of_bend) / d, bend = (s_2 * of_bend - s_3 * of_slope) / d;
  p = q = r = 0.;
  for_each(
      [&](const double x, const double y)
      {
        const double s = cosine * x + sine * y, t = cosine * y - sine * x - (slope + bend * s) * s;
        if(const double square = s * s + t * t; square > 0.)
        {
          p += s * s / square;
          q += s * t / square;
          r += t * t / square;
        }
      });
  return determinant(p, q, r) < smallest * (p + r) * (p + r);
}

// the same of a sample of a surface and its neighbors
template <typename SampledSurface, typename Neighbors>
bool are_on_curve(const SampledSurface& surface, std::size_t i, const Neighbors& neighbors)
{
  constexpr double wide =
      .02; // of the mean squares along and across, compared to that of their sum; 0.25 all around
  const Eigen::Vector3d& center = surface.point(i);
  Eigen::Vector3d t1, t2;
  tangent_basis(surface.normal(i), t1, t2);
  double size = 0.;
  for(const auto j : neighbors)
    size = (std::max)(size, (surface.point(j) - center).cwiseAbs().maxCoeff());
  const auto for_each_place = [&](const auto& f)
  {
    for(const auto j : neighbors)
    {
      const Eigen::Vector3d d = (surface.point(j) - center) / size;
      f(t1.dot(d), t2.dot(d));
    }
  };
  double p = 0., q = 0., r = 0.;
  for_each_place(
      [&](const double x, const double y)
      {
        p += x * x;
        q += x * y;
        r += y * y;
      });
  return determinant(p, q, r) < wide * (p + r) * (p + r) && are_on_curve(for_each_place);
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_ARE_ON_CURVE_H
