#ifndef SHAPE_CHARACTERISTICS_CURVATURE_FUNDAMENTAL_FORMS_H
#define SHAPE_CHARACTERISTICS_CURVATURE_FUNDAMENTAL_FORMS_H

#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/internal/conversions.h>

#include <CGAL/Kernel_traits.h>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  holds the first and second fundamental form of a parametric surface \f$ x(u, v) \f$ at a point (the thesis's section
  4.3.2, equations 4.13 to 4.15), and computes the curvatures from them.

  The coefficients are the textbook ones, with the normal \f$ n = T_u \times T_v / \|T_u \times T_v\| \f$:
  \f$ L = T_{uu} \cdot n \f$ is negative for a sphere whose \f$ n \f$ points outward. The curvatures follow the convention of the library:
  positive where the surface is convex seen along \f$ n \f$. So parametrize such that \f$ n \f$ points
  outward, or exchange `u` and `v`.

  Where \f$ T_u \f$ and \f$ T_v \f$ are parallel or zero (the pole of a sphere in spherical coordinates), or anything is not finite,
  the normal and the curvatures are quiet NaN.

  \tparam GeomTraits a model of `Kernel`, whose number type must have a quiet NaN

  \cgalExample{curvature/parametric_surface.cpp}
*/
template <typename GeomTraits>
class Fundamental_forms
{
public:
  using FT = typename GeomTraits::FT;             ///< number type
  using Vector_3 = typename GeomTraits::Vector_3; ///< vector type

  /// from the first and second derivatives of the surface at the point
  Fundamental_forms(const Vector_3& Tu,
                    const Vector_3& Tv,
                    const Vector_3& Tuu,
                    const Vector_3& Tuv,
                    const Vector_3& Tvv)
    : tu(internal::to_eigen(Tu)),
      tv(internal::to_eigen(Tv))
  {
    const double length_u = internal::safe_norm(tu), length_v = internal::safe_norm(tv);
    const Eigen::Vector3d cross = (tu / length_u).cross(tv / length_v);
    const double sine = cross.norm();
    // below, the direction of the cross product is rounding noise
    if(sine > std::numeric_limits<double>::epsilon())
      unit_normal = cross / sine;
    second[0] = internal::to_eigen(Tuu).dot(unit_normal);
    second[1] = internal::to_eigen(Tuv).dot(unit_normal);
    second[2] = internal::to_eigen(Tvv).dot(unit_normal);
    eigen = internal::eigen_of_second_fundamental_form(unit_normal, second[0], second[1], second[2], tu, tv);
  }

  /// \name First Fundamental Form
  /// @{
  FT E() const { return FT(tu.squaredNorm()); } ///< \f$ T_u \cdot T_u \f$
  FT F() const { return FT(tu.dot(tv)); }       ///< \f$ T_u \cdot T_v \f$
  FT G() const { return FT(tv.squaredNorm()); } ///< \f$ T_v \cdot T_v \f$
  /// @}

  /// \name Second Fundamental Form
  /// @{
  FT L() const { return FT(second[0]); } ///< \f$ T_{uu} \cdot n \f$
  FT M() const { return FT(second[1]); } ///< \f$ T_{uv} \cdot n \f$
  FT N() const { return FT(second[2]); } ///< \f$ T_{vv} \cdot n \f$
  /// @}

  /// \name Results
  /// @{

  /// returns the unit normal \f$ n \f$.
  Vector_3 normal() const { return Vector_3(FT(unit_normal.x()), FT(unit_normal.y()), FT(unit_normal.z())); }

  /// returns the principal curvatures and directions: the eigenvalues and eigenvectors of the shape operator
  /// \f$ -I^{-1} II \f$ (4.15, negated).
  Principal_curvatures_and_directions<GeomTraits> curvatures() const
  {
    return internal::to_principal_curvatures<GeomTraits>(eigen);
  }

  /// returns the mean curvature \f$ -\frac{E N - 2 F M + G L}{2 (E G - F^2)} \f$.
  FT mean_curvature() const { return FT(0.5 * eigen.min_curvature + 0.5 * eigen.max_curvature); }

  /// returns the Gaussian curvature \f$ \frac{L N - M^2}{E G - F^2} \f$.
  FT Gaussian_curvature() const { return FT(eigen.min_curvature * eigen.max_curvature); }

  /// @}

private:
  Eigen::Vector3d tu, tv;
  Eigen::Vector3d unit_normal = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  double second[3];
  internal::Shape_operator_eigen eigen;
};

template <typename Vector_3>
Fundamental_forms(const Vector_3&, const Vector_3&, const Vector_3&, const Vector_3&, const Vector_3&)
    -> Fundamental_forms<typename CGAL::Kernel_traits<Vector_3>::Kernel>;

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_FUNDAMENTAL_FORMS_H
