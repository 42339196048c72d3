#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_ERROR_STATISTICS_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_ERROR_STATISTICS_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace benchmark_support {

/// Gathers the errors of principal curvatures over vertices, of one mesh or of several.
class Error_statistics
{
public:
  /// Counts a vertex whose curvatures are off by these (signed) errors. A vertex for which one of them isn't
  /// finite is flagged: it is counted, and left out of all means.
  void add(double error_k_max, double error_k_min)
  {
    ++m_vertices;
    if(!std::isfinite(error_k_max) || !std::isfinite(error_k_min))
    {
      ++m_flagged;
      return;
    }
    m_absolute_max += std::abs(error_k_max);
    m_absolute_min += std::abs(error_k_min);
    m_square_max += error_k_max * error_k_max;
    m_square_min += error_k_min * error_k_min;
    m_sums.push_back(std::abs(error_k_max) + std::abs(error_k_min));
  }

  /// Adds what another one gathered.
  void add(const Error_statistics& other)
  {
    m_vertices += other.m_vertices;
    m_flagged += other.m_flagged;
    m_absolute_max += other.m_absolute_max;
    m_absolute_min += other.m_absolute_min;
    m_square_max += other.m_square_max;
    m_square_min += other.m_square_min;
    m_sums.insert(m_sums.end(), other.m_sums.begin(), other.m_sums.end());
  }

  std::size_t vertices() const { return m_vertices; } ///< flagged ones included
  std::size_t flagged() const { return m_flagged; }

  // the means are NaN if no vertex was estimated
  double mae_k_max() const { return m_absolute_max / count(); }
  double mae_k_min() const { return m_absolute_min / count(); }
  double mse_k_max() const { return m_square_max / count(); }
  double mse_k_min() const { return m_square_min / count(); }

  /// MAE of k_max and of k_min added: what the thesis prints under the name of MSE
  double mae() const { return mae_k_max() + mae_k_min(); }
  double mse() const { return mse_k_max() + mse_k_min(); }

  /// median of |error of k_max| + |error of k_min| (the upper one of an even number)
  double median() const
  {
    if(m_sums.empty())
      return std::numeric_limits<double>::quiet_NaN();
    std::vector<double> sums = m_sums;
    const auto middle = sums.begin() + std::ptrdiff_t(sums.size() / 2);
    std::nth_element(sums.begin(), middle, sums.end());
    return *middle;
  }

private:
  double count() const { return double(m_vertices - m_flagged); }

  std::size_t m_vertices = 0, m_flagged = 0;
  double m_absolute_max = 0., m_absolute_min = 0., m_square_max = 0., m_square_min = 0.;
  std::vector<double> m_sums;
};

} // namespace benchmark_support

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_ERROR_STATISTICS_H
