#ifndef SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_COMPUTE_DESCRIPTORS_OF_H
#define SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_COMPUTE_DESCRIPTORS_OF_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/descriptors/Descriptor_matrix.h>
#include <Shape_characteristics/descriptors/compute_descriptors.h>
#include <Shape_characteristics/internal/callback_of.h>
#include <Shape_characteristics/internal/unwrapped.h>

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// the samples that the named parameter `descriptor_samples` names, of `size` there are; empty where it isn't given
template <typename NamedParameters>
std::vector<std::size_t> descriptor_samples_of(std::size_t size, const NamedParameters& np)
{
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  std::vector<std::size_t> samples;
  if constexpr(!is_default_parameter<NamedParameters, internal_np::descriptor_samples_t>::value)
  {
    const auto given = get_parameter(np, internal_np::descriptor_samples);
    for(const auto i : unwrapped(given))
    {
      // a negative one becomes too large
      if(std::size_t(i) >= size)
        throw std::invalid_argument("Shape_characteristics: descriptor_samples must be numbers of samples, "
                                    "from 0 to one less than their number");
      samples.push_back(std::size_t(i));
    }
  }
  return samples;
}

// the descriptors of a surface with `size` samples: of those that `descriptor_samples` names, or of all. Observes `callback`.
template <typename ConcurrencyTag, typename Descriptor, typename NamedParameters>
Descriptor_matrix
compute_descriptors_of(const Descriptor& descriptor, std::size_t size, const NamedParameters& np)
{
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  const std::function<bool(double)> callback = callback_of(np);
  if constexpr(is_default_parameter<NamedParameters, internal_np::descriptor_samples_t>::value)
    return compute_descriptors<ConcurrencyTag>(descriptor, size, callback);
  else
    return compute_descriptors<ConcurrencyTag>(descriptor, descriptor_samples_of(size, np), callback);
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_COMPUTE_DESCRIPTORS_OF_H
