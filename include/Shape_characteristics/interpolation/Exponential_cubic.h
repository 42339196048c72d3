#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_EXPONENTIAL_CUBIC_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_EXPONENTIAL_CUBIC_H

#include <Shape_characteristics/interpolation/internal/Shape_parameter.h>
#include <Shape_characteristics/interpolation/internal/power_of_root.h>

#include <array>
#include <cmath>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsInterpolation

  is the exponential of the cubed distance \f$ \phi(r) = \exp(-\varepsilon r^3) \f$.

  It is the basis function that the thesis uses with a shape parameter (section 8.1.1). The parameter
  multiplies the cube of the distance (it is not inside of it), so it scales as 1/length<sup>3</sup>.
  Fits that are given none choose the thesis's: a mean edge length over the cubed side of a box. In the thesis it depends on the
  unit of length; here both lengths are in units of that side, so that it doesn't, but is larger than it was for the thesis's
  data. On the level sets of its chapter 8 some 1e-3, in units of a neighborhood's size, is more accurate.

  The function is not positive definite, and only three times differentiable at the origin: what
  `radial_derivatives()` defines there as 0 are terms whose limits depend on the direction of approach.

  Construction with a shape parameter that is not finite and positive throws `std::invalid_argument`.

  \cgalModels{RadialBasisFunction}
*/
class Exponential_cubic : public internal::Shape_parameter<Exponential_cubic>
{
public:
  static constexpr bool is_positive_definite = false;

  using internal::Shape_parameter<Exponential_cubic>::Shape_parameter;

  /// returns \f$ \phi(r) \f$.
  double operator()(double r) const noexcept { return std::exp(-epsilon * r * r * r); }

  /// returns \f$ \phi'(r) \f$.
  double first_derivative(double r) const noexcept
  {
    const double phi = (*this)(r);
    return phi == 0 ? 0 : -3 * epsilon * r * r * phi;
  }

  /// returns \f$ \phi''(r) \f$.
  double second_derivative(double r) const noexcept
  {
    const double w = epsilon * r * r * r, phi = std::exp(-w);
    return phi == 0 ? 0 : 3 * epsilon * r * (3 * w - 2) * phi;
  }

  /// returns \f$ \phi'''(r) \f$.
  double third_derivative(double r) const noexcept
  {
    const double w = epsilon * r * r * r, phi = std::exp(-w);
    return phi == 0 ? 0 : 3 * epsilon * (-2 + w * (18 - 9 * w)) * phi;
  }

  /// returns \f$ (2\,d/dq)^k \phi \f$ for \f$ k = 0 \dots 3 \f$ at \f$ q = r^2 \f$.
  std::array<double, 4> radial_derivatives(double q) const noexcept
  {
    const double r = std::sqrt(q), w = epsilon * q * r, phi = std::exp(-w);
    if(phi == 0) // far away, where the other factors may overflow
      return {0, 0, 0, 0};
    const double factor = 3 * epsilon * phi;
    if(q < internal::coincidence_bound)
      return {phi, -factor * r, 0, 0};
    const double inverse = 1 / r;
    return {phi, -factor * r, factor * inverse * (3 * w - 1),
            factor * inverse * inverse * inverse * (1 + 9 * w * (1 - w))};
  }
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_EXPONENTIAL_CUBIC_H
