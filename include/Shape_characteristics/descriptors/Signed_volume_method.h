#ifndef SHAPE_CHARACTERISTICS_DESCRIPTORS_SIGNED_VOLUME_METHOD_H
#define SHAPE_CHARACTERISTICS_DESCRIPTORS_SIGNED_VOLUME_METHOD_H

namespace Shape_characteristics {

/// \ingroup PkgShapeCharacteristicsDescriptors
/// says what spans the volume of `Signed_volume_descriptor`
enum class Signed_volume_method : unsigned char
{
  EXTREMA, ///< the samples with the largest and the smallest curvature
  BINS ///< the centroids of the parts of the neighborhood with the largest and the smallest mean curvature
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_DESCRIPTORS_SIGNED_VOLUME_METHOD_H
