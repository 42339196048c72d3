#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_FIT_HERMITE_RBF_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_FIT_HERMITE_RBF_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/internal/Scaled_neighborhood.h>
#include <Shape_characteristics/internal/callback_of.h>
#include <Shape_characteristics/internal/passes.h>
#include <Shape_characteristics/internal/whole_number.h>
#include <Shape_characteristics/interpolation/Inverse_multiquadric.h>
#include <Shape_characteristics/interpolation/Local_hermite_rbf.h>
#include <Shape_characteristics/interpolation/Matern_9_2.h>
#include <Shape_characteristics/interpolation/internal/Batched_hermite_rbf.h>
#include <Shape_characteristics/interpolation/internal/Hermite_fit_output.h>
#include <Shape_characteristics/interpolation/internal/Hermite_fit_rules.h>
#include <Shape_characteristics/interpolation/internal/Noise_probes.h>
#include <Shape_characteristics/interpolation/internal/Polynomial_part.h>
#include <Shape_characteristics/interpolation/internal/Sample_patches.h>
#include <Shape_characteristics/interpolation/internal/Smoothing_trial.h>
#include <Shape_characteristics/interpolation/internal/for_each_patch.h>
#include <Shape_characteristics/sampling/for_each_sample.h>
#include <Shape_characteristics/sampling/poisson_disc_pattern.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

inline constexpr std::int64_t passes_over_noise = 3; // by default

// How often one goes from neighbors to neighbors to know all that has a part in the fit at a vertex: once for each pass.
// With inexact normals, as often as over noise; the neighborhoods that tell of it are within that reach.
template <typename NamedParameters>
unsigned int reach_of_hermite_rbf(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  if(choose_parameter(get_parameter(np, internal_np::normals_are_exact), false))
    return 1;
  const std::int64_t passes =
      whole_number(np, internal_np::number_of_passes, std::int64_t(0), "number_of_passes");
  return static_cast<unsigned int>((std::max)(passes_over_noise, passes));
}

// Fits of the samples `0, ..., size - 1` of `surface`, whose others only lend a hand, or of those of them that are in `only`, if it
// isn't empty. `output` is called with each of them, by several threads at a time, but not with those before which the callback
// stopped.
template <typename ConcurrencyTag>
class Hermite_rbf_fitter
{
public:
  using Index = Sample_patches::Index;
  using Output = Hermite_fit_output;

  template <typename NamedParameters>
  explicit Hermite_rbf_fitter(const NamedParameters& np)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    m_normals_are_exact = choose_parameter(get_parameter(np, internal_np::normals_are_exact), false);
    m_box = choose_parameter(get_parameter(np, internal_np::shape_parameter_box),
                             Shape_parameter_box::AXIS_ALIGNED);
    m_noise_level = choose_parameter(get_parameter(np, internal_np::noise_level), -1.);
    m_normal_noise_level = choose_parameter(get_parameter(np, internal_np::normal_noise_level),
                                            Noisy_fit_attempts::default_normal_noise_level);
    if(!(m_normal_noise_level >= 0. && std::isfinite(m_normal_noise_level)))
      throw std::invalid_argument(
          "Shape_characteristics: normal_noise_level must be finite and not negative");
    const std::int64_t passes =
        whole_number(np, internal_np::number_of_passes, std::int64_t(0), "number_of_passes");
    constexpr bool passes_are_given =
        !parameters::is_default_parameter<NamedParameters, internal_np::number_of_passes_t>::value;
    if(passes_are_given)
      check_number_of_passes(passes);
    m_passes = static_cast<std::size_t>(passes);
    const std::int64_t degree =
        whole_number(np, internal_np::polynomial_degree, std::int64_t(-1), "polynomial_degree");
    if(degree < -1 || degree > Polynomial_part::largest_degree)
      throw std::invalid_argument("Shape_characteristics: polynomial_degree must be between -1 and 8");
    m_polynomial_degree = static_cast<int>(degree);
    m_sampling_distance = choose_parameter(get_parameter(np, internal_np::sampling_distance), 0.3);
    m_seed = whole_number(np, internal_np::random_seed, std::uint64_t(4), "random_seed");
    m_callback = callback_of(np);
    m_fits_are_shared = choose_parameter(get_parameter(np, internal_np::fits_are_shared), true);

