#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_HEAD_FEATURE_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_HEAD_FEATURE_H

#include <cstddef>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsHeadFeatures

  names the feature points of a head (thesis, Figures 9.1 to 9.5).

  As in the thesis, "left" is the side of negative x, with the nose towards +z and the top towards +y: the left of a picture
  that the head looks out of, and the right of the person. Which of two corners, and which of the points around the nose, has
  which number is defined in the thesis by its figures alone; here it is as said below.
*/
enum class Head_feature : unsigned char
{
  TOP,      ///< the highest point of the head
  NOSE_TIP, ///< the tip of the nose
  CHIN,     ///< the foremost point of the chin (pogonion)

  LEFT_E1, ///< outer corner of the left eye
  LEFT_E2, ///< inner corner of the left eye
  LEFT_E3, ///< edge of the upper lid, a third of the way from the outer to the inner corner
  LEFT_E4, ///< edge of the upper lid, two thirds of the way
  LEFT_E5, ///< edge of the lower lid, a third of the way
  LEFT_E6, ///< edge of the lower lid, two thirds of the way

  RIGHT_E1, ///< outer corner of the right eye
  RIGHT_E2, ///< inner corner of the right eye
  RIGHT_E3, ///< edge of the upper lid, a third of the way from the outer to the inner corner
  RIGHT_E4, ///< edge of the upper lid, two thirds of the way
  RIGHT_E5, ///< edge of the lower lid, a third of the way
  RIGHT_E6, ///< edge of the lower lid, two thirds of the way

  N1, ///< base of the nose: where it meets the upper lip (subnasale)
  N2, ///< tip of the nose: the same point as `NOSE_TIP`
  N3, ///< middle of the bridge, between root and tip
  N4, ///< root of the nose, between the eyes (nasion)
  N5, ///< left side of the nose at N3
  N6, ///< left side of the nose at N4
  N7, ///< right side of the nose at N3
  N8, ///< right side of the nose at N4

  M1, ///< left corner of the mouth
  M2, ///< right corner of the mouth
  M3, ///< middle of the upper lip
  M4, ///< middle of the lower lip

  LEFT_R1, ///< left ear, the point nearest to the outer corner at the top and front of the ear's box
  LEFT_R2, ///< left ear, top and back
  LEFT_R3, ///< left ear, bottom and front
  LEFT_R4, ///< left ear, bottom and back
  LEFT_R5, ///< inside of the left ear: the point nearest to the mean of R1 to R4

  RIGHT_R1, ///< right ear, the point nearest to the outer corner at the top and front of the ear's box
  RIGHT_R2, ///< right ear, top and back
  RIGHT_R3, ///< right ear, bottom and front
  RIGHT_R4, ///< right ear, bottom and back
  RIGHT_R5  ///< inside of the right ear: the point nearest to the mean of R1 to R4
};

/// \ingroup PkgShapeCharacteristicsHeadFeatures
/// the number of feature points: those of `Head_feature` are 0, 1, ..., up to it
inline constexpr std::size_t number_of_head_features = 37;

/*!
  \ingroup PkgShapeCharacteristicsHeadFeatures

  names the regions of a head. Left is where x is negative, as in `Head_feature`.
*/
enum class Head_region : unsigned char
{
  LEFT_EYE,  ///< the left eye with its lids
  RIGHT_EYE, ///< the right eye with its lids
  NOSE,      ///< the nose, from its root to its base
  MOUTH,     ///< the lips
  LEFT_EAR,  ///< the left auricle
  RIGHT_EAR  ///< the right auricle
};

/// \ingroup PkgShapeCharacteristicsHeadFeatures
/// the number of regions: those of `Head_region` are 0, 1, ..., up to it
inline constexpr std::size_t number_of_head_regions = 6;

/// \ingroup PkgShapeCharacteristicsHeadFeatures
/// returns the name of `feature` as it is written in the program, for tables and files.
constexpr const char* to_string(Head_feature feature) noexcept
{
  constexpr const char* names[number_of_head_features] = {
      "TOP",      "NOSE_TIP", "CHIN",     "LEFT_E1",  "LEFT_E2",  "LEFT_E3",  "LEFT_E4",  "LEFT_E5",
      "LEFT_E6",  "RIGHT_E1", "RIGHT_E2", "RIGHT_E3", "RIGHT_E4", "RIGHT_E5", "RIGHT_E6", "N1",
      "N2",       "N3",       "N4",       "N5",       "N6",       "N7",       "N8",       "M1",
      "M2",       "M3",       "M4",       "LEFT_R1",  "LEFT_R2",  "LEFT_R3",  "LEFT_R4",  "LEFT_R5",
      "RIGHT_R1", "RIGHT_R2", "RIGHT_R3", "RIGHT_R4", "RIGHT_R5"};
  const auto i = static_cast<std::size_t>(feature);
  return i < number_of_head_features ? names[i] : "";
}

/// \ingroup PkgShapeCharacteristicsHeadFeatures
/// returns the name of `region` as it is written in the program, for tables and files.
constexpr const char* to_string(Head_region region) noexcept
{
  constexpr const char* names[number_of_head_regions] = {"LEFT_EYE", "RIGHT_EYE", "NOSE",
                                                         "MOUTH",    "LEFT_EAR",  "RIGHT_EAR"};
  const auto i = static_cast<std::size_t>(region);
  return i < number_of_head_regions ? names[i] : "";
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_HEAD_FEATURE_H
