#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INVERSE_MULTIQUADRIC_CUBIC_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INVERSE_MULTIQUADRIC_CUBIC_H

#include <Shape_characteristics/interpolation/internal/Shape_parameter.h>
#include <Shape_characteristics/interpolation/internal/power_of_root.h>

#include <array>
#include <cmath>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsInterpolation

  is the inverse multiquadric of the cubed distance \f$ \phi(r) = \frac{1}{\sqrt{1 + (\varepsilon r)^3}} \f$.

  It is the variant that the thesis's Table 8.7 compares. It is not positive definite, and only three
  times differentiable at the origin: what `radial_derivatives()` defines there as 0 are terms whose
  limits depend on the direction of approach.

  Construction with a shape parameter that is not finite and positive throws `std::invalid_argument`.

  \cgalModels{RadialBasisFunction}
*/
class Inverse_multiquadric_cubic : public internal::Shape_parameter<Inverse_multiquadric_cubic>
{
public:
  static constexpr bool is_positive_definite = false;

  using internal::Shape_parameter<Inverse_multiquadric_cubic>::Shape_parameter;

  /// returns \f$ \phi(r) \f$.
  double operator()(double r) const noexcept
  {
    const double a = epsilon * r;
    return 1 / std::sqrt(1 + a * a * a);
  }

  /// returns \f$ \phi'(r) \f$.
  double first_derivative(double r) const noexcept
  {
    const double a = epsilon * r, inverse = 1 / (1 + a * a * a);
    return -1.5 * epsilon * a * (a * inverse) * std::sqrt(inverse);
  }

  /// returns \f$ \phi''(r) \f$.
  double second_derivative(double r) const noexcept
  {
    const double a = epsilon * r, inverse = 1 / (1 + a * a * a);
    return -1.5 * epsilon * epsilon * (a * inverse) * std::sqrt(inverse) * (4.5 * inverse - 2.5);
  }

  /// returns \f$ \phi'''(r) \f$.
  double third_derivative(double r) const noexcept
  {
    const double a = epsilon * r, inverse = 1 / (1 + a * a * a);
    return -1.5 * epsilon * epsilon * epsilon * inverse * std::sqrt(inverse) *
           (8.75 + inverse * (33.75 * inverse - 40.5));
  }

  /// returns \f$ (2\,d/dq)^k \phi \f$ for \f$ k = 0 \dots 3 \f$ at \f$ q = r^2 \f$.
  std::array<double, 4> radial_derivatives(double q) const noexcept
  {
    const double r = std::sqrt(q), e2 = epsilon * epsilon, a = epsilon * r;
    const double inverse = 1 / (1 + e2 * q * a);
    if(inverse == 0) // far away, where the other factors may overflow
      return {0, 0, 0, 0};
    const double phi = std::sqrt(inverse), factor = -1.5 * e2 * inverse * phi;
    if(q < internal::coincidence_bound)
      return {phi, factor * a, 0, 0};
    const double reciprocal = epsilon / r; // (1 + w)^-1 stands for w: no power of w can overflow
    return {phi, factor * a, factor * reciprocal * (4.5 * inverse - 3.5),
            factor * reciprocal / q * (19.25 + inverse * (33.75 * inverse - 54))};
  }
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INVERSE_MULTIQUADRIC_CUBIC_H
