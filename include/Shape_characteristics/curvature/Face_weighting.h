#ifndef SHAPE_CHARACTERISTICS_CURVATURE_FACE_WEIGHTING_H
#define SHAPE_CHARACTERISTICS_CURVATURE_FACE_WEIGHTING_H

namespace Shape_characteristics {

/// \ingroup PkgShapeCharacteristicsCurvature
/// says how the curvatures of the faces at a vertex are weighted in the mean that is the vertex's curvature
enum class Face_weighting : unsigned char
{
  UNIFORM, ///< all alike: better on irregular meshes
  AREA     ///< area of the face, or of the part of it that belongs to the vertex: see the function
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_FACE_WEIGHTING_H
