#ifndef SHAPE_CHARACTERISTICS_CURVATURE_IMPLICIT_SURFACE_GAUSSIAN_CURVATURE_H
#define SHAPE_CHARACTERISTICS_CURVATURE_IMPLICIT_SURFACE_GAUSSIAN_CURVATURE_H

#include <Shape_characteristics/curvature/internal/conversions.h>

#include <CGAL/Kernel_traits.h>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  returns the Gaussian curvature of the level set of a function \f$ F \f$ at a point, from the first and second
  derivatives of \f$ F \f$ there:

  \f[ K_G = \frac{\nabla F^T H^*\, \nabla F}{\|\nabla F\|^4}, \f]

  with \f$ H^* \f$ being the adjugate of the Hessian matrix \f$ H \f$. This is the thesis's equation 4.10; in the adjugate as printed (4.9)
  the entry (1,1) must read \f$ H_{22} H_{33} - H_{23} H_{32} \f$, and the entry (2,3) \f$ H_{12} H_{31} - H_{11} H_{32} \f$.

  Quiet NaN if the gradient is zero, or anything is not finite. Constant time.

  \tparam Vector_3 the vector type of a model of `Kernel`, whose number type must have a quiet NaN
  \tparam Matrix a type with `m(i, j)` for \f$ 0 \leq i, j < 3 \f$, like `Eigen::Matrix3d`

  \param gradient the gradient \f$ \nabla F \f$
  \param hessian the symmetric matrix \f$ H \f$ of second derivatives of \f$ F \f$; only its upper triangle is read

  \sa `implicit_surface_curvatures()`
*/
template <typename Vector_3, typename Matrix>
typename CGAL::Kernel_traits<Vector_3>::Kernel::FT
implicit_surface_Gaussian_curvature(const Vector_3& gradient, const Matrix& hessian)
{
  using FT = typename CGAL::Kernel_traits<Vector_3>::Kernel::FT;
  const Eigen::Vector3d g = internal::to_eigen(gradient);
  const double length = internal::safe_norm(g);
  if(!(length > 0 && std::isfinite(length)))
    return FT(std::numeric_limits<double>::quiet_NaN());
  const Eigen::Vector3d n = g / length;
  const Eigen::Matrix3d h = internal::to_eigen_matrix(hessian) / length;

  // the cofactors: second-order minors, each without cancellation of its products' rounding errors
  const auto minor = [&h](int i, int j, int k, int l) { // h_ij h_kl - h_il h_kj
    const double product = h(i, l) * h(k, j);
    const double error = std::fma(-h(i, l), h(k, j), product);
    return std::fma(h(i, j), h(k, l), -product) + error;
  };
  const double a11 = minor(1, 1, 2, 2), a22 = minor(0, 0, 2, 2), a33 = minor(0, 0, 1, 1);
  const double a12 = minor(1, 2, 2, 0), a13 = minor(1, 0, 2, 1), a23 = minor(0, 1, 2, 0);
  const double result = n.x() * n.x() * a11 + n.y() * n.y() * a22 + n.z() * n.z() * a33 +
                        2 * (n.x() * n.y() * a12 + n.x() * n.z() * a13 + n.y() * n.z() * a23);
  return FT(std::isfinite(result) ? result : std::numeric_limits<double>::quiet_NaN());
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_IMPLICIT_SURFACE_GAUSSIAN_CURVATURE_H
