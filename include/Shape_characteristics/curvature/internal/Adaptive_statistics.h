#ifndef SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ADAPTIVE_STATISTICS_H
#define SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ADAPTIVE_STATISTICS_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/curvature/Adaptive_estimator_choice.h>
#include <Shape_characteristics/curvature/internal/Fitted_sample.h>
#include <Shape_characteristics/curvature/internal/Noise_evidence.h>
#include <Shape_characteristics/internal/log_of_sum.h>
#include <Shape_characteristics/interpolation/Inverse_multiquadric.h>
#include <Shape_characteristics/interpolation/Local_hermite_rbf.h>
#include <Shape_characteristics/interpolation/Matern_9_2.h>
#include <Shape_characteristics/interpolation/fit_hermite_rbf.h>
#include <Shape_characteristics/sampling/for_each_sample.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// those that are blended
inline constexpr std::size_t number_of_adaptive_candidates = std::size_t(Adaptive_estimator_choice::QUADRIC);

// The share of an estimator in a blend, as a multiple of the best one's; `distance`: of the scores of both. A small one is
// none, and it becomes so continuously: scores hang on rounding, too.
inline double adaptive_share(double distance)
{
  constexpr double least = .02;
  return (std::max)((std::exp(-distance) - least) / (1. - least), 0.);
}

// Whose fit takes the share of an estimator in a blend, if it has one. Since exactness is checked, three rings are hardly ever worse than
// two, and mostly better.
inline constexpr Adaptive_estimator_choice adaptive_heir(Adaptive_estimator_choice choice)
{
  return choice == Adaptive_estimator_choice::CHECKED_2_RINGS ? Adaptive_estimator_choice::CHECKED_3_RINGS
                                                              : choice;
}

