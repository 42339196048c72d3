#ifndef SHAPE_CHARACTERISTICS_CURVATURE_IMPLICIT_SURFACE_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_IMPLICIT_SURFACE_CURVATURES_H

#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/internal/conversions.h>

#include <CGAL/Kernel_traits.h>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  returns the principal curvatures and directions of the level set of a function \f$ F \f$ at a point, from the
  first and second derivatives of \f$ F \f$ there (the thesis's section 4.3.1).

  The surface is oriented by the gradient: where \f$ F \f$ is negative inside and positive outside, convex parts
  have positive curvatures. The length of the gradient doesn't matter: \f$ F \f$ and \f$ c F \f$, \f$ c > 0 \f$, have
  the same curvatures.

  The curvatures are the eigenvalues of the shape operator \f$ P^T H P / \|\nabla F\| \f$, with the columns of \f$ P \f$ being an
  orthonormal basis of the tangent plane. In contrast to \f$ K_H \pm \sqrt{K_H^2 - K_G} \f$ (4.12), this is
  accurate at and near umbilics, and for the smaller curvature of nearly cylindrical surfaces.

  If the gradient is zero, or anything is not finite, there is no answer and all members of the result are quiet NaN.

  Constant time.

  \tparam Vector_3 the vector type of a model of `Kernel`, whose number type must have a quiet NaN
  \tparam Matrix a type with `m(i, j)` for \f$ 0 \leq i, j < 3 \f$, like `Eigen::Matrix3d`

  \param gradient the gradient \f$ \nabla F \f$
  \param hessian the symmetric matrix \f$ H \f$ of second derivatives of \f$ F \f$; only its upper triangle is read

  \cgalExample{curvature/implicit_surface.cpp}

  \sa `implicit_surface_mean_curvature()`
  \sa `implicit_surface_Gaussian_curvature()`
*/
template <typename Vector_3, typename Matrix>
Principal_curvatures_and_directions<typename CGAL::Kernel_traits<Vector_3>::Kernel>
implicit_surface_curvatures(const Vector_3& gradient, const Matrix& hessian)
{
  return internal::to_principal_curvatures<typename CGAL::Kernel_traits<Vector_3>::Kernel>(
      internal::curvatures_of_implicit(internal::to_eigen(gradient), internal::to_eigen_matrix(hessian)));
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_IMPLICIT_SURFACE_CURVATURES_H
