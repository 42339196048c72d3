#ifndef SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_TICKS_H
#define SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_TICKS_H

#include <string>
#include <vector>

namespace support {

/// The values that a scale is marked with, and their texts.
struct Ticks
{
  std::vector<double> values;
  std::vector<std::string> labels;
  std::string factor; ///< what the labels are to be multiplied by, e.g. "×10^{-6}"; empty for 1
};

/// At most about `wished` round values (1, 2 or 5 times a power of ten apart) in [low, high].
Ticks linear_ticks(double low, double high, int wished);

/// Powers of ten in [low, high], both positive; every second, third ... if there were more than `wished`.
/// If there are fewer than two, 2 and 5 times those as well; linear_ticks() if these are too few, too.
Ticks logarithmic_ticks(double low, double high, int wished);

} // namespace support

#endif
