#ifndef SHAPE_CHARACTERISTICS_PRINCIPAL_CURVATURES_AND_DIRECTIONS_H
#define SHAPE_CHARACTERISTICS_PRINCIPAL_CURVATURES_AND_DIRECTIONS_H

#include <CGAL/Origin.h>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsResults

  stores the principal curvatures and directions of a surface at a point.

  The curvatures are signed and pointwise (unit: 1/length; never integrated over an area), and
  `min_curvature <= max_curvature`. They are positive where the surface is convex seen along its outward
  normal: on a sphere of radius \f$ r \f$ both are \f$ +1/r \f$. Flipping the normals negates and exchanges them.

  The directions are of unit length, orthogonal to each other and to the normal, and determined up to their
  sign; where both curvatures are equal (at an umbilic), they are any such pair.

  The members are those of `CGAL::Polygon_mesh_processing::Principal_curvatures_and_directions` (\cgal 6),
  which every estimator fills just as well.

  \tparam GeomTraits a model of `Kernel`
*/
template <typename GeomTraits>
struct Principal_curvatures_and_directions
{
  using FT = typename GeomTraits::FT;             ///< number type
  using Vector_3 = typename GeomTraits::Vector_3; ///< vector type

  FT min_curvature = FT(0);                   ///< smaller principal curvature
  FT max_curvature = FT(0);                   ///< larger principal curvature
  Vector_3 min_direction = CGAL::NULL_VECTOR; ///< unit direction of `min_curvature`
  Vector_3 max_direction = CGAL::NULL_VECTOR; ///< unit direction of `max_curvature`

  /// a plane's curvatures, no directions
  Principal_curvatures_and_directions() = default;

  /// from the values of all members
  Principal_curvatures_and_directions(const FT& min_curvature,
                                      const FT& max_curvature,
                                      const Vector_3& min_direction,
                                      const Vector_3& max_direction)
    : min_curvature(min_curvature),
      max_curvature(max_curvature),
      min_direction(min_direction),
      max_direction(max_direction)
  {}
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_PRINCIPAL_CURVATURES_AND_DIRECTIONS_H
