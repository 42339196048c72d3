#ifndef SHAPE_CHARACTERISTICS_CHARACTERISTICS_SURFACE_CLASS_H
#define SHAPE_CHARACTERISTICS_CHARACTERISTICS_SURFACE_CLASS_H

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>

namespace Shape_characteristics {

/// \ingroup PkgShapeCharacteristicsCharacteristics
/// is the class of the shape of a surface at a point, by the signs of its principal curvatures (the thesis's Table 4.1).
enum class Surface_class : unsigned char
{
  CONCAVE_ELLIPSOID, ///< both curvatures are negative: a hollow
  CONCAVE_CYLINDER,  ///< one curvature is zero, one negative: a groove
  PLANE,             ///< both curvatures are zero
  HYPERBOLOID,       ///< the curvatures differ in sign: a saddle
  CONVEX_CYLINDER,   ///< one curvature is zero, one positive: a ridge
  CONVEX_ELLIPSOID,  ///< both curvatures are positive: a bump
  UNDEFINED          ///< a curvature is infinite or NaN
};

/*!
  \ingroup PkgShapeCharacteristicsCharacteristics

  returns the class of the shape of a surface with the given principal curvatures (the thesis's Table 4.1).

  A curvature counts as zero if its magnitude is at most `tolerance` times the larger magnitude of the two, or at most
  `planar_curvature`. With the default values only a curvature that is exactly zero in both values makes
  a plane: what is flat depends on the size of the object, which a point doesn't tell. Constant time.

  \tparam PrincipalCurvatures a type with the members `min_curvature` and `max_curvature`, as
  `Principal_curvatures_and_directions`

  \param curvatures the principal curvatures
  \param tolerance a ratio of curvatures, in [0, 1)
  \param planar_curvature a curvature (unit: 1/length), for example \f$ 0.001 / s \f$ for objects of the size \f$ s \f$

  \throws std::invalid_argument if `tolerance` is not in [0, 1), or `planar_curvature` is negative or NaN
*/
template <typename PrincipalCurvatures>
auto surface_class(const PrincipalCurvatures& curvatures,
                   double tolerance = 1e-3,
                   double planar_curvature = 0)
    -> std::enable_if_t<sizeof(curvatures.min_curvature) != 0, Surface_class>
{
  if(!(tolerance >= 0 && tolerance < 1))
    throw std::invalid_argument("surface_class: `tolerance` must be in [0, 1)");
  if(!(planar_curvature >= 0))
    throw std::invalid_argument("surface_class: `planar_curvature` must not be negative");

  const double k_min = CGAL::to_double(curvatures.min_curvature),
               k_max = CGAL::to_double(curvatures.max_curvature);
  if(!(std::isfinite(k_min) && std::isfinite(k_max)))
    return Surface_class::UNDEFINED;
  const double zero = std::max(planar_curvature, tolerance * std::max(std::abs(k_min), std::abs(k_max)));
  const auto sign = [zero](double k) { return k > zero ? 1 : k < -zero ? -1 : 0; };
  switch(3 * sign(k_min) + sign(k_max))
  {
  case -4:
    return Surface_class::CONCAVE_ELLIPSOID;
  case -3:
  case -1:
    return Surface_class::CONCAVE_CYLINDER;
  case 0:
    return Surface_class::PLANE;
  case 1:
  case 3:
    return Surface_class::CONVEX_CYLINDER;
  case 4:
    return Surface_class::CONVEX_ELLIPSOID;
  default:
    return Surface_class::HYPERBOLOID;
  }
}

/// \ingroup PkgShapeCharacteristicsCharacteristics
/// returns the name of `c` as it is written in the program, for tables and messages.
constexpr const char* to_string(Surface_class c) noexcept
{
  switch(c)
  {
  case Surface_class::CONCAVE_ELLIPSOID:
    return "CONCAVE_ELLIPSOID";
  case Surface_class::CONCAVE_CYLINDER:
    return "CONCAVE_CYLINDER";
  case Surface_class::PLANE:
    return "PLANE";
  case Surface_class::HYPERBOLOID:
    return "HYPERBOLOID";
  case Surface_class::CONVEX_CYLINDER:
    return "CONVEX_CYLINDER";
  case Surface_class::CONVEX_ELLIPSOID:
    return "CONVEX_ELLIPSOID";
  case Surface_class::UNDEFINED:
    return "UNDEFINED";
  }
  return "";
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CHARACTERISTICS_SURFACE_CLASS_H
