#ifndef SHAPE_CHARACTERISTICS_INTERNAL_CALLBACK_OF_H
#define SHAPE_CHARACTERISTICS_INTERNAL_CALLBACK_OF_H

#include <Shape_characteristics/Named_function_parameters.h>

#include <functional>

namespace Shape_characteristics {
namespace internal {

// the named parameter `callback`; empty if there is none
template <typename NamedParameters>
std::function<bool(double)> callback_of(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  return choose_parameter(get_parameter(np, internal_np::callback), std::function<bool(double)>());
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_CALLBACK_OF_H
