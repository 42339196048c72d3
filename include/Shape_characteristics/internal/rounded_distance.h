#ifndef SHAPE_CHARACTERISTICS_INTERNAL_ROUNDED_DISTANCE_H
#define SHAPE_CHARACTERISTICS_INTERNAL_ROUNDED_DISTANCE_H

#include <cmath>
#include <cstdint>
#include <cstring>

namespace Shape_characteristics {
namespace internal {

/*
  A squared distance with half its digits, by which places are compared. On regular meshes, many are equally far but for
  the rounding of coordinates. They are equal now (unless a multiple of the last digit comes between them, about once in ten
  million times), so that something else decides between them, and decides alike wherever the surface is and however large.
*/
inline double rounded_distance(double squared_distance)
{
  constexpr std::uint64_t dropped = (std::uint64_t(1) << 26) - 1;
  std::uint64_t bits;
  std::memcpy(&bits, &squared_distance, sizeof(bits));
  bits &= ~dropped;
  std::memcpy(&squared_distance, &bits, sizeof(bits));
  return squared_distance;
}

// no squared distance with this rounded one is larger
inline double largest_rounded_to(double rounded)
{
  return std::isfinite(rounded) ? rounded * (1. + 0x1p-25) : rounded;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_ROUNDED_DISTANCE_H
