#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_FIT_RULES_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_FIT_RULES_H

#include <Shape_characteristics/internal/Axis_scaling.h>
#include <Shape_characteristics/internal/Scaled_neighborhood.h>
#include <Shape_characteristics/interpolation/internal/Hermite_jet.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// What of a fitted function decides whether it describes a surface.
struct Fit_quality
{
  double gradient_length = 0.;
  double largest_curvature =
      0.; // of the surface, in units of the inverse size of the neighborhood; what the function
          // does off the surface doesn't matter

  Fit_quality() = default;
  explicit Fit_quality(const Hermite_jet& jet)
  {
    // Frobenius' norm of P H P with the projection P = I - n n^T onto the tangent plane
    const double squared_length = jet.gradient.squaredNorm();
    const Eigen::Vector3d image = jet.hessian * jet.gradient;
    const double along_normal = jet.gradient.dot(image) / squared_length;
    const double square =
        jet.hessian.squaredNorm() - 2. * (image.squaredNorm() / squared_length) + along_normal * along_normal;
    gradient_length = std::sqrt(squared_length);
    largest_curvature = std::sqrt((std::max)(square, 0.)) / gradient_length;
  }
};

inline constexpr double largest_plausible_curvature = 50.; // beyond which a fit has failed

// Shape parameter of a positive definite basis function that was given none, for exact normals: flatter for larger
// neighborhoods. Measured best at 7, 19, 37 and 61 points of smooth surfaces.
inline double shape_parameter_of_exact_fit(std::size_t number_of_points)
{
  const double flat = 0.08 + 0.0775 * (std::sqrt(double(number_of_points)) - std::sqrt(7.));
  return (std::min)((std::max)(flat, 0.05), 0.6);
}

inline constexpr double shape_parameter_of_noisy_fit = 0.25;

template <typename RadialBasisFunction>
double shape_parameter_of_fit(const RadialBasisFunction& phi, std::size_t number_of_points, bool is_exact)
{
  if constexpr(RadialBasisFunction::has_shape_parameter)
  {
    if(phi.is_shape_parameter_set())
      return phi.shape_parameter();
    return is_exact ? shape_parameter_of_exact_fit(number_of_points) : shape_parameter_of_noisy_fit;
  }
  else
    return 1.;
}

inline double nugget(double rounding_error)
{
  return (std::max)(1e-12, 16. * rounding_error * rounding_error);
}

// The linear trend of an inexact fit. Normals of an opposite sheet don't take part in it, nor do those at right angles:
// where a regular surface has some, rounding would decide.
inline Eigen::Vector3d trend_of_noisy_fit(const std::vector<Eigen::Vector3d>& normals)
{
  Eigen::Vector3d trend = Eigen::Vector3d::Zero();
  for(const Eigen::Vector3d& n : normals)
    if(n.dot(normals[0]) > 0.1)
      trend += n;
  return trend.normalized();
}

// Whether the first of some exact normals is at right angles to all the others, which agree with each other. No surface is like that,
// but a function may well have any derivatives at a single point.
inline bool contradicts_others(const std::vector<Eigen::Vector3d>& normals)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for(std::size_t k = 1; k < normals.size(); ++k)
    sum += normals[k];
  const double length = sum.norm();
  return length > 0.5 * double(normals.size() - 1) && std::abs(sum.dot(normals[0])) < 0.1 * length;
}

/*
  The attempts to fit inexact data. The noise of the normals is guessed. Where it was guessed too high, as on a surface that
  bends much between its samples, the function may as well be zero everywhere, and its gradient shrinks: then normals are
  trusted more. Where the points' noise was guessed too low, as at a sharp edge between large flat faces, the surface bends
  more than its samples can tell: then points are trusted less.
*/
class Noisy_fit_attempts
{
public:
  Noisy_fit_attempts() = default;
  // noise_level: in units of the size of the nearest neighbors; normal_noise_level: of a component of the normals
  Noisy_fit_attempts(const Scaled_neighborhood& neighborhood,
                     double noise_level,
                     double normal_noise_level = default_normal_noise_level)
  {
    const double noise = noise_level * neighborhood.nearest_size;
    m_bends_trend = noise_level < negligible;
    m_value_variance = (std::max)(noise * noise, nugget(neighborhood.rounding_error));
    m_derivative_variance =
        (std::max)(normal_noise_level * normal_noise_level, nugget(neighborhood.rounding_error));
  }

