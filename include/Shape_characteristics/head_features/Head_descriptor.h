#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_HEAD_DESCRIPTOR_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_HEAD_DESCRIPTOR_H

#include <limits>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsHeadFeatures

  holds what the thesis looks at to find the features of a head (section 9.1.1): four characteristics of the surface at a vertex,
  free of units and averaged over its neighborhood. `head_descriptors()` computes them.

  What depends on the size of the head is mapped linearly to [0, 1]: the smallest value on the head becomes 0, the largest one 1.
  What couldn't be estimated, or isn't there, is quiet NaN.
*/
struct Head_descriptor
{
  double shape_index =
      std::numeric_limits<double>::quiet_NaN(); ///< in [-1, 1]: -1 is a cup, 1 a cap; a plane has none
  double curvedness = std::numeric_limits<double>::quiet_NaN(); ///< mapped to [0, 1]
  double mean_curvature =
      std::numeric_limits<double>::quiet_NaN(); ///< mapped to [0, 1]: 0 is most concave, 1 most convex
  double Willmore_energy = std::numeric_limits<double>::quiet_NaN(); ///< mapped to [0, 1]
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_HEAD_DESCRIPTOR_H
