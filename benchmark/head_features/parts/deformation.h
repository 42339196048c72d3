#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_HEAD_FEATURES_PARTS_DEFORMATION_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_HEAD_FEATURES_PARTS_DEFORMATION_H

#include "Head.h"

#include <Shape_characteristics/head_features/Head_expression.h>

#include <string>

namespace head_features {

/// How one head differs when it is deformed by the points that were found, and by the true ones; in percent of its height.
struct Deformation_difference
{
  std::string name, variant;
  SC::Head_expression expression;
  bool is_deformed = false;                         ///< no point is missing that the expression needs
  double largest_motion = 0.;                       ///< of a vertex, by the true points
  double largest_difference = 0.;                   ///< between the two places of a vertex
  double mean_distance = 0., largest_distance = 0.; ///< from the vertices that move to the other surface
};

Deformation_difference
deformation_difference(const Head& head, const Features& found, SC::Head_expression expression);

} // namespace head_features

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_HEAD_FEATURES_PARTS_DEFORMATION_H
