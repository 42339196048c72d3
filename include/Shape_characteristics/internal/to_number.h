#ifndef SHAPE_CHARACTERISTICS_INTERNAL_TO_NUMBER_H
#define SHAPE_CHARACTERISTICS_INTERNAL_TO_NUMBER_H

#include <limits>

namespace Shape_characteristics {
namespace internal {

// `value`, which may be NaN, in the number type of a result.
template <typename Number>
Number to_number(double value)
{
  static_assert(std::numeric_limits<Number>::has_quiet_NaN,
                "Shape_characteristics: what can't be estimated is quiet NaN, which exact and integer types "
                "don't have: "
                "take a map of double or float, or of vectors and curvatures of a kernel of these");
  return Number(value);
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_TO_NUMBER_H
