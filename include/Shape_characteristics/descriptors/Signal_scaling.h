#ifndef SHAPE_CHARACTERISTICS_DESCRIPTORS_SIGNAL_SCALING_H
#define SHAPE_CHARACTERISTICS_DESCRIPTORS_SIGNAL_SCALING_H

namespace Shape_characteristics {

/// \ingroup PkgShapeCharacteristicsDescriptors
/// says in which unit a symmetry signal is
enum class Signal_scaling : unsigned char
{
  UNIT_FREE, ///< divided by the power of the radius that makes it the same number for a surface and a scaled copy of it
  AS_PRINTED ///< as the thesis's formula says: in the unit of the points, or a power of it
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_DESCRIPTORS_SIGNAL_SCALING_H
