#ifndef SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_SHAPE_OPERATOR_H
#define SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_SHAPE_OPERATOR_H

#include <Shape_characteristics/internal/Shape_operator_eigen.h>
#include <Shape_characteristics/internal/determinant.h>
#include <Shape_characteristics/internal/tangent_basis.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace Shape_characteristics {
namespace internal {

// length without overflow or underflow, at the price of the plain one in the usual range
inline double safe_norm(const Eigen::Vector3d& v) noexcept
{
  const double square = v.squaredNorm();
  if(square > 1e-280 && square < 1e280)
    return std::sqrt(square);
  const double largest = v.cwiseAbs().maxCoeff();
  // a second division: 1 / largest may overflow
  return largest > 0 && std::isfinite(largest) ? largest * (v / largest).norm() : largest;
}

// a power of two by which the entries of a shape operator are divided so that their products neither overflow nor vanish
inline int exponent_of_shape_operator(double& l, double& m, double& n) noexcept
{
  const double largest = (std::max)((std::max)(std::abs(l), std::abs(m)), std::abs(n));
  int exponent = 0;
  if(largest > 1e100 || (largest < 1e-100 && largest > 0))
  {
    std::frexp(largest, &exponent);
    l = std::ldexp(l, -exponent);
    m = std::ldexp(m, -exponent);
    n = std::ldexp(n, -exponent);
  }
  return exponent;
}

// The eigenvalues of the shape operator [l m; m n], the smaller one first. Their difference has full relative accuracy, and
// so has the smaller one in magnitude: neither is the result of a cancellation, in contrast to K_H +- sqrt(K_H^2 - K_G).
inline std::pair<double, double> eigenvalues_of_shape_operator(double l, double m, double n) noexcept
{
  const int exponent = exponent_of_shape_operator(l, m, n);
  const double mean = 0.5 * (l + n), delta = 0.5 * (l - n);
  const double radius = std::sqrt(delta * delta + m * m);
  // The larger one in magnitude is a sum, the other one a difference, or a quotient where that would cancel. Both are
  // computed: which one it is can't be foreseen.
  const double large = mean + std::copysign(radius, mean);
  const double others[] = {mean - std::copysign(radius, mean),
                           determinant(l, m, n) / (large != 0. ? large : 1.)};
  const double other = others[radius > 0.5 * std::abs(mean) && mean != 0.];
  const double k_min = (std::min)(other, large), k_max = (std::max)(other, large);
  if(exponent != 0)
    return {std::ldexp(k_min, exponent), std::ldexp(k_max, exponent)};
  return {k_min, k_max};
}

// Eigenvalues and directions of the shape operator [l m; m n] given in the orthonormal tangent basis t1, t2 (convex
// positive: l is the normal curvature in the direction of t1). `normal` is the unit normal.
inline Shape_operator_eigen eigen_of_shape_operator(const Eigen::Vector3d& normal,
                                                    double l,
                                                    double m,
                                                    double n,
                                                    const Eigen::Vector3d& t1,
                                                    const Eigen::Vector3d& t2) noexcept
{
  Shape_operator_eigen result;
  if(!(std::isfinite(l) && std::isfinite(m) && std::isfinite(n)))
    return result;

  std::tie(result.min_curvature, result.max_curvature) = eigenvalues_of_shape_operator(l, m, n);
  exponent_of_shape_operator(l, m, n);
  double delta = 0.5 * (l - n), minus_delta = -delta;
  // the curvatures' difference may be of another size than they are
  exponent_of_shape_operator(delta, m, minus_delta);
  const double radius = std::sqrt(delta * delta + m * m);

  // (radius + delta, m) and (m, radius - delta) are parallel; take the one that is the sum of two positive terms
  const double along = radius > 0 ? radius + std::abs(delta) : 1., across = m;
  const double length = std::sqrt(along * along + across * across);
  const double unit[] = {along / length, across / length};
  const double c = unit[delta < 0], s = unit[delta >= 0];
  result.max_direction = c * t1 + s * t2;
  result.min_direction = normal.cross(result.max_direction);
  return result;
}

// The same from the second fundamental form in a tangent basis t1, t2 that need not be orthonormal: L = x_11 . normal,
// M = x_12 . normal, N = x_22 . normal for the second derivatives of the surface (so a sphere with outward normal has
// negative L and N). NaN if t1 and t2 are parallel or zero.
inline Shape_operator_eigen eigen_of_second_fundamental_form(const Eigen::Vector3d& normal,
                                                             double L,
                                                             double M,
                                                             double N,
                                                             const Eigen::Vector3d& t1,
                                                             const Eigen::Vector3d& t2) noexcept
{
  const double length_1 = safe_norm(t1), length_2 = safe_norm(t2);
  if(!(length_1 > 0 && length_2 > 0 && std::isfinite(length_1) && std::isfinite(length_2)))
    return {};
  // t1 / |t1| = e1; t2 / |t2| = b e1 + c e2
  const Eigen::Vector3d e1 = t1 / length_1, unit_2 = t2 / length_2;
  const double b = e1.dot(unit_2);
  Eigen::Vector3d e2 = normal.cross(e1);
  double c = e2.dot(unit_2);
  if(c < 0)
  {
    e2 = -e2;
    c = -c;
  }
  if(!(c > std::numeric_limits<double>::epsilon()))
    return {};
  const double l = -L / length_1 / length_1;
  const double m = -M / length_1 / length_2;
  const double n = -N / length_2 / length_2;
  const double off_diagonal = (m - b * l) / c;
  return eigen_of_shape_operator(normal, l, off_diagonal, (n - b * (b * l + 2 * c * off_diagonal)) / (c * c),
                                 e1, e2);
}

// Curvatures of the level set of a function with the given gradient, which is outward, and Hessian matrix
// (the thesis's 4.3.1): the eigenvalues of P^T H P / |gradient| with a tangent basis P. Only the upper triangle of the
// Hessian matrix is read. NaN if the gradient is zero, or anything is not finite.
inline Shape_operator_eigen curvatures_of_implicit(const Eigen::Vector3d& gradient,
                                                   const Eigen::Matrix3d& hessian) noexcept
{
  const double length = safe_norm(gradient);
  if(!(length > 0 && std::isfinite(length)))
    return {};
  const Eigen::Vector3d normal = gradient / length;
  Eigen::Vector3d t1, t2;
  tangent_basis(normal, t1, t2);

  const double xx = hessian(0, 0) / length, xy = hessian(0, 1) / length, xz = hessian(0, 2) / length,
               yy = hessian(1, 1) / length, yz = hessian(1, 2) / length, zz = hessian(2, 2) / length;
  const auto image = [=](const Eigen::Vector3d& t)
  {
    return Eigen::Vector3d(xx * t.x() + xy * t.y() + xz * t.z(), xy * t.x() + yy * t.y() + yz * t.z(),
                           xz * t.x() + yz * t.y() + zz * t.z());
  };
  const Eigen::Vector3d image_1 = image(t1), image_2 = image(t2);
  return eigen_of_shape_operator(normal, t1.dot(image_1), t1.dot(image_2), t2.dot(image_2), t1, t2);
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_SHAPE_OPERATOR_H
