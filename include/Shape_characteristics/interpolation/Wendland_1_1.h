#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_WENDLAND_1_1_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_WENDLAND_1_1_H

#include <Shape_characteristics/interpolation/internal/Shape_parameter.h>
#include <Shape_characteristics/interpolation/internal/power_of_root.h>

#include <array>
#include <cmath>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsInterpolation

  is the Wendland function \f$ \phi(r) = (1 - \varepsilon r)_+^3 (3 \varepsilon r + 1) \f$.

  It is the last function of the thesis's Table 3.1, there with \f$ \varepsilon = 1 \f$. Its support is
  the ball of radius \f$ 1 / \varepsilon \f$. It is twice continuously differentiable, and positive
  definite on the line only; for Hermite data in space use `Wendland_3_2`.

  What `radial_derivatives()` defines as 0 at the origin are terms whose limits depend on the direction of
  approach. The third derivative jumps to 0 at the end of the support.

  Construction with a shape parameter that is not finite and positive throws `std::invalid_argument`.

  \cgalModels{RadialBasisFunction}
*/
class Wendland_1_1 : public internal::Shape_parameter<Wendland_1_1>
{
public:
  static constexpr bool is_positive_definite = false;

  using internal::Shape_parameter<Wendland_1_1>::Shape_parameter;

  /// returns \f$ \phi(r) \f$.
  double operator()(double r) const noexcept
  {
    const double a = epsilon * r, b = 1 - a;
    return a >= 1 ? 0 : b * b * b * (3 * a + 1);
  }

  /// returns \f$ \phi'(r) \f$.
  double first_derivative(double r) const noexcept
  {
    const double a = epsilon * r, b = 1 - a;
    return a >= 1 ? 0 : -12 * epsilon * a * b * b;
  }

  /// returns \f$ \phi''(r) \f$.
  double second_derivative(double r) const noexcept
  {
    const double a = epsilon * r;
    return a >= 1 ? 0 : 12 * epsilon * epsilon * (1 - a) * (3 * a - 1);
  }

  /// returns \f$ \phi'''(r) \f$.
  double third_derivative(double r) const noexcept
  {
    const double a = epsilon * r;
    return a >= 1 ? 0 : 24 * epsilon * epsilon * epsilon * (2 - 3 * a);
  }

  /// returns \f$ (2\,d/dq)^k \phi \f$ for \f$ k = 0 \dots 3 \f$ at \f$ q = r^2 \f$.
  std::array<double, 4> radial_derivatives(double q) const noexcept
  {
    const double r = std::sqrt(q), a = epsilon * r, b = 1 - a, e2 = epsilon * epsilon;
    if(a >= 1)
      return {0, 0, 0, 0};
    const double value = b * b * b * (3 * a + 1), first = -12 * e2 * b * b;
    if(q < internal::coincidence_bound)
      return {value, first, 0, 0};
    const double factor = 24 * epsilon * e2 / r;
    return {value, first, factor * b, -factor / q};
  }
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_WENDLAND_1_1_H
