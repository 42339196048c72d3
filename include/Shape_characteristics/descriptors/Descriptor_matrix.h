#ifndef SHAPE_CHARACTERISTICS_DESCRIPTORS_DESCRIPTOR_MATRIX_H
#define SHAPE_CHARACTERISTICS_DESCRIPTORS_DESCRIPTOR_MATRIX_H

#include <Shape_characteristics/Estimation_status.h>

#include <Eigen/Core>

#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsDescriptors

  holds the descriptors of samples, one below the other, and for each whether there is one and if not why.

  What compares or matches descriptors sees this and nothing else, and so doesn't know which descriptor it serves.
*/
struct Descriptor_matrix
{
  /// a row per sample, a column per component. The rows of samples without a descriptor are quiet NaN.
  Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> values;
  /// the status of each row. Those that are not `ESTIMATED` or `BORDER` carry no descriptor.
  std::vector<Estimation_status> status;
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_DESCRIPTORS_DESCRIPTOR_MATRIX_H
