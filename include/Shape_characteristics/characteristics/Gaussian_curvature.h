#ifndef SHAPE_CHARACTERISTICS_CHARACTERISTICS_GAUSSIAN_CURVATURE_H
#define SHAPE_CHARACTERISTICS_CHARACTERISTICS_GAUSSIAN_CURVATURE_H

#include <CGAL/number_utils.h>

#include <type_traits>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsCharacteristics

  returns the Gaussian curvature \f$ K_G = K_1 K_2 \f$ (the thesis's equation 4.7). Its unit is 1/length<sup>2</sup>; it doesn't
  depend on the orientation of the surface.

  It leaves the range of `double` (infinity or 0) if its true value does. NaN in a curvature gives NaN.
  Constant time.

  \tparam PrincipalCurvatures a type with the members `min_curvature` and `max_curvature`, as
  `Principal_curvatures_and_directions`

  \cgalExample{characteristics/characteristics.cpp}
*/
template <typename PrincipalCurvatures>
auto Gaussian_curvature(const PrincipalCurvatures& curvatures)
    -> std::decay_t<decltype(curvatures.min_curvature)>
{
  using FT = std::decay_t<decltype(curvatures.min_curvature)>;
  const double k_min = CGAL::to_double(curvatures.min_curvature),
               k_max = CGAL::to_double(curvatures.max_curvature);
  return FT(k_min * k_max);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CHARACTERISTICS_GAUSSIAN_CURVATURE_H
