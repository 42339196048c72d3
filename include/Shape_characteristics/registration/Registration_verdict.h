#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_REGISTRATION_VERDICT_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_REGISTRATION_VERDICT_H

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsRegistration

  says whether two scans were registered.
*/
enum class Registration_verdict : unsigned char
{
  SUCCESS, ///< one motion, and no other, brings the scans together
  AMBIGUOUS, ///< several motions do so almost equally well, or a reflection: the scans can't tell which is meant
  FAILED     ///< none was found
};

/// \ingroup PkgShapeCharacteristicsRegistration
/// returns the name of `verdict` as it is written in the program, for tables and messages.
constexpr const char* to_string(Registration_verdict verdict) noexcept
{
  switch(verdict)
  {
  case Registration_verdict::SUCCESS:
    return "SUCCESS";
  case Registration_verdict::AMBIGUOUS:
    return "AMBIGUOUS";
  case Registration_verdict::FAILED:
    return "FAILED";
  }
  return "";
}

/*!
  \ingroup PkgShapeCharacteristicsRegistration

  says why two scans were not registered.
*/
enum class Registration_obstacle : unsigned char
{
  NONE,                ///< nothing: the verdict is `SUCCESS`
  FEW_SAMPLES,         ///< a scan has too few points that can be used
  CANCELLED,           ///< the callback stopped the search
  FEW_CORRESPONDENCES, ///< too few descriptors are alike: the surfaces have nothing in common, or no features at all
  SURFACES_DISAGREE, ///< what was found doesn't bring the surfaces together
  DIFFERENT_UNITS, ///< one scan is at least 2.5 times as large as the other, with points as many times as far apart
  REFLECTION,     ///< the scans come together only mirrored: one was, or they are the two sides of one object
  SLIDING,        ///< the surfaces can be moved along each other: planes, spheres, cylinders
  SEVERAL_MOTIONS ///< the object can't be told from itself after a rotation
};

/// \ingroup PkgShapeCharacteristicsRegistration
/// returns the name of `obstacle` as it is written in the program, for tables and messages.
constexpr const char* to_string(Registration_obstacle obstacle) noexcept
{
  switch(obstacle)
  {
  case Registration_obstacle::NONE:
    return "NONE";
  case Registration_obstacle::FEW_SAMPLES:
    return "FEW_SAMPLES";
  case Registration_obstacle::CANCELLED:
    return "CANCELLED";
  case Registration_obstacle::FEW_CORRESPONDENCES:
    return "FEW_CORRESPONDENCES";
  case Registration_obstacle::SURFACES_DISAGREE:
    return "SURFACES_DISAGREE";
  case Registration_obstacle::DIFFERENT_UNITS:
    return "DIFFERENT_UNITS";
  case Registration_obstacle::REFLECTION:
    return "REFLECTION";
  case Registration_obstacle::SLIDING:
    return "SLIDING";
  case Registration_obstacle::SEVERAL_MOTIONS:
    return "SEVERAL_MOTIONS";
  }
  return "";
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_REGISTRATION_VERDICT_H
