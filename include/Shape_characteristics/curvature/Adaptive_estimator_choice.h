#ifndef SHAPE_CHARACTERISTICS_CURVATURE_ADAPTIVE_ESTIMATOR_CHOICE_H
#define SHAPE_CHARACTERISTICS_CURVATURE_ADAPTIVE_ESTIMATOR_CHOICE_H

namespace Shape_characteristics {

/// \ingroup PkgShapeCharacteristicsCurvature
/// the estimators among which `adaptive_curvatures()` chooses at each sample: Hermite radial basis functions that
/// trust points and normals to different degrees, over neighborhoods of different sizes, which it blends, and the quadric
/// of all points or all normals, where there is one
enum class Adaptive_estimator_choice : unsigned char
{
  EXACT_2_RINGS,  ///< points and normals are taken for exact, unchecked; two rings (18 neighbors)
  EXACT_3_RINGS,  ///< points and normals are taken for exact, unchecked; three rings (36 neighbors)
  POINTS_2_RINGS, ///< points are exact, normals are weak evidence; two rings
  POINTS_3_RINGS, ///< points are exact, normals are weak evidence; three rings
  POINTS_4_RINGS, ///< points are exact and the surface is smooth, normals are weak evidence; four rings (60 neighbors)
  NORMALS_2_RINGS, ///< points are noisy, normals are trusted; two rings
  NORMALS_3_RINGS, ///< points are noisy, normals are trusted; three rings
  SMOOTHED_3_RINGS, ///< as `hrbf_curvatures()` by default: points and normals are as noisy as they seem to be, and are smoothed
                    ///< before the fit; three rings
  SMOOTHED_4_RINGS, ///< points and normals are noisy (by .002 of the neighbors' distance at least), and are smoothed twice
                    ///< before the fit; four rings
  GENTLY_SMOOTHED_4_RINGS, ///< as `SMOOTHED_4_RINGS`, for a tenth of the noise that points seem to have
  BARELY_SMOOTHED_4_RINGS, ///< points have a hundredth of the noise, and are not smoothed before the fit; four rings
  CHECKED_2_RINGS, ///< as `hrbf_curvatures()` where `normals_are_exact`: they are, as far as they agree with the points; two rings,
                   ///< chosen where three have no fit
  CHECKED_3_RINGS, ///< as `CHECKED_2_RINGS`, with three rings
  QUADRIC,         ///< a quadric has the points, or the normals, of two rings (18 neighbors), to eight digits
  NONE             ///< there is no estimate
};

/// \ingroup PkgShapeCharacteristicsCurvature
/// returns the name of `choice` as it is written in the program, for tables and messages.
constexpr const char* to_string(Adaptive_estimator_choice choice) noexcept
{
  switch(choice)
  {
  case Adaptive_estimator_choice::EXACT_2_RINGS:
    return "EXACT_2_RINGS";
  case Adaptive_estimator_choice::EXACT_3_RINGS:
    return "EXACT_3_RINGS";
  case Adaptive_estimator_choice::POINTS_2_RINGS:
    return "POINTS_2_RINGS";
  case Adaptive_estimator_choice::POINTS_3_RINGS:
    return "POINTS_3_RINGS";
  case Adaptive_estimator_choice::POINTS_4_RINGS:
    return "POINTS_4_RINGS";
  case Adaptive_estimator_choice::NORMALS_2_RINGS:
    return "NORMALS_2_RINGS";
  case Adaptive_estimator_choice::NORMALS_3_RINGS:
    return "NORMALS_3_RINGS";
  case Adaptive_estimator_choice::SMOOTHED_3_RINGS:
    return "SMOOTHED_3_RINGS";
  case Adaptive_estimator_choice::SMOOTHED_4_RINGS:
    return "SMOOTHED_4_RINGS";
  case Adaptive_estimator_choice::GENTLY_SMOOTHED_4_RINGS:
    return "GENTLY_SMOOTHED_4_RINGS";
  case Adaptive_estimator_choice::BARELY_SMOOTHED_4_RINGS:
    return "BARELY_SMOOTHED_4_RINGS";
  case Adaptive_estimator_choice::CHECKED_2_RINGS:
    return "CHECKED_2_RINGS";
  case Adaptive_estimator_choice::CHECKED_3_RINGS:
    return "CHECKED_3_RINGS";
  case Adaptive_estimator_choice::QUADRIC:
    return "QUADRIC";
  case Adaptive_estimator_choice::NONE:
    return "NONE";
  }
  return "";
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_ADAPTIVE_ESTIMATOR_CHOICE_H