/*
  What there is to be known of a sample and its surroundings, without units: lengths are in units of the size h of the
  nearest neighbors, curvatures in those of 1 / h. Those before `IRREGULARITY` are decimal logarithms of means over the neighbors.
  What is less than the least noise level counts as that: rounding decides it, where points are far from the origin. Angles
  alone, which tell whether normals are exact, are taken as they are.

  A surface with normals and shape operators that are those of its points satisfies along each short edge d, up to the fifth
  power of its length,
    (n_p + n_q) / 2 . d + (d . S_p d - d . S_q d) / 12 = 0           (the trapezoidal rule, corrected at its ends)
  and up to the third
    n_q - n_p = (S_p + S_q) / 2 d.
  What remains of the first tells how far normals and points disagree, in angles; what remains of the second, how far
  normals and curvatures do. Of fits to noise nothing else is known to hold; a smooth surface that is sampled coarsely leaves less
  the better it is sampled. How much two fits differ that trust the data to different degrees tells the rest.
*/
enum class Adaptive_statistic : unsigned char
{
  // the first remainder of each fit, over |d|: in the order of Adaptive_estimator_choice
  EXACT_2_ANGLES,
  EXACT_3_ANGLES,
  POINTS_2_ANGLES,
  POINTS_3_ANGLES,
  POINTS_4_ANGLES,
  NORMALS_2_ANGLES,
  NORMALS_3_ANGLES,
  SMOOTHED_3_ANGLES,
  SMOOTHED_4_ANGLES,
  GENTLY_4_ANGLES,
  BARELY_4_ANGLES,
  CHECKED_2_ANGLES,
  CHECKED_3_ANGLES,
  // the second one, as an angle, too
  EXACT_2_TURNS,
  EXACT_3_TURNS,
  POINTS_2_TURNS,
  POINTS_3_TURNS,
  POINTS_4_TURNS,
  NORMALS_2_TURNS,
  NORMALS_3_TURNS,
  SMOOTHED_3_TURNS,
  SMOOTHED_4_TURNS,
  GENTLY_4_TURNS,
  BARELY_4_TURNS,
  CHECKED_2_TURNS,
  CHECKED_3_TURNS,
  // differences of the shape operators of two fits
  EXACT_2_EXACT_3,
  POINTS_2_POINTS_3,
  POINTS_3_POINTS_4,
  EXACT_3_POINTS_3,
  EXACT_2_NORMALS_2,
  NORMALS_2_NORMALS_3,
  EXACT_3_NORMALS_3,
  POINTS_3_NORMALS_3,
  POINTS_3_SMOOTHED_3,
  POINTS_4_SMOOTHED_4,
  NORMALS_3_SMOOTHED_3,
  SMOOTHED_3_SMOOTHED_4,
  SMOOTHED_3_GENTLY_4,
  SMOOTHED_4_GENTLY_4,
  GENTLY_4_BARELY_4,
  POINTS_4_BARELY_4,
  CHECKED_2_CHECKED_3,
  CHECKED_3_POINTS_3,
  CHECKED_2_NORMALS_2,
  CHECKED_3_NORMALS_3,
  EXACT_3_CHECKED_3,
  // angles between the given normals and those of a fit
  POINTS_3_NORMALS,
  SMOOTHED_3_NORMALS,
  // shape operators
  POINTS_3_BEND,
  SMOOTHED_3_BEND,
  // displacements along the normals, and their mean: noise has none
  SMOOTHED_3_MOVES,
  SMOOTHED_3_DRIFT,
  NOISE,              // the noise level of the points of the whole surface, if bends count as noise
  NOISE_BESIDE_BENDS, // if they don't
  IRREGULARITY,       // size of the nearest neighbors over the distance of the nearest one
  // How likely levels of noise make the nearest neighbors, if the surface is as rough as the default fit takes it to be: see
  // Noise_evidence, in whose order they are.
  NORMALS_BY_1E_3,
  NORMALS_BY_1E_2,
  NORMALS_BY_1E_1,
  POINTS_BY_1E_6,
  POINTS_BY_1E_3,
  POINTS_BY_1E_2,
  POINTS_BY_3E_2,
  LIKELY_NOISE_OF_POINTS,
  LIKELY_NOISE_OF_NORMALS,
  NEITHER_IS_NOISY,
  // the same if it is as rough, or twice or four times so
  ROUGH_NORMALS_BY_1E_3,
  ROUGH_NORMALS_BY_1E_2,
  ROUGH_NORMALS_BY_1E_1,
  ROUGH_POINTS_BY_1E_6,
  ROUGH_POINTS_BY_1E_3,
  ROUGH_POINTS_BY_1E_2,
  ROUGH_POINTS_BY_3E_2,
  ROUGH_LIKELY_NOISE_OF_POINTS,
  ROUGH_LIKELY_NOISE_OF_NORMALS,
  ROUGH_NEITHER_IS_NOISY,
  COUNT
};

inline constexpr std::size_t number_of_adaptive_statistics = std::size_t(Adaptive_statistic::COUNT);

static_assert(std::size_t(Adaptive_statistic::NORMALS_BY_1E_3) + 2 * Noise_evidence::number_of_statistics ==
              number_of_adaptive_statistics);

// Whether normals are exact beyond doubt: a fit to points and given normals agrees with them much better than one that hardly looks at
// normals (`exactness` is learned), or as well, and as only exact ones do. `statistic(name)` is one of the sample: all are decimal
// logarithms. Where the noise level isn't the least one, the smaller one of the angles keeps all noise out but that of single precision.
// Where a surface bends little, points and normals of the faces of marching cubes agree as well: but then either normals agree less
// with curvatures, or to check whether they are exact changes curvatures as much as not to look at them.
template <typename Statistic>
bool normals_are_exact(const Statistic& statistic, double exactness)
{
  using Name = Adaptive_statistic;
  constexpr double no_noise = -5.9, no_change = -5.5, largest_angle = -4.5, largest_angle_without_noise = -3.,
                   margin = .12;
  const double angle = statistic(Name::EXACT_3_ANGLES), difference = angle - statistic(Name::POINTS_3_ANGLES);
  if(difference < exactness)
    return true;
  const double bound = statistic(Name::NOISE) < no_noise ? largest_angle_without_noise : largest_angle;
  if(!(angle < bound && difference < margin &&
       statistic(Name::EXACT_3_TURNS) - statistic(Name::POINTS_3_TURNS) < margin))
    return false;
  const double change = statistic(Name::EXACT_3_CHECKED_3);
  return change < no_change || change - statistic(Name::EXACT_3_POINTS_3) < -margin;
}

