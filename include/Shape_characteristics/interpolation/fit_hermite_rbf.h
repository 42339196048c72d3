#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_FIT_HERMITE_RBF_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_FIT_HERMITE_RBF_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/internal/lexicographically_smaller.h>
#include <Shape_characteristics/interpolation/Inverse_multiquadric.h>
#include <Shape_characteristics/interpolation/Local_hermite_rbf.h>
#include <Shape_characteristics/interpolation/Matern_9_2.h>
#include <Shape_characteristics/sampling/for_each_sample.h>
#include <Shape_characteristics/sampling/poisson_disc_pattern.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// How often one goes from neighbors to neighbors to know all that has a part in the fit at a vertex. With inexact normals
// these are two passes, and the neighborhoods from which the noise is estimated.
template <typename NamedParameters>
unsigned int reach_of_hermite_rbf(const NamedParameters& np)
{
  const bool normals_are_exact =
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::normals_are_exact), false);
  return normals_are_exact ? 1 : 3;
}

/*
  The standard deviation of the points, in units of the neighborhoods' sizes: of those on a grid, the one under which
  the data of some neighborhoods together are likeliest. Each neighborhood alone knows too little to choose.
*/
template <typename SampledSurface, typename RadialBasisFunction>
double estimate_noise_level(const SampledSurface& surface,
                            const Local_hermite_rbf<SampledSurface, RadialBasisFunction>& fit)
{
  constexpr std::size_t number_of_probes = 50;
  constexpr int first_exponent = -12, last_exponent = -1; // of the variance

  using Fit = Local_hermite_rbf<SampledSurface, RadialBasisFunction>;
  typename Fit::Workspace workspace;
  constexpr std::size_t levels = last_exponent - first_exponent + 1;
  std::array<double, levels> likelihood{}, of_probe{};
  std::array<std::size_t, levels> failures{};
  std::size_t used = 0;
  // The probes are spread evenly over the surface's own order: that of the input, and samples that can't be used, don't
  // matter.
  std::vector<std::size_t> samples;
  for(std::size_t i = 0; i < surface.size(); ++i)
    if(is_estimated(surface.status(i)))
      samples.push_back(i);
  std::sort(samples.begin(), samples.end(),
            [&](const std::size_t i, const std::size_t j)
            {
              if(surface.point(i) != surface.point(j))
                return lexicographically_smaller(surface.point(i), surface.point(j));
              return lexicographically_smaller(surface.normal(i), surface.normal(j));
            });
  const std::size_t probes = (std::min)(number_of_probes, samples.size());
  const auto level = [](const std::size_t e) { return std::pow(10., (first_exponent + int(e)) / 2.); };
  for(std::size_t k = 0; k < probes; ++k)
  {
    const std::size_t i = samples[(2 * k + 1) * samples.size() / (2 * probes)];
    for(std::size_t e = levels; e-- > 0;)
    {
      of_probe[e] = fit.log_likelihood(i, level(e), workspace);
      if(std::isfinite(of_probe[e]))
        likelihood[e] += of_probe[e];
      else if(e + 1 == levels) // there is no surface at all
        break;
      else
      {
        ++failures[e];
        of_probe[e] = of_probe[e + 1];
        likelihood[e] += of_probe[e];
      }
      used += e == 0;
    }
  }
  // The lowest level that isn't clearly worse than the best one: noise is assumed on strong evidence alone, for a
  // surface that bends much between its samples looks a little noisy as well.
  constexpr double evidence = 1.5; // per probe
  const double threshold = *std::max_element(likelihood.begin(), likelihood.end()) - evidence * double(used);
  std::size_t best = 0;
  while(best + 1 < levels && (10 * failures[best] > used || likelihood[best] < threshold))
    ++best;
  return level(best);
}

// Progress of several passes as progress of one.
class Callback_of_pass
{
public:
  Callback_of_pass(const std::function<bool(double)>& callback,
                   std::size_t pass,
                   std::size_t number_of_passes)
    : m_callback(callback),
      m_begin(double(pass) / double(number_of_passes)),
      m_length(1. / double(number_of_passes))
  {}

  bool operator()(double advancement) const { return m_callback(m_begin + m_length * advancement); }

private:
  const std::function<bool(double)>& m_callback;
  double m_begin, m_length;
};

// Fits of the samples `0, ..., size - 1` of `surface`, whose others only lend a hand. `transform` makes results of
// surfaces; a default constructed result stays where the callback stopped before the sample.
template <typename ConcurrencyTag, typename Result>
class Hermite_rbf_fitter
{
public:
  template <typename NamedParameters>
  explicit Hermite_rbf_fitter(const NamedParameters& np)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    m_normals_are_exact = choose_parameter(get_parameter(np, internal_np::normals_are_exact), false);
    m_box = choose_parameter(get_parameter(np, internal_np::shape_parameter_box),
                             Shape_parameter_box::AXIS_ALIGNED);
    m_noise_level = choose_parameter(get_parameter(np, internal_np::noise_level), -1.);
    const long long passes =
        static_cast<long long>(choose_parameter(get_parameter(np, internal_np::number_of_passes), 0));
    constexpr bool passes_are_given =
        !parameters::is_default_parameter<NamedParameters, internal_np::number_of_passes_t>::value;
    if(passes_are_given && (passes < 1 || passes > 1000))
      throw std::invalid_argument("Shape_characteristics: number_of_passes must be between 1 and 1000");
    m_passes = static_cast<std::size_t>(passes);
    const double distance = choose_parameter(get_parameter(np, internal_np::sampling_distance), 0.3);
    const std::uint64_t seed = choose_parameter(get_parameter(np, internal_np::random_seed), 4u);
    m_callback = choose_parameter(get_parameter(np, internal_np::callback), std::function<bool(double)>());

