#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_POLYHARMONIC_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_POLYHARMONIC_H

#include <Shape_characteristics/interpolation/internal/power_of_root.h>

#include <array>
#include <cmath>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsInterpolation

  is the polyharmonic spline \f$ \phi(r) = r^t, t = 1, 3, 5, \dots \f$.

  It is the fifth function of the thesis's Table 3.1, and has no shape parameter. It is conditionally
  positive definite of order \f$ (t + 1) / 2 \f$ only (up to its sign): a system for Hermite data needs a
  pivoting solver, and \f$ t \geq 3 \f$.

  For even `t` the function is a polynomial, whose matrices are singular. The class compiles then, with
  `is_valid` being `false`, so that the exponent can be rejected where it is used: functions that use it
  throw `std::invalid_argument`.

  `radial_derivatives()` at \f$ q = 0 \f$ are all 0: for \f$ t \geq 7 \f$ as limits, else by definition.
  With \f$ t = 3 \f$ this defines the third derivatives at the center, which depend on the direction of
  approach and are odd, as 0; with \f$ t = 1 \f$ the gradient as well.

  \cgalModels{RadialBasisFunction}
*/
template <int t>
class Polyharmonic
{
  static_assert(t >= 1, "Polyharmonic: the exponent t must be positive");

public:
  static constexpr bool is_positive_definite = false;
  static constexpr bool has_shape_parameter = false;
  static constexpr bool is_valid = t % 2 == 1;

  /// returns \f$ \phi(r) \f$.
  double operator()(double r) const noexcept { return internal::power<t>(r); }

  /// returns \f$ \phi'(r) \f$.
  double first_derivative(double r) const noexcept { return t * internal::power<t - 1>(r); }

  /// returns \f$ \phi''(r) \f$.
  double second_derivative(double r) const noexcept
  {
    if constexpr(t < 2)
      return 0;
    else
      return t * (t - 1) * internal::power<t - 2>(r);
  }

  /// returns \f$ \phi'''(r) \f$.
  double third_derivative(double r) const noexcept
  {
    if constexpr(t < 3)
      return 0;
    else
      return t * (t - 1) * (t - 2) * internal::power<t - 3>(r);
  }

  /// returns \f$ (2\,d/dq)^k \phi \f$ for \f$ k = 0 \dots 3 \f$ at \f$ q = r^2 \f$.
  std::array<double, 4> radial_derivatives(double q) const noexcept
  {
    const double r = t % 2 == 1 ? std::sqrt(q) : 0;
    return {internal::power_of_root<t>(r, q), term<1>(r, q), term<2>(r, q), term<3>(r, q)};
  }

private:
  template <int k>
  static double term(double r, double q) noexcept
  {
    constexpr int coefficient = k == 1 ? t : k == 2 ? t * (t - 2) : t * (t - 2) * (t - 4);
    if constexpr(coefficient == 0) // even exponents only
      return 0;
    else if constexpr(t < 2 * k)
      return q < internal::coincidence_bound ? 0 : coefficient * internal::power_of_root<t - 2 * k>(r, q);
    else
      return coefficient * internal::power_of_root<t - 2 * k>(r, q);
  }
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_POLYHARMONIC_H