// Fits of all kinds to a surface and what they tell of each other, each computed when it is first asked for.
template <typename ConcurrencyTag, typename SampledSurface>
class Adaptive_statistics
{
  using Choice = Adaptive_estimator_choice;
  using Name = Adaptive_statistic;
  using Vector = Eigen::Vector3d;

public:
  using Index = std::uint32_t;

  // makes the surface with neighborhoods of so many rings, or as many neighbors
  using Make_surface = std::function<SampledSurface(unsigned int)>;

  // all samples of the surface
  Adaptive_statistics(const Make_surface& make_surface,
                      const std::function<bool(double)>& callback,
                      bool fits_are_shared)
    : m_make_surface(make_surface),
      m_callback(callback),
      m_fits_are_shared(fits_are_shared),
      m_surface(make_surface(2)),
      m_size(m_surface.size())
  {
    collect_neighbors();
  }

  std::size_t size() const { return m_size; }
  // the samples `0, ..., size - 1` alone: what surfaces with other neighborhoods know of as well
  void set_size(std::size_t size) { m_size = (std::min)(m_size, size); }
  const SampledSurface& surface() const { return m_surface; }
  bool is_cancelled() const { return m_is_cancelled; }

  // tells the callback that all is done
  void finish()
  {
    if(m_callback && !m_is_cancelled)
      m_callback(1.);
  }

  // Where a surface bends much, bends count as noise, too. There, over noise, the others are too low for a fit that is to be smooth, and
  // where it is clean, there are fits that don't ask.
  double noise_level()
  {
    if(m_noise_level < 0.)
      m_noise_level = Noise_probes<SampledSurface>(m_surface, true).level(Matern_9_2());
    return m_noise_level;
  }

  // From now on, statistics are asked for of these samples alone, one at least: what has no part in them needn't be computed.
  void restrict_to(std::vector<Index> samples)
  {
    std::vector<unsigned char> has_part(m_size, 0);
    for(const Index i : samples)
      has_part[i] = 1;
    const auto with_neighbors = [&](std::vector<Index> some, const std::size_t nearest)
    {
      for(std::size_t k = 0, end = some.size(); k < end; ++k)
        for(std::size_t l = 0; l < (std::min)(nearest, m_neighbors[some[k]].size()); ++l)
          if(const Index j = m_neighbors[some[k]][l]; j < m_size && !has_part[j])
          {
            has_part[j] = 1;
            some.push_back(j);
          }
      std::sort(some.begin(), some.end());
      return some;
    };
    m_asked_for = std::move(samples);
    m_known = with_neighbors(m_asked_for, s_pool);
    m_fitted = with_neighbors(m_known, s_edges);
  }

  // a part of it, but not less than points without noise have
  double noise_level(double part) { return (std::max)(part * noise_level(), least_noise_level); }

