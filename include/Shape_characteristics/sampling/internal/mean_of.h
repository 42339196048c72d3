#ifndef SHAPE_CHARACTERISTICS_SAMPLING_INTERNAL_MEAN_OF_H
#define SHAPE_CHARACTERISTICS_SAMPLING_INTERNAL_MEAN_OF_H

#include <algorithm>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// The mean of positive numbers, with the same bits whatever their order; 0 if there are none.
inline double mean_of(std::vector<double>& numbers)
{
  std::sort(numbers.begin(), numbers.end());
  double sum = 0.;
  for(const double number : numbers)
    sum += number / double(numbers.size()); // a sum of huge ones would overflow
  return sum;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SAMPLING_INTERNAL_MEAN_OF_H
