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
/// says why a shape was not taken for a head, or not with certainty
enum class Head_obstacle : unsigned char
{
  NONE,        ///< nothing: the verdict is `HEAD`
  FEW_SAMPLES, ///< there are too few points that can be used
  CANCELLED,   ///< the callback stopped the search
  INSIDE_OUT, ///< it is a head, but its normals point inward: reverse the orientation of the faces, or the normals
  NO_NOSE,            ///< nothing stands out as the tip of a nose does
  SHAPE_DISAGREES,    ///< no pose brings the shape and a mean head together well enough
  FACE_IS_INCOMPLETE, ///< a large part of the face, or one side of it, isn't there
  NO_SYMMETRY,        ///< the sides of the face aren't mirror images of each other
  WRONG_WAY_UP        ///< the top isn't where `upward_direction` says
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_HEAD_VERDICT_H
