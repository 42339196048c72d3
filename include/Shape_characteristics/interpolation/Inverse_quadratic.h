#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INVERSE_QUADRATIC_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INVERSE_QUADRATIC_H

#include <Shape_characteristics/interpolation/internal/Shape_parameter.h>

#include <array>
#include <cmath>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsInterpolation

  is the inverse quadratic \f$ \phi(r) = \frac{1}{1 + (\varepsilon r)^2} \f$.

  It is the third function of the thesis's Table 3.1: infinitely smooth and strictly positive definite on
  every space.

  Construction with a shape parameter that is not finite and positive throws `std::invalid_argument`.

  \cgalModels{RadialBasisFunction}
*/
class Inverse_quadratic : public internal::Shape_parameter<Inverse_quadratic>
{
public:
  static constexpr bool is_positive_definite = true;

  using internal::Shape_parameter<Inverse_quadratic>::Shape_parameter;

  /// returns \f$ \phi(r) \f$.
  double operator()(double r) const noexcept { return 1 / (1 + (epsilon * r) * (epsilon * r)); }

  /// returns \f$ \phi'(r) \f$.
  double first_derivative(double r) const noexcept
  {
    const double phi = (*this)(r);
    return -2 * epsilon * (epsilon * r * phi) * phi;
  }

  /// returns \f$ \phi''(r) \f$.
  double second_derivative(double r) const noexcept
  {
    const double phi = (*this)(r);
    return 2 * epsilon * epsilon * phi * phi * (3 - 4 * phi);
  }

  /// returns \f$ \phi'''(r) \f$.
  double third_derivative(double r) const noexcept
  {
    const double phi = (*this)(r);
    return 24 * epsilon * epsilon * epsilon * (epsilon * r * phi) * phi * phi * (2 * phi - 1);
  }

  /// returns \f$ (2\,d/dq)^k \phi \f$ for \f$ k = 0 \dots 3 \f$ at \f$ q = r^2 \f$.
  std::array<double, 4> radial_derivatives(double q) const noexcept
  {
    const double e2 = epsilon * epsilon, phi = 1 / (1 + e2 * q);
    const double factor = e2 * phi;
    const double first = -2 * factor * phi, second = -4 * factor * first;
    return {phi, first, second, -6 * factor * second};
  }
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INVERSE_QUADRATIC_H
