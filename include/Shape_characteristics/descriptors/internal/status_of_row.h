#ifndef SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_STATUS_OF_ROW_H
#define SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_STATUS_OF_ROW_H

#include <Shape_characteristics/Estimation_status.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace Shape_characteristics {
namespace internal {

// The status of a sample whose descriptor is in `row`: `status`, or `DEGENERATE` and a row of NaN if a number is too large for single
// precision, or none.
inline Estimation_status status_of_row(float* row, std::size_t dimension, Estimation_status status)
{
  if(std::all_of(row, row + dimension, [](const float x) { return std::isfinite(x); }))
    return status;
  std::fill_n(row, dimension, std::numeric_limits<float>::quiet_NaN());
  return is_estimated(status) ? Estimation_status::DEGENERATE : status;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_STATUS_OF_ROW_H