    constexpr bool level_is_given =
        !parameters::is_default_parameter<NamedParameters, internal_np::noise_level_t>::value;
    if(level_is_given && !(m_noise_level >= 0. && std::isfinite(m_noise_level)))
      throw std::invalid_argument("Shape_characteristics: noise_level must be finite and not negative");
    check_sampling_distance(m_sampling_distance); // whether the pattern is needed or not
  }

  // Not inline: a program may instantiate it in one source file for all.
  template <typename SampledSurface, typename RadialBasisFunction>
  void operator()(SampledSurface& surface,
                  const RadialBasisFunction& phi,
                  std::size_t size,
                  const std::vector<Index>& only,
                  const Output& output) const;

private:
  template <typename SampledSurface, typename RadialBasisFunction>
  void fit_indefinite(const SampledSurface& surface,
                      const RadialBasisFunction& phi,
                      std::size_t size,
                      const std::vector<Index>& only,
                      const Output& output) const
  {
    using Fit = Local_hermite_rbf<SampledSurface, RadialBasisFunction>;
    typename Fit::Options options;
    options.normals_are_exact = m_normals_are_exact;
    options.box = m_box;
    options.polynomial_degree = m_polynomial_degree;
    if(!m_normals_are_exact)
    {
      options.pattern = poisson_disc_pattern(m_sampling_distance, m_seed);
      options.pattern_radius = surface.mean_spacing();
    }
    const Fit fit(surface, phi, options);
    Shape_characteristics::for_each_sample<ConcurrencyTag, typename Fit::Workspace>(
        only.empty() ? size : only.size(),
        [&](const std::size_t k, typename Fit::Workspace& workspace)
        {
          const std::size_t i = only.empty() ? k : only[k];
          output.surface(i, fit(i, workspace));
        },
        pass_callback(0, 1));
  }

  template <typename SampledSurface, typename RadialBasisFunction>
  void fit_positive_definite(SampledSurface& surface,
                             const RadialBasisFunction& phi,
                             std::size_t size,
                             const std::vector<Index>& only,
                             const Output& output) const
  {
    using Fit = Batched_hermite_rbf<SampledSurface, RadialBasisFunction>;
    typename Fit::Options options;
    options.normals_are_exact = m_normals_are_exact;
    options.exactness_is_checked = m_normal_noise_level > 0.;
    options.fits_are_shared = m_fits_are_shared && size == surface.size() && only.empty();
    // Fits to exact normals take little time and reach far: there are enough of them in half as many patches.
    const std::size_t patch_size =
        m_normals_are_exact ? Sample_patches::patch_size_for(size, 4) : Sample_patches::patch_size_for(size);
    Sample_patches patches = options.fits_are_shared ? Sample_patches::compact(surface, patch_size)
                             : only.empty()          ? Sample_patches(size, patch_size)
                                                     : Sample_patches(only, surface.size(), patch_size);
    std::size_t passes = 1;
    if(!m_normals_are_exact)
    {
      const bool level_is_given = m_noise_level >= 0.;
      options.noise_level = level_is_given ? m_noise_level : Noise_probes<SampledSurface>(surface).level(phi);
      options.normal_noise_level = m_normal_noise_level;
      const bool is_noisy = !(options.noise_level < Noisy_fit_attempts::negligible);
      passes = m_passes > 0 ? m_passes : is_noisy ? std::size_t(passes_over_noise) : 1;
      if(!level_is_given && is_noisy && passes > 1)
        options.noise_level *=
            Smoothing_trial<ConcurrencyTag, SampledSurface, RadialBasisFunction>(surface, size, phi, options)
                .part();
    }
    for(std::size_t pass = 0; pass + 1 < passes; ++pass)
    {
      const Fit fit(surface, phi, options);
      const bool goes_on =
          only.empty() && size == surface.size()
              ? denoise(surface, fit, patches, pass, passes)
              : denoise(surface, fit, *patches_around(surface, size, only, passes - 1 - pass), pass, passes);
      if(!goes_on)
        return;
    }
    for_each_patch<ConcurrencyTag>(Fit(surface, phi, options), surface.size(), patches, output,
                                   pass_callback(passes - 1, passes));
  }

  // The samples whose places have a part in the last pass, if so many are to follow: where a single sample is asked for, all.
  template <typename SampledSurface>
  static std::unique_ptr<Sample_patches> patches_around(const SampledSurface& surface,
                                                        std::size_t size,
                                                        const std::vector<Index>& only,
                                                        std::size_t passes)
  {
    const std::size_t patch_size = Sample_patches::patch_size_for(surface.size());
    if(only.empty() || size < surface.size())
      return std::make_unique<Sample_patches>(surface.size(), patch_size);
    std::vector<unsigned char> has_part(surface.size(), 0);
    std::vector<Index> samples = only;
    for(const Index i : samples)
      has_part[i] = 1;
    typename SampledSurface::Workspace workspace;
    for(std::size_t begin = 0; passes > 0; --passes)
      for(const std::size_t end = samples.size(); begin != end; ++begin)
        for(const Index j :
            surface.neighbors(samples[begin], seen_neighborhood(surface, samples[begin]), workspace))
          if(!has_part[j])
          {
            has_part[j] = 1;
            samples.push_back(j);
          }
    return std::make_unique<Sample_patches>(samples, surface.size(), patch_size);
  }

  // moves the samples, and turns their normals, to the fitted surfaces
  template <typename SampledSurface, typename Fit>
  bool denoise(SampledSurface& surface,
               const Fit& fit,
               Sample_patches& patches,
               std::size_t pass,
               std::size_t passes) const
  {
    std::vector<Eigen::Vector3d> points(surface.size()), normals(surface.size());
    for(std::size_t i = 0; i < surface.size(); ++i)
    {
      points[i] = surface.point(i);
      normals[i] = surface.normal(i);
    }
    const auto move = [&](const std::size_t i, const Local_implicit_surface& local)
    {
      if(!is_estimated(local.status))
        return;
      points[i] += local.displacement;
      normals[i] = local.gradient.normalized();
    };
    if(!for_each_patch<ConcurrencyTag>(fit, surface.size(), patches, {move}, pass_callback(pass, passes)))
      return false;
    for(std::size_t i = 0; i < surface.size(); ++i)
      surface.set_point(i, points[i]);
    surface.set_normals(std::move(normals));
    return true;
  }

  std::function<bool(double)> pass_callback(std::size_t pass, std::size_t passes) const
  {
    if(!m_callback)
      return {};
    return Callback_of_pass(m_callback, pass, passes);
  }

  bool m_normals_are_exact;
  Shape_parameter_box m_box;
  double m_noise_level; // negative: to be estimated
  double m_normal_noise_level;
  std::size_t m_passes; // 0: to be chosen
  bool m_fits_are_shared;
  int m_polynomial_degree; // -1: no polynomial
  double m_sampling_distance;
  std::uint64_t m_seed;
  std::function<bool(double)> m_callback;
};

