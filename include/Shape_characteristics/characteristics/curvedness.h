#ifndef SHAPE_CHARACTERISTICS_CHARACTERISTICS_CURVEDNESS_H
#define SHAPE_CHARACTERISTICS_CHARACTERISTICS_CURVEDNESS_H

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsCharacteristics

  returns the curvedness \f$ C = \sqrt{(K_1^2 + K_2^2) / 2} \f$: how much the surface deviates from a plane, regardless of the shape (the
  thesis's section 6.1.1; Koenderink and van Doorn \cgalCite{koenderink}).

  Its unit is 1/length. It is never negative, 0 on planes, and doesn't depend on the orientation of the surface.

  No square overflows or vanishes. NaN in a curvature gives NaN. Constant time.

  \tparam PrincipalCurvatures a type with the members `min_curvature` and `max_curvature`, as
  `Principal_curvatures_and_directions`

  \cgalExample{characteristics/characteristics.cpp}
*/
template <typename PrincipalCurvatures>
auto curvedness(const PrincipalCurvatures& curvatures) -> std::decay_t<decltype(curvatures.min_curvature)>
{
  using FT = std::decay_t<decltype(curvatures.min_curvature)>;
  const double k_min = CGAL::to_double(curvatures.min_curvature),
               k_max = CGAL::to_double(curvatures.max_curvature);
  if(std::isnan(k_min) || std::isnan(k_max)) // hypot(NaN, infinity) is infinity
    return FT(std::numeric_limits<double>::quiet_NaN());
  constexpr double sqrt_half = 0.70710678118654752440;
  const double largest = std::max(std::abs(k_min), std::abs(k_max));
  return FT(largest > std::numeric_limits<double>::max() / 2
                ? std::hypot(sqrt_half * k_min, sqrt_half * k_max)
                : sqrt_half * std::hypot(k_min, k_max));
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CHARACTERISTICS_CURVEDNESS_H
