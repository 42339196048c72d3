#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_POLYHARMONIC_LOGARITHMIC_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_POLYHARMONIC_LOGARITHMIC_H

#include <Shape_characteristics/interpolation/internal/power_of_root.h>

#include <array>
#include <cmath>
#include <limits>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsInterpolation

  is the polyharmonic spline \f$ \phi(r) = r^t \ln r, t = 2, 4, 6, \dots \f$.

  It is the sixth function of the thesis's Table 3.1 (the thin plate spline for \f$ t = 2 \f$), and has no
  shape parameter. It is conditionally positive definite of order \f$ t / 2 + 1 \f$ only (up to its sign).

  For odd `t` the class compiles with `is_valid` being `false`, so that the exponent can be rejected where
  it is used: functions that use it throw `std::invalid_argument`.

  The derivatives of order \f$ t \f$ and higher are infinite at the origin: the second one of \f$ r^2 \ln
  r \f$ is \f$ -\infty \f$, the third one \f$ +\infty \f$. `radial_derivatives()` at \f$ q = 0 \f$ are all
  0: those of order \f$ k < t / 2 \f$ as limits, the others, which are infinite, by definition.

  \cgalModels{RadialBasisFunction}
*/
template <int t>
class Polyharmonic_logarithmic
{
  static_assert(t >= 1, "Polyharmonic_logarithmic: the exponent t must be positive");

public:
  static constexpr bool is_positive_definite = false;
  static constexpr bool has_shape_parameter = false;
  static constexpr bool is_valid = t % 2 == 0;

  /// returns \f$ \phi(r) \f$.
  double operator()(double r) const noexcept { return r == 0 ? 0 : internal::power<t>(r) * std::log(r); }

  /// returns \f$ \phi'(r) \f$.
  double first_derivative(double r) const noexcept
  {
    return r == 0 ? limit_at_0<1>() : internal::power<t - 1>(r) * (t * std::log(r) + 1);
  }

  /// returns \f$ \phi''(r) \f$.
  double second_derivative(double r) const noexcept
  {
    return r == 0 ? limit_at_0<2>() : internal::power<t - 2>(r) * (t * (t - 1) * std::log(r) + (2 * t - 1));
  }

  /// returns \f$ \phi'''(r) \f$.
  double third_derivative(double r) const noexcept
  {
    return r == 0
               ? limit_at_0<3>()
               : internal::power<t - 3>(r) * (t * (t - 1) * (t - 2) * std::log(r) + (3 * t * t - 6 * t + 2));
  }

  /// returns \f$ (2\,d/dq)^k \phi \f$ for \f$ k = 0 \dots 3 \f$ at \f$ q = r^2 \f$.
  std::array<double, 4> radial_derivatives(double q) const noexcept
  {
    if(q < internal::coincidence_bound)
      return {0, 0, 0, 0};
    const double r = t % 2 == 1 ? std::sqrt(q) : 0, logarithm = std::log(q) / 2;
    // (1/r) d/dr takes r^s (a ln r + b) to r^(s-2) (s a ln r + s b + a)
    constexpr double a1 = t, b1 = 1, a2 = a1 * (t - 2), b2 = b1 * (t - 2) + a1, a3 = a2 * (t - 4),
                     b3 = b2 * (t - 4) + a2;
    return {internal::power_of_root<t>(r, q) * logarithm,
            internal::power_of_root<t - 2>(r, q) * (a1 * logarithm + b1),
            internal::power_of_root<t - 4>(r, q) * (a2 * logarithm + b2),
            internal::power_of_root<t - 6>(r, q) * (a3 * logarithm + b3)};
  }

private:
  template <int order>
  static double limit_at_0() noexcept
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    // of order t: t! ln r; of higher orders: alternating sign, beginning with +
    return order < t ? 0 : order == t ? -infinity : (order - t) % 2 == 1 ? infinity : -infinity;
  }
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_POLYHARMONIC_LOGARITHMIC_H