    constexpr bool level_is_given =
        !parameters::is_default_parameter<NamedParameters, internal_np::noise_level_t>::value;
    if(level_is_given && !(m_noise_level >= 0. && std::isfinite(m_noise_level)))
      throw std::invalid_argument("Shape_characteristics: noise_level must be finite and not negative");
    m_pattern = poisson_disc_pattern(distance, seed);
  }

  template <typename SampledSurface, typename RadialBasisFunction, typename Transform>
  std::vector<Result> operator()(SampledSurface& surface,
                                 const RadialBasisFunction& phi,
                                 std::size_t size,
                                 const Transform& transform) const
  {
    using Fit = Local_hermite_rbf<SampledSurface, RadialBasisFunction>;
    typename Fit::Options options;
    options.normals_are_exact = m_normals_are_exact;
    options.box = m_box;
    if constexpr(RadialBasisFunction::is_positive_definite)
    {
      if(!m_normals_are_exact)
      {
        options.noise_level =
            m_noise_level >= 0. ? m_noise_level : estimate_noise_level(surface, Fit(surface, phi, options));
        const std::size_t passes = m_passes > 0 ? m_passes : options.noise_level < 1e-4 ? 1 : 2;
        for(std::size_t pass = 0; pass + 1 < passes; ++pass)
          if(!denoise(surface, Fit(surface, phi, options), pass, passes))
            return std::vector<Result>(size);
        return last_pass(Fit(surface, phi, options), size, transform, passes);
      }
    }
    else if(!m_normals_are_exact)
    {
      options.pattern = m_pattern;
      options.pattern_radius = surface.mean_spacing();
    }
    return last_pass(Fit(surface, phi, options), size, transform, 1);
  }

private:
  // moves the samples, and turns their normals, to the fitted surfaces
  template <typename SampledSurface, typename Fit>
  bool denoise(SampledSurface& surface, const Fit& fit, std::size_t pass, std::size_t passes) const
  {
    std::vector<Eigen::Vector3d> points(surface.size()), normals(surface.size());
    const auto move = [&](const std::size_t i, typename Fit::Workspace& workspace)
    {
      const Local_implicit_surface local = fit(i, workspace);
      const bool moves = is_estimated(local.status);
      points[i] = surface.point(i);
      if(moves)
        points[i] += local.displacement;
      normals[i] = moves ? local.gradient.normalized() : surface.normal(i);
    };
    if(!for_each_sample<ConcurrencyTag, typename Fit::Workspace>(surface.size(), move,
                                                                 callback_of(pass, passes)))
      return false;
    for(std::size_t i = 0; i < surface.size(); ++i)
      surface.set_point(i, points[i]);
    surface.set_normals(std::move(normals));
    return true;
  }

  template <typename Fit, typename Transform>
  std::vector<Result>
  last_pass(const Fit& fit, std::size_t size, const Transform& transform, std::size_t passes) const
  {
    std::vector<Result> results(size);
    for_each_sample<ConcurrencyTag, typename Fit::Workspace>(
        size,
        [&](const std::size_t i, typename Fit::Workspace& workspace)
        { results[i] = transform(i, fit(i, workspace)); },
        callback_of(passes - 1, passes));
    return results;
  }

  std::function<bool(double)> callback_of(std::size_t pass, std::size_t passes) const
  {
    if(!m_callback)
      return {};
    return Callback_of_pass(m_callback, pass, passes);
  }

  bool m_normals_are_exact;
  Shape_parameter_box m_box;
  double m_noise_level; // negative: to be estimated
  std::size_t m_passes; // 0: to be chosen
  std::vector<Eigen::Vector2d> m_pattern;
  std::function<bool(double)> m_callback;
};

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsInterpolation

  fits Hermite radial basis functions to the neighborhoods of the first `size` samples of a surface, as named parameters
  say, and returns for each what `transform` makes of the fit. `hrbf_curvatures()` and `hrbf_normals()` are made
  of it, and document the parameters.

  \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or `CGAL::Parallel_if_available_tag`
  \tparam Result the type of the results. Where the callback stops the computation, it is default constructed.
  \tparam SampledSurface a model of `SampledSurface`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"
  \tparam Transform a function object with `Result operator()(std::size_t, const Local_implicit_surface&) const`

  \param surface the surface. Where several passes are made, its points and normals are smoothed.
  \param size the number of samples to answer for; the others only are neighbors
  \param transform what to make of each fit
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters"
*/
template <typename ConcurrencyTag,
          typename Result,
          typename SampledSurface,
          typename Transform,
          typename NamedParameters>
std::vector<Result> fit_hermite_rbf(SampledSurface& surface,
                                    std::size_t size,
                                    const Transform& transform,
                                    const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  const internal::Hermite_rbf_fitter<ConcurrencyTag, Result> fitter(np);
  if constexpr(!is_default_parameter<NamedParameters, internal_np::radial_basis_function_t>::value)
  {
    const auto phi = get_parameter(np, internal_np::radial_basis_function);
    return fitter(surface, phi, size, transform);
  }
  else
  {
    const bool normals_are_exact = choose_parameter(get_parameter(np, internal_np::normals_are_exact), false);
    return normals_are_exact ? fitter(surface, Inverse_multiquadric(), size, transform)
                             : fitter(surface, Matern_9_2(), size, transform);
  }
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_FIT_HERMITE_RBF_H
