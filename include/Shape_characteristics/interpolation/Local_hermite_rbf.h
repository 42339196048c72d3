#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_LOCAL_HERMITE_RBF_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_LOCAL_HERMITE_RBF_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/internal/Scaled_neighborhood.h>
#include <Shape_characteristics/internal/tangent_basis.h>
#include <Shape_characteristics/interpolation/Exponential_cubic.h>
#include <Shape_characteristics/interpolation/Shape_parameter_box.h>
#include <Shape_characteristics/interpolation/internal/Exact_fit_attempts.h>
#include <Shape_characteristics/interpolation/internal/Hermite_fit_rules.h>
#include <Shape_characteristics/interpolation/internal/Hermite_jet.h>
#include <Shape_characteristics/interpolation/internal/Hermite_system.h>
#include <Shape_characteristics/interpolation/internal/Hermite_trend.h>
#include <Shape_characteristics/interpolation/internal/bend_by_heights.h>
#include <Shape_characteristics/interpolation/internal/interpolation_data.h>
#include <Shape_characteristics/interpolation/internal/trend_of_exact_fit.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace Shape_characteristics {

/// \ingroup PkgShapeCharacteristicsInterpolation
/// the implicit surface that was fitted to the neighborhood of a sample, seen from the sample
struct Local_implicit_surface
{
  /// whether there is a surface
  Estimation_status status = Estimation_status::DEGENERATE;
  /// gradient of the function, which is outward and about of unit length
  Eigen::Vector3d gradient = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  /// Hessian matrix (1/length)
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN());
  /// from the sample to the point of the surface where gradient and Hessian matrix were taken
  Eigen::Vector3d displacement = Eigen::Vector3d::Zero();
};

/*!
  \ingroup PkgShapeCharacteristicsInterpolation

  fits Hermite radial basis functions to the neighborhood of each sample of a surface (thesis, section 8.1).

  Each neighborhood is moved to its sample and scaled to root mean square distance 1; for positive definite basis functions,
  rings that reach more than twice as far along an axis of the tangent plane as across it (four times beside a border) are
  compressed along it before. The function's zero set follows the points, its gradient the normals. The basis function chooses the
  system of equations:

  - a positive definite one, with normals that are exact: value 0 and both tangential derivatives 0 at each of the
    \f$ m \f$ points, and the derivative along the normal 1 at the sample. These are \f$ 3m+1 \f$ equations: of a normal, its
    direction is used and not its length. Solved by Cholesky's method. Where a polynomial of degree 4 over the tangent plane
    leaves little of the data, the basis function is fitted to what it leaves.
  - a positive definite one, with inexact normals: \f$ 4m \f$ equations for values and gradients, solved as a
    Gaussian process whose noise levels are given. The derivatives are taken at the nearest point of the zero set. Where points that
    are hardly noisy are all around the sample and nearly on a polynomial of degree 3, the basis function is fitted to what it leaves.
  - any other: the thesis's \f$ 4m \f$ equations (3.11), solved by LU, with a polynomial part if one is asked for. The derivatives are taken at the sample, or with
    inexact normals averaged over a Poisson-disc pattern in the tangent plane (8.5, 8.6).

  \tparam SampledSurface a model of `SampledSurface`
  \tparam RadialBasisFunction a model of `RadialBasisFunction`
*/
template <typename SampledSurface, typename RadialBasisFunction>
class Local_hermite_rbf
{
public:
  /// what else there is to choose
  struct Options
  {
    /// whether the normals are those of the surface itself
    bool normals_are_exact = false;
    /// whether to trust exact normals, their points or both less where that makes the data much likelier (positive definite basis
    /// functions)
    bool exactness_is_checked = true;
    /// standard deviation of the points, in units of the root mean square distance of the 9 nearest neighbors (positive
    /// definite basis functions with inexact normals)
    double noise_level = 1e-6;
    /// standard deviation of the components of the unit normals (in the same cases)
    double normal_noise_level = internal::Noisy_fit_attempts::default_normal_noise_level;
    /// degree of the polynomial part (other basis functions); -1: none
    int polynomial_degree = -1;
    /// box for `Exponential_cubic`
    Shape_parameter_box box = Shape_parameter_box::AXIS_ALIGNED;
    /// where to average, in units of `pattern_radius`; empty: at the sample alone (other basis functions)
    std::vector<Eigen::Vector2d> pattern;
    /// radius of the pattern
    double pattern_radius = 0.;
  };

