#ifndef SHAPE_CHARACTERISTICS_INTERNAL_SCALE_TO_RANGE_H
#define SHAPE_CHARACTERISTICS_INTERNAL_SCALE_TO_RANGE_H

#include <algorithm>
#include <cmath>

namespace Shape_characteristics {
namespace internal {

// What lengths about as large as `length` are multiplied with so that their products are in the range of numbers: 1 in any unit but
// extraordinary ones, and a power of two there, which leaves all digits as they are.
inline double scale_to_range(double length)
{
  constexpr double smallest = 1e-70, largest = 1e70;
  if((length > smallest && length < largest) || !(length > 0.) || !std::isfinite(length))
    return 1.;
  return std::ldexp(1., (std::min)(-std::ilogb(length), 1000));
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_SCALE_TO_RANGE_H
