#ifndef SHAPE_CHARACTERISTICS_CURVATURE_HEIGHT_FIELD_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_HEIGHT_FIELD_CURVATURES_H

#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/internal/conversions.h>

#include <CGAL/number_utils.h>

namespace Shape_characteristics {

/// \ingroup PkgShapeCharacteristicsCurvature
/// says which side of a height field \f$ z = h(u, v) \f$ is the outer one.
enum class Height_field_normal
{
  UPWARD,  ///< the normal points to growing heights: hilltops are convex
  DOWNWARD ///< the normal points to falling heights: hollows are convex
};

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  returns the principal curvatures and directions of a height field \f$ (u, v, h(u, v)) \f$ (Monge patch) at a point, from the
  first and second derivatives of \f$ h \f$ there (the thesis's section 4.3.3, where the right-hand sides of equations 4.17
  and 4.18 are exchanged).

  The directions are vectors in space. If anything is not finite, all members of the result are quiet NaN. Constant time.

  \tparam GeomTraits a model of `Kernel`, whose number type must have a quiet NaN; must be given

  \param hu,hv the first derivatives
  \param huu,huv,hvv the second derivatives
  \param normal the outer side: convex seen from there is positive

  \cgalExample{curvature/height_field.cpp}
*/
template <typename GeomTraits>
Principal_curvatures_and_directions<GeomTraits> height_field_curvatures(const typename GeomTraits::FT& hu,
                                                                        const typename GeomTraits::FT& hv,
                                                                        const typename GeomTraits::FT& huu,
                                                                        const typename GeomTraits::FT& huv,
                                                                        const typename GeomTraits::FT& hvv,
                                                                        Height_field_normal normal)
{
  // the level set of z - h: on steep slopes the tangents in u and v are nearly parallel, the gradient is exact
  const double sign = normal == Height_field_normal::UPWARD ? 1 : -1;
  const Eigen::Vector3d gradient(-sign * CGAL::to_double(hu), -sign * CGAL::to_double(hv), sign);
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
  hessian(0, 0) = -sign * CGAL::to_double(huu);
  hessian(0, 1) = hessian(1, 0) = -sign * CGAL::to_double(huv);
  hessian(1, 1) = -sign * CGAL::to_double(hvv);
  return internal::to_principal_curvatures<GeomTraits>(internal::curvatures_of_implicit(gradient, hessian));
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_HEIGHT_FIELD_CURVATURES_H