  /// scratch memory, for one thread at a time
  struct Workspace
  {
    /// of the surface
    typename SampledSurface::Workspace surface;
    /// the system of equations
    internal::Hermite_system<RadialBasisFunction> system;
    /// what is fitted
    internal::Scaled_neighborhood neighborhood;
    /// mean distance of adjacent samples, not scaled (`Exponential_cubic`)
    double mean_spacing = 0.;
  };

  /// \throws std::invalid_argument if the basis function is not valid or has no second derivatives at the origin
  Local_hermite_rbf(const SampledSurface& surface, const RadialBasisFunction& phi, const Options& options)
    : m_surface(surface),
      m_phi(phi),
      m_options(options)
  {
    if(!RadialBasisFunction::is_valid)
      throw std::invalid_argument(
          "Shape_characteristics: radial_basis_function: `Polyharmonic<t>` needs an odd, "
          "`Polyharmonic_logarithmic<t>` an even exponent");
    internal::require_basis_function_for_normals<RadialBasisFunction>(
        "Shape_characteristics: radial_basis_function");
  }

  /// fits the surface at sample `i`
  Local_implicit_surface operator()(std::size_t i, Workspace& workspace) const
  {
    Local_implicit_surface result;
    result.status = prepare(i, workspace);
    if(!is_estimated(result.status))
      return result;

    internal::Hermite_jet jet;
    Eigen::Vector3d displacement = Eigen::Vector3d::Zero();
    bool fitted = false;
    if constexpr(!RadialBasisFunction::is_positive_definite)
      fitted = fit_indefinite(workspace, jet);
    else if(m_options.normals_are_exact)
      fitted = fit_exact(workspace, jet);
    else
      fitted = fit_noisy(workspace, jet, displacement);

    if(!fitted || !jet.gradient.allFinite() || !jet.hessian.allFinite())
    {
      result.status = Estimation_status::DEGENERATE;
      return result;
    }
    const internal::Scaled_neighborhood& neighborhood = workspace.neighborhood;
    result.gradient = neighborhood.scaling(jet.gradient);
    result.hessian = neighborhood.scaling(Eigen::Matrix3d(jet.hessian / neighborhood.scale));
    result.displacement = neighborhood.scale * neighborhood.scaling.inverse()(displacement);
    return result;
  }

  /// returns the logarithm of the probability density of the data at sample `i` and its nearest neighbors, for which rings
  /// grow if need be, if the points' noise was `noise_level`; NaN where there is no fit
  double log_likelihood(std::size_t i,
                        double noise_level,
                        std::size_t number_of_neighbors,
                        Workspace& workspace) const
  {
    static_assert(RadialBasisFunction::is_positive_definite);
    if(!is_estimated(workspace.neighborhood.collect_evenly(m_surface, i, workspace.surface,
                                                           number_of_neighbors, number_of_neighbors, false,
                                                           internal::Scaled_neighborhood::crowd)))
      return std::numeric_limits<double>::quiet_NaN();
    set_up_noisy(workspace, false);
    const internal::Noisy_fit_attempts noise(workspace.neighborhood, noise_level,
                                             m_options.normal_noise_level);
    return workspace.system.solve_positive_definite(noise.value_variance(), noise.derivative_variance())
               ? workspace.system.log_likelihood()
               : std::numeric_limits<double>::quiet_NaN();
  }

private:
  using Vector = Eigen::Vector3d;

  Estimation_status prepare(std::size_t i, Workspace& workspace) const
  {
    internal::Scaled_neighborhood& neighborhood = workspace.neighborhood;
    if constexpr(RadialBasisFunction::is_positive_definite)
    {
      const bool is_exact = m_options.normals_are_exact;
      const Estimation_status status = neighborhood.collect_evenly(
          m_surface, i, workspace.surface, internal::largest_neighborhood(m_surface.neighborhood(), is_exact),
          internal::desired_neighborhood(m_surface, i, is_exact), is_exact);
      return is_exact && is_estimated(status) && internal::contradicts_others(neighborhood.normals)
                 ? Estimation_status::DEGENERATE
                 : status;
    }
    const Estimation_status status = neighborhood.collect(m_surface, i, workspace.surface);
    if constexpr(std::is_same_v<RadialBasisFunction, Exponential_cubic>)
    {
      if(!is_estimated(status))
        return status;
      workspace.mean_spacing = 0.;
      for(const auto j : neighborhood.samples)
        workspace.mean_spacing += m_surface.spacing(j);
      workspace.mean_spacing /= double(neighborhood.samples.size());
      // of samples that are infinitely far: no shape parameter follows from it
      constexpr double epsilon = std::numeric_limits<double>::epsilon();
      if(!(workspace.mean_spacing > epsilon * neighborhood.scale) ||
         !(workspace.mean_spacing < neighborhood.scale / epsilon))
        return Estimation_status::DEGENERATE;
    }
    return status;
  }

