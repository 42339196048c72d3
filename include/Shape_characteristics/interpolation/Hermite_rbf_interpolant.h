#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_HERMITE_RBF_INTERPOLANT_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_HERMITE_RBF_INTERPOLANT_H

#include <Shape_characteristics/interpolation/Polyharmonic.h>
#include <Shape_characteristics/interpolation/internal/Hermite_jet.h>
#include <Shape_characteristics/interpolation/internal/Hermite_system.h>
#include <Shape_characteristics/interpolation/internal/Hermite_trend.h>
#include <Shape_characteristics/interpolation/internal/Polynomial_part.h>
#include <Shape_characteristics/interpolation/internal/interpolation_data.h>

#include <CGAL/Kernel_traits.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsInterpolation

  interpolates points and normals of a surface by radial basis functions and their gradients,
  \f$ f(x) = \sum_i \alpha_i\, \phi(\|x - P_i\|) - \beta_i \cdot \nabla\phi(\|x - P_i\|) \f$ with \f$ f(P_i) = 0 \f$ and
  \f$ \nabla f(P_i) = n_i \f$ (I. Macêdo, J. P. Gois, L. Velho, Hermite Radial Basis Functions Implicits, 2011; thesis,
  section 3.2.2, equations 3.9 to 3.11, where \f$ \beta_i \f$ has the other sign). In contrast to `Rbf_interpolant`, no
  off-surface points are needed.

  The surface is the zero set; \f$ f \f$ is negative inside and positive outside, and near the surface about
  the signed distance. Value, gradient and Hessian matrix can be evaluated anywhere; from the latter two,
  `implicit_surface_curvatures()` gives the curvatures of the surface.

  The points are translated to their centroid and scaled to the root mean square distance 1, so that the result depends
  neither on the unit of length nor on the position. A shape parameter that is set in the basis function is meant
  relative to that size. One that is not set is chosen such that, at four times the mean distance of a point
  to its nearest neighbor, the basis function is half (if it grows, double) its value at the center; or at two or one times
  that distance if the system is singular to working precision otherwise (`Gaussian`, for many points), unless the reason is
  two points that are a hundred times as close as others.

  A positive definite basis function gives a positive definite system, which is solved by Cholesky's method; any other one
  the thesis's, solved by LU with partial pivoting. The system may be singular: two points coincide, to twelve digits, or the
  basis function is too flat for the given points. Then `is_valid()` is `false` and each evaluation returns quiet NaN.

  Construction takes \cgalBigO{m^3} time and \cgalBigO{m^2} memory for \f$ m \f$ points (the system has \f$ 4m \f$
  equations), an evaluation \cgalBigO{m}. The coordinates are converted to `double`.

  \tparam GeomTraits a model of `Kernel`; deduced from the points
  \tparam RadialBasisFunction_ a model of `RadialBasisFunction` with finite second derivatives at the origin; third ones for
  the Hessian matrix at a center

  \cgalExample{interpolation/hermite_rbf_surface.cpp}
*/
template <typename GeomTraits, typename RadialBasisFunction_ = Polyharmonic<3>>
class Hermite_rbf_interpolant
{
public:
  using FT = typename GeomTraits::FT;               ///< number type
  using Point_3 = typename GeomTraits::Point_3;     ///< point type
  using Vector_3 = typename GeomTraits::Vector_3;   ///< vector type
  using RadialBasisFunction = RadialBasisFunction_; ///< basis function type
  using Matrix = Eigen::Matrix3d;                   ///< type of the Hessian matrix

  /*!
    interpolates the surface through `points` with outward `normals`.

    \param points the points
    \param normals the normals, in the order of the points, of any length: \f$ n_i \f$ are the unit vectors along them
    \param basis_function the basis function
    \param polynomial_degree the degree of a polynomial that is added to the basis functions, whose weights see no polynomial of that
           degree then: \f$ (t - 1)/2 \f$ makes the system of `Polyharmonic<t>` definite. -1: none; so it is with a positive
           definite basis function, whatever is given. Lower where there are less than twice as many equations as monomials.

    \tparam PointRange a model of `ConstRange` whose value type is `Point_3`
    \tparam NormalRange a model of `ConstRange` whose value type is `Vector_3`

    \throws std::invalid_argument if `points` is empty, `normals` has another size, a coordinate is not finite, a
    normal is zero, the basis function is not valid or has no second derivatives at the origin
    (`Polyharmonic<1>`, `Polyharmonic_logarithmic<2>`), or the degree isn't between -1 and 8
  */
  template <typename PointRange, typename NormalRange>
  Hermite_rbf_interpolant(const PointRange& points,
                          const NormalRange& normals,
                          const RadialBasisFunction& basis_function = RadialBasisFunction(),
                          int polynomial_degree = -1)
    : m_basis_function(basis_function)
  {
    if(polynomial_degree < -1 || polynomial_degree > internal::Polynomial_part::largest_degree)
      throw std::invalid_argument("Hermite_rbf_interpolant: `polynomial_degree` must be between -1 and 8");
    internal::require_valid_basis_function<RadialBasisFunction>("Hermite_rbf_interpolant");
    internal::require_basis_function_for_normals<RadialBasisFunction>("Hermite_rbf_interpolant");
    Eigen::Matrix3Xd centers = internal::coordinates_of("Hermite_rbf_interpolant", "points", points);
    const Eigen::Matrix3Xd directions =
        internal::unit_vectors_of("Hermite_rbf_interpolant", "normals", normals);
    if(directions.cols() != centers.cols())
      throw std::invalid_argument(
          "Hermite_rbf_interpolant: `points` and `normals` differ in their number of elements");

    m_frame = internal::Unit_frame(centers);
    m_frame.apply(centers);
    const double spacing = internal::mean_spacing(centers), smallest = internal::smallest_distance(centers);
    if(centers.cols() > 1 && !(smallest > s_coincident * spacing))
      return; // the matrix is singular, though rounding may hide it
    if constexpr(RadialBasisFunction::has_shape_parameter)
      if(!m_basis_function.is_shape_parameter_set())
      {
        // Two points that are close to each other are no reason for basis functions that are too narrow for all others.
        const double least_reach = smallest > s_close * spacing ? 1. : 4.;
        for(double reach = 4.; !m_is_valid && reach >= least_reach; reach /= 2.)
        {
          m_basis_function = internal::shape_parameter_of_half_value(basis_function, reach * spacing);
          solve(centers, directions, polynomial_degree);
        }
        return;
      }
    solve(centers, directions, polynomial_degree);
  }

