#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_INTERNAL_PIXEL_RADIUS_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_INTERNAL_PIXEL_RADIUS_H

#include <Shape_characteristics/Named_function_parameters.h>

#include <stdexcept>

namespace Shape_characteristics {
namespace internal {

// the named parameter of that name
template <typename NamedParameters>
int pixel_radius(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const int radius = int(choose_parameter(get_parameter(np, internal_np::pixel_radius), 8));
  if(radius < 2 || radius > 64)
    throw std::invalid_argument("Shape_characteristics: pixel_radius must be in [2, 64]");
  return radius;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_INTERNAL_PIXEL_RADIUS_H
