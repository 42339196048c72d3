#ifndef SHAPE_CHARACTERISTICS_INTERNAL_LEAVE_WIDE_GAP_H
#define SHAPE_CHARACTERISTICS_INTERNAL_LEAVE_WIDE_GAP_H

#include <CGAL/number_type_config.h>

#include <cstddef>

namespace Shape_characteristics {
namespace internal {

// Whether nothing is seen within 120 degrees somewhere around, of `number` things (one at least) at the angles `angle(k)`, in ascending order.
template <typename Angle>
bool leave_wide_gap(std::size_t number, const Angle& angle)
{
  constexpr double wide = 2. * CGAL_PI / 3.;
  for(std::size_t k = 1; k < number; ++k)
    if(angle(k) - angle(k - 1) > wide)
      return true;
  return angle(0) + 2. * CGAL_PI - angle(number - 1) > wide;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_LEAVE_WIDE_GAP_H
