#ifndef SHAPE_CHARACTERISTICS_CURVATURE_NORMAL_CURVATURE_H
#define SHAPE_CHARACTERISTICS_CURVATURE_NORMAL_CURVATURE_H

#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/internal/conversions.h>

#include <CGAL/number_utils.h>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  returns the normal curvature in a tangent direction (Euler's formula, the thesis's equation 4.5):
  \f$ k_n = K_{max} \cos^2 \alpha + K_{min} \sin^2 \alpha \f$.

  The direction need not be of unit length, and is projected to the tangent plane, which the principal directions span. If it is zero
  or normal to the surface, or anything is not finite, the result is quiet NaN. Constant time.

  \tparam GeomTraits a model of `Kernel`, whose number type must have a quiet NaN

  \param curvatures the principal curvatures and directions
  \param direction the direction, whose sign doesn't matter
*/
template <typename GeomTraits>
typename GeomTraits::FT normal_curvature(const Principal_curvatures_and_directions<GeomTraits>& curvatures,
                                         const typename GeomTraits::Vector_3& direction)
{
  using FT = typename GeomTraits::FT;
  const Eigen::Vector3d d = internal::to_eigen(direction);
  const double length = internal::safe_norm(d);
  const Eigen::Vector3d unit = d / length;
  const double c = unit.dot(internal::to_eigen(curvatures.max_direction));
  const double s = unit.dot(internal::to_eigen(curvatures.min_direction));
  const double square = c * c + s * s;
  // of a direction along the normal, rounding alone leaves a tangential part
  constexpr double noise = 16 * std::numeric_limits<double>::epsilon();
  if(!(square > noise * noise))
    return FT(std::numeric_limits<double>::quiet_NaN());
  // weights that add up to 1 keep the result between the principal curvatures
  const double weight = c * c / square;
  return FT(weight * CGAL::to_double(curvatures.max_curvature) +
            (1 - weight) * CGAL::to_double(curvatures.min_curvature));
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  returns the normal curvature in the tangent direction at the angle `alpha` (in radians) to the direction of the
  maximal curvature (Euler's formula, the thesis's equation 4.5). Constant time.

  \tparam GeomTraits a model of `Kernel`
*/
template <typename GeomTraits>
typename GeomTraits::FT normal_curvature(const Principal_curvatures_and_directions<GeomTraits>& curvatures,
                                         const typename GeomTraits::FT& alpha)
{
  using FT = typename GeomTraits::FT;
  const double c = std::cos(CGAL::to_double(alpha)), s = std::sin(CGAL::to_double(alpha));
  return FT(c * c * CGAL::to_double(curvatures.max_curvature) +
            s * s * CGAL::to_double(curvatures.min_curvature));
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_NORMAL_CURVATURE_H
