#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_MEAN_CURVATURE_EXTREME_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_MEAN_CURVATURE_EXTREME_H

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsScreenSpace

  returns the magnitude of mean curvature that a given share of the pixels does not exceed, to scale a picture by: the extreme that
  `Two_part_ambient_occlusion` asks for.

  The largest magnitude of all would be that of some pixel at a silhouette or a crease, beside which the rest of the surface is flat.

  \tparam NumberRange a model of `ConstRange` whose value type is a number type

  \param mean_curvatures the mean curvatures. Those that are not finite don't count.
  \param share the share of the pixels, in [0, 1]

  \return the magnitude, in 1/length; 0 if no curvature is finite or the surface is flat: there is no extreme then

  \throws std::invalid_argument if `share` is outside [0, 1]

  Complexity: linear.

  \cgalExample{screen_space/ambient_occlusion.cpp}
*/
template <typename NumberRange>
double mean_curvature_extreme(const NumberRange& mean_curvatures, double share = 0.999)
{
  if(!(share >= 0 && share <= 1))
    throw std::invalid_argument("mean_curvature_extreme: `share` must be in [0, 1]");
  std::vector<double> magnitudes;
  for(const auto& h : mean_curvatures)
    if(const double magnitude = std::abs(CGAL::to_double(h)); std::isfinite(magnitude))
      magnitudes.push_back(magnitude);
  if(magnitudes.empty())
    return 0;
  const auto place = magnitudes.begin() + std::ptrdiff_t(std::llround(share * double(magnitudes.size() - 1)));
  std::nth_element(magnitudes.begin(), place, magnitudes.end());
  return *place;
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_MEAN_CURVATURE_EXTREME_H
