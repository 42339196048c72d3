#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_MATERN_9_2_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_MATERN_9_2_H

#include <Shape_characteristics/interpolation/internal/Shape_parameter.h>

#include <array>
#include <cmath>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsInterpolation

  is the Matérn function of smoothness 9/2, \f$ \phi(r) = \left(1 + a + \frac{3}{7} a^2 + \frac{2}{21} a^3 + \frac{1}{105} a^4\right) e^{-a},\ a = \varepsilon r \f$.

  It is eight times continuously differentiable and strictly positive definite on every space (Rasmussen
  and Williams, Gaussian Processes for Machine Learning, 2006, section 4.2.1; their argument is \f$ a = 3
  r / \ell \f$). As the covariance of a random surface it is the choice for inexact Hermite data.

  Its derivatives by \f$ q \f$ are Matérn functions of smoothness 7/2, 5/2 and 3/2, all finite at the
  origin.

  Construction with a shape parameter that is not finite and positive throws `std::invalid_argument`.

  \cgalModels{RadialBasisFunction}
*/
class Matern_9_2 : public internal::Shape_parameter<Matern_9_2>
{
public:
  static constexpr bool is_positive_definite = true;

  using internal::Shape_parameter<Matern_9_2>::Shape_parameter;

  /// returns \f$ \phi(r) \f$.
  double operator()(double r) const noexcept
  {
    const double a = epsilon * r, e = std::exp(-a);
    return e == 0 ? 0 : (1 + a * (1 + a * (3. / 7 + a * (2. / 21 + a * (1. / 105))))) * e;
  }

  /// returns \f$ \phi'(r) \f$.
  double first_derivative(double r) const noexcept
  {
    const double a = epsilon * r, e = std::exp(-a);
    return e == 0 ? 0 : -(epsilon / 7) * a * (1 + a * (1 + a * (2. / 5 + a * (1. / 15)))) * e;
  }

  /// returns \f$ \phi''(r) \f$.
  double second_derivative(double r) const noexcept
  {
    const double a = epsilon * r, e = std::exp(-a);
    return e == 0 ? 0 : (epsilon * epsilon / 105) * (-15 + a * (-15 + a * (-3 + a * (2 + a)))) * e;
  }

  /// returns \f$ \phi'''(r) \f$.
  double third_derivative(double r) const noexcept
  {
    const double a = epsilon * r, e = std::exp(-a);
    return e == 0 ? 0 : (epsilon * epsilon * epsilon / 105) * a * (9 + a * (9 + a * (2 - a))) * e;
  }

  /// returns \f$ (2\,d/dq)^k \phi \f$ for \f$ k = 0 \dots 3 \f$ at \f$ q = r^2 \f$.
  std::array<double, 4> radial_derivatives(double q) const noexcept
  {
    const double a = epsilon * std::sqrt(q), e = std::exp(-a);
    if(e == 0) // far away, where the polynomials may overflow
      return {0, 0, 0, 0};
    const double e2 = epsilon * epsilon;
    return {(1 + a * (1 + a * (3. / 7 + a * (2. / 21 + a * (1. / 105))))) * e,
            -(e2 / 7) * (1 + a * (1 + a * (2. / 5 + a * (1. / 15)))) * e,
            (e2 * e2 / 35) * (1 + a * (1 + a * (1. / 3))) * e, -(e2 * e2 * e2 / 105) * (1 + a) * e};
  }
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_MATERN_9_2_H