  RadialBasisFunction basis_function(std::size_t number_of_points) const
  {
    if constexpr(!RadialBasisFunction::has_shape_parameter)
      return m_phi;
    else
      return m_phi.with_shape_parameter(
          internal::shape_parameter_of_fit(m_phi, number_of_points, m_options.normals_are_exact));
  }

  bool fit_exact(Workspace& workspace, internal::Hermite_jet& jet) const
  {
    const internal::Scaled_neighborhood& neighborhood = workspace.neighborhood;
    const Vector& normal = neighborhood.normals[0];
    const double unit = internal::shape_parameter_of_fit(m_phi, neighborhood.points.size(), true);
    workspace.system.clear(basis_function(neighborhood.points.size()),
                           internal::trend_of_exact_fit(neighborhood, unit));
    for(std::size_t k = 0; k < neighborhood.points.size(); ++k)
    {
      Vector t1, t2;
      internal::tangent_basis(neighborhood.normals[k], t1, t2);
      if(k == 0)
        workspace.system.add_center(neighborhood.points[k], 0., std::array<Vector, 3>{t1, t2, normal},
                                    std::array<double, 3>{0., 0., 1.});
      else
        workspace.system.add_center(neighborhood.points[k], 0., std::array<Vector, 2>{t1, t2},
                                    std::array<double, 2>{0., 0.});
    }
    internal::Exact_fit_attempts attempts(neighborhood);
    do
    {
      bool is_solved;
      do
        is_solved = workspace.system.solve_positive_definite(attempts.value_variance(),
                                                             attempts.derivative_variance());
      while(is_solved && m_options.exactness_is_checked && goes_on(attempts, workspace));
      if(!is_solved)
        continue;
      jet = workspace.system(Vector::Zero());
      if(internal::Exact_fit_attempts::is_surface(internal::Fit_quality(jet), jet.gradient.dot(normal)))
        return true;
    } while(attempts.next());
    return false;
  }

  // whether what was solved asks for another attempt
  static bool goes_on(internal::Exact_fit_attempts& attempts, const Workspace& workspace)
  {
    const internal::Fit_evidence evidence{workspace.neighborhood.points.size(), workspace.system.residual(),
                                          workspace.system.mahalanobis_square(),
                                          workspace.system.log_likelihood()};
    return attempts.is_in_doubt(evidence) && attempts.next_if_inexact(evidence);
  }

  void set_up_noisy(Workspace& workspace, bool bends_trend) const
  {
    const internal::Scaled_neighborhood& neighborhood = workspace.neighborhood;
    internal::Hermite_trend trend(internal::trend_of_noisy_fit(neighborhood.normals));
    if(bends_trend)
      internal::bend_by_heights(trend, neighborhood.points);
    workspace.system.clear(basis_function(neighborhood.points.size()), trend);
    add_gradients(workspace);
  }

  static void add_gradients(Workspace& workspace)
  {
    const internal::Scaled_neighborhood& neighborhood = workspace.neighborhood;
    for(std::size_t k = 0; k < neighborhood.points.size(); ++k)
    {
      const Vector& n = neighborhood.normals[k];
      workspace.system.add_center(neighborhood.points[k], 0.,
                                  std::array<Vector, 3>{Vector::UnitX(), Vector::UnitY(), Vector::UnitZ()},
                                  std::array<double, 3>{n.x(), n.y(), n.z()});
    }
  }

