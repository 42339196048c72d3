#ifndef SHAPE_CHARACTERISTICS_CHARACTERISTICS_IS_UMBILIC_H
#define SHAPE_CHARACTERISTICS_CHARACTERISTICS_IS_UMBILIC_H

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsCharacteristics

  returns whether both principal curvatures are equal up to a relative tolerance: \f$ |K_1 - K_2| \f$ is at most `tolerance` times
  the larger magnitude of the two. There the principal directions are arbitrary.

  Planes are umbilic if both curvatures are exactly zero; where they are merely almost zero, ask `is_planar()`. NaN or
  infinity in a curvature gives `false`. Constant time.

  \tparam PrincipalCurvatures a type with the members `min_curvature` and `max_curvature`, as
  `Principal_curvatures_and_directions`

  \param curvatures the principal curvatures
  \param tolerance a ratio of curvatures

  \throws std::invalid_argument if `tolerance` is negative or NaN

  \cgalExample{characteristics/characteristics.cpp}
*/
template <typename PrincipalCurvatures>
auto is_umbilic(const PrincipalCurvatures& curvatures, double tolerance = 1e-6)
    -> std::enable_if_t<sizeof(curvatures.min_curvature) != 0, bool>
{
  if(!(tolerance >= 0))
    throw std::invalid_argument("is_umbilic: `tolerance` must not be negative");
  const double k_min = CGAL::to_double(curvatures.min_curvature),
               k_max = CGAL::to_double(curvatures.max_curvature);
  const double largest = std::max(std::abs(k_min), std::abs(k_max));
  if(!(std::isfinite(k_min) && std::isfinite(k_max)))
    return false;
  if(largest > std::numeric_limits<double>::max() / 2) // the difference would overflow
    return std::abs(0.5 * k_max - 0.5 * k_min) <= tolerance * (0.5 * largest);
  return std::abs(k_max - k_min) <= tolerance * largest;
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CHARACTERISTICS_IS_UMBILIC_H
