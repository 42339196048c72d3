#ifndef SHAPE_CHARACTERISTICS_INTERNAL_ROUNDED_DISTANCE_H
#define SHAPE_CHARACTERISTICS_INTERNAL_ROUNDED_DISTANCE_H

#include <cmath>
#include <cstdint>
#include <cstring>

namespace Shape_characteristics {
namespace internal {

/*
  Rounds squared distances to half their digits, in a unit that grows with the surface. On regular meshes, many places
  are equally far but for the rounding of coordinates. They are equal now, unless they are half way between two rounded
  ones: something else decides between them, and decides alike wherever the surface is and however large.
*/
class Rounded_distance
{
public:
  // `unit`: a squared distance. Powers of two make no difference to digits: no quotient leaves the range of numbers.
  explicit Rounded_distance(double unit)
    : m_unit(unit > 0. && std::isfinite(unit) ? std::scalbn(unit, -std::ilogb(unit)) : 1.),
      m_inverse(1. / m_unit)
  {}

  double operator()(double squared_distance) const
  {
    constexpr std::uint64_t quantum = std::uint64_t(1) << 26;
    squared_distance *= m_inverse;
    std::uint64_t bits;
    std::memcpy(&bits, &squared_distance, sizeof(bits));
    bits = (bits + quantum / 2) & ~(quantum - 1);
    std::memcpy(&squared_distance, &bits, sizeof(bits));
    return squared_distance;
  }

  // no squared distance that becomes `rounded` is larger
  double largest(double rounded) const
  {
    return std::isfinite(rounded) ? rounded * m_unit * (1. + 0x1p-25) : rounded;
  }

  // of what becomes `rounded`, not squared
  double length(double rounded) const { return std::sqrt(rounded * m_unit); }

private:
  double m_unit, m_inverse;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_ROUNDED_DISTANCE_H