template <typename ConcurrencyTag>
template <typename SampledSurface, typename RadialBasisFunction>
void Hermite_rbf_fitter<ConcurrencyTag>::operator()(SampledSurface& surface,
                                                    const RadialBasisFunction& phi,
                                                    std::size_t size,
                                                    const std::vector<Index>& only,
                                                    const Output& output) const
{
  if constexpr(RadialBasisFunction::is_positive_definite)
    fit_positive_definite(surface, phi, size, only, output);
  else
    fit_indefinite(surface, phi, size, only, output);
}

// the same with the basis function that the named parameters say
template <typename ConcurrencyTag, typename SampledSurface, typename NamedParameters>
void for_each_hermite_rbf_fit(SampledSurface& surface,
                              std::size_t size,
                              const std::vector<Sample_patches::Index>& only,
                              const typename Hermite_rbf_fitter<ConcurrencyTag>::Output& output,
                              const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  const Hermite_rbf_fitter<ConcurrencyTag> fitter(np);
  if constexpr(!is_default_parameter<NamedParameters, internal_np::radial_basis_function_t>::value)
    fitter(surface, get_parameter(np, internal_np::radial_basis_function), size, only, output);
  else if(choose_parameter(get_parameter(np, internal_np::normals_are_exact), false))
    fitter(surface, Inverse_multiquadric(), size, only, output);
  else
    fitter(surface, Matern_9_2(), size, only, output);
}

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

  \throws std::invalid_argument if there are fewer than `size` samples, or a parameter is out of its range
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
  if(size > surface.size())
    throw std::invalid_argument(
        "Shape_characteristics: fit_hermite_rbf() is asked for more samples than the surface has");
  std::vector<Result> results(size);
  internal::for_each_hermite_rbf_fit<ConcurrencyTag>(
      surface, size, {},
      {[&](const std::size_t i, const Local_implicit_surface& local) { results[i] = transform(i, local); }},
      np);
  return results;
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_FIT_HERMITE_RBF_H
