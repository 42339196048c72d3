#ifndef SHAPE_CHARACTERISTICS_INTERNAL_MEDIAN_H
#define SHAPE_CHARACTERISTICS_INTERNAL_MEDIAN_H

#include <algorithm>
#include <cstddef>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// the median of some numbers, of an even number the larger one of both in the middle; changes their order
inline double median(std::vector<double>& numbers)
{
  const auto middle = numbers.begin() + std::ptrdiff_t(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_MEDIAN_H