  /// returns whether the system of equations could be solved. If not, as where two points coincide, each evaluation returns NaN.
  bool is_valid() const noexcept { return m_is_valid; }

  /// returns the number of points.
  std::size_t number_of_centers() const noexcept { return m_system.number_of_centers(); }

  /// returns the basis function, with the shape parameter that is used.
  const RadialBasisFunction& basis_function() const noexcept { return m_basis_function; }

  /// returns \f$ f(p) \f$, in the unit of length of the points.
  FT operator()(const Point_3& p) const { return FT(m_frame.size() * jet(p).value); }

  /// returns \f$ \nabla f(p) \f$.
  Vector_3 gradient(const Point_3& p) const
  {
    const Eigen::Vector3d g = jet(p).gradient;
    return Vector_3(FT(g.x()), FT(g.y()), FT(g.z()));
  }

  /// returns the matrix of second derivatives of \f$ f \f$ at `p`. At a center, third derivatives that a basis
  /// function doesn't have there (`Polyharmonic<3>`) are taken as 0.
  Matrix hessian(const Point_3& p) const { return jet(p).hessian / m_frame.size(); }

private:
  // of the mean distance of a point to its nearest neighbor: points that are one, and points that are close
  static constexpr double s_coincident = 1e-12, s_close = 1e-2;

  void solve(const Eigen::Matrix3Xd& centers, const Eigen::Matrix3Xd& directions, int polynomial_degree)
  {
    m_system.clear(m_basis_function, internal::Hermite_trend(), polynomial_degree);
    const std::array<Eigen::Vector3d, 3> axes{Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(),
                                              Eigen::Vector3d::UnitZ()};
    for(Eigen::Index i = 0; i < centers.cols(); ++i)
      m_system.add_center(Eigen::Vector3d(centers.col(i)), 0., axes,
                          std::array<double, 3>{directions(0, i), directions(1, i), directions(2, i)});
    if constexpr(RadialBasisFunction::is_positive_definite)
      m_is_valid = m_system.solve_positive_definite(0., 0.);
    else
      m_is_valid = m_system.solve_indefinite();
    m_is_valid = m_is_valid && interpolates(centers, directions);
  }

  internal::Hermite_jet jet(const Point_3& p) const
  {
    if(m_is_valid)
      return m_system(m_frame.to_local(internal::to_eigen(p)));
    internal::Hermite_jet none;
    none.value = std::numeric_limits<double>::quiet_NaN();
    none.gradient.setConstant(none.value);
    none.hessian.setConstant(none.value);
    return none;
  }

  // A system that is singular to working precision may be solved without complaint, and wrongly.
  bool interpolates(const Eigen::Matrix3Xd& centers, const Eigen::Matrix3Xd& directions) const
  {
    const double tolerance = std::sqrt(std::numeric_limits<double>::epsilon());
    for(Eigen::Index i = 0; i < centers.cols(); ++i)
    {
      const internal::Hermite_jet at_center = m_system(centers.col(i));
      if(!(std::abs(at_center.value) <= tolerance &&
           (at_center.gradient - directions.col(i)).norm() <= tolerance))
        return false;
    }
    return true;
  }

  RadialBasisFunction m_basis_function;
  internal::Unit_frame m_frame;
  internal::Hermite_system<RadialBasisFunction> m_system;
  bool m_is_valid = false;
};

template <typename PointRange, typename NormalRange, typename RadialBasisFunction = Polyharmonic<3>>
Hermite_rbf_interpolant(const PointRange&, const NormalRange&, const RadialBasisFunction&, int = -1)
    -> Hermite_rbf_interpolant<internal::Kernel_of_points<PointRange>, RadialBasisFunction>;

template <typename PointRange, typename NormalRange>
Hermite_rbf_interpolant(const PointRange&, const NormalRange&)
    -> Hermite_rbf_interpolant<internal::Kernel_of_points<PointRange>, Polyharmonic<3>>;

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_HERMITE_RBF_INTERPOLANT_H
