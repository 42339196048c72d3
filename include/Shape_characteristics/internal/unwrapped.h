#ifndef SHAPE_CHARACTERISTICS_INTERNAL_UNWRAPPED_H
#define SHAPE_CHARACTERISTICS_INTERNAL_UNWRAPPED_H

#include <functional>

namespace Shape_characteristics {
namespace internal {

// what a named parameter is, whether it was given itself or by `std::cref()`
template <typename T>
const T& unwrapped(const T& value)
{
  return value;
}

template <typename T>
const T& unwrapped(const std::reference_wrapper<T>& reference)
{
  return reference.get();
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_UNWRAPPED_H
