#ifndef SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_VALUE_RANGE_H
#define SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_VALUE_RANGE_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace support {

/// The interval of values that a colour gradient is spread over; never empty.
struct Value_range
{
  double low = 0, high = 1;
  bool clips_low = false;  ///< there are values below `low`
  bool clips_high = false; ///< there are values above `high`

  /// 0 at `low`, 1 at `high`, NaN for NaN; not clamped.
  double position(double value) const { return (value - low) / (high - low); }
};

/// The `fraction`-quantile (fraction in [0,1]) of the finite ones among `values`, interpolated linearly
/// between the two nearest. Throws `std::invalid_argument` if no value is finite or if `fraction` is
/// outside [0,1].
inline double percentile(std::vector<double> values, double fraction)
{
  if(!(fraction >= 0 && fraction <= 1))
    throw std::invalid_argument("percentile: fraction must be in [0,1]");
  values.erase(std::remove_if(values.begin(), values.end(), [](double v) { return !std::isfinite(v); }),
               values.end());
  if(values.empty())
    throw std::invalid_argument("percentile: values: none is finite");
  const double place = fraction * double(values.size() - 1);
  const auto lower = values.begin() + std::ptrdiff_t(place);
  std::nth_element(values.begin(), lower, values.end());
  const double rest = place - std::floor(place);
  if(rest == 0)
    return *lower;
  return *lower + rest * (*std::min_element(lower + 1, values.end()) - *lower);
}

/// The range from the `tail`-quantile of the finite values to the (1 - tail)-quantile, so that a few
/// outliers don't flatten the picture. With `symmetric` it is widened to [-m, m], which puts zero in the
/// gradient's middle.
///
/// It is never empty. If more than the tails are of one and the same value the tails are halved until
/// they aren't; values that are all equal (up to 1e-6 of their size, below which differences are not
/// worth a colour) get a range around them. No finite value at all gives [-1, 1].
inline Value_range
percentile_range(const std::vector<double>& values, double tail = 0.02, bool symmetric = false)
{
  if(!(tail >= 0 && tail < 0.5))
    throw std::invalid_argument("percentile_range: tail must be in [0,0.5)");
  std::vector<double> sorted;
  for(double v : values)
    if(std::isfinite(v))
      sorted.push_back(v);
  Value_range range;
  range.low = -1;
  range.high = 1;
  if(!sorted.empty())
  {
    std::sort(sorted.begin(), sorted.end());
    const auto quantile = [&](double fraction)
    {
      const double place = fraction * double(sorted.size() - 1);
      const std::size_t i = std::size_t(place);
      const double rest = place - double(i);
      return rest == 0 ? sorted[i] : sorted[i] + rest * (sorted[i + 1] - sorted[i]);
    };
    const auto empty = [&]
    { return range.high - range.low <= 1e-6 * std::max(std::abs(range.low), std::abs(range.high)); };
    for(double t = tail;; t = t * double(sorted.size()) < 0.5 ? 0 : t / 2)
    {
      range.low = quantile(t);
      range.high = quantile(1 - t);
      if(!empty() || t == 0)
        break;
    }
    const double size = std::max(std::abs(range.low), std::abs(range.high));
    if(symmetric)
    {
      range.low = size > 0 ? -size : -1;
      range.high = size > 0 ? size : 1;
    }
    else if(empty())
    {
      const double middle = (range.low + range.high) / 2;
      range.low = middle - (size > 0 ? size / 2 : 1);
      range.high = middle + (size > 0 ? size / 2 : 1);
    }
  }
  for(double v : values)
  {
    range.clips_low = range.clips_low || v < range.low;
    range.clips_high = range.clips_high || v > range.high;
  }
  return range;
}

} // namespace support

#endif
