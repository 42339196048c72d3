#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_MULTIQUADRIC_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_MULTIQUADRIC_H

#include <Shape_characteristics/interpolation/internal/Shape_parameter.h>

#include <array>
#include <cmath>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsInterpolation

  is the multiquadric \f$ \phi(r) = \sqrt{1 + (\varepsilon r)^2} \f$.

  It is the second function of the thesis's Table 3.1: infinitely smooth, growing, and conditionally
  positive definite only. The standard interpolant exists for any distinct points; Hermite data need a
  pivoting solver.

  Construction with a shape parameter that is not finite and positive throws `std::invalid_argument`.

  \cgalModels{RadialBasisFunction}
*/
class Multiquadric : public internal::Shape_parameter<Multiquadric>
{
public:
  static constexpr bool is_positive_definite = false;

  using internal::Shape_parameter<Multiquadric>::Shape_parameter;

  /// returns \f$ \phi(r) \f$.
  double operator()(double r) const noexcept { return std::hypot(1., epsilon * r); }

  /// returns \f$ \phi'(r) \f$.
  double first_derivative(double r) const noexcept
  {
    const double a = epsilon * r;
    return epsilon * (a / std::hypot(1., a));
  }

  /// returns \f$ \phi''(r) \f$.
  double second_derivative(double r) const noexcept
  {
    const double inverse = 1 / std::hypot(1., epsilon * r);
    return epsilon * epsilon * inverse * inverse * inverse;
  }

  /// returns \f$ \phi'''(r) \f$.
  double third_derivative(double r) const noexcept
  {
    const double a = epsilon * r, inverse = 1 / std::hypot(1., a);
    const double square = inverse * inverse;
    return -3 * epsilon * epsilon * epsilon * (a * inverse) * square * square;
  }

  /// returns \f$ (2\,d/dq)^k \phi \f$ for \f$ k = 0 \dots 3 \f$ at \f$ q = r^2 \f$.
  std::array<double, 4> radial_derivatives(double q) const noexcept
  {
    const double e2 = epsilon * epsilon, phi = std::sqrt(1 + e2 * q);
    const double inverse = 1 / phi, square = inverse * inverse;
    const double first = e2 * inverse, second = -e2 * square * first;
    return {phi, first, second, -3 * e2 * square * second};
  }
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_MULTIQUADRIC_H
