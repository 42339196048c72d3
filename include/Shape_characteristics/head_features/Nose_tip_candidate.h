#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_NOSE_TIP_CANDIDATE_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_NOSE_TIP_CANDIDATE_H

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsHeadFeatures

  holds a place of a surface that stands out like the tip of a nose, found by `nose_tip_candidates()`.

  \tparam Kernel a \cgal kernel
*/
template <typename Kernel>
struct Nose_tip_candidate
{
  /// the place, in the coordinates of the shape: a vertex, a point of the set, or a point within a large face
  typename Kernel::Point_3 point = typename Kernel::Point_3(0, 0, 0);
  /// the outward normal there, a mean over the surroundings
  typename Kernel::Vector_3 normal = typename Kernel::Vector_3(0, 0, 0);
  /// the mean depth of the surroundings below the tangent plane, by their radius: 0.33 for the end of a capsule, near 1 for a needle
  double prominence = 0.;
  /// the distance from the plane of symmetry, in units of the radius of the shape: a nose has about 0
  double asymmetry = 0.;
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_NOSE_TIP_CANDIDATE_H
