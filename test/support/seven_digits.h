#ifndef SHAPE_CHARACTERISTICS_TEST_SUPPORT_SEVEN_DIGITS_H
#define SHAPE_CHARACTERISTICS_TEST_SUPPORT_SEVEN_DIGITS_H

#include <cmath>

namespace test_support {

/// The number, cut off after 27 binary digits.
inline double seven_digits(double number)
{
  int exponent;
  const double mantissa = std::frexp(number, &exponent);
  return std::ldexp(std::trunc(std::ldexp(mantissa, 27)), exponent - 27);
}

} // namespace test_support

#endif // SHAPE_CHARACTERISTICS_TEST_SUPPORT_SEVEN_DIGITS_H
