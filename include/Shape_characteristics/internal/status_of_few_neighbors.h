#ifndef SHAPE_CHARACTERISTICS_INTERNAL_STATUS_OF_FEW_NEIGHBORS_H
#define SHAPE_CHARACTERISTICS_INTERNAL_STATUS_OF_FEW_NEIGHBORS_H

#include <Shape_characteristics/Estimation_status.h>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace Shape_characteristics {
namespace internal {

template <typename SampledSurface, typename = void>
inline constexpr bool knows_coincident_points = false;
template <typename SampledSurface>
inline constexpr bool knows_coincident_points<
    SampledSurface,
    std::void_t<decltype(std::declval<const SampledSurface&>().has_coincident_points(std::size_t()))>> = true;

// of a sample with so many neighbors, too few: those of a point set may all be where it is
template <typename SampledSurface>
Estimation_status
status_of_few_neighbors(const SampledSurface& surface, std::size_t i, std::size_t number_of_neighbors)
{
  if constexpr(knows_coincident_points<SampledSurface>)
    if(number_of_neighbors == 0 && surface.has_coincident_points(i))
      return Estimation_status::DEGENERATE;
  return Estimation_status::FEW_NEIGHBOURS;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_STATUS_OF_FEW_NEIGHBORS_H
