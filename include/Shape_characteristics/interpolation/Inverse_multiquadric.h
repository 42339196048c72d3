#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INVERSE_MULTIQUADRIC_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INVERSE_MULTIQUADRIC_H

#include <Shape_characteristics/interpolation/internal/Shape_parameter.h>

#include <array>
#include <cmath>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsInterpolation

  is the inverse multiquadric \f$ \phi(r) = \frac{1}{\sqrt{1 + (\varepsilon r)^2}} \f$.

  It is the fourth function of the thesis's Table 3.1: infinitely smooth and strictly positive definite on
  every space. With a shape parameter in units of the neighborhood's size it is the most accurate one for
  exact Hermite data.

  Construction with a shape parameter that is not finite and positive throws `std::invalid_argument`.

  \cgalModels{RadialBasisFunction}
*/
class Inverse_multiquadric : public internal::Shape_parameter<Inverse_multiquadric>
{
public:
  static constexpr bool is_positive_definite = true;

  using internal::Shape_parameter<Inverse_multiquadric>::Shape_parameter;

  /// returns \f$ \phi(r) \f$.
  double operator()(double r) const noexcept { return 1 / std::hypot(1., epsilon * r); }

  /// returns \f$ \phi'(r) \f$.
  double first_derivative(double r) const noexcept
  {
    const double a = epsilon * r, phi = 1 / std::hypot(1., a);
    return -epsilon * (a * phi) * phi * phi;
  }

  /// returns \f$ \phi''(r) \f$.
  double second_derivative(double r) const noexcept
  {
    const double phi = (*this)(r), square = phi * phi;
    return epsilon * epsilon * phi * square * (2 - 3 * square);
  }

  /// returns \f$ \phi'''(r) \f$.
  double third_derivative(double r) const noexcept
  {
    const double a = epsilon * r, phi = 1 / std::hypot(1., a), square = phi * phi;
    return epsilon * epsilon * epsilon * (a * phi) * square * square * (15 * square - 6);
  }

  /// returns \f$ (2\,d/dq)^k \phi \f$ for \f$ k = 0 \dots 3 \f$ at \f$ q = r^2 \f$.
  std::array<double, 4> radial_derivatives(double q) const noexcept
  {
    const double e2 = epsilon * epsilon, square = 1 / (1 + e2 * q);
    const double phi = std::sqrt(square), factor = -e2 * square;
    const double first = factor * phi, second = 3 * factor * first;
    return {phi, first, second, 5 * factor * second};
  }
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INVERSE_MULTIQUADRIC_H
