#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_EXACT_CURVATURE_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_EXACT_CURVATURE_H

#include "Triangle_arrays.h"

#include <cmath>
#include <utility>

namespace benchmark_support {

/// The truth at a point of a surface. Curvatures are positive where the surface is convex seen along the
/// outward normal.
struct Exact_curvature
{
  Vector normal{};
  double k_min = 0.;
  double k_max = 0.;
  Vector d_min{}; ///< unit direction of k_min; any tangent direction at an umbilic
  Vector d_max{}; ///< unit direction of k_max, with d_min and the normal an orthogonal triple

  double mean() const { return .5 * (k_min + k_max); }
  double gaussian() const { return k_min * k_max; }
};

/// Any two unit vectors that make an orthogonal triple with the unit vector `normal`.
inline std::pair<Vector, Vector> tangents(const Vector& normal)
{
  // the axis farthest from the normal keeps the cross product long
  Vector axis{};
  const Vector a{std::abs(normal[0]), std::abs(normal[1]), std::abs(normal[2])};
  axis[a[0] <= a[1] && a[0] <= a[2] ? 0 : (a[1] <= a[2] ? 1 : 2)] = 1.;
  const Vector s = normalized(cross(normal, axis));
  return {s, cross(normal, s)};
}

/// The curvature of the level set of a function F at a point where F has this gradient (outward, not zero) and
/// this Hessian: the eigenvalues of the shape operator, the Hessian on the tangent plane over the length of the
/// gradient.
inline Exact_curvature exact_curvature(const Vector& gradient, const Symmetric_matrix& hessian)
{
  Exact_curvature result;
  const double g = length(gradient);
  result.normal = (1. / g) * gradient;
  const auto [s, t] = tangents(result.normal);
  const double ss = dot(s, multiply(hessian, s)) / g;
  const double st = dot(s, multiply(hessian, t)) / g;
  const double tt = dot(t, multiply(hessian, t)) / g;

  // one Jacobi rotation diagonalizes a 2x2 matrix
  const double angle = .5 * std::atan2(2. * st, ss - tt);
  const double c = std::cos(angle), d = std::sin(angle);
  result.d_max = c * s + d * t;
  result.d_min = c * t - d * s;
  const double half = .5 * std::hypot(ss - tt, 2. * st);
  result.k_max = .5 * (ss + tt) + half;
  result.k_min = .5 * (ss + tt) - half;
  return result;
}

} // namespace benchmark_support

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_EXACT_CURVATURE_H