  bool fit_noisy(Workspace& workspace, internal::Hermite_jet& jet, Vector& displacement) const
  {
    internal::Noisy_fit_attempts attempts(workspace.neighborhood, m_options.noise_level,
                                          m_options.normal_noise_level);
    for(bool go_on = true; go_on;)
    {
      set_up_noisy(workspace, attempts.bends_trend());
      if(!workspace.system.solve_positive_definite(attempts.value_variance(), attempts.derivative_variance()))
      {
        go_on = attempts.next_if_indefinite();
        continue;
      }
      displacement.setZero();
      jet = workspace.system(displacement);
      internal::step_to_zero_set(jet, workspace.neighborhood.scaling, displacement);
      if(!internal::is_negligible(displacement))
      {
        internal::step_to_zero_set(workspace.system(displacement), workspace.neighborhood.scaling,
                                   displacement);
        jet = workspace.system(displacement);
      }
      const internal::Fit_quality quality(jet);
      const bool is_surface = internal::Noisy_fit_attempts::is_surface(quality, displacement);
      if(is_surface && internal::Noisy_fit_attempts::is_plausible(quality))
        return true;
      go_on = attempts.next(is_surface);
    }
    return false;
  }

  bool fit_indefinite(Workspace& workspace, internal::Hermite_jet& jet) const
  {
    const internal::Scaled_neighborhood& neighborhood = workspace.neighborhood;
    workspace.system.clear(thesis_basis_function(workspace), internal::Hermite_trend(),
                           m_options.polynomial_degree);
    add_gradients(workspace);
    if(!workspace.system.solve_indefinite())
      return false;
    // A matrix that is singular to working precision may be solved without complaint, and wrongly.
    constexpr double tolerance = 1e-3;
    const internal::Hermite_jet at_center = workspace.system(Vector::Zero());
    if(!(std::abs(at_center.value) < tolerance &&
         (at_center.gradient - neighborhood.normals[0]).norm() < tolerance))
      return false;
    if(m_options.pattern.empty())
      jet = at_center;
    else
    {
      // the same pattern for a normal and its opposite: flipping a surface flips the result to the last bit. The sign of
      // what is zero but for rounding doesn't decide.
      constexpr double is_zero = 1e-9;
      const Vector& normal = neighborhood.normals[0];
      const Vector n = (normal.array().abs() < is_zero).select(0., normal);
      const bool is_up = n.z() != 0. ? n.z() > 0. : (n.y() != 0. ? n.y() > 0. : n.x() > 0.);
      Vector t1, t2;
      internal::tangent_basis(Vector(is_up ? n : Vector(-n)) + Vector::Zero(), t1, t2); // -0 becomes 0
      const double radius = m_options.pattern_radius / neighborhood.scale;
      for(const Eigen::Vector2d& c : m_options.pattern)
      {
        const internal::Hermite_jet sample = workspace.system(radius * (c.x() * t1 + c.y() * t2));
        jet.gradient += sample.gradient / double(m_options.pattern.size());
        jet.hessian += sample.hessian / double(m_options.pattern.size());
      }
    }
    return internal::Fit_quality(jet).largest_curvature < internal::largest_plausible_curvature;
  }

  // The thesis's choice (8.1.1): mean edge length over the cubed longest side of a box, where that side is the unit
  // of length.
  RadialBasisFunction thesis_basis_function(const Workspace& workspace) const
  {
    if constexpr(!std::is_same_v<RadialBasisFunction, Exponential_cubic>)
      return m_phi;
    else
    {
      const internal::Scaled_neighborhood& neighborhood = workspace.neighborhood;
      if(m_phi.is_shape_parameter_set())
        return m_phi;
      Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
      if(m_options.box == Shape_parameter_box::ORIENTED)
      {
        Vector mean = Vector::Zero();
        for(const Vector& p : neighborhood.points)
          mean += p / double(neighborhood.points.size());
        Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
        for(const Vector& p : neighborhood.points)
          covariance += (p - mean) * (p - mean).transpose();
        axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors().transpose();
      }
      Vector low = Vector::Zero(), high = Vector::Zero();
      for(const Vector& p : neighborhood.points)
      {
        low = low.cwiseMin(axes * p);
        high = high.cwiseMax(axes * p);
      }
      const double longest = (high - low).maxCoeff();
      const double edge = workspace.mean_spacing / neighborhood.scale;
      return m_phi.with_shape_parameter(edge / longest / (longest * longest * longest));
    }
  }

  const SampledSurface& m_surface;
  RadialBasisFunction m_phi;
  Options m_options;
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_LOCAL_HERMITE_RBF_H
