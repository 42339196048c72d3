#ifndef SHAPE_CHARACTERISTICS_CURVATURE_PATCH_EVALUATION_H
#define SHAPE_CHARACTERISTICS_CURVATURE_PATCH_EVALUATION_H

namespace Shape_characteristics {

/// \ingroup PkgShapeCharacteristicsCurvature
/// says at which point of the curved patch over a triangle its curvature is taken
enum class Patch_evaluation : unsigned char
{
  CENTER, ///< in the middle: one curvature for a triangle, for all its vertices
  VERTEX  ///< at the vertex in question
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_PATCH_EVALUATION_H
