#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_MULTIPLY_DESCRIPTORS_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_MULTIPLY_DESCRIPTORS_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/descriptors/Descriptor_matrix.h>
#include <Shape_characteristics/registration/internal/combine_descriptors.h>

#include <Eigen/Core>

#include <cstddef>
#include <stdexcept>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsRegistration

  multiplies descriptors by a signal: row `i` of the result is that of `features` times component `i`, `column` of `signals` (thesis,
  section 10.1.3).

  A signal that changes its sign when the surface is mirrored makes mirror images far from each other. But where it is about
  0, near planes of symmetry above all, all descriptors become about 0, and what is matched there is chance:
  `append_descriptors()` doesn't do that.

  \param features descriptors of any kind
  \param signals a signal, of the same samples
  \param column the column of the signal in `signals`

  \return a row for each sample, as wide as `features`. Where one of them has no value, it has none, and its status says why.

  \throws std::invalid_argument if the numbers of rows differ, or there is no such column

  Complexity: linear in the size of the result.
*/
inline Descriptor_matrix multiply_descriptors(const Descriptor_matrix& features,
                                              const Descriptor_matrix& signals,
                                              std::size_t column = 0)
{
  internal::check_combination(features, signals);
  if(column >= std::size_t(signals.values.cols()))
    throw std::invalid_argument("Shape_characteristics: the signal to multiply by has no such column");
  Descriptor_matrix result;
  result.values.resize(features.values.rows(), features.values.cols());
  result.status.resize(features.status.size());
  for(Eigen::Index i = 0; i < result.values.rows(); ++i)
  {
    auto row = result.values.row(i);
    row = signals.values(i, Eigen::Index(column)) * features.values.row(i);
    const std::size_t s = std::size_t(i);
    result.status[s] = internal::finish_row(internal::combined_status(features.status[s], signals.status[s]),
                                            std::size_t(row.size()), row.data());
  }
  return result;
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_MULTIPLY_DESCRIPTORS_H
