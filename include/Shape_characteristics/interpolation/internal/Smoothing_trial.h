#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_SMOOTHING_TRIAL_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_SMOOTHING_TRIAL_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/internal/Scaled_neighborhood.h>
#include <Shape_characteristics/internal/median.h>
#include <Shape_characteristics/interpolation/Local_hermite_rbf.h>
#include <Shape_characteristics/interpolation/internal/Batched_hermite_rbf.h>
#include <Shape_characteristics/interpolation/internal/Hermite_fit_rules.h>
#include <Shape_characteristics/interpolation/internal/Noise_probes.h>
#include <Shape_characteristics/interpolation/internal/Sample_patches.h>
#include <Shape_characteristics/interpolation/internal/for_each_patch.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

/*
  Two passes over some parts of a surface, to learn how much of the noise each of several passes should expect.

  Passes that each expect all of it may smooth away the bends of the surface as well. The displacements of the second pass
  tell: where the first one left noise, they are waves of about the length between samples, so that those of samples a
  little apart have opposite signs; where it flattened bends, those around a sample have one sign. So the level is lowered
  until the correlation of the displacements is that of noise, or else to where it is least.
*/
template <typename ConcurrencyTag, typename SampledSurface, typename RadialBasisFunction>
class Smoothing_trial
{
  using Fit = Batched_hermite_rbf<SampledSurface, RadialBasisFunction>;
  using Index = std::uint32_t;

public:
  using Options = typename Fit::Options;

  // The points and normals of the surface are moved by `part()`, and back. Of its samples, the first `size` count.
  Smoothing_trial(SampledSurface& surface,
                  std::size_t size,
                  const RadialBasisFunction& phi,
                  const Options& options)
    : m_surface(surface),
      m_phi(phi),
      m_options(options)
  {
    std::vector<Index> centers((std::min)(size, s_clusters));
    if(size < surface.size())
      std::iota(centers.begin(), centers.end(), Index(0));
    else
      centers = probes_of(surface, s_clusters);
    collect_samples(centers);
    collect_pairs();
  }

  // what part of the noise level of the options to expect: between a tenth and all
  double part() const
  {
    constexpr std::array<double, 3> exponents = {0., -0.5, -1.};
    std::array<double, 3> correlations;
    for(std::size_t k = 0; k < exponents.size(); ++k)
    {
      correlations[k] = correlation(std::pow(10., exponents[k]));
      if(!(correlations[k] < s_of_noise))
        continue;
      if(k == 0)
        return 1.;
      const double t = (correlations[k] - s_of_noise) / (correlations[k] - correlations[k - 1]);
      const double exponent = exponents[k] + t * (exponents[k - 1] - exponents[k]);
      return std::pow(10., std::round(s_steps * exponent) / s_steps); // whatever the rounding of sums
    }
    const auto least = std::min_element(correlations.begin(), correlations.end());
    return std::pow(10., exponents[std::size_t(least - correlations.begin())]);
  }

private:
  // clusters of samples, and with them those that have a part in their fits
  void collect_samples(const std::vector<Index>& centers)
  {
    std::vector<unsigned char> is_inner(m_surface.size(), 0), is_outer(m_surface.size(), 0);
    typename SampledSurface::Workspace workspace;
    for(const Index center : centers)
    {
      if(!is_estimated(m_surface.status(center)))
        continue;
      const std::size_t begin = m_inner.size();
      const auto add = [&](const Index i)
      {
        if(is_inner[i] || m_inner.size() - begin == s_cluster_size)
          return;
        is_inner[i] = 1;
        m_inner.push_back(i);
      };
      add(center);
      for(std::size_t k = begin; k < m_inner.size() && m_inner.size() - begin < s_cluster_size; ++k)
        for(const Index j : m_surface.neighbors(m_inner[k], 0, workspace))
          add(j);
      const auto add_outer = [&](const Index i)
      {
        if(!is_outer[i])
          m_outer.push_back(i);
        is_outer[i] = 1;
      };
      for(std::size_t k = begin; k < m_inner.size(); ++k)
        add_outer(m_inner[k]);
      for(std::size_t k = begin; k < m_inner.size(); ++k)
        for(const Index j :
            m_surface.neighbors(m_inner[k], seen_neighborhood(m_surface, m_inner[k]), workspace))
          add_outer(j);
    }
  }

