#ifndef SHAPE_CHARACTERISTICS_INTERNAL_LOG_OF_SUM_H
#define SHAPE_CHARACTERISTICS_INTERNAL_LOG_OF_SUM_H

#include <cmath>
#include <limits>

namespace Shape_characteristics {
namespace internal {

// the logarithm of the sum of the numbers whose logarithms these are, NaN for 0; NaN if there is no other
template <typename Iterator>
double log_of_sum(Iterator first, Iterator last)
{
  double largest = std::numeric_limits<double>::quiet_NaN();
  for(Iterator i = first; i != last; ++i)
    largest = std::fmax(largest, *i);
  if(!std::isfinite(largest))
    return largest;
  double sum = 0.;
  for(Iterator i = first; i != last; ++i)
    if(!std::isnan(*i))
      sum += std::exp(*i - largest);
  return largest + std::log(sum);
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_LOG_OF_SUM_H
