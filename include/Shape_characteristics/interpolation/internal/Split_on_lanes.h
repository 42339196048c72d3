#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_SPLIT_ON_LANES_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_SPLIT_ON_LANES_H

#include <Shape_characteristics/interpolation/internal/Pair_on_lanes.h>

namespace Shape_characteristics {
namespace internal {

/*
  A number in two parts, on lanes, for sums of products with more digits: the first part is a multiple of a unit of which the number has
  no more than some 2^21, so that there are no rounding errors in products of first parts, and in their sums. The rest is as
  much smaller, and so are its rounding errors. A product takes three fused operations, that of Pair_on_lanes and its sum a dozen.
*/
template <typename V>
struct Split_on_lanes
{
  V first, rest;

  Split_on_lanes() = default;
  [[gnu::always_inline]] Split_on_lanes(const V& f, const V& r) : first(f), rest(r) {}
};

// `shift`: 1.5 * 2^52 units
template <typename V>
[[gnu::always_inline]] inline Split_on_lanes<V> split(const Pair_on_lanes<V>& number, const V& shift)
{
  const V first = (number.high + shift) - shift;
  return {first, (number.high - first) + number.low};
}

// the sum of products of numbers in two parts
template <typename V>
struct Sum_of_splits_on_lanes
{
  V first, rest;

  // GCC doesn't inline a default one into functions for other processors.
  [[gnu::always_inline]] Sum_of_splits_on_lanes() : first(), rest() {}
  [[gnu::always_inline]] Sum_of_splits_on_lanes(const V& f, const V& r) : first(f), rest(r) {}

  template <int sign>
  [[gnu::always_inline]] void add_product(const Split_on_lanes<V>& a, const Split_on_lanes<V>& b)
  {
    const V whole = b.first + b.rest;
    if constexpr(sign > 0)
    {
      first = first + a.first * b.first;
      rest = rest + a.first * b.rest;
      rest = rest + a.rest * whole;
    }
    else
    {
      first = first - a.first * b.first;
      rest = rest - a.first * b.rest;
      rest = rest - a.rest * whole;
    }
  }

  [[gnu::always_inline]] void add_square(const Split_on_lanes<V>& a)
  {
    first = first + a.first * a.first;
    rest = rest + a.rest * (2. * a.first + a.rest);
  }

  [[gnu::always_inline]] Pair_on_lanes<V> pair() const { return normalized(Pair_on_lanes<V>(first, rest)); }

  [[gnu::always_inline]] Split_on_lanes<V> split(const V& shift) const
  {
    const V rounded = ((first + rest) + shift) - shift;
    return {rounded, (first - rounded) + rest};
  }
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_SPLIT_ON_LANES_H
