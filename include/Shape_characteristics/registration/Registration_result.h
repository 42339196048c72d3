#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_REGISTRATION_RESULT_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_REGISTRATION_RESULT_H

#include <Shape_characteristics/registration/Registration_quality.h>
#include <Shape_characteristics/registration/Registration_verdict.h>

#include <CGAL/Aff_transformation_3.h>

#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsRegistration

  holds what `register_partial_scans()` found.

  \tparam Kernel a \cgal kernel
*/
template <typename Kernel>
struct Registration_result
{
  /// a motion that brings the source to the target, and how well
  struct Candidate
  {
    CGAL::Aff_transformation_3<Kernel> transformation; ///< of the source
    Registration_quality quality;                      ///< how the scans fit together then
    bool is_reflection = false; ///< whether it mirrors the source: no motion in space does
  };

  /// whether the scans are registered. Look at it before the transformation: a failure has one, too.
  Registration_verdict verdict = Registration_verdict::FAILED;
  /// why they are not
  Registration_obstacle obstacle = Registration_obstacle::FEW_SAMPLES;
  /// the motion of the source. If the verdict is `AMBIGUOUS`, one of several, but the identity if only a reflection fits, which is
  /// then the first of the alternatives; if it is `FAILED`, the best that was tried, or the identity if there was none. Rotation and
  /// translation; with other units, scaling as well.
  CGAL::Aff_transformation_3<Kernel> transformation = CGAL::Aff_transformation_3<Kernel>(CGAL::IDENTITY);
  /// how the scans fit together then
  Registration_quality quality;
  /// how sure the verdict `SUCCESS` is, in [0, 1]; 0 if it is `FAILED`. If it is `AMBIGUOUS`, how sure this motion is: 0 if only a
  /// reflection fits.
  double confidence = 0.;
  /// the size of the source, by that of the target: other than 1 only if units are different
  double scale_ratio = 1.;
  /// other motions that fit almost as well, or a reflection that does; the best one first
  std::vector<Candidate> alternatives;
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_REGISTRATION_RESULT_H
