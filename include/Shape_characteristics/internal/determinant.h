#ifndef SHAPE_CHARACTERISTICS_INTERNAL_DETERMINANT_H
#define SHAPE_CHARACTERISTICS_INTERNAL_DETERMINANT_H

#include <cmath>

namespace Shape_characteristics {
namespace internal {

// l n - m^2 with an error of 1.5 units in the last place (Kahan), whatever cancels
inline double determinant(double l, double m, double n) noexcept
{
  const double square = m * m;
  const double error = std::fma(-m, m, square);
  return std::fma(l, n, -square) + error;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_DETERMINANT_H