  const Fitted_field& field(Choice choice)
  {
    Fitted_field& field = m_fields[std::size_t(choice)];
    if(field.empty() && m_size > 0)
    {
      switch(choice)
      {
      case Choice::EXACT_2_RINGS:
        field = fit_exact(2);
        break;
      case Choice::EXACT_3_RINGS:
        field = fit_exact(3);
        break;
      case Choice::POINTS_2_RINGS:
        field = fit_inexact(2, 0., default_normal_noise(), 1);
        break;
      case Choice::POINTS_3_RINGS:
        field = fit_inexact(3, 0., default_normal_noise(), 1);
        break;
      case Choice::POINTS_4_RINGS:
        // a basis function without a limit to its smoothness
        field = fit(4, parameters::noise_level(0.).number_of_passes(1u).radial_basis_function(
                           Inverse_multiquadric()));
        break;
      case Choice::NORMALS_2_RINGS:
        field = fit_inexact(2, noise_level(), trusted_normal_noise, 1);
        break;
      case Choice::NORMALS_3_RINGS:
        field = fit_inexact(3, noise_level(), trusted_normal_noise, 1);
        break;
      case Choice::SMOOTHED_3_RINGS:
        // as hrbf_curvatures() does
        field = fit(3, parameters::radial_basis_function(Matern_9_2()));
        break;
      case Choice::SMOOTHED_4_RINGS:
        field = fit_inexact(4, (std::max)(noise_level(), least_smoothed_level), default_normal_noise(),
                            smoothing_passes);
        break;
      case Choice::GENTLY_SMOOTHED_4_RINGS:
        field = fit_inexact(4, noise_level(.1), default_normal_noise(), smoothing_passes);
        break;
      case Choice::BARELY_SMOOTHED_4_RINGS:
        field = fit_inexact(4, noise_level(.01), default_normal_noise(), 1);
        break;
      case Choice::CHECKED_2_RINGS:
        field = fit(2, parameters::normals_are_exact(true));
        break;
      default:
        field = fit(3, parameters::normals_are_exact(true));
      }
    }
    return field;
  }

  const std::vector<double>& statistic(Name name)
  {
    std::vector<double>& statistic = m_statistics[std::size_t(name)];
    if(statistic.empty() && m_size > 0)
      statistic = compute(name);
    return statistic;
  }

private:
  struct Evidence
  {
    Noise_evidence of_surface, of_rough_surface;
    bool is_known = false;
  };

  static constexpr std::size_t s_edges = 8, s_pool = 18; // nearest neighbors
  static constexpr double least_noise_level = 1e-6, least_angle = 1e-12;
  static constexpr double least_move = 1e-4; // of clean points, rounding decides smaller ones
  static constexpr unsigned int smoothing_passes = 3;
  // The scores were learned with 1e-3. Somewhat less suits exact normals of points with much noise better, and still serves those of
  // faces.
  static constexpr double trusted_normal_noise = 8e-4;
  // Level sets of marching cubes look like flat ones without noise where they bend little, and aren't where they bend.
  static constexpr double least_smoothed_level = 2e-3;

  void collect_neighbors()
  {
    m_neighbors.resize(m_size);
    m_sizes.assign(m_size, 0.);
    for_each_sample<ConcurrencyTag, typename SampledSurface::Workspace>(
        m_size,
        [&](const std::size_t i, typename SampledSurface::Workspace& workspace)
        {
          if(!is_estimated(m_surface.status(i)))
            return;
          const auto& neighbors = m_surface.neighbors(i, 5, workspace);
          const std::size_t n = (std::min)(neighbors.size(), s_pool), nearest = (std::min)(n, s_edges);
          m_neighbors[i].assign(neighbors.begin(), neighbors.begin() + std::ptrdiff_t(n));
          double largest = 0., sum = 0.;
          for(std::size_t k = 0; k < nearest; ++k)
            largest = (std::max)(largest,
                                 (m_surface.point(neighbors[k]) - m_surface.point(i)).cwiseAbs().maxCoeff());
          for(std::size_t k = 0; k < nearest; ++k)
            sum += ((m_surface.point(neighbors[k]) - m_surface.point(i)) / largest).squaredNorm();
          m_sizes[i] = nearest > 0 ? largest * std::sqrt(sum / double(nearest)) : 0.;
        });
  }

  static double default_normal_noise()
  {
    return typename Local_hermite_rbf<SampledSurface, Matern_9_2>::Options().normal_noise_level;
  }

  // What follows normals that aren't exact, too: how far it is off tells that, and the scores were learned with it.
  Fitted_field fit_exact(unsigned int rings)
  {
    return fit(rings, parameters::normals_are_exact(true).normal_noise_level(0.).radial_basis_function(
                          Inverse_multiquadric()));
  }

