#ifndef SHAPE_CHARACTERISTICS_CHARACTERISTICS_MEAN_CURVATURE_H
#define SHAPE_CHARACTERISTICS_CHARACTERISTICS_MEAN_CURVATURE_H

#include <CGAL/number_utils.h>

#include <type_traits>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsCharacteristics

  returns the mean curvature \f$ K_H = (K_1 + K_2) / 2 \f$ (the thesis's equation 4.6). Its unit is 1/length; positive where the surface
  is convex.

  No sum overflows. NaN in a curvature gives NaN. Constant time.

  \tparam PrincipalCurvatures a type with the members `min_curvature` and `max_curvature`, as
  `Principal_curvatures_and_directions`

  \cgalExample{characteristics/characteristics.cpp}
*/
template <typename PrincipalCurvatures>
auto mean_curvature(const PrincipalCurvatures& curvatures) -> std::decay_t<decltype(curvatures.min_curvature)>
{
  using FT = std::decay_t<decltype(curvatures.min_curvature)>;
  const double k_min = CGAL::to_double(curvatures.min_curvature),
               k_max = CGAL::to_double(curvatures.max_curvature);
  return FT(0.5 * k_min + 0.5 * k_max);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CHARACTERISTICS_MEAN_CURVATURE_H
