#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_LOCAL_HERMITE_RBF_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_LOCAL_HERMITE_RBF_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/internal/length.h>
#include <Shape_characteristics/internal/tangent_basis.h>
#include <Shape_characteristics/interpolation/Exponential_cubic.h>
#include <Shape_characteristics/interpolation/Inverse_multiquadric.h>
#include <Shape_characteristics/interpolation/Shape_parameter_box.h>
#include <Shape_characteristics/interpolation/internal/Hermite_system.h>

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

  Each neighborhood is moved to its sample and scaled to root mean square distance 1. The function's zero set follows
  the points, its gradient the normals. The basis function chooses the system of equations:

  - a positive definite one, with normals that are exact: value 0 and both tangential derivatives 0 at each of the
    \f$ m \f$ points, and the derivative along the normal 1 at the sample. These are \f$ 3m+1 \f$ equations: of a normal, its
    direction is used and not its length. Solved by Cholesky's method.
  - a positive definite one, with inexact normals: \f$ 4m \f$ equations for values and gradients, solved as a
    Gaussian process whose noise levels are given. The derivatives are taken at the nearest point of the zero set.
  - any other: the thesis's \f$ 4m \f$ equations (3.11), solved by LU. The derivatives are taken at the sample, or with
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
    /// standard deviation of the points, in units of the root mean square distance of the 9 nearest neighbors (positive
    /// definite basis functions with inexact normals)
    double noise_level = 1e-6;
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
    /// points of the neighborhood, scaled; the sample is the first
    std::vector<Eigen::Vector3d> points;
    /// normals of the neighborhood
    std::vector<Eigen::Vector3d> normals;
    /// root mean square distance of the nearest neighbors, scaled
    double nearest_size = 1.;
    /// mean distance of adjacent samples, not scaled (`Exponential_cubic`)
    double mean_spacing = 0.;
  };

  /// \throws std::invalid_argument if the basis function is not valid
  Local_hermite_rbf(const SampledSurface& surface, const RadialBasisFunction& phi, const Options& options)
    : m_surface(surface),
      m_phi(phi),
      m_options(options)
  {
    if(!RadialBasisFunction::is_valid)
      throw std::invalid_argument(
          "Shape_characteristics: radial_basis_function: the exponent of Polyharmonic must be odd");
  }

  /// fits the surface at sample `i`
  Local_implicit_surface operator()(std::size_t i, Workspace& workspace) const
  {
    Local_implicit_surface result;
    double scale = 0.;
    result.status = prepare(i, workspace, scale);
    if(!is_estimated(result.status))
      return result;

    internal::Hermite_jet jet;
    Eigen::Vector3d displacement = Eigen::Vector3d::Zero();
    bool fitted = false;
    if constexpr(!RadialBasisFunction::is_positive_definite)
      fitted = fit_indefinite(scale, workspace, jet);
    else if(m_options.normals_are_exact)
      fitted = fit_exact(rounding_error(i, scale), workspace, jet);
    else
      fitted = fit_noisy(rounding_error(i, scale), workspace, jet, displacement);

    if(!fitted || !jet.gradient.allFinite() || !jet.hessian.allFinite())
    {
      result.status = Estimation_status::DEGENERATE;
      return result;
    }
    result.gradient = jet.gradient;
    result.hessian = jet.hessian / scale;
    result.displacement = scale * displacement;
    return result;
  }

  /// returns the logarithm of the probability density of the data at sample `i` and its 9 nearest neighbors, if the
  /// points' noise was `noise_level`; NaN where there is no fit
  double log_likelihood(std::size_t i, double noise_level, Workspace& workspace) const
  {
    static_assert(RadialBasisFunction::is_positive_definite);
    double scale = 0.;
    if(!is_estimated(prepare(i, workspace, scale, s_nearest)))
      return std::numeric_limits<double>::quiet_NaN();
    set_up_noisy(workspace);
    const double variance = (std::max)(noise_level * noise_level, nugget(rounding_error(i, scale)));
    return workspace.system.solve_positive_definite(variance, s_normal_variance)
               ? workspace.system.log_likelihood()
               : std::numeric_limits<double>::quiet_NaN();
  }