  Fitted_field fit_inexact(unsigned int rings, double noise, double normal_noise, unsigned int passes)
  {
    return fit(rings, parameters::noise_level(noise)
                          .normal_noise_level(normal_noise)
                          .number_of_passes(passes)
                          .radial_basis_function(Matern_9_2()));
  }

  template <typename NamedParameters>
  Fitted_field fit(unsigned int rings, const NamedParameters& np)
  {
    if(m_is_cancelled)
      return Fitted_field(m_size);
    SampledSurface surface = m_make_surface(rings);
    // How many fits there will be isn't known before: each takes a quarter of what is left.
    const double begin = m_progress, length = (1. - m_progress) / 4.;
    std::function<bool(double)> callback;
    if(m_callback)
      callback = [this, begin, length](const double advancement)
      {
        m_is_cancelled = m_is_cancelled || !m_callback(begin + length * advancement);
        return !m_is_cancelled;
      };
    // Which samples a shared fit serves depends on all that are asked for.
    const std::vector<Index> only = m_fits_are_shared ? std::vector<Index>() : m_fitted;
    Fitted_field result(m_size);
    for_each_hermite_rbf_fit<ConcurrencyTag>(
        surface, m_size, only,
        {[&](const std::size_t i, const Local_implicit_surface& local) { result[i] = Fitted_sample(local); }},
        np.fits_are_shared(m_fits_are_shared).callback(callback));
    m_progress = begin + length;
    return result;
  }

