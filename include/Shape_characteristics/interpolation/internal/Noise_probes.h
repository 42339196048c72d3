#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_NOISE_PROBES_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_NOISE_PROBES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/internal/Rounded_order.h>
#include <Shape_characteristics/internal/Scaled_neighborhood.h>
#include <Shape_characteristics/internal/lexicographically_smaller.h>
#include <Shape_characteristics/interpolation/internal/Batched_hermite_rbf.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// `count` (or all) of the samples that can be used, spread evenly over their lexicographic order: that of the input, rounding,
// and samples that can't be used, don't matter.
template <typename SampledSurface>
std::vector<std::uint32_t> probes_of(const SampledSurface& surface, std::size_t count)
{
  std::vector<std::uint32_t> samples;
  for(std::size_t i = 0; i < surface.size(); ++i)
    if(is_estimated(surface.status(i)))
      samples.push_back(std::uint32_t(i));
  Eigen::AlignedBox3d box;
  for(const std::uint32_t i : samples)
    box.extend(surface.point(i));
  const Rounded_order order(box.min(), box.sizes().maxCoeff());
  const auto is_before = [&](const std::uint32_t i, const std::uint32_t j)
  {
    if(surface.point(i) != surface.point(j))
      return order(surface.point(i), surface.point(j));
    return lexicographically_smaller(surface.normal(i), surface.normal(j));
  };
  const std::size_t probes = (std::min)(count, samples.size());
  const auto rank = [&](const std::size_t k) { return (2 * k + 1) * samples.size() / (2 * probes); };
  // The middle one of the probes to be found parts the samples; then the same with those on either side.
  struct Part
  {
    std::size_t first_probe, last_probe, begin, end;
  };
  std::vector<Part> parts;
  if(probes > 0)
    parts.push_back({0, probes, 0, samples.size()});
  while(!parts.empty())
  {
    const Part part = parts.back();
    parts.pop_back();
    const std::size_t middle = (part.first_probe + part.last_probe) / 2, place = rank(middle);
    std::nth_element(samples.begin() + std::ptrdiff_t(part.begin), samples.begin() + std::ptrdiff_t(place),
                     samples.begin() + std::ptrdiff_t(part.end), is_before);
    if(part.first_probe < middle)
      parts.push_back({part.first_probe, middle, part.begin, place});
    if(middle + 1 < part.last_probe)
      parts.push_back({middle + 1, part.last_probe, place + 1, part.end});
  }
  std::vector<std::uint32_t> result;
  for(std::size_t k = 0; k < probes; ++k)
    result.push_back(samples[rank(k)]);
  return result;
}

/*
  Some neighborhoods of a surface, and what they tell of the noise of its points.

  A surface that bends much from sample to sample looks noisy as well, and suffers most from being smoothed: there, it may be as
  rough as a basis function of up to four times the usual shape parameter makes it. What that can't follow, either, is noise. Where
  a surface bends little, all that a fit of the usual shape can't follow is noise.
*/
template <typename SampledSurface>
class Noise_probes
{
  using Probes = std::vector<std::uint32_t>;

  static constexpr std::size_t s_levels = 12;

public:
  // `bends_are_noise`: where the surface bends much, what a fit of the usual shape can't follow counts as noise, too, if the evidence
  // is strong
  explicit Noise_probes(const SampledSurface& surface, bool bends_are_noise = false)
    : m_surface(surface),
      m_bends_are_noise(bends_are_noise),
      m_probes(probes_of(surface, s_number_of_probes)),
      m_levels(s_levels)
  {
    typename SampledSurface::Workspace workspace;
    std::size_t usable = 0;
    for(const std::uint32_t i : m_probes)
    {
      Scaled_neighborhood neighborhood;
      if(!is_estimated(neighborhood.collect_evenly(surface, i, workspace, s_many, s_many, false,
                                                   Scaled_neighborhood::crowd)))
        continue;
      ++usable;
      if(bending_of(neighborhood) < s_gentle_bending)
        m_gentle.push_back(i);
      m_is_uneven = m_is_uneven || !neighborhood.scaling.is_identity();
    }
    m_surface_bends_little = usable > 0 && 3 * m_gentle.size() >= usable;
    for(std::size_t e = 0; e < s_levels; ++e)
      m_levels[e] = std::pow(10., (double(e) - 12.) / 2.); // variances from 1e-12 to 0.1
  }

