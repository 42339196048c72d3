#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_HEAD_VERDICT_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_HEAD_VERDICT_H

namespace Shape_characteristics {

/// \ingroup PkgShapeCharacteristicsHeadFeatures
/// says whether a shape is a human head
enum class Head_verdict : unsigned char
{
  HEAD,      ///< it is, and its pose is known
  UNCERTAIN, ///< it may be: the pose is the best one found, and worth a look before it is used
  NOT_A_HEAD ///< it isn't, or too little of it is there; the pose means nothing
};

/// \ingroup PkgShapeCharacteristicsHeadFeatures
/// returns the name of `verdict` as it is written in the program, for tables and messages.
constexpr const char* to_string(Head_verdict verdict) noexcept
{
  switch(verdict)
  {
  case Head_verdict::HEAD:
    return "HEAD";
  case Head_verdict::UNCERTAIN:
    return "UNCERTAIN";
  case Head_verdict::NOT_A_HEAD:
    return "NOT_A_HEAD";
  }
  return "";
}

/// \ingroup PkgShapeCharacteristicsHeadFeatures
/// says why a shape was not taken for a head, or not with certainty
enum class Head_obstacle : unsigned char
{
  NONE,        ///< nothing: the verdict is `HEAD`, and what was looked for is there
  FEW_SAMPLES, ///< there are too few points that can be used, or fewer vertices than a head has features
  CANCELLED,   ///< the callback stopped the search
  INSIDE_OUT, ///< it is a head, but its normals point inward: reverse the orientation of the faces, or the normals
  NO_NOSE,            ///< nothing stands out as the tip of a nose does
  SHAPE_DISAGREES,    ///< no pose brings the shape and a mean head together well enough
  FACE_IS_INCOMPLETE, ///< a large part of the face, or one side of it, isn't there
  NO_SYMMETRY,        ///< the sides of the face aren't mirror images of each other
  WRONG_WAY_UP,       ///< the top isn't where `upward_direction` says
  DUPLICATE ///< there are no features to be found on a soup of faces, each of which has its own copies of its vertices:
            ///< see `CGAL::Polygon_mesh_processing::stitch_borders()`
};

/// \ingroup PkgShapeCharacteristicsHeadFeatures
/// returns the name of `obstacle` as it is written in the program, for tables and messages.
constexpr const char* to_string(Head_obstacle obstacle) noexcept
{
  switch(obstacle)
  {
  case Head_obstacle::NONE:
    return "NONE";
  case Head_obstacle::FEW_SAMPLES:
    return "FEW_SAMPLES";
  case Head_obstacle::CANCELLED:
    return "CANCELLED";
  case Head_obstacle::INSIDE_OUT:
    return "INSIDE_OUT";
  case Head_obstacle::NO_NOSE:
    return "NO_NOSE";
  case Head_obstacle::SHAPE_DISAGREES:
    return "SHAPE_DISAGREES";
  case Head_obstacle::FACE_IS_INCOMPLETE:
    return "FACE_IS_INCOMPLETE";
  case Head_obstacle::NO_SYMMETRY:
    return "NO_SYMMETRY";
  case Head_obstacle::WRONG_WAY_UP:
    return "WRONG_WAY_UP";
  case Head_obstacle::DUPLICATE:
    return "DUPLICATE";
  }
  return "";
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_HEAD_VERDICT_H
