#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_SCAN_SCALE_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_SCAN_SCALE_H

#include <Shape_characteristics/internal/scale_to_range.h>
#include <Shape_characteristics/registration/Oriented_points.h>

#include <algorithm>
#include <cstddef>

namespace Shape_characteristics {
namespace internal {

// What the coordinates of two scans are multiplied with so that their products are in the range of numbers: 1 in any unit but
// extraordinary ones.
inline double scan_scale(const Oriented_points& source, const Oriented_points& target)
{
  double largest = 0.;
  for(const Oriented_points* const scan : {&source, &target})
    for(std::size_t i = 0; i < scan->size(); ++i)
      if(scan->is_usable(i))
        largest = (std::max)(largest, scan->points[i].cwiseAbs().maxCoeff());
  return scale_to_range(largest);
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_SCAN_SCALE_H
