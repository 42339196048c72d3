#ifndef SHAPE_CHARACTERISTICS_CHARACTERISTICS_IS_PLANAR_H
#define SHAPE_CHARACTERISTICS_CHARACTERISTICS_IS_PLANAR_H

#include <CGAL/number_utils.h>

#include <cmath>
#include <stdexcept>
#include <type_traits>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsCharacteristics

  returns whether the surface is flat: the magnitudes of both principal curvatures are at most `largest_curvature`.

  What is flat depends on the size of the object, so give a bound: for an object of the size \f$ s \f$, for example
  \f$ 0.001 / s \f$. By default only exactly zero is flat. NaN in a curvature gives `false`. Constant time.

  \tparam PrincipalCurvatures a type with the members `min_curvature` and `max_curvature`, as
  `Principal_curvatures_and_directions`

  \param curvatures the principal curvatures
  \param largest_curvature a curvature (unit: 1/length)

  \throws std::invalid_argument if `largest_curvature` is negative or NaN

  \cgalExample{characteristics/characteristics.cpp}
*/
template <typename PrincipalCurvatures>
auto is_planar(const PrincipalCurvatures& curvatures, double largest_curvature = 0)
    -> std::enable_if_t<sizeof(curvatures.min_curvature) != 0, bool>
{
  if(!(largest_curvature >= 0))
    throw std::invalid_argument("is_planar: `largest_curvature` must not be negative");
  return std::abs(CGAL::to_double(curvatures.min_curvature)) <= largest_curvature &&
         std::abs(CGAL::to_double(curvatures.max_curvature)) <= largest_curvature;
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CHARACTERISTICS_IS_PLANAR_H
