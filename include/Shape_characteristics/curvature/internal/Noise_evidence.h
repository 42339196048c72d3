#ifndef SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_NOISE_EVIDENCE_H
#define SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_NOISE_EVIDENCE_H

#include <Shape_characteristics/internal/log_of_sum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace Shape_characteristics {
namespace internal {

// How likely some levels of noise make the data around a sample: for each pair of one of the points and one of the normals, the
// logarithm of the probability density, relative to the likeliest pair; of several samples, the mean.
class Noise_evidence
{
public:
  // as `noise_level` and `normal_noise_level` of hrbf_curvatures()
  static constexpr std::array<double, 5> point_levels = {1e-6, 1e-3, 1e-2, 3e-2, 1e-1};
  static constexpr std::array<double, 4> normal_levels = {1e-3, 1e-2, 1e-1, .31622776601683794};

  // what it says
  static constexpr std::size_t number_of_statistics = normal_levels.size() - 1 + point_levels.size() - 1 + 3;

  // zero: nothing is known
  Noise_evidence() : m_logarithms{} {}

  double& operator()(std::size_t normal_level, std::size_t point_level)
  {
    return m_logarithms[normal_level * point_levels.size() + point_level];
  }

  // Relative to the likeliest pair. Whether there is one: logarithms may be NaN, where there is no fit.
  bool normalize()
  {
    constexpr double least = -1e4;
    double largest = -std::numeric_limits<double>::infinity();
    for(const double x : m_logarithms)
      largest = std::fmax(largest, x);
    if(!std::isfinite(largest))
      return false;
    for(double& x : m_logarithms)
      x = std::isfinite(x) ? (std::max)(x - largest, least) : least;
    return true;
  }

  void operator+=(const Noise_evidence& other)
  {
    for(std::size_t k = 0; k < m_logarithms.size(); ++k)
      m_logarithms[k] += other.m_logarithms[k];
  }

  void operator/=(double number)
  {
    for(double& x : m_logarithms)
      x /= number;
  }

  /*
    Numbers of some units: for each level of the normals but the last, how much likelier it is than the last one; the same for the
    points; the means of the decimal logarithms of the levels, of points and of normals; how likely it is that neither are noisy.
    Logarithms of densities, which may have any size, are compressed.
  */
  double statistic(std::size_t k) const
  {
    const std::size_t of_normals = normal_levels.size() - 1, of_points = point_levels.size() - 1;
    if(k < of_normals)
      return compressed(of_normal_level(k) - of_normal_level(of_normals));
    k -= of_normals;
    if(k < of_points)
      return compressed(of_point_level(k) - of_point_level(of_points));
    k -= of_points;
    if(k == 2)
      return compressed(m_logarithms[0] - largest());
    return mean_level(k == 0);
  }

private:
  static constexpr std::size_t s_pairs = point_levels.size() * normal_levels.size();

  double largest() const { return *std::max_element(m_logarithms.begin(), m_logarithms.end()); }

  static double compressed(double x) { return std::copysign(std::log10(1. + std::abs(x)), x); }

  double of_normal_level(std::size_t level) const
  {
    const auto first = m_logarithms.begin() + std::ptrdiff_t(level * point_levels.size());
    return log_of_sum(first, first + std::ptrdiff_t(point_levels.size()));
  }

  double of_point_level(std::size_t level) const
  {
    std::array<double, normal_levels.size()> of_normals;
    for(std::size_t k = 0; k < of_normals.size(); ++k)
      of_normals[k] = m_logarithms[k * point_levels.size() + level];
    return log_of_sum(of_normals.begin(), of_normals.end());
  }

  double mean_level(bool is_of_points) const
  {
    const double largest = this->largest();
    double weights = 0., sum = 0.;
    for(std::size_t k = 0; k < s_pairs; ++k)
    {
      const double weight = std::exp(m_logarithms[k] - largest);
      weights += weight;
      sum += weight * std::log10(is_of_points ? point_levels[k % point_levels.size()]
                                              : normal_levels[k / point_levels.size()]);
    }
    return sum / weights;
  }

  std::array<double, s_pairs> m_logarithms;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_NOISE_EVIDENCE_H
