#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_MIRRORED_DESCRIPTORS_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_MIRRORED_DESCRIPTORS_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/descriptors/Descriptor_matrix.h>
#include <Shape_characteristics/registration/internal/check_statuses.h>

#include <Eigen/Core>

#include <cstddef>
#include <stdexcept>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsRegistration

  gives for each row of a matrix the descriptor that the sample would have on the mirrored surface, as `match_descriptors()` takes it.

  \tparam Descriptor a model of the concept `Descriptor` that has `mirrored()`

  \param descriptor what the rows were computed with
  \param descriptors the rows
  \throws std::invalid_argument if the matrix has another number of columns than the descriptor has components, or not a status for
          each row

  Complexity: linear in the size of the matrix.
*/
template <typename Descriptor>
Descriptor_matrix mirrored_descriptors(const Descriptor& descriptor, const Descriptor_matrix& descriptors)
{
  if(std::size_t(descriptors.values.cols()) != descriptor.dimension())
    throw std::invalid_argument("Shape_characteristics: these rows are of another descriptor");
  internal::check_statuses(descriptors);
  Descriptor_matrix result = descriptors;
  for(std::size_t i = 0; i < descriptors.status.size(); ++i)
    if(is_estimated(descriptors.status[i]))
      descriptor.mirrored(descriptors.values.row(Eigen::Index(i)).data(),
                          result.values.row(Eigen::Index(i)).data());
  return result;
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_MIRRORED_DESCRIPTORS_H
