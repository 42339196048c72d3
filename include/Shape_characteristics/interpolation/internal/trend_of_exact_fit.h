#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_TREND_OF_EXACT_FIT_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_TREND_OF_EXACT_FIT_H

#include <Shape_characteristics/internal/Scaled_neighborhood.h>
#include <Shape_characteristics/internal/tangent_basis.h>
#include <Shape_characteristics/interpolation/internal/Height_polynomial.h>
#include <Shape_characteristics/interpolation/internal/Height_polynomial_fit.h>
#include <Shape_characteristics/interpolation/internal/Hermite_trend.h>

#include <Eigen/Core>
#include <Eigen/QR>

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

  This is plain Eigen; Hermite_batch_solver does the same side by side.
*/
inline Hermite_trend trend_of_exact_fit(const Scaled_neighborhood& neighborhood, double unit)
{
  constexpr Eigen::Index size = Eigen::Index(Height_polynomial<double>::size);
  const std::size_t number_of_points = neighborhood.points.size();
  Hermite_trend trend(neighborhood.normals[0]);
  tangent_basis(trend.w, trend.u, trend.v);

  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(3 * Eigen::Index(number_of_points - 1) + size, size);
  Eigen::VectorXd data = Eigen::VectorXd::Zero(rows.rows());
  Eigen::Index row = 0;
  for(std::size_t i = 1; i < number_of_points; ++i, row += 3)
  {
    const Eigen::Vector3d &p = neighborhood.points[i], &n = neighborhood.normals[i];
    const double x = trend.u.dot(p), y = trend.v.dot(p), weight = trend.w.dot(n);
    data.segment<3>(row) << weight * trend.w.dot(p), -trend.u.dot(n), -trend.v.dot(n);
    for(Eigen::Index k = 0; k < size; ++k)
    {
      Height_polynomial<double> monomial;
      monomial.c[k] = weight;
      monomial.value(x, y, rows(row, k));
      monomial.gradient(x, y, rows(row + 1, k), rows(row + 2, k));
    }
  }
  for(Eigen::Index k = 0; k < size; ++k)
    rows(row + k, k) =
        std::pow(unit, k < 3 ? 3. : (k < 7 ? 2. : 1.)) / std::sqrt(Height_polynomial<double>::binomials[k]);
  Eigen::Map<Eigen::VectorXd>(trend.height.c, size) = rows.householderQr().solve(data);

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
