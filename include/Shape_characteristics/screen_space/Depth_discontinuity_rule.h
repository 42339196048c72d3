#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_DEPTH_DISCONTINUITY_RULE_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_DEPTH_DISCONTINUITY_RULE_H

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsScreenSpace

  chooses how neighboring pixels are found that belong to different surfaces.
*/
enum class Depth_discontinuity_rule : unsigned char
{
  /// pixels belong together if both show a surface
  NONE,
  /// the thesis's equation 7.13: a neighbor whose depth differs by more than 1/f, with f the distance of the far plane, at least 100, and depths
  /// the distance divided by that of the far plane, is replaced by that one pixel away. So a gap is what is wider than 1, if the far plane is beyond 100,
  /// whatever the unit of length; and pixels next to a silhouette keep their neighbor on the other surface.
  FAR_PLANE,
  /// ours: points `p`, `q` with normals `m`, `n` belong to different surfaces if the edge `q - p` is long, more than twice the distance of the pixels at that
  /// depth, and neither lies along the surface: \f$ |(m + n) \cdot (q - p)| > |q - p| / 2 \f$. On a smooth surface the sum vanishes to third order, however
  /// steeply it is seen; a crease is kept where both of its sides are seen at less than 60 degrees. Normals of normal maps, and of coarse meshes, are not
  /// those of the points: so the edge is kept as well if the pixel before or behind it is in line to an eighth of its length. A neighbor that is told apart is replaced by that one pixel away, and if this one is as well, its triangles are left out. It has no unit.
  TANGENT_PLANES
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_DEPTH_DISCONTINUITY_RULE_H