  void collect_pairs()
  {
    std::vector<Index> place(m_surface.size(), Index(m_inner.size()));
    for(std::size_t k = 0; k < m_inner.size(); ++k)
      place[m_inner[k]] = Index(k);
    typename SampledSurface::Workspace workspace;
    Scaled_neighborhood neighborhood;
    m_inverse_units.reserve(m_inner.size());
    m_apart_begin.push_back(0);
    for(const Index i : m_inner)
    {
      const bool is_usable =
          is_estimated(neighborhood.collect(m_surface, i, workspace, s_apart_end, s_apart_end));
      if(is_usable)
        for(std::size_t k = s_apart_begin; k < neighborhood.samples.size(); ++k)
          if(const Index j = place[neighborhood.samples[k]]; j < m_inner.size())
            m_apart.push_back(j);
      m_apart_begin.push_back(m_apart.size());
      m_inverse_units.push_back(is_usable ? 1. / (neighborhood.scale * neighborhood.nearest_size) : 0.);
    }
  }

  // of the displacements of the second of two passes, between samples that are a little apart
  double correlation(double part) const
  {
    const std::vector<double> heights = heights_of_second_pass(part);
    double products = 0., squares = 0.;
    for(std::size_t k = 0; k < m_inner.size(); ++k)
    {
      const std::size_t begin = m_apart_begin[k], end = m_apart_begin[k + 1];
      if(begin == end)
        continue;
      double sum = 0.;
      for(std::size_t l = begin; l < end; ++l)
        sum += heights[m_apart[l]];
      products += heights[k] * sum / double(end - begin);
      squares += heights[k] * heights[k];
    }
    return squares > 0. ? products / squares : -1.; // without displacements nothing is flattened
  }

  // how far the inner samples move along their normals after all have moved once, in units of the distances there
  std::vector<double> heights_of_second_pass(double part) const
  {
    Options options = m_options;
    options.noise_level = part * m_options.noise_level;
    const Fit fit(m_surface, m_phi, options);

    std::vector<Eigen::Vector3d> points(m_surface.size()), normals(m_surface.size());
    for(std::size_t i = 0; i < m_surface.size(); ++i)
    {
      points[i] = m_surface.point(i);
      normals[i] = m_surface.normal(i);
    }
    std::vector<Eigen::Vector3d> old_normals = normals;
    for_each_of(m_outer, fit,
                [&](const std::size_t i, const Local_implicit_surface& local)
                {
                  if(!is_estimated(local.status))
                    return;
                  points[i] += local.displacement;
                  normals[i] = local.gradient.normalized();
                });
    const auto exchange_points = [&]
    {
      for(const Index i : m_outer)
      {
        const Eigen::Vector3d old = m_surface.point(i);
        m_surface.set_point(i, points[i]);
        points[i] = old;
      }
    };
    exchange_points();
    m_surface.set_normals(std::move(normals));

    std::vector<double> heights_of_all(m_surface.size(), 0.);
    for_each_of(m_inner, fit,
                [&](const std::size_t i, const Local_implicit_surface& local)
                {
                  if(is_estimated(local.status))
                    heights_of_all[i] = local.displacement.dot(local.gradient.normalized());
                });
    exchange_points();
    m_surface.set_normals(std::move(old_normals));

    std::vector<double> heights;
    heights.reserve(m_inner.size());
    for(std::size_t k = 0; k < m_inner.size(); ++k)
      heights.push_back(m_inverse_units[k] * heights_of_all[m_inner[k]]);
    limit_outliers(heights);
    return heights;
  }

  // A few samples, at creases for example, would else outweigh all others.
  static void limit_outliers(std::vector<double>& heights)
  {
    if(heights.empty())
      return;
    std::vector<double> sizes;
    sizes.reserve(heights.size());
    for(const double height : heights)
      sizes.push_back(std::abs(height));
    const double limit = s_limit * median(sizes);
    for(double& height : heights)
      height = (std::min)((std::max)(height, -limit), limit);
  }

  void for_each_of(const std::vector<Index>& samples,
                   const Fit& fit,
                   const std::function<void(std::size_t, const Local_implicit_surface&)>& output) const
  {
    Sample_patches patches(samples, m_surface.size(), Sample_patches::patch_size_for(samples.size()));
    for_each_patch<ConcurrencyTag>(fit, m_surface.size(), patches, {output});
  }

  static constexpr std::size_t s_clusters = 32, s_cluster_size = 128;
  static constexpr std::size_t s_apart_begin = 7, s_apart_end = 18; // about the second ring of a regular mesh
  static constexpr double s_of_noise = -0.03;                       // correlation
  static constexpr double s_limit = 4.;  // of displacements, in units of their median
  static constexpr double s_steps = 64.; // of the part, for each factor of ten

  SampledSurface& m_surface;
  const RadialBasisFunction& m_phi;
  Options m_options;
  std::vector<Index> m_inner;             // samples of which displacements are looked at
  std::vector<Index> m_outer;             // those and what has a part in their fits: all that are smoothed
  std::vector<double> m_inverse_units;    // for each inner sample
  std::vector<std::size_t> m_apart_begin; // for each inner sample, of the places of those a little apart
  std::vector<Index> m_apart;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_SMOOTHING_TRIAL_H
