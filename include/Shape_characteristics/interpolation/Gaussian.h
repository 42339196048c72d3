#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_GAUSSIAN_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_GAUSSIAN_H

#include <Shape_characteristics/interpolation/internal/Shape_parameter.h>

#include <array>
#include <cmath>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsInterpolation

  is the Gaussian \f$ \phi(r) = \exp(-(\varepsilon r)^2) \f$.

  It is the first function of the thesis's Table 3.1: infinitely smooth and strictly positive definite on
  every space, so that it is fit for Hermite data. Its matrices are the worst conditioned of all basis
  functions here.

  Construction with a shape parameter that is not finite and positive throws `std::invalid_argument`.

  \cgalModels{RadialBasisFunction}
*/
class Gaussian : public internal::Shape_parameter<Gaussian>
{
public:
  static constexpr bool is_positive_definite = true;

  using internal::Shape_parameter<Gaussian>::Shape_parameter;

  /// returns \f$ \phi(r) \f$.
  double operator()(double r) const noexcept { return std::exp(-(epsilon * r) * (epsilon * r)); }

  /// returns \f$ \phi'(r) \f$.
  double first_derivative(double r) const noexcept { return -2 * epsilon * (epsilon * r) * (*this)(r); }

  /// returns \f$ \phi''(r) \f$.
  double second_derivative(double r) const noexcept
  {
    const double a = epsilon * r, phi = (*this)(r);
    return phi == 0 ? 0 : 2 * epsilon * epsilon * (2 * a * a - 1) * phi;
  }

  /// returns \f$ \phi'''(r) \f$.
  double third_derivative(double r) const noexcept
  {
    const double a = epsilon * r, phi = (*this)(r);
    return phi == 0 ? 0 : 4 * epsilon * epsilon * epsilon * a * (3 - 2 * a * a) * phi;
  }

  /// returns \f$ (2\,d/dq)^k \phi \f$ for \f$ k = 0 \dots 3 \f$ at \f$ q = r^2 \f$.
  std::array<double, 4> radial_derivatives(double q) const noexcept
  {
    const double factor = -2 * epsilon * epsilon;
    const double phi = std::exp(-epsilon * epsilon * q);
    return {phi, factor * phi, factor * factor * phi, factor * factor * factor * phi};
  }
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_GAUSSIAN_H
