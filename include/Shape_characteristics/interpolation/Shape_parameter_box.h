#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_SHAPE_PARAMETER_BOX_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_SHAPE_PARAMETER_BOX_H

namespace Shape_characteristics {

/// \ingroup PkgShapeCharacteristicsInterpolation
/// says by which box of a neighborhood the thesis's shape parameter of `Exponential_cubic` is chosen (thesis, 8.1.1)
enum class Shape_parameter_box : unsigned char
{
  AXIS_ALIGNED, ///< along the coordinate axes: the result changes when the object turns
  ORIENTED      ///< along the principal axes of the neighborhood
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_SHAPE_PARAMETER_BOX_H
