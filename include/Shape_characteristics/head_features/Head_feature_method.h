#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_HEAD_FEATURE_METHOD_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_HEAD_FEATURE_METHOD_H

namespace Shape_characteristics {

/// \ingroup PkgShapeCharacteristicsHeadFeatures
/// says how `detect_head_features()` looks for regions and points
enum class Head_feature_method : unsigned char
{
  /// by the shape of the surface, between vertices as well as at them: the result doesn't depend on how densely the head is
  /// tessellated, and what isn't there is not found
  SURFACE,
  /// as chapter 9 of the thesis says, word by word: vertices alone, numbers of vertices given by the user, and an answer whatever
  /// the mesh is, if its pose is known
  THESIS
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_HEAD_FEATURE_METHOD_H
