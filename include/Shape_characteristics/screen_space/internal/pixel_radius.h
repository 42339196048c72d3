#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_INTERNAL_PIXEL_RADIUS_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_INTERNAL_PIXEL_RADIUS_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/internal/whole_number.h>

#include <cstdint>
#include <stdexcept>

namespace Shape_characteristics {
namespace internal {

// the named parameter of that name
template <typename NamedParameters>
int pixel_radius(const NamedParameters& np)
{
  const std::int64_t radius = whole_number(np, internal_np::pixel_radius, std::int64_t(8), "pixel_radius");
  if(radius < 2 || radius > 64)
    throw std::invalid_argument("Shape_characteristics: pixel_radius must be in [2, 64]");
  return int(radius);
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_INTERNAL_PIXEL_RADIUS_H
