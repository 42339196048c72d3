#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_WENDLAND_3_2_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_WENDLAND_3_2_H

#include <Shape_characteristics/interpolation/internal/Shape_parameter.h>
#include <Shape_characteristics/interpolation/internal/power_of_root.h>

#include <array>
#include <cmath>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsInterpolation

  is the Wendland function \f$ \phi(r) = (1 - \varepsilon r)_+^6\, \frac{35 (\varepsilon r)^2 + 18 \varepsilon r + 3}{3} \f$.

  It is four times continuously differentiable and strictly positive definite on \f$ \mathbb{R}^3 \f$, the
  least of Wendland's functions fit for Hermite data in space (Wendland, Piecewise polynomial, positive
  definite and compactly supported radial functions of minimal degree, 1995). Its support is the ball of
  radius \f$ 1 / \varepsilon \f$.

  The last entry of `radial_derivatives()` is unbounded near the origin and defined there as 0; the third
  derivatives of the function in space tend to 0.

  Construction with a shape parameter that is not finite and positive throws `std::invalid_argument`.

  \cgalModels{RadialBasisFunction}
*/
class Wendland_3_2 : public internal::Shape_parameter<Wendland_3_2>
{
public:
  static constexpr bool is_positive_definite = true;

  using internal::Shape_parameter<Wendland_3_2>::Shape_parameter;

  /// returns \f$ \phi(r) \f$.
  double operator()(double r) const noexcept
  {
    const double a = epsilon * r, b = 1 - a;
    return a >= 1 ? 0 : internal::power<6>(b) * (1 + a * (6 + a * (35. / 3)));
  }

  /// returns \f$ \phi'(r) \f$.
  double first_derivative(double r) const noexcept
  {
    const double a = epsilon * r, b = 1 - a;
    return a >= 1 ? 0 : -(56. / 3) * epsilon * a * internal::power<5>(b) * (5 * a + 1);
  }

  /// returns \f$ \phi''(r) \f$.
  double second_derivative(double r) const noexcept
  {
    const double a = epsilon * r, b = 1 - a;
    return a >= 1 ? 0 : (56. / 3) * epsilon * epsilon * internal::power<4>(b) * (a * (35 * a - 4) - 1);
  }

  /// returns \f$ \phi'''(r) \f$.
  double third_derivative(double r) const noexcept
  {
    const double a = epsilon * r, b = 1 - a;
    return a >= 1 ? 0 : 560 * epsilon * epsilon * epsilon * a * b * b * b * (3 - 7 * a);
  }

  /// returns \f$ (2\,d/dq)^k \phi \f$ for \f$ k = 0 \dots 3 \f$ at \f$ q = r^2 \f$.
  std::array<double, 4> radial_derivatives(double q) const noexcept
  {
    const double r = std::sqrt(q), a = epsilon * r, b = 1 - a, e2 = epsilon * epsilon;
    if(a >= 1)
      return {0, 0, 0, 0};
    const double b3 = b * b * b, b5 = b3 * b * b;
    const double third = q < internal::coincidence_bound ? 0 : -2240 * e2 * e2 * b3 * (epsilon / r);
    return {b5 * b * (1 + a * (6 + a * (35. / 3))), -(56. / 3) * e2 * b5 * (5 * a + 1),
            560 * e2 * e2 * b3 * b, third};
  }
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_WENDLAND_3_2_H