  /*
    The standard deviation of the points, in units of the root mean square distance of the 9 nearest neighbors: that of a
    grid under which the data of the neighborhoods together are likeliest. Each neighborhood alone knows too little to
    choose.
  */
  template <typename RadialBasisFunction>
  double level(const RadialBasisFunction& phi) const
  {
    using Fit = Batched_hermite_rbf<SampledSurface, RadialBasisFunction>;
    // Evened out, a surface may bend more between samples; not evened out, it may bend more than samples far apart can tell.
    // Either looks like noise; true noise is seen both ways.
    typename Fit::Options options;
    const double level = level_of(Fit(m_surface, phi, options));
    if(!m_is_uneven || !(level > m_levels[0]))
      return level;
    options.rings_are_evened_out = false;
    return (std::min)(level, level_of(Fit(m_surface, phi, options)));
  }

private:
  template <typename Fit>
  double level_of(const Fit& fit) const
  {
    if(!m_surface_bends_little && m_bends_are_noise) // neighborhoods so small that it bends less in them
      return m_levels[evidence_of(fit, m_probes, s_few, {1.}).lowest_likely(1.5, 0)];
    if(!m_surface_bends_little)
      return m_levels[evidence_of(fit, m_probes, s_many, {1., 2., 4.}).lowest_likely(.5, 0)];

    // Larger neighborhoods see the noise of marching cubes, which varies slowly from vertex to vertex. It may be in some
    // places only, and is largest in still larger neighborhoods; the fits at these places need it known.
    const Evidence evidence = evidence_of(fit, m_gentle, s_many, {1.});
    const std::size_t careful = evidence.lowest_likely(8., 0);
    if(m_levels[careful] < 0.99e-4)
      return m_levels[careful];
    return m_levels[evidence_of(fit, evidence.noisy, s_most, {1.})
                        .lowest_likely(1., evidence.lowest_likely(1., 0))];
  }

  // how likely each level makes the neighborhoods of some probes
  struct Evidence
  {
    std::array<double, s_levels> log_likelihood{}; // of all together
    std::array<std::size_t, s_levels> failures{};  // probes without a fit
    std::size_t used = 0;                          // probes with a fit at some level
    Probes noisy;                                  // those for which the lowest level isn't the likeliest

    // The lowest level, from the given one on, that isn't clearly worse than the best one: by less than `margin` for each
    // probe.
    std::size_t lowest_likely(double margin, std::size_t level) const
    {
      const double threshold =
          *std::max_element(log_likelihood.begin() + std::ptrdiff_t(level), log_likelihood.end()) -
          margin * double(used);
      while(level + 1 < s_levels && (10 * failures[level] > used || log_likelihood[level] < threshold))
        ++level;
      return level;
    }
  };

  // root mean square of the differences between a sample's normal and those of its neighbors
  static double bending_of(const Scaled_neighborhood& neighborhood)
  {
    double sum = 0.;
    for(const Eigen::Vector3d& n : neighborhood.normals)
      sum += (n - neighborhood.normals[0]).squaredNorm();
    return std::sqrt(sum / double(neighborhood.normals.size() - 1));
  }

  template <typename Fit>
  Evidence evidence_of(const Fit& fit,
                       const Probes& probes,
                       std::size_t number_of_neighbors,
                       const std::vector<double>& shape_factors) const
  {
    const std::vector<double> of_probe =
        fit.log_likelihoods(probes, m_levels, number_of_neighbors, shape_factors);
    Evidence evidence;
    for(std::size_t k = 0; k < probes.size(); ++k)
    {
      const double* const of_level = of_probe.data() + k * s_levels;
      double last = of_level[s_levels - 1], largest = last;
      if(!std::isfinite(last)) // there is no surface at all
        continue;
      ++evidence.used;
      bool is_noisy = true;
      for(std::size_t e = s_levels; e-- > 0;)
      {
        if(std::isfinite(of_level[e]))
          last = of_level[e];
        else
          ++evidence.failures[e];
        evidence.log_likelihood[e] += last;
        is_noisy = e > 0 || !(last > largest);
        largest = (std::max)(last, largest);
      }
      if(is_noisy)
        evidence.noisy.push_back(probes[k]);
    }
    return evidence;
  }

  static constexpr std::size_t s_number_of_probes = 50;
  static constexpr double s_gentle_bending = 0.15;
  static constexpr std::size_t s_few = Scaled_neighborhood::nearest, s_many = 2 * s_few, s_most = 4 * s_few;

  const SampledSurface& m_surface;
  bool m_bends_are_noise;
  Probes m_probes, m_gentle;
  bool m_surface_bends_little = false; // between the samples of many neighborhoods
  bool m_is_uneven = false;            // that is what rings around some samples are
  std::vector<double> m_levels;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_NOISE_PROBES_H
