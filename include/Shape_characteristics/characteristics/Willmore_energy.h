#ifndef SHAPE_CHARACTERISTICS_CHARACTERISTICS_WILLMORE_ENERGY_H
#define SHAPE_CHARACTERISTICS_CHARACTERISTICS_WILLMORE_ENERGY_H

#include <CGAL/number_utils.h>

#include <type_traits>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsCharacteristics

  returns the (pointwise) Willmore energy \f$ (K_1 - K_2)^2 / 4 = K_H^2 - K_G \f$: how much the surface deviates from a round sphere (the
  thesis's section 6.1.1).

  Its unit is 1/length<sup>2</sup>. It is never negative, 0 at umbilics and on planes, and doesn't depend on the orientation
  of the surface. It is computed from the difference, which doesn't cancel.

  It leaves the range of `double` (infinity or 0) if its true value does. NaN in a curvature gives NaN. Constant time.

  \tparam PrincipalCurvatures a type with the members `min_curvature` and `max_curvature`, as
  `Principal_curvatures_and_directions`

  \cgalExample{characteristics/characteristics.cpp}
*/
template <typename PrincipalCurvatures>
auto Willmore_energy(const PrincipalCurvatures& curvatures)
    -> std::decay_t<decltype(curvatures.min_curvature)>
{
  using FT = std::decay_t<decltype(curvatures.min_curvature)>;
  const double k_min = CGAL::to_double(curvatures.min_curvature),
               k_max = CGAL::to_double(curvatures.max_curvature);
  const double half_difference = 0.5 * (k_max - k_min);
  return FT(half_difference * half_difference);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CHARACTERISTICS_WILLMORE_ENERGY_H
