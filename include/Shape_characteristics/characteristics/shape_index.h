#ifndef SHAPE_CHARACTERISTICS_CHARACTERISTICS_SHAPE_INDEX_H
#define SHAPE_CHARACTERISTICS_CHARACTERISTICS_SHAPE_INDEX_H

#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsCharacteristics

  returns the shape index \f$ S = \frac{2}{\pi} \arctan \frac{K_1 + K_2}{K_1 - K_2} \f$, \f$ K_1 \geq K_2 \f$ (the thesis's section 6.1.1;
  Koenderink and van Doorn \cgalCite{koenderink}).

  It tells the shape regardless of the size, in [-1, 1]: -1 is a cup (spherical hollow), -0.5 a rut, 0 a symmetric saddle, +0.5 a ridge, and
  +1 a cap (spherical bump). Flipping the normals negates it.

  At umbilics, where \f$ K_1 = K_2 \neq 0 \f$, it is the limit, \f$ \pm 1 \f$. On planes, where both curvatures
  are zero, the shape index is not defined and the result is quiet NaN (0 would claim a saddle). Curvatures
  that are merely almost zero give the shape index of their noise: ask `is_planar()` first. NaN or infinity in a
  curvature gives NaN.

  No sum overflows. Constant time.

  \tparam PrincipalCurvatures a type with the members `min_curvature` and `max_curvature`, as
  `Principal_curvatures_and_directions`

  \cgalExample{characteristics/characteristics.cpp}
*/
template <typename PrincipalCurvatures>
auto shape_index(const PrincipalCurvatures& curvatures) -> std::decay_t<decltype(curvatures.min_curvature)>
{
  using FT = std::decay_t<decltype(curvatures.min_curvature)>;
  double k_min = CGAL::to_double(curvatures.min_curvature), k_max = CGAL::to_double(curvatures.max_curvature);
  if(!(std::isfinite(k_min) && std::isfinite(k_max)) || (k_min == 0 && k_max == 0))
    return FT(std::numeric_limits<double>::quiet_NaN());
  if(std::max(std::abs(k_min), std::abs(k_max)) > std::numeric_limits<double>::max() / 2)
  { // the sum or the difference would overflow
    k_min *= 0.5;
    k_max *= 0.5;
  }
  const double index = std::atan2(k_max + k_min, std::abs(k_max - k_min)) * (2 / CGAL_PI);
  return FT(std::clamp(index, -1., 1.));
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CHARACTERISTICS_SHAPE_INDEX_H
