#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_ASSESS_REGISTRATION_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_ASSESS_REGISTRATION_H

#include <Shape_characteristics/registration/Oriented_points.h>
#include <Shape_characteristics/registration/Registration_quality.h>
#include <Shape_characteristics/registration/internal/Registration_assessor.h>
#include <Shape_characteristics/registration/internal/check_oriented_points.h>
#include <Shape_characteristics/registration/internal/moved_scan.h>
#include <Shape_characteristics/registration/internal/scan_scale.h>

#include <Eigen/Geometry>

#include <algorithm>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsRegistration

  tells how well two scans fit together after a motion of one of them, whoever found it.

  The thesis leaves open how wrong registrations are found without somebody who looks at them (10.2.4). Where surfaces that
  belong together are near each other they coincide, and where surfaces that don't are near, they cross: of a right
  registration, most of the points that are near the other scan meet it. By `Registration_quality::agreement` above .25
  nearly all right registrations are told from nearly all wrong ones, those of mirrored sides included.

  \param source the source
  \param target the target
  \param motion the motion of the source

  \return the quality; all its numbers but `expected_agreement`, which the scans alone determine, are 0 if they aren't near each
          other anywhere or the motion isn't finite, and that as well if one has no two different points that can be used

  \throws std::invalid_argument if there are more or less normals than points or one is neither 0 nor of unit length, or `motion`
          stretches or mirrors

  The spacing of a scan is the mean distance of its points to their 6 nearest ones; the larger one of the two is taken. If scans are
  not equally dense, the denser one should be thinned out.

  Complexity: \f$ O(n \log n) \f$ for \f$ n \f$ points.
*/
inline Registration_quality assess_registration(const Oriented_points& source,
                                                const Oriented_points& target,
                                                const Eigen::Isometry3d& motion)
{
  internal::check_normals(source, target);
  internal::check_motion(motion);
  const double unit = internal::scan_scale(source, target);
  const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  const Oriented_points s = internal::moved_scan(source, origin, unit),
                        t = internal::moved_scan(target, origin, unit);
  const double spacing =
      (std::max)(internal::Registration_assessor::spacing(s), internal::Registration_assessor::spacing(t));
  if(!(spacing > 0.))
    return {};
  Eigen::Isometry3d m = motion;
  m.translation() *= unit;
  return internal::Registration_assessor(s, t, spacing)(m);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_ASSESS_REGISTRATION_H
