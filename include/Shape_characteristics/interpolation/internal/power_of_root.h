#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_POWER_OF_ROOT_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_POWER_OF_ROOT_H

namespace Shape_characteristics {
namespace internal {

// x^n by repeated squaring; 1 for n = 0 whatever x is
template <int n>
inline double power(double x) noexcept
{
  if constexpr(n < 0)
    return 1. / power<-n>(x);
  else if constexpr(n == 0)
    return 1.;
  else if constexpr(n % 2 == 1)
    return n == 1 ? x : x * power<n - 1>(x);
  else
  {
    const double half = power<n / 2>(x);
    return half * half;
  }
}

// r^n from r and q = r^2 in the fewest multiplications
template <int n>
inline double power_of_root(double r, double q) noexcept
{
  if constexpr(n < 0)
    return 1. / power_of_root<-n>(r, q);
  else if constexpr(n % 2 == 0)
    return power<n / 2>(q);
  else
    return r * power<(n - 1) / 2>(q);
}

// A squared distance below this one makes r^n with n >= -6 overflow; between points of a neighborhood of size
// about 1 it says that they coincide.
constexpr double coincidence_bound = 1e-100;

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_POWER_OF_ROOT_H