  double value_variance() const { return m_value_variance; }
  double derivative_variance() const { return m_derivative_variance; }

  // whether points may tell how the trend bends: those of the first attempt, if they are hardly noisy
  bool bends_trend() const { return m_bends_trend && m_failures == 0; }
  void keep_trend_straight() { m_bends_trend = false; }

  // whether the function has a zero set near the sample; `displacement` is how far
  static bool is_surface(const Fit_quality& quality, const Eigen::Vector3d& displacement)
  {
    return quality.gradient_length > 0.05 && displacement.squaredNorm() < 0.25;
  }

  static bool is_plausible(const Fit_quality& quality)
  {
    return quality.largest_curvature < s_largest_curvature;
  }

  // after an attempt with a matrix that wasn't positive definite: whether there is another
  bool next_if_indefinite()
  {
    m_value_variance *= 100.;
    return ++m_failures < s_attempts;
  }

  // after an attempt that gave something else than a plausible surface: whether there is another
  bool next(bool was_surface)
  {
    if(!was_surface)
      m_derivative_variance *= 0.1;
    if(was_surface || m_failures >= 2)
      m_value_variance = (std::max)(100. * m_value_variance, 1e-8);
    return ++m_failures < s_attempts;
  }

  // estimated normals are weak evidence beside good positions: a variance of .1
  static constexpr double default_normal_noise_level = .31622776601683794;

  static constexpr double negligible = 1e-4; // noise level

private:
  static constexpr int s_attempts = 9; // with noise levels that are ever farther from the given ones
  static constexpr double s_largest_curvature = 4.;

  double m_value_variance = 0., m_derivative_variance = 0.;
  bool m_bends_trend = false;
  int m_failures = 0;
};

// How many neighbors take part in a fit, the nearest first. A vertex with long edges, as on the border of a Delaunay
// triangulation, has hundreds within some rings: they cost much, and those that are far tell nothing. Exact normals tell so much
// that it takes hardly more than a regular mesh has.
inline std::size_t largest_neighborhood(const Neighborhood& neighborhood, bool is_exact)
{
  if(neighborhood.kind() != Neighborhood::Kind::RINGS)
    return (std::numeric_limits<std::size_t>::max)();
  const std::size_t rings = neighborhood.count(), regular = 3 * rings * (rings + 1);
  return is_exact ? (std::max)(11 * regular / 9, std::size_t(22)) : (std::max)(2 * regular, std::size_t(48));
}

// How many neighbors a fit should have: where rings have less, they grow. Around a vertex of the border, they have half as many as
// elsewhere, all on one side: enough for exact normals, which tell that much; with inexact ones, a fit to so few has several times
// the error.
template <typename SampledSurface>
std::size_t desired_neighborhood(const SampledSurface& surface, std::size_t i, bool is_exact)
{
  using Kind = decltype(surface.neighborhood().kind());
  if(is_exact || surface.neighborhood().kind() != Kind::RINGS ||
     surface.status(i) != Estimation_status::BORDER)
    return Scaled_neighborhood::desired;
  const std::size_t rings = surface.neighborhood().count(), regular = 3 * rings * (rings + 1);
  return 13 * regular / 10;
}

// The same for all that is asked of a neighborhood with inexact normals: the nearest ones tell the level of noise.
template <typename SampledSurface>
std::size_t seen_neighborhood(const SampledSurface& surface, std::size_t i)
{
  return (std::max)(Scaled_neighborhood::nearest, desired_neighborhood(surface, i, false));
}

// a step of Newton's method from `displacement` towards the zero set, along its normal in space before it was scaled
inline void
step_to_zero_set(const Hermite_jet& jet, const Axis_scaling& scaling, Eigen::Vector3d& displacement)
{
  const Eigen::Vector3d gradient = scaling(jet.gradient);
  displacement -= jet.value / gradient.squaredNorm() * scaling(gradient);
}

// whether derivatives are the same before and after a displacement, as far as anybody can tell
inline bool is_negligible(const Eigen::Vector3d& displacement)
{
  return displacement.squaredNorm() < 1e-12;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_FIT_RULES_H
