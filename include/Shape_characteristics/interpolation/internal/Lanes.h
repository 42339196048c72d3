#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_LANES_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_LANES_H

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

namespace Shape_characteristics {
namespace internal {

/*
  Numbers that are computed with side by side: the same operation on each, and none sees another. What is written for
  `Lanes<n>` compiles for `double` as well, where the compiler has no vectors, and gives the same bits for each n if the
  processor's multiplication and addition are fused for all of them or for none.

  Functions on lanes are inlined into their caller and so compiled for the caller's instruction set; they take
  references, for how vectors are passed to functions depends on the instruction set, too.
*/
#if defined(__GNUC__)
template <int n>
struct Lanes_of
{
  typedef double type __attribute__((vector_size(n * sizeof(double)), may_alias));
  typedef std::uint64_t bits __attribute__((vector_size(n * sizeof(double)), may_alias));
};
#else
template <int n>
struct Lanes_of;
#endif

template <>
struct Lanes_of<1>
{
  using type = double;
  using bits = std::uint64_t;
};

template <int n>
using Lanes = typename Lanes_of<n>::type;

template <typename V>
constexpr int number_of_lanes = int(sizeof(V) / sizeof(double));

template <typename V>
using Bits_of_lanes = typename Lanes_of<number_of_lanes<V> >::bits;

template <typename V>
[[gnu::always_inline]] inline void set_lanes(V& v, double value)
{
  v = V{} + value;
}

// 1, x, x^2, ...
template <typename V, int n>
[[gnu::always_inline]] inline void set_powers(const V& x, V (&powers)[n])
{
  set_lanes(powers[0], 1.);
  for(int k = 1; k < n; ++k)
    powers[k] = powers[k - 1] * x;
}

template <typename To, typename From>
[[gnu::always_inline]] inline void copy_bits(To& to, const From& from)
{
  static_assert(sizeof(To) == sizeof(From));
  std::memcpy(&to, &from, sizeof(To));
}

// y = 1 / sqrt(x) of normal numbers, to some units in the last place; vectors are divided and rooted much more slowly. The number
// whose exponent is half the negative one is wrong by 3.5 %. With e = 1 - x y^2, the answer is y / sqrt(1 - e): two steps multiply
// y by a parabola that is best for |e| < 0.07 and leaves 3e-5, then by four terms of the binomial series, which leave the rounding.
template <typename V>
[[gnu::always_inline]] inline void inverse_sqrt(const V& x, V& y)
{
  Bits_of_lanes<V> bits;
  copy_bits(bits, x);
  bits = std::uint64_t(0x5fe6eb50c7b537a9) - (bits >> 1);
  copy_bits(y, bits);
  const V first = 1. - x * y * y;
  y = y + y * first * (0.5011 + 0.3755 * first);
  const V second = 1. - x * y * y;
  y = y + y * second * (0.5 + second * (0.375 + 0.3125 * second));
}

// y = exp(x) for x <= 0, to some units in the last place, and 0 below -700
template <typename V>
[[gnu::always_inline]] inline void exp_of_negative(const V& x, V& y)
{
  constexpr double shift = 6755399441055744.; // 1.5 * 2^52: what is added to it is rounded to an integer
  constexpr double log2_high = 0x1.62e42fefap-1, log2_low = 0x1.cf79abc9e3b3ap-40;
  const V rounded = x * 1.4426950408889634 + shift;
  const V k = rounded - shift;
  const V r = (x - k * log2_high) - k * log2_low;
  V p;
  set_lanes(p, 1. / 6227020800.); // Taylor's series: |r| < 0.35
  p = p * r + 1. / 479001600.;
  p = p * r + 1. / 39916800.;
  p = p * r + 1. / 3628800.;
  p = p * r + 1. / 362880.;
  p = p * r + 1. / 40320.;
  p = p * r + 1. / 5040.;
  p = p * r + 1. / 720.;
  p = p * r + 1. / 120.;
  p = p * r + 1. / 24.;
  p = p * r + 1. / 6.;
  p = p * r + 0.5;
  p = p * r + 1.;
  p = p * r + 1.;
  Bits_of_lanes<V> exponent, bits;
  copy_bits(exponent, rounded);
  copy_bits(bits, p);
  bits = bits + (exponent << 52); // the low bits of `rounded` are those of k
  copy_bits(y, bits);
  y = x < -700. ? V{} : y;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_LANES_H