  std::vector<double> compute(Name name)
  {
    const auto number = std::size_t(name);
    if(number < number_of_adaptive_candidates)
      return angles(Choice(number));
    if(number < 2 * number_of_adaptive_candidates)
      return turns(Choice(number - number_of_adaptive_candidates));
    switch(name)
    {
    case Name::EXACT_2_EXACT_3:
      return differences(Choice::EXACT_2_RINGS, Choice::EXACT_3_RINGS);
    case Name::POINTS_2_POINTS_3:
      return differences(Choice::POINTS_2_RINGS, Choice::POINTS_3_RINGS);
    case Name::POINTS_3_POINTS_4:
      return differences(Choice::POINTS_3_RINGS, Choice::POINTS_4_RINGS);
    case Name::EXACT_3_POINTS_3:
      return differences(Choice::EXACT_3_RINGS, Choice::POINTS_3_RINGS);
    case Name::EXACT_2_NORMALS_2:
      return differences(Choice::EXACT_2_RINGS, Choice::NORMALS_2_RINGS);
    case Name::NORMALS_2_NORMALS_3:
      return differences(Choice::NORMALS_2_RINGS, Choice::NORMALS_3_RINGS);
    case Name::EXACT_3_NORMALS_3:
      return differences(Choice::EXACT_3_RINGS, Choice::NORMALS_3_RINGS);
    case Name::POINTS_3_NORMALS_3:
      return differences(Choice::POINTS_3_RINGS, Choice::NORMALS_3_RINGS);
    case Name::POINTS_3_SMOOTHED_3:
      return differences(Choice::POINTS_3_RINGS, Choice::SMOOTHED_3_RINGS);
    case Name::POINTS_4_SMOOTHED_4:
      return differences(Choice::POINTS_4_RINGS, Choice::SMOOTHED_4_RINGS);
    case Name::NORMALS_3_SMOOTHED_3:
      return differences(Choice::NORMALS_3_RINGS, Choice::SMOOTHED_3_RINGS);
    case Name::SMOOTHED_3_SMOOTHED_4:
      return differences(Choice::SMOOTHED_3_RINGS, Choice::SMOOTHED_4_RINGS);
    case Name::SMOOTHED_3_GENTLY_4:
      return differences(Choice::SMOOTHED_3_RINGS, Choice::GENTLY_SMOOTHED_4_RINGS);
    case Name::SMOOTHED_4_GENTLY_4:
      return differences(Choice::SMOOTHED_4_RINGS, Choice::GENTLY_SMOOTHED_4_RINGS);
    case Name::GENTLY_4_BARELY_4:
      return differences(Choice::GENTLY_SMOOTHED_4_RINGS, Choice::BARELY_SMOOTHED_4_RINGS);
    case Name::POINTS_4_BARELY_4:
      return differences(Choice::POINTS_4_RINGS, Choice::BARELY_SMOOTHED_4_RINGS);
    case Name::CHECKED_2_CHECKED_3:
      return differences(Choice::CHECKED_2_RINGS, Choice::CHECKED_3_RINGS);
    case Name::CHECKED_3_POINTS_3:
      return differences(Choice::CHECKED_3_RINGS, Choice::POINTS_3_RINGS);
    case Name::CHECKED_2_NORMALS_2:
      return differences(Choice::CHECKED_2_RINGS, Choice::NORMALS_2_RINGS);
    case Name::CHECKED_3_NORMALS_3:
      return differences(Choice::CHECKED_3_RINGS, Choice::NORMALS_3_RINGS);
    case Name::EXACT_3_CHECKED_3:
      return differences(Choice::EXACT_3_RINGS, Choice::CHECKED_3_RINGS);
    case Name::POINTS_3_NORMALS:
      return normals(Choice::POINTS_3_RINGS);
    case Name::SMOOTHED_3_NORMALS:
      return normals(Choice::SMOOTHED_3_RINGS);
    case Name::POINTS_3_BEND:
      return bend(Choice::POINTS_3_RINGS);
    case Name::SMOOTHED_3_BEND:
      return bend(Choice::SMOOTHED_3_RINGS);
    case Name::SMOOTHED_3_MOVES:
      return moves(Choice::SMOOTHED_3_RINGS);
    case Name::SMOOTHED_3_DRIFT:
      return drift(Choice::SMOOTHED_3_RINGS);
    case Name::NOISE:
      return std::vector<double>(m_size, logarithm(noise_level()));
    case Name::NOISE_BESIDE_BENDS:
      return std::vector<double>(m_size,
                                 logarithm(Noise_probes<SampledSurface>(m_surface).level(Matern_9_2())));
    case Name::IRREGULARITY:
      return irregularity();
    default:
      return evidence(number - std::size_t(Name::NORMALS_BY_1E_3));
    }
  }

  static double logarithm(double x, double least = least_noise_level)
  {
    constexpr double largest = 1e3;
    return std::log10((std::min)((std::max)(x, least), largest));
  }

  // the logarithm of the mean over each sample and its neighbors of what is known there, whatever its sign
  std::vector<double> pooled(const std::vector<double>& values, double least = least_noise_level) const
  {
    std::vector<double> result(m_size, logarithm(std::numeric_limits<double>::infinity()));
    for_each_of(m_asked_for,
                [&](const std::size_t i)
                {
                  double sum = 0.;
                  std::size_t number = 0;
                  const auto add = [&](const std::size_t j)
                  {
                    if(j < m_size && std::isfinite(values[j]))
                    {
                      sum += values[j];
                      ++number;
                    }
                  };
                  add(i);
                  for(const Index j : m_neighbors[i])
                    add(j);
                  if(number > 0)
                    result[i] = logarithm(std::abs(sum) / double(number), least);
                });
    return result;
  }

  template <typename Function>
  std::vector<double> of_each(const Function& function) const
  {
    std::vector<double> result(m_size, std::numeric_limits<double>::quiet_NaN());
    for_each_of(m_known,
                [&](const std::size_t i)
                {
                  if(m_sizes[i] > 0.)
                    result[i] = function(i);
                });
    return result;
  }

  // these samples, or all if there are none
  template <typename Function>
  void for_each_of(const std::vector<Index>& samples, const Function& function) const
  {
    for_each_sample<ConcurrencyTag, No_workspace>(samples.empty() ? m_size : samples.size(),
                                                  [&](const std::size_t k, No_workspace&)
                                                  { function(samples.empty() ? k : samples[k]); });
  }

