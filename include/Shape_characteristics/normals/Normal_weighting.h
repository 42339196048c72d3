#ifndef SHAPE_CHARACTERISTICS_NORMALS_NORMAL_WEIGHTING_H
#define SHAPE_CHARACTERISTICS_NORMALS_NORMAL_WEIGHTING_H

namespace Shape_characteristics {

/// \ingroup PkgShapeCharacteristicsNormals
/// says how the unit normals of the faces at a vertex are weighted in the sum that is the vertex's normal
enum class Normal_weighting : unsigned char
{
  AVERAGE, ///< all alike (thesis, equation 2.2)
  MAX, ///< sine of the corner's angle over the product of its two edges' lengths (N. Max 1999; thesis, equation 2.3):
       ///< exact on spheres, and the best of the four on smooth surfaces
  AREA, ///< area of the face
  ANGLE ///< angle of the face's corner
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_NORMALS_NORMAL_WEIGHTING_H
