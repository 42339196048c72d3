#ifndef SHAPE_CHARACTERISTICS_INTERNAL_HAS_NO_CURVATURE_H
#define SHAPE_CHARACTERISTICS_INTERNAL_HAS_NO_CURVATURE_H

#include <Shape_characteristics/internal/has_opposite_sheet.h>
#include <Shape_characteristics/internal/is_tip.h>

#include <cstddef>

namespace Shape_characteristics {
namespace internal {

// Whether its neighbors tell that there is no curvature at a sample: at the tip of a cone, or, where neighbors may be of any surface that is
// near, between sheets that face each other.
template <typename SampledSurface, typename Neighbors>
bool has_no_curvature(const SampledSurface& surface, std::size_t i, const Neighbors& neighbors)
{
  using Kind = decltype(surface.neighborhood().kind());
  return is_tip(surface, i, neighbors) ||
         (surface.neighborhood().kind() != Kind::RINGS && has_opposite_sheet(surface, i, neighbors));
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_HAS_NO_CURVATURE_H