private:
  using Vector = Eigen::Vector3d;

  static constexpr std::size_t s_minimum = 3; // neighbors without which there is no answer
  static constexpr std::size_t s_desired = 5; // neighbors for which further rings are searched
  static constexpr std::size_t s_nearest =
      9; // neighbors that tell the level of noise: so few that a smooth surface
         // bends little between them
  static constexpr double s_merged = 1e-3;      // distance, in units of the scale, below which points are one
  static constexpr double s_largest = 50.;      // curvature times scale beyond which a fit has failed
  static constexpr double s_largest_noisy = 4.; // the same of inexact data
  static constexpr int s_attempts =
      9; // to fit inexact data, with noise levels that are ever farther from the given ones
  static constexpr double s_normal_variance =
      0.1; // of estimated normals: weak evidence beside good positions

  // collects the scaled neighborhood
  Estimation_status prepare(std::size_t i,
                            Workspace& workspace,
                            double& scale,
                            std::size_t limit = (std::numeric_limits<std::size_t>::max)()) const
  {
    const Estimation_status status = m_surface.status(i);
    if(!is_estimated(status))
      return status;
    const auto& neighbors = m_surface.neighbors(i, s_desired, workspace.surface);
    if(neighbors.size() < s_minimum)
      return Estimation_status::FEW_NEIGHBOURS;

    const Vector& center = m_surface.point(i);
    workspace.points.assign(1, Vector::Zero());
    workspace.normals.assign(1, m_surface.normal(i));
    double largest = 0.;
    const std::size_t number_of_neighbors = (std::min)(neighbors.size(), limit);
    for(std::size_t k = 0; k < number_of_neighbors; ++k)
    {
      const auto j = neighbors[k];
      workspace.points.push_back(m_surface.point(j) - center);
      workspace.normals.push_back(m_surface.normal(j));
      largest = (std::max)(largest, workspace.points.back().template lpNorm<Eigen::Infinity>());
    }
    if(!(largest > 0.) || !std::isfinite(largest))
      return Estimation_status::DEGENERATE;
    double sum = 0., sum_of_nearest = 0.;
    for(std::size_t k = 1; k <= number_of_neighbors; ++k)
    {
      sum += (workspace.points[k] / largest).squaredNorm();
      if(k == (std::min)(s_nearest, number_of_neighbors))
        sum_of_nearest = sum / double(k);
    }
    sum /= double(number_of_neighbors);
    scale = largest * std::sqrt(sum);
    if(!(scale >= (std::numeric_limits<double>::min)()))
      return Estimation_status::DEGENERATE;
    workspace.nearest_size = std::sqrt(sum_of_nearest / sum);
    for(Vector& d : workspace.points)
      d /= scale;
    if constexpr(std::is_same_v<RadialBasisFunction, Exponential_cubic>)
    {
      workspace.mean_spacing = m_surface.spacing(i);
      for(const auto j : neighbors)
        workspace.mean_spacing += m_surface.spacing(j);
      workspace.mean_spacing /= double(neighbors.size() + 1);
      // of samples that coincide or are infinitely far: no shape parameter follows from it
      constexpr double epsilon = std::numeric_limits<double>::epsilon();
      if(!(workspace.mean_spacing > epsilon * scale) || !(workspace.mean_spacing < scale / epsilon))
        return Estimation_status::DEGENERATE;
    }
    merge(workspace);
    return workspace.points.size() <= s_minimum || is_collinear(workspace.points)
               ? Estimation_status::DEGENERATE
               : status;
  }

  // Points closer to each other than any sampling means them to be, with different normals, would make the surface
  // between them explode. The one nearest to the sample stays.
  static void merge(Workspace& workspace)
  {
    std::size_t kept = 1;
    for(std::size_t k = 1; k < workspace.points.size(); ++k)
    {
      const bool is_far = std::all_of(
          workspace.points.begin(), workspace.points.begin() + std::ptrdiff_t(kept),
          [&](const Vector& p) { return (p - workspace.points[k]).squaredNorm() > s_merged * s_merged; });
      if(!is_far)
        continue;
      workspace.points[kept] = workspace.points[k];
      workspace.normals[kept] = workspace.normals[k];
      ++kept;
    }
    workspace.points.resize(kept);
    workspace.normals.resize(kept);
  }

  // whether points (one of them the origin) lie on a line, as far as curvature is concerned
  static bool is_collinear(const std::vector<Vector>& points)
  {
    Vector axis = Vector::Zero();
    for(const Vector& p : points)
      if(p.squaredNorm() > axis.squaredNorm())
        axis = p;
    double farthest = 0.;
    for(const Vector& p : points)
      farthest = (std::max)(farthest, p.cross(axis).squaredNorm());
    return farthest <= 1e-12 * axis.squaredNorm() * axis.squaredNorm();
  }

  // of coordinates that were rounded before the neighborhood was scaled
  double rounding_error(std::size_t i, double scale) const
  {
    return std::numeric_limits<double>::epsilon() *
           (m_surface.point(i).template lpNorm<Eigen::Infinity>() / scale);
  }

  static double nugget(double rounding) { return (std::max)(1e-12, 16. * rounding * rounding); }

  // flatter for larger neighborhoods: measured best at 7, 19, 37 and 61 points of smooth surfaces
  RadialBasisFunction basis_function(std::size_t number_of_points) const
  {
    if constexpr(!RadialBasisFunction::has_shape_parameter)
      return m_phi;
    else
    {
      if(m_phi.is_shape_parameter_set())
        return m_phi;
      const double rings = std::sqrt(double(number_of_points));
      const double flat = (std::min)((std::max)(0.08 + 0.0775 * (rings - std::sqrt(7.)), 0.05), 0.6);
      return m_phi.with_shape_parameter(m_options.normals_are_exact ? flat : 0.25);
    }
  }

  // whether the surface bends as much as the samples can tell; what the function does off the surface doesn't matter
  static bool is_bounded(const internal::Hermite_jet& jet, double largest = s_largest)
  {
    const double length = jet.gradient.norm();
    const Eigen::Matrix3d projection =
        Eigen::Matrix3d::Identity() - (jet.gradient / length) * (jet.gradient / length).transpose();
    return (projection * jet.hessian * projection).norm() < largest * length;
  }

  bool fit_exact(double rounding, Workspace& workspace, internal::Hermite_jet& jet) const
  {
    const Vector& normal = workspace.normals[0];
    workspace.system.clear(basis_function(workspace.points.size()), normal);
    for(std::size_t k = 0; k < workspace.points.size(); ++k)
    {
      Vector t1, t2;
      internal::tangent_basis(workspace.normals[k], t1, t2);
      if(k == 0)
        workspace.system.add_center(workspace.points[k], 0., std::array<Vector, 3>{t1, t2, normal},
                                    std::array<double, 3>{0., 0., 1.});
      else
        workspace.system.add_center(workspace.points[k], 0., std::array<Vector, 2>{t1, t2},
                                    std::array<double, 2>{0., 0.});
    }
    double noise = nugget(rounding);
    for(int attempt = 0; attempt < 4; ++attempt, noise *= 100.)
    {
      if(!workspace.system.solve_positive_definite(noise, noise))
        continue;
      jet = workspace.system(Vector::Zero());
      const double length = jet.gradient.norm();
      if(length > 0.1 && jet.gradient.dot(normal) > 0.5 * length && is_bounded(jet))
        return true;
    }
    return false;
  }

  void set_up_noisy(Workspace& workspace) const
  {
    // normals of an opposite sheet don't take part in the trend
    Vector trend = Vector::Zero();
    for(const Vector& n : workspace.normals)
      if(n.dot(workspace.normals[0]) > 0.)
        trend += n;
    trend.normalize();

    workspace.system.clear(basis_function(workspace.points.size()), trend);
    for(std::size_t k = 0; k < workspace.points.size(); ++k)
    {
      const Vector& n = workspace.normals[k];
      workspace.system.add_center(workspace.points[k], 0.,
                                  std::array<Vector, 3>{Vector::UnitX(), Vector::UnitY(), Vector::UnitZ()},
                                  std::array<double, 3>{n.x(), n.y(), n.z()});
    }
  }

  // The noise of the normals is guessed. Where it was guessed too high, as on a surface that bends much between its
  // samples, the function may as well be zero everywhere, and its gradient shrinks: then normals are trusted more. Where
  // the points' noise was guessed too low, as at a sharp edge between large flat faces, the surface bends more than its
  // samples can tell: then points are trusted less.
  bool
  fit_noisy(double rounding, Workspace& workspace, internal::Hermite_jet& jet, Vector& displacement) const
  {
    set_up_noisy(workspace);
    const double noise = m_options.noise_level * workspace.nearest_size;
    double variance = (std::max)(noise * noise, nugget(rounding));
    double normal_variance = s_normal_variance;
    for(int attempt = 0; attempt < s_attempts; ++attempt)
    {
      if(!workspace.system.solve_positive_definite(variance, normal_variance))
      {
        variance *= 100.;
        continue;
      }
      displacement.setZero();
      for(int step = 0; step < 2; ++step)
      {
        jet = workspace.system(displacement);
        displacement -= jet.value / jet.gradient.squaredNorm() * jet.gradient;
      }
      jet = workspace.system(displacement);
      const double length = jet.gradient.norm();
      const bool is_surface = length > 0.05 && displacement.norm() < 0.5;
      if(is_surface && is_bounded(jet, s_largest_noisy))
        return true;
      if(!is_surface)
        normal_variance *= 0.1;
      if(is_surface || attempt >= 2)
        variance = (std::max)(100. * variance, 1e-8);
    }
    return false;
  }

  bool fit_indefinite(double scale, Workspace& workspace, internal::Hermite_jet& jet) const
  {
    workspace.system.clear(thesis_basis_function(scale, workspace), Vector::Zero());
    for(std::size_t k = 0; k < workspace.points.size(); ++k)
    {
      const Vector& n = workspace.normals[k];
      workspace.system.add_center(workspace.points[k], 0.,
                                  std::array<Vector, 3>{Vector::UnitX(), Vector::UnitY(), Vector::UnitZ()},
                                  std::array<double, 3>{n.x(), n.y(), n.z()});
    }
    if(!workspace.system.solve_indefinite())
      return false;
    // A matrix that is singular to working precision may be solved without complaint, and wrongly.
    constexpr double tolerance = 1e-3;
    const internal::Hermite_jet at_center = workspace.system(Vector::Zero());
    if(!(std::abs(at_center.value) < tolerance &&
         (at_center.gradient - workspace.normals[0]).norm() < tolerance))
      return false;
    if(m_options.pattern.empty())
      jet = at_center;
    else
    {
      // the same pattern for a normal and its opposite: flipping a surface flips the result to the last bit
      const Vector& n = workspace.normals[0];
      const bool is_up = n.z() != 0. ? n.z() > 0. : (n.y() != 0. ? n.y() > 0. : n.x() > 0.);
      Vector t1, t2;
      internal::tangent_basis(Vector(is_up ? n : Vector(-n)) + Vector::Zero(), t1, t2); // -0 becomes 0
      const double radius = m_options.pattern_radius / scale;
      for(const Eigen::Vector2d& c : m_options.pattern)
      {
        const internal::Hermite_jet sample = workspace.system(radius * (c.x() * t1 + c.y() * t2));
        jet.gradient += sample.gradient / double(m_options.pattern.size());
        jet.hessian += sample.hessian / double(m_options.pattern.size());
      }
    }
    return is_bounded(jet);
  }

  // The thesis's choice (8.1.1): mean edge length over the cubed longest side of a box, where that side is the unit
  // of length.
  RadialBasisFunction thesis_basis_function(double scale, const Workspace& workspace) const
  {
    if constexpr(!std::is_same_v<RadialBasisFunction, Exponential_cubic>)
    {
      (void)scale;
      return m_phi;
    }
    else
    {
      if(m_phi.is_shape_parameter_set())
        return m_phi;
      Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
      if(m_options.box == Shape_parameter_box::ORIENTED)
      {
        Vector mean = Vector::Zero();
        for(const Vector& p : workspace.points)
          mean += p / double(workspace.points.size());
        Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
        for(const Vector& p : workspace.points)
          covariance += (p - mean) * (p - mean).transpose();
        axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors().transpose();
      }
      Vector low = Vector::Zero(), high = Vector::Zero();
      for(const Vector& p : workspace.points)
      {
        low = low.cwiseMin(axes * p);
        high = high.cwiseMax(axes * p);
      }
      const double longest = (high - low).maxCoeff();
      const double edge = workspace.mean_spacing / scale;
      return m_phi.with_shape_parameter(edge / longest / (longest * longest * longest));
    }
  }

  const SampledSurface& m_surface;
  RadialBasisFunction m_phi;
  Options m_options;
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_LOCAL_HERMITE_RBF_H
