#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_CHECK_STATUSES_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_CHECK_STATUSES_H

#include <Shape_characteristics/descriptors/Descriptor_matrix.h>

#include <cstddef>
#include <stdexcept>

namespace Shape_characteristics {
namespace internal {

inline void check_statuses(const Descriptor_matrix& matrix)
{
  if(matrix.status.size() != std::size_t(matrix.values.rows()))
    throw std::invalid_argument("Shape_characteristics: a matrix of descriptors needs a status for each row");
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_CHECK_STATUSES_H
