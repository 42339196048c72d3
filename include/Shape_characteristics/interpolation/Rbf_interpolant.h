#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_RBF_INTERPOLANT_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_RBF_INTERPOLANT_H

#include <Shape_characteristics/interpolation/Polyharmonic.h>
#include <Shape_characteristics/interpolation/internal/interpolation_data.h>

#include <CGAL/Kernel_traits.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <type_traits>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsInterpolation

  interpolates scattered data by a sum of radial basis functions,
  \f$ f(x) = \sum_i \alpha_i\, \phi(\|x - P_i\|) \f$ (the thesis's section 3.2.1, equations 3.6 to 3.8).

  The data are either values at points, or points and normals of a surface, which then is the zero set of
  \f$ f \f$. The value, the gradient and the Hessian matrix can be evaluated anywhere; from them,
  `implicit_surface_curvatures()` gives the curvatures of the surface.

  The points are translated to their centroid and scaled to the root mean square distance 1, so that the result depends
  neither on the unit of length nor on the position. A shape parameter that is set in the basis function is meant
  relative to that size. One that is not set is chosen such that, at twice the mean distance of a point
  to its nearest neighbor, the basis function is half (if it grows, double) its value at the center.

  Construction takes \cgalBigO{m^3} time and \cgalBigO{m^2} memory, an evaluation \cgalBigO{m}, for
  \f$ m \f$ values, or \f$ m / 3 \f$ points with normals. The coordinates are converted to `double`.

  The system of equations may be singular: two points coincide, or the basis function is too flat for the given
  points. Then `is_valid()` is `false` and each evaluation returns quiet NaN.

  \tparam GeomTraits a model of `Kernel`; deduced from the points
  \tparam RadialBasisFunction_ a model of `RadialBasisFunction`

  \cgalExample{interpolation/rbf_surface.cpp}
*/
template <typename GeomTraits, typename RadialBasisFunction_ = Polyharmonic<3>>
class Rbf_interpolant
{
public:
  using FT = typename GeomTraits::FT;               ///< number type
  using Point_3 = typename GeomTraits::Point_3;     ///< point type
  using Vector_3 = typename GeomTraits::Vector_3;   ///< vector type
  using RadialBasisFunction = RadialBasisFunction_; ///< basis function type
  using Matrix = Eigen::Matrix3d;                   ///< type of the Hessian matrix

  /*!
    interpolates `values` at `points`: \f$ f(P_i) \f$ is the i-th value.

    \tparam PointRange a model of `ConstRange` whose value type is `Point_3`
    \tparam ValueRange a model of `ConstRange` whose value type is convertible to `FT`

    \throws std::invalid_argument if `points` is empty, `values` has another size, a coordinate or a value is not
    finite, or the basis function is not valid
  */
#ifdef DOXYGEN_RUNNING
  template <typename PointRange, typename ValueRange>
#else
  template <typename PointRange,
            typename ValueRange,
            std::enable_if_t<!internal::is_range_of_v<ValueRange, Vector_3>, int> = 0>
#endif
  Rbf_interpolant(const PointRange& points,
                  const ValueRange& values,
                  const RadialBasisFunction& basis_function = RadialBasisFunction())
    : phi(basis_function)
  {
    internal::require_valid_basis_function<RadialBasisFunction>("Rbf_interpolant");
    centers = internal::coordinates_of("Rbf_interpolant", "points", points);
    Eigen::VectorXd data(centers.cols());
    Eigen::Index i = 0;
    for(const auto& value : values)
    {
      if(i == data.size())
        throw std::invalid_argument("Rbf_interpolant: `values` has more elements than `points`");
      data[i] = CGAL::to_double(FT(value));
      if(!std::isfinite(data[i++]))
        throw std::invalid_argument("Rbf_interpolant: an element of `values` is not finite");
    }
    if(i != data.size())
      throw std::invalid_argument("Rbf_interpolant: `values` has fewer elements than `points`");

    frame = internal::Unit_frame(centers);
    frame.apply(centers);
    choose_shape_parameter(internal::mean_spacing(centers));
    solve(data);
  }

  /*!
    interpolates the surface through `points` with outward `normals`: \f$ f(P_i) = 0 \f$ and
    \f$ f(P_i \pm c\,n_i) = \pm 1 \f$ with \f$ c \f$ being the `offset`. So \f$ f \f$ is negative inside, positive
    outside, and \f$ c f \f$ is about the signed distance near the surface.

    The normals need not be of unit length.

    \param points the points
    \param normals the normals, in the order of the points
    \param basis_function the basis function
    \param offset the distance of the off-surface points from the surface, in the unit of the points; it must be smaller
    than the radii of curvature and the thickness of the object. 0 stands for half the mean distance
    of a point to its nearest neighbor.

    \tparam PointRange a model of `ConstRange` whose value type is `Point_3`
    \tparam NormalRange a model of `ConstRange` whose value type is `Vector_3`

    \throws std::invalid_argument if `points` is empty, `normals` has another size, a coordinate is not finite, a
    normal is zero, the basis function is not valid, `offset` is negative or not finite, or `offset` is 0
    while all points coincide
  */
#ifdef DOXYGEN_RUNNING
  template <typename PointRange, typename NormalRange>
#else
  template <typename PointRange,
            typename NormalRange,
            std::enable_if_t<internal::is_range_of_v<NormalRange, Vector_3>, int> = 0>
#endif
  Rbf_interpolant(const PointRange& points,
                  const NormalRange& normals,
                  const RadialBasisFunction& basis_function = RadialBasisFunction(),
                  double offset = 0)
    : phi(basis_function)
  {
    internal::require_valid_basis_function<RadialBasisFunction>("Rbf_interpolant");
    if(!(std::isfinite(offset) && offset >= 0))
      throw std::invalid_argument("Rbf_interpolant: `offset` must be finite and not negative");
    Eigen::Matrix3Xd on_surface = internal::coordinates_of("Rbf_interpolant", "points", points);
    const Eigen::Matrix3Xd directions = internal::unit_vectors_of("Rbf_interpolant", "normals", normals);
    if(directions.cols() != on_surface.cols())
      throw std::invalid_argument(
          "Rbf_interpolant: `points` and `normals` differ in their number of elements");

    frame = internal::Unit_frame(on_surface);
    if(frame.is_degenerate() && offset > 0) // one point: the offset is the only length there is
      frame = internal::Unit_frame(on_surface, offset);
    frame.apply(on_surface);
    const double spacing = internal::mean_spacing(on_surface);
    const double scaled_offset = offset > 0 ? offset / frame.size() : spacing / 2;
    if(!(scaled_offset > 0))
      throw std::invalid_argument("Rbf_interpolant: `offset` must be given if all points coincide");

    const Eigen::Index m = on_surface.cols();
    centers.resize(3, 3 * m);
    centers << on_surface, on_surface + scaled_offset * directions, on_surface - scaled_offset * directions;
    Eigen::VectorXd data(3 * m);
    data << Eigen::VectorXd::Zero(m), Eigen::VectorXd::Ones(m), -Eigen::VectorXd::Ones(m);
    choose_shape_parameter(spacing > 0 ? spacing : scaled_offset);
    solve(data);
  }

  /// returns whether the system of equations could be solved. If not, each evaluation returns NaN.
  bool is_valid() const noexcept
  {
    return solved;
  }

  /// returns an estimate of the reciprocal condition number of the system of equations: the relative error of the
  /// weights is about the machine precision divided by it.
  double reciprocal_condition_number() const noexcept
  {
    return rcond;
  }

  /// returns the number of centers: the number of values, or three times the number of points with normals.
  std::size_t number_of_centers() const noexcept
  {
    return static_cast<std::size_t>(centers.cols());
  }

  /// returns the basis function, with the shape parameter that is used.
  const RadialBasisFunction& basis_function() const noexcept
  {
    return phi;
  }

  /// returns \f$ f(p) \f$.
  FT operator()(const Point_3& p) const
  {
    const Eigen::Vector3d x = frame.to_local(internal::to_eigen(p));
    double value = 0;
    for(Eigen::Index i = 0; i < centers.cols(); ++i)
      value += weights[i] * phi.radial_derivatives((x - centers.col(i)).squaredNorm())[0];
    return FT(value);
  }

  /// returns \f$ \nabla f(p) \f$. At a center, the gradient of a basis function that has none there (`Polyharmonic<1>`)
  /// is taken as 0.
  Vector_3 gradient(const Point_3& p) const
  {
    const Eigen::Vector3d x = frame.to_local(internal::to_eigen(p));
    Eigen::Vector3d g = Eigen::Vector3d::Zero();
    for(Eigen::Index i = 0; i < centers.cols(); ++i)
    {
      const Eigen::Vector3d d = x - centers.col(i);
      g += weights[i] * phi.radial_derivatives(d.squaredNorm())[1] * d;
    }
    g /= frame.size();
    return Vector_3(g.x(), g.y(), g.z());
  }

  /// returns the matrix of second derivatives of \f$ f \f$ at `p`. At a center, second derivatives that a basis
  /// function doesn't have there (`Polyharmonic<1>`, `Polyharmonic_logarithmic<2>`) are taken as 0.
  Matrix hessian(const Point_3& p) const
  {
    const Eigen::Vector3d x = frame.to_local(internal::to_eigen(p));
    Matrix h = Matrix::Zero();
    for(Eigen::Index i = 0; i < centers.cols(); ++i)
    {
      const Eigen::Vector3d d = x - centers.col(i);
      const auto derivatives = phi.radial_derivatives(d.squaredNorm());
      h.noalias() += (weights[i] * derivatives[2] * d) * d.transpose();
      h.diagonal().array() += weights[i] * derivatives[1];
    }
    return h / frame.size() / frame.size();
  }

private:
  void choose_shape_parameter(double spacing)
  {
    if constexpr(RadialBasisFunction::has_shape_parameter)
      if(!phi.is_shape_parameter_set())
        phi = internal::shape_parameter_of_half_value(phi, 2 * spacing);
  }

  void solve(const Eigen::VectorXd& data)
  {
    const Eigen::Index n = centers.cols();
    Eigen::MatrixXd matrix(n, n);
    for(Eigen::Index j = 0; j < n; ++j)
      for(Eigen::Index i = j; i < n; ++i)
        matrix(i, j) = matrix(j, i) =
            phi.radial_derivatives((centers.col(i) - centers.col(j)).squaredNorm())[0];

    const Eigen::PartialPivLU<Eigen::MatrixXd> factors(matrix);
    // the estimate passes over pivots that are exactly zero, which duplicate points give
    const bool is_singular = (factors.matrixLU().diagonal().array() == 0).any();
    rcond = is_singular ? 0 : factors.rcond();
    if(!std::isfinite(rcond))
      rcond = 0;
    weights = factors.solve(data);
    weights += factors.solve(data - matrix * weights); // one step of iterative refinement
    const double residual = (data - matrix * weights).cwiseAbs().maxCoeff();
    // a system singular to working precision may still have a small residual, with meaningless derivatives
    constexpr double precision = std::numeric_limits<double>::epsilon();
    solved = rcond > precision && residual <= std::sqrt(precision) * data.cwiseAbs().maxCoeff();
    if(!solved)
      weights.setConstant(std::numeric_limits<double>::quiet_NaN());
  }

  RadialBasisFunction phi;
  internal::Unit_frame frame;
  Eigen::Matrix3Xd centers; // in the frame
  Eigen::VectorXd weights;
  double rcond = 0;
  bool solved = false;
};

template <typename PointRange,
          typename DataRange,
          typename RadialBasisFunction = Polyharmonic<3>,
          typename... Offset>
Rbf_interpolant(const PointRange&, const DataRange&, const RadialBasisFunction&, Offset...)
    -> Rbf_interpolant<internal::Kernel_of_points<PointRange>, RadialBasisFunction>;

template <typename PointRange, typename DataRange>
Rbf_interpolant(const PointRange&, const DataRange&)
    -> Rbf_interpolant<internal::Kernel_of_points<PointRange>, Polyharmonic<3>>;

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_RBF_INTERPOLANT_H
