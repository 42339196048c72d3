#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_PAIR_ON_LANES_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_PAIR_ON_LANES_H

#include <Shape_characteristics/interpolation/internal/Lanes.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace Shape_characteristics {
namespace internal {

/*
  A number with more digits than a double has, on lanes: the sum of two, of which the second is what rounding took from the first,
  known to half its digits at least. It isn't normalized after each operation, which takes half the time of arithmetic that does
  (M. Lange and S. M. Rump, Faithfully rounded floating-point computations, ACM Transactions on Mathematical Software 46, 2020).

  Operators give objects in memory, not vectors, so that they are the same functions for all instruction sets.
*/
template <typename V>
struct Pair_on_lanes
{
  V high, low;

  Pair_on_lanes() = default;
  [[gnu::always_inline]] explicit Pair_on_lanes(const V& value) : high(value), low() {}
  [[gnu::always_inline]] Pair_on_lanes(const V& h, const V& l) : high(h), low(l) {}

  // to one double
  [[gnu::always_inline]] void round(V& result) const { result = high + low; }
};

// the part of a number whose square is a double
template <typename V>
[[gnu::always_inline]] inline void take_first_half(const V& number, V& half)
{
  Bits_of_lanes<V> bits;
  copy_bits(bits, number);
  bits = bits & ~std::uint64_t(0x7ffffff);
  copy_bits(half, bits);
}

// What rounding took from a b, by halves of both (Dekker): exact, whether products are fused with what follows or not, but for
// `product` itself.
template <typename V>
[[gnu::always_inline]] inline void find_error_of_product(const V& a, const V& b, const V& product, V& error)
{
  V ah, bh;
  take_first_half(a, ah);
  take_first_half(b, bh);
  const V al = a - ah, bl = b - bh;
  error = (((ah * bh - product) + ah * bl) + al * bh) + al * bl;
}

// a b as product + error
template <typename V>
[[gnu::always_inline]] inline void multiply(const V& a, const V& b, V& product, V& error)
{
  product = a * b;
#if defined(__clang__)
  find_error_of_product(a, b, product, error); // Clang fuses nothing beyond an expression
#elif defined(__GNUC__) && defined(__x86_64__)
  asm("" : "+v"(product));              // nor may GCC
  if constexpr(number_of_lanes<V> >= 4) // for processors that multiply and subtract at once
  {
    error = product;
    asm("vfmsub231pd {%2, %1, %0|%0, %1, %2}" : "+v"(error) : "v"(a), "v"(b));
  }
  else
    find_error_of_product(a, b, product, error);
#else
  constexpr std::size_t n = number_of_lanes<V>;
  std::array<double, n> x, y, p, e;
  std::memcpy(x.data(), &a, sizeof(V));
  std::memcpy(y.data(), &b, sizeof(V));
  std::memcpy(p.data(), &product, sizeof(V));
  for(std::size_t lane = 0; lane < n; ++lane)
    e[lane] = std::fma(x[lane], y[lane], -p[lane]);
  std::memcpy(&error, e.data(), sizeof(V));
#endif
}

// what rounding took from `sum`, that of a and b (Knuth)
template <typename V>
[[gnu::always_inline]] inline void find_error_of_sum(const V& a, const V& b, const V& sum, V& error)
{
  const V of_b = sum - a;
  error = (a - (sum - of_b)) + (b - of_b);
}

// a - b of doubles
template <typename V>
[[gnu::always_inline]] inline Pair_on_lanes<V> difference(const V& a, const V& b)
{
  Pair_on_lanes<V> result;
  result.high = a - b;
  find_error_of_sum(a, V(-b), result.high, result.low);
  return result;
}

template <typename V>
[[gnu::always_inline]] inline Pair_on_lanes<V> operator-(const Pair_on_lanes<V>& a)
{
  return {-a.high, -a.low};
}

template <typename V>
[[gnu::always_inline]] inline Pair_on_lanes<V> operator+(const Pair_on_lanes<V>& a, const Pair_on_lanes<V>& b)
{
  Pair_on_lanes<V> result;
  result.high = a.high + b.high;
  find_error_of_sum(a.high, b.high, result.high, result.low);
  result.low = result.low + (a.low + b.low);
  return result;
}

template <typename V>
[[gnu::always_inline]] inline Pair_on_lanes<V> operator-(const Pair_on_lanes<V>& a, const Pair_on_lanes<V>& b)
{
  return a + -b;
}

template <typename V>
[[gnu::always_inline]] inline Pair_on_lanes<V> operator+(const Pair_on_lanes<V>& a, const V& b)
{
  Pair_on_lanes<V> result;
  result.high = a.high + b;
  find_error_of_sum(a.high, b, result.high, result.low);
  result.low = result.low + a.low;
  return result;
}

template <typename V>
[[gnu::always_inline]] inline Pair_on_lanes<V> operator*(const Pair_on_lanes<V>& a, const Pair_on_lanes<V>& b)
{
  Pair_on_lanes<V> result;
  multiply(a.high, b.high, result.high, result.low);
  result.low = result.low + (a.high * b.low + a.low * b.high);
  return result;
}

template <typename V>
[[gnu::always_inline]] inline Pair_on_lanes<V> operator*(const Pair_on_lanes<V>& a, const V& b)
{
  Pair_on_lanes<V> result;
  multiply(a.high, b, result.high, result.low);
  result.low = result.low + a.low * b;
  return result;
}

// a + b of which the second isn't larger (Dekker)
template <typename V>
[[gnu::always_inline]] inline Pair_on_lanes<V> sum_of_ordered(const V& a, const V& b)
{
  const V sum = a + b;
  return {sum, b - (sum - a)};
}

template <typename V>
[[gnu::always_inline]] inline Pair_on_lanes<V> sum_of_ordered(const V& a, const Pair_on_lanes<V>& b)
{
  const Pair_on_lanes<V> sum = sum_of_ordered(a, b.high);
  return {sum.high, sum.low + b.low};
}

template <typename V>
[[gnu::always_inline]] inline Pair_on_lanes<V> sum_of_ordered(const Pair_on_lanes<V>& a, const V& b)
{
  const Pair_on_lanes<V> sum = sum_of_ordered(a.high, b);
  return {sum.high, sum.low + a.low};
}

// the same number, the first double of which is all of it but for rounding
template <typename V>
[[gnu::always_inline]] inline Pair_on_lanes<V> normalized(const Pair_on_lanes<V>& a)
{
  return sum_of_ordered(a.high, a.low);
}

// times a power of two
template <typename V>
[[gnu::always_inline]] inline Pair_on_lanes<V> magnify(const Pair_on_lanes<V>& a, double factor)
{
  return {factor * a.high, factor * a.low};
}

// A step of Newton's from the root of a double; x >= 0.
template <typename V>
[[gnu::always_inline]] inline Pair_on_lanes<V> sqrt(const Pair_on_lanes<V>& x)
{
  const V positive = x.high + 1e-300; // the root of 0 is 0
  V inverse, square, rest_of_square;
  inverse_sqrt(positive, inverse);
  const V root = x.high * inverse;
  multiply(root, root, square, rest_of_square);
  return {root, (0.5 * inverse) * (((x.high - square) - rest_of_square) + x.low)};
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_PAIR_ON_LANES_H
