#ifndef SHAPE_CHARACTERISTICS_INTERNAL_ROUNDED_COMPARISON_H
#define SHAPE_CHARACTERISTICS_INTERNAL_ROUNDED_COMPARISON_H

#include <cmath>

namespace Shape_characteristics {
namespace internal {

/*
  Compares numbers as multiples of `unit` from `origin`, rounded to whole ones: those that are equal but for rounding are
  equal, unless they are half way between two multiples. (An origin that others are level with keeps regular ones from
  that.)
*/
class Rounded_comparison
{
public:
  Rounded_comparison(double origin, double unit) : m_origin(origin), m_unit(unit) {}

  // negative if `x` is less than `y`, positive if it is larger
  int operator()(double x, double y) const
  {
    const double difference = x - y;
    if(std::abs(difference) > 2. * m_unit) // so are the multiples
      return difference < 0. ? -1 : 1;
    const double of_x = multiple(x), of_y = multiple(y);
    return int(of_x > of_y) - int(of_x < of_y);
  }

private:
  double multiple(double x) const { return std::nearbyint((x - m_origin) / m_unit); }

  double m_origin, m_unit;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_ROUNDED_COMPARISON_H
