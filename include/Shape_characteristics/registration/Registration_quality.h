#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_REGISTRATION_QUALITY_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_REGISTRATION_QUALITY_H

#include <cstddef>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsRegistration

  tells how well two scans fit together after a motion of one of them. It looks at the surfaces, and knows nothing
  of the descriptors and correspondences that the motion was found with. All numbers are free of units.

  Points and normals are averaged over 16 neighbors before, along the normal.
*/
struct Registration_quality
{
  /// the share of the points of either scan that have the other one near, in [0, 1]: its nearest point is within 3 spacings, and
  /// within one spacing along the surface
  double overlap = 0.;
  /// the share of those near points that meet the other scan, in [0, 1]: they are within .35 spacings of its tangent plane,
  /// and the normals are within 32 degrees (cosine .85)
  double agreement = 0.;
  /// what the agreement of a right registration would be, in [0, 1]: that of the points with their own scan, at the nearest other
  /// point of it. It is less than 1 where there is noise.
  double expected_agreement = 0.;
  /// the correlation of the ranks of the near points' curvatures with those of the other scan there, in [-1, 1]; 0 if there are less
  /// than 10
  double curvature_correlation = 0.;
  /// the share of the near points where the surfaces cross or turn their backs to each other, in [0, 1]: normals are more than
  /// 90 degrees apart
  double opposition = 0.;
  /// the share of the near points that lie beneath the other scan, in [0, 1]: more than .35 spacings under its tangent plane.
  /// What two scans of one solid have beneath each other is noise.
  double penetration = 0.;
  /// number of near points
  std::size_t number_of_near_points = 0;
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_REGISTRATION_QUALITY_H
