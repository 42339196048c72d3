#ifndef SHAPE_CHARACTERISTICS_DESCRIPTORS_SHOT_VARIANT_H
#define SHAPE_CHARACTERISTICS_DESCRIPTORS_SHOT_VARIANT_H

namespace Shape_characteristics {

/// \ingroup PkgShapeCharacteristicsDescriptors
/// says how `Shot_descriptor` shares a neighbor among the bins next to it
enum class Shot_variant : unsigned char
{
  PAPER, ///< quadrilinear interpolation: the product of the weights in azimuth, elevation, radius and cosine
  /// as the Point Cloud Library does: the sum of the four weights in the bin of the neighbor, and in each of the four
  /// directions one weight in the bin next to it; what belongs to the last of the 11 bins of cosines by a share of less than
  /// one half goes to the first
  PCL
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_DESCRIPTORS_SHOT_VARIANT_H
