#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_HEAD_POSE_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_HEAD_POSE_H

#include <Shape_characteristics/head_features/Head_verdict.h>

#include <CGAL/Aff_transformation_3.h>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsHeadFeatures

  holds what `estimate_head_pose()` found: where the head is, which way it looks, and how large it is.

  The frame of a head is the thesis's (section 9.1.1): the nose points towards +z, the top of the head is towards +y, the plane of
  symmetry is x = 0, and the box around the head has its center in the origin and 1 as its longest side. What the box contains
  doesn't depend on how much beside the head is there: it is the one around the mean head, from its top down to the neck,
  a tenth of its height below the chin, after it was brought to this head by a similarity. So a bust, the head cut from it, and a
  scan of its face have the same frame. The head's own box differs by a few percent, and the box of a bust reaches farther down
  and to the sides.

  \tparam Kernel a \cgal kernel
*/
template <typename Kernel>
struct Head_pose
{
  /// whether the shape is a head. Look at it before the rest: what isn't a head has a pose, too.
  Head_verdict verdict = Head_verdict::NOT_A_HEAD;
  /// why it isn't, or isn't with certainty
  Head_obstacle obstacle = Head_obstacle::FEW_SAMPLES;
  /// how sure it is that the shape is a head in this pose, in [0, 1]
  double confidence = 0.;
  /// from the coordinates of the shape to the frame of the head: rotation, translation and scaling, never a reflection. If
  /// the shape is no head, the best that was tried, or the identity if there was none.
  CGAL::Aff_transformation_3<Kernel> transformation = CGAL::Aff_transformation_3<Kernel>(CGAL::IDENTITY);
  /// the plane of symmetry in the coordinates of the shape; its normal points towards +x of the frame
  typename Kernel::Plane_3 symmetry_plane = typename Kernel::Plane_3(1, 0, 0, 0);
  /// the tip of the nose, a point of the shape, in its coordinates: the vertex (or point) that reaches farthest to the front
  typename Kernel::Point_3 nose_tip = typename Kernel::Point_3(0, 0, 0);
  /// the length, in the unit of the shape, that is 1 in the frame
  double size = 0.;

  /// whether the verdict is `HEAD`
  bool is_head() const noexcept { return verdict == Head_verdict::HEAD; }
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_HEAD_POSE_H
