#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_TREND_OF_EXACT_FIT_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_TREND_OF_EXACT_FIT_H

#include <Shape_characteristics/internal/Scaled_neighborhood.h>
#include <Shape_characteristics/internal/solve_positive_semidefinite.h>
#include <Shape_characteristics/internal/tangent_basis.h>
#include <Shape_characteristics/interpolation/internal/Height_polynomial.h>
#include <Shape_characteristics/interpolation/internal/Height_polynomial_fit.h>
#include <Shape_characteristics/interpolation/internal/Hermite_trend.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace Shape_characteristics {
namespace internal {

/*
  The trend of a fit to exact normals: the plane through the sample, bent by a polynomial where the polynomial leaves
  so little that it can be said to be known.

  A flat basis function needs large weights of opposite signs to follow a polynomial, and loses as many digits. Where samples are
  close, a polynomial is nearly all that there is.

  This is plain Eigen; Hermite_function_on_lanes does the same side by side. `Neighborhood` is Scaled_neighborhood; a template, so
  that it is compiled where it is used alone.
*/
template <typename Neighborhood>
Hermite_trend trend_of_exact_fit(const Neighborhood& neighborhood, double unit)
{
  constexpr Eigen::Index size = Eigen::Index(Height_polynomial<double>::size);
  const std::size_t number_of_points = neighborhood.points.size();
  Hermite_trend trend(neighborhood.normals[0]);
  tangent_basis(trend.w, trend.u, trend.v);

  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size); // normal equations
  Eigen::VectorXd right = Eigen::VectorXd::Zero(size), rows[3];
  rows[0] = rows[1] = rows[2] = right;
  for(std::size_t i = 1; i < number_of_points; ++i)
  {
    const Eigen::Vector3d &p = neighborhood.points[i], &n = neighborhood.normals[i];
    const double x = trend.u.dot(p), y = trend.v.dot(p), weight = trend.w.dot(n);
    const double data[3] = {weight * trend.w.dot(p), -trend.u.dot(n), -trend.v.dot(n)};
    for(Eigen::Index k = 0; k < size; ++k)
    {
      Height_polynomial<double> monomial;
      monomial.c[k] = weight;
      monomial.value(x, y, rows[0][k]);
      monomial.gradient(x, y, rows[1][k], rows[2][k]);
    }
    for(int k = 0; k < 3; ++k)
    {
      matrix += rows[k] * rows[k].transpose();
      right += data[k] * rows[k];
    }
  }
  for(Eigen::Index k = 0; k < size; ++k)
    matrix(k, k) += std::pow(unit, k < 3 ? 6. : (k < 7 ? 4. : 2.)) / Height_polynomial<double>::binomials[k];
  Eigen::Map<Eigen::VectorXd>(trend.height.c, size) = solve_positive_semidefinite(matrix, right);

  double square = 0.;
  for(std::size_t i = 1; i < number_of_points; ++i)
  {
    const Eigen::Vector3d gradient = trend(neighborhood.points[i]).gradient, &n = neighborhood.normals[i];
    square += (gradient - gradient.dot(n) * n).squaredNorm();
  }
  const double remainder = Height_polynomial_fit<double>::usual_remainder * (unit * unit * unit);
  const double excess = square / (2. * double(number_of_points - 1) * remainder * remainder);
  const double part = (std::min)((4. - excess) / 3., 1.);
  for(double& c : trend.height.c)
    c = part > 0. ? part * c : 0.;
  return trend;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_TREND_OF_EXACT_FIT_H
