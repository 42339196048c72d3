#ifndef SHAPE_CHARACTERISTICS_CURVATURE_IMPLICIT_SURFACE_MEAN_CURVATURE_H
#define SHAPE_CHARACTERISTICS_CURVATURE_IMPLICIT_SURFACE_MEAN_CURVATURE_H

#include <Shape_characteristics/curvature/internal/conversions.h>

#include <CGAL/Kernel_traits.h>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  returns the mean curvature of the level set of a function \f$ F \f$ at a point, from the first and second
  derivatives of \f$ F \f$ there:

  \f[ K_H = \frac{\|\nabla F\|^2\, \mathrm{trace}(H) - \nabla F^T H\, \nabla F}{2 \|\nabla F\|^3}, \f]

  which is the thesis's equation 4.11, negated: with an outward gradient, convex surfaces have positive mean
  curvature. Quiet NaN if the gradient is zero, or anything is not finite. Constant time.

  \tparam Vector_3 the vector type of a model of `Kernel`, whose number type must have a quiet NaN
  \tparam Matrix a type with `m(i, j)` for \f$ 0 \leq i, j < 3 \f$, like `Eigen::Matrix3d`

  \param gradient the gradient \f$ \nabla F \f$
  \param hessian the symmetric matrix \f$ H \f$ of second derivatives of \f$ F \f$; only its upper triangle is read

  \sa `implicit_surface_curvatures()`
*/
template <typename Vector_3, typename Matrix>
typename CGAL::Kernel_traits<Vector_3>::Kernel::FT implicit_surface_mean_curvature(const Vector_3& gradient,
                                                                                   const Matrix& hessian)
{
  using FT = typename CGAL::Kernel_traits<Vector_3>::Kernel::FT;
  const Eigen::Vector3d g = internal::to_eigen(gradient);
  const double length = internal::safe_norm(g);
  if(!(length > 0 && std::isfinite(length)))
    return FT(std::numeric_limits<double>::quiet_NaN());
  // divided by the length at once, its powers can't overflow
  const Eigen::Vector3d n = g / length;
  const Eigen::Matrix3d h = internal::to_eigen_matrix(hessian) / length;
  const double result = 0.5 * (h.trace() - n.dot(h * n));
  return FT(std::isfinite(result) ? result : std::numeric_limits<double>::quiet_NaN());
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_IMPLICIT_SURFACE_MEAN_CURVATURE_H
