#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_HEAD_EXPRESSION_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_HEAD_EXPRESSION_H

#include <cstddef>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsHeadFeatures

  names the ready deformations of a head by its feature points (thesis, Figures 9.9 to 9.11).
*/
enum class Head_expression : unsigned char
{
  SMILE,           ///< the corners of the mouth go up, outwards and back
  SAD,             ///< the corners of the mouth go down
  WIDE_MOUTH,      ///< the corners of the mouth go outwards
  LONGER_EAR_LOBE, ///< the lobes of the ears that were found go down
  LONGER_CHIN,     ///< the chin goes down
  BIGGER_NOSE      ///< the nose grows
};

/// \ingroup PkgShapeCharacteristicsHeadFeatures
/// the number of expressions: those of `Head_expression` are 0, 1, ..., up to it
inline constexpr std::size_t number_of_head_expressions = 6;

/// \ingroup PkgShapeCharacteristicsHeadFeatures
/// returns the name of `expression` as it is written in the program, for tables and files.
constexpr const char* to_string(Head_expression expression) noexcept
{
  constexpr const char* names[number_of_head_expressions] = {"SMILE",           "SAD",         "WIDE_MOUTH",
                                                             "LONGER_EAR_LOBE", "LONGER_CHIN", "BIGGER_NOSE"};
  const auto i = static_cast<std::size_t>(expression);
  return i < number_of_head_expressions ? names[i] : "";
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_HEAD_EXPRESSION_H
