#ifndef SHAPE_CHARACTERISTICS_CHARACTERISTICS_INTERNAL_SALIENCY_ESTIMATOR_H
#define SHAPE_CHARACTERISTICS_CHARACTERISTICS_INTERNAL_SALIENCY_ESTIMATOR_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/internal/passes.h>
#include <Shape_characteristics/sampling/for_each_sample.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <vector>

namespace Shape_characteristics {
namespace internal {

struct Saliency_estimate
{
  Estimation_status status = Estimation_status::CANCELLED;
  double value = std::numeric_limits<double>::quiet_NaN();
};

// How far away neighbors matter, in units of the scale: two standard deviations of the coarsest average, and of the finer one at the
// same scale.
inline constexpr double reach_of_saliency = 24., reach_of_maxima = reach_of_saliency / 2.;

// What saliency() says, for all samples of a surface, which is there twice: with the neighbors in balls of either radius.
template <typename ConcurrencyTag, typename SampledSurface>
class Saliency_estimator
{
public:
  Saliency_estimator(const SampledSurface& surface,
                     const SampledSurface& with_fewer_neighbors,
                     const std::vector<double>& mean_curvatures,
                     double scale)
    : m_surface(surface),
      m_with_fewer_neighbors(with_fewer_neighbors),
      m_curvatures(mean_curvatures),
      m_scale(scale),
      m_status(surface.size()),
      m_differences(surface.size())
  {}

  std::vector<Saliency_estimate> operator()(const std::function<bool(double)>& callback)
  {
    std::vector<Saliency_estimate> result(m_surface.size());
    if(!visit(callback, 0, [&](std::size_t i, Workspace& w) { find_differences(i, w); }))
      return result;
    normalize();
    std::vector<Values> maxima(m_surface.size());
    if(!visit(callback, 1, [&](std::size_t i, Workspace& w) { maxima[i] = local_maxima(i, w); }))
      return result;
    const Values weights = suppression(maxima);
    for(std::size_t i = 0; i < m_surface.size(); ++i)
    {
      result[i].status = m_status[i];
      if(is_estimated(m_status[i]))
        result[i].value = std::inner_product(weights.begin(), weights.end(), m_differences[i].begin(), 0.);
    }
    return result;
  }

private:
  using Workspace = typename SampledSurface::Workspace;
  static constexpr std::size_t s_scales = 5;
  using Values = std::array<double, s_scales>;
  static constexpr double s_rounding = 1e-9; // relative

  // of the Gaussian of the finer average, in units of the scale; that of the coarser one is twice as much
  static constexpr double standard_deviation(std::size_t k) { return double(k + 2); }

  // Gaussians end where they are two standard deviations wide.
  static bool is_within(double distance, double standard_deviation)
  {
    return distance <= (1. + s_rounding) * 2. * standard_deviation;
  }

  template <typename Function>
  bool visit(const std::function<bool(double)>& callback, std::size_t pass, const Function& function) const
  {
    std::function<bool(double)> of_pass;
    if(callback)
      of_pass = Callback_of_pass(callback, pass, 2);
    return for_each_sample<ConcurrencyTag, Workspace>(m_surface.size(), function, of_pass);
  }

  double distance(std::size_t i, std::size_t j) const
  {
    return (m_surface.point(j) - m_surface.point(i)).norm() / m_scale;
  }

  void find_differences(std::size_t i, Workspace& workspace)
  {
    m_differences[i].fill(0.);
    m_status[i] = m_surface.status(i);
    if(!is_estimated(m_status[i]))
      return;
    if(!std::isfinite(m_curvatures[i]))
    {
      m_status[i] = Estimation_status::DEGENERATE;
      return;
    }
    // averages of what curvatures are more than here: of a curvature that is large all around, few digits would be left
    Values fine{}, coarse{}, weight_of_fine, weight_of_coarse;
    weight_of_fine.fill(1.); // the sample's own
    weight_of_coarse.fill(1.);
    bool has_neighbors = false;
    for(const auto j : m_surface.neighbors(i, 0, workspace))
    {
      if(!std::isfinite(m_curvatures[j]))
        continue;
      has_neighbors = true;
      const double d = distance(i, j), c = m_curvatures[j] - m_curvatures[i];
      const auto add = [d, c](double sigma, double& sum, double& weight)
      {
        if(!is_within(d, sigma))
          return;
        const double w = std::exp(-.5 * (d / sigma) * (d / sigma));
        sum += w * c;
        weight += w;
      };
      for(std::size_t k = 0; k < s_scales; ++k)
      {
        add(standard_deviation(k), fine[k], weight_of_fine[k]);
        add(2. * standard_deviation(k), coarse[k], weight_of_coarse[k]);
      }
    }
    if(!has_neighbors)
      m_status[i] = Estimation_status::FEW_NEIGHBOURS;
    for(std::size_t k = 0; k < s_scales; ++k)
      m_differences[i][k] = std::abs(fine[k] / weight_of_fine[k] - coarse[k] / weight_of_coarse[k]);
    if(!std::all_of(m_differences[i].begin(), m_differences[i].end(),
                    [](double d) { return std::isfinite(d); }))
    { // curvatures around here are too large for sums of them
      m_status[i] = Estimation_status::DEGENERATE;
      m_differences[i].fill(0.);
    }
  }

  // The largest of each scale becomes 1, unless all are rounding errors.
  void normalize()
  {
    double largest_curvature = 0.;
    for(std::size_t i = 0; i < m_surface.size(); ++i)
      if(is_estimated(m_status[i]))
        largest_curvature = (std::max)(largest_curvature, std::abs(m_curvatures[i]));
    for(std::size_t k = 0; k < s_scales; ++k)
    {
      double largest = 0.;
      for(const Values& d : m_differences)
        largest = (std::max)(largest, d[k]);
      const bool is_flat = !(largest > s_rounding * largest_curvature);
      for(Values& d : m_differences)
        d[k] = is_flat ? 0. : d[k] / largest;
    }
  }

  // the differences where no sample as near as counts in the finer average has a larger one, but for rounding, else 0
  Values local_maxima(std::size_t i, Workspace& workspace) const
  {
    Values result = m_differences[i];
    if(!is_estimated(m_status[i]))
      return result; // 0
    for(const auto j : m_with_fewer_neighbors.neighbors(i, 0, workspace))
      for(std::size_t k = 0; k < s_scales; ++k)
        if(m_differences[j][k] > (1. + s_rounding) * m_differences[i][k] &&
           is_within(distance(i, j), standard_deviation(k)))
          result[k] = 0.;
    return result;
  }

  // What each scale counts: the more, the more its largest difference stands out among the local maxima.
  static Values suppression(const std::vector<Values>& maxima)
  {
    Values result;
    for(std::size_t k = 0; k < s_scales; ++k)
    {
      std::vector<double> others;
      for(const Values& m : maxima)
        if(m[k] > 0.)
          others.push_back(m[k]);
      std::sort(others.begin(), others.end()); // for a sum that doesn't depend on the order of the samples
      if(!others.empty())
        others.pop_back();
      const double sum = std::accumulate(others.begin(), others.end(), 0.);
      const double mean = others.empty() ? 0. : sum / double(others.size());
      result[k] = (1. - mean) * (1. - mean);
    }
    return result;
  }

  const SampledSurface &m_surface, &m_with_fewer_neighbors;
  const std::vector<double>& m_curvatures;
  double m_scale;
  std::vector<Estimation_status> m_status;
  std::vector<Values> m_differences; // of the two averages, for each scale
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CHARACTERISTICS_INTERNAL_SALIENCY_ESTIMATOR_H