  // root mean square over the edges at each sample of what `function` makes of two fits and the edge
  template <typename Function>
  std::vector<double> over_edges(Choice choice, const Function& function)
  {
    const Fitted_field& fits = field(choice);
    return of_each(
        [&](const std::size_t i)
        {
          double sum = 0.;
          std::size_t number = 0;
          for(std::size_t k = 0; k < (std::min)(s_edges, m_neighbors[i].size()); ++k)
          {
            const std::size_t j = m_neighbors[i][k];
            if(j >= m_size || !is_estimated(fits[i].status) || !is_estimated(fits[j].status))
              continue;
            const Vector d =
                m_surface.point(j) - m_surface.point(i) + fits[j].displacement - fits[i].displacement;
            const double remainder = function(fits[i], fits[j], d) / d.norm();
            if(!std::isfinite(remainder))
              continue;
            sum += remainder * remainder;
            ++number;
          }
          return std::sqrt(sum / double(number));
        });
  }

  std::vector<double> angles(Choice choice)
  {
    return pooled(over_edges(choice,
                             [](const Fitted_sample& p, const Fitted_sample& q, const Vector& d) {
                               return .5 * (p.normal + q.normal).dot(d) +
                                      (d.dot(p.turn(d)) - d.dot(q.turn(d))) / 12.;
                             }),
                  least_angle);
  }

  // times h / h: without units as it is
  std::vector<double> turns(Choice choice)
  {
    return pooled(
        over_edges(choice, [](const Fitted_sample& p, const Fitted_sample& q, const Vector& d)
                   { return (q.normal - p.normal - .5 * (p.turn(d) + q.turn(d))).norm() * d.norm(); }));
  }

  std::vector<double> differences(Choice a, Choice b)
  {
    const Fitted_field &fits_a = field(a), &fits_b = field(b);
    return pooled(of_each([&](const std::size_t i)
                          { return m_sizes[i] * distance_of_shapes(fits_a[i].shape, fits_b[i].shape); }));
  }

  std::vector<double> bend(Choice choice)
  {
    const Fitted_field& fits = field(choice);
    return pooled(of_each([&](const std::size_t i) { return m_sizes[i] * norm_of_shape(fits[i].shape); }));
  }

  std::vector<double> normals(Choice choice)
  {
    const Fitted_field& fits = field(choice);
    return pooled(
        of_each([&](const std::size_t i) { return (fits[i].normal - m_surface.normal(i)).norm(); }));
  }

  std::vector<double> heights(Choice choice)
  {
    const Fitted_field& fits = field(choice);
    return of_each(
        [&](const std::size_t i)
        {
          return is_estimated(fits[i].status) ? fits[i].displacement.dot(fits[i].normal) / m_sizes[i]
                                              : std::numeric_limits<double>::quiet_NaN();
        });
  }

  std::vector<double> moves(Choice choice)
  {
    std::vector<double> of_samples = heights(choice);
    for(double& x : of_samples)
      x = std::abs(x);
    return pooled(of_samples, least_move);
  }

  std::vector<double> drift(Choice choice) { return pooled(heights(choice), least_move); }

  std::vector<double> irregularity() const
  {
    return pooled(
        of_each([&](const std::size_t i)
                { return m_sizes[i] / (m_surface.point(m_neighbors[i][0]) - m_surface.point(i)).norm(); }));
  }

  std::vector<double> evidence(std::size_t statistic)
  {
    if(m_evidence.empty())
      collect_evidence();
    const bool is_rough = statistic >= Noise_evidence::number_of_statistics;
    const std::size_t number = statistic - (is_rough ? Noise_evidence::number_of_statistics : 0);
    std::vector<double> result(m_size, 0.);
    for_each_of(m_asked_for,
                [&](const std::size_t i)
                {
                  const Evidence& evidence = m_evidence[i];
                  result[i] = (is_rough ? evidence.of_rough_surface : evidence.of_surface).statistic(number);
                });
    return result;
  }

