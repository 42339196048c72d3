#ifndef SHAPE_CHARACTERISTICS_TEST_SUPPORT_NEIGHBOR_KEY_H
#define SHAPE_CHARACTERISTICS_TEST_SUPPORT_NEIGHBOR_KEY_H

#include <array>
#include <cmath>
#include <cstddef>

namespace test_support {

/// By what the neighbors of `center` are sorted: the squared distance to 27 binary digits, the offset to a millionth of the distance,
/// all digits.
inline std::array<double, 7> neighbor_key(const std::array<double, 3>& center, const std::array<double, 3>& p)
{
  std::array<double, 3> d;
  double squared_distance = 0.;
  for(std::size_t c = 0; c < 3; ++c)
  {
    d[c] = p[c] - center[c];
    squared_distance += d[c] * d[c];
  }
  int exponent;
  const double mantissa = std::frexp(squared_distance, &exponent);
  const double rounded = std::ldexp(std::nearbyint(std::ldexp(mantissa, 27)), exponent - 27);
  const double unit = std::sqrt(rounded) / 1048576.;
  return {rounded,
          std::nearbyint(d[0] / unit),
          std::nearbyint(d[1] / unit),
          std::nearbyint(d[2] / unit),
          p[0],
          p[1],
          p[2]};
}

} // namespace test_support

#endif // SHAPE_CHARACTERISTICS_TEST_SUPPORT_NEIGHBOR_KEY_H
