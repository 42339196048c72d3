#ifndef SHAPE_CHARACTERISTICS_INTERNAL_WHOLE_NUMBER_H
#define SHAPE_CHARACTERISTICS_INTERNAL_WHOLE_NUMBER_H

#include <Shape_characteristics/Named_function_parameters.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace Shape_characteristics {
namespace internal {

// `value` of the named parameter `name`, which counts something, as an integer. Users may pass numbers of any type, and what a
// processor makes of NaN, of infinity and of parts is no count.
template <typename Integer = std::int64_t, typename Number>
Integer whole_number(const Number& value, const char* name)
{
  if constexpr(std::is_floating_point<Number>::value)
  {
    constexpr bool is_signed = std::numeric_limits<Integer>::is_signed;
    const Number limit = std::ldexp(Number(1), std::numeric_limits<Integer>::digits);
    if(!(std::isfinite(value) && std::trunc(value) == value))
      throw std::invalid_argument(std::string("Shape_characteristics: ") + name + " must be a whole number");
    if(!(value >= (is_signed ? -limit : Number(0)) && value < limit))
      throw std::invalid_argument(std::string("Shape_characteristics: ") + name + " is out of range");
  }
  return static_cast<Integer>(value);
}

// The named parameter `tag` as an integer; `fallback` if it isn't given.
template <typename Integer = std::int64_t, typename NamedParameters, typename Tag>
Integer whole_number(const NamedParameters& np, Tag tag, Integer fallback, const char* name)
{
  return whole_number<Integer>(parameters::choose_parameter(parameters::get_parameter(np, tag), fallback),
                               name);
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_WHOLE_NUMBER_H