  void collect_evidence()
  {
    m_evidence.resize(m_size);
    if(m_is_cancelled)
      return;
    std::vector<Evidence> of_samples(m_size);
    constexpr std::size_t block = 32;
    std::vector<Index> samples = m_known;
    if(samples.empty())
    {
      samples.resize(m_size);
      std::iota(samples.begin(), samples.end(), Index(0));
    }
    for_each_sample<ConcurrencyTag, No_workspace>(
        (samples.size() + block - 1) / block,
        [&](const std::size_t k, No_workspace&)
        {
          const auto begin = samples.begin() + std::ptrdiff_t(k * block),
                     end = samples.begin() + std::ptrdiff_t((std::min)((k + 1) * block, samples.size()));
          collect_evidence(std::vector<Index>(begin, end), of_samples);
        });
    for_each_of(m_asked_for,
                [&](const std::size_t i)
                {
                  double number = 0.;
                  const auto add = [&](const std::size_t j)
                  {
                    if(j < m_size && of_samples[j].is_known)
                    {
                      m_evidence[i].of_surface += of_samples[j].of_surface;
                      m_evidence[i].of_rough_surface += of_samples[j].of_rough_surface;
                      ++number;
                    }
                  };
                  add(i);
                  for(const Index j : m_neighbors[i])
                    add(j);
                  if(number > 0.)
                  {
                    m_evidence[i].of_surface /= number;
                    m_evidence[i].of_rough_surface /= number;
                  }
                });
  }

  void collect_evidence(const std::vector<Index>& samples, std::vector<Evidence>& result) const
  {
    using Fit = Batched_hermite_rbf<SampledSurface, Matern_9_2>;
    static const std::vector<double> levels(Noise_evidence::point_levels.begin(),
                                            Noise_evidence::point_levels.end());
    for(std::size_t normals = 0; normals < Noise_evidence::normal_levels.size(); ++normals)
    {
      typename Fit::Options options;
      options.normal_noise_level = Noise_evidence::normal_levels[normals];
      const Fit fit(m_surface, Matern_9_2(), options);
      const std::vector<double> usual = fit.log_likelihoods(samples, levels, s_pool, {1.}),
                                rough = fit.log_likelihoods(samples, levels, s_pool, {2., 4.});
      for(std::size_t k = 0; k < samples.size(); ++k)
        for(std::size_t points = 0; points < levels.size(); ++points)
        {
          const std::array<double, 2> both = {usual[k * levels.size() + points],
                                              rough[k * levels.size() + points]};
          result[samples[k]].of_surface(normals, points) = both[0];
          result[samples[k]].of_rough_surface(normals, points) = log_of_sum(both.begin(), both.end());
        }
    }
    for(const Index i : samples)
      result[i].is_known = result[i].of_surface.normalize() && result[i].of_rough_surface.normalize();
  }

  Make_surface m_make_surface;
  std::function<bool(double)> m_callback;
  bool m_fits_are_shared;
  bool m_is_cancelled = false;
  double m_progress = 0.;
  SampledSurface m_surface;
  std::size_t m_size;
  std::vector<std::vector<Index> > m_neighbors; // the nearest ones of two rings
  std::vector<double> m_sizes;                  // root mean square distance of the nearest ones of them
  double m_noise_level = -1.;                   // negative: not known yet
  std::vector<Evidence> m_evidence;             // means over the nearest ones
  std::vector<Index> m_asked_for;               // samples of which statistics are asked for (empty: all),
  std::vector<Index> m_known;                   // those that they are means of,
  std::vector<Index> m_fitted;                  // and those of which it takes fits
  std::array<Fitted_field, number_of_adaptive_candidates> m_fields;
  std::array<std::vector<double>, number_of_adaptive_statistics> m_statistics;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ADAPTIVE_STATISTICS_H
