#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_FITTED_EXPONENT_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_FITTED_EXPONENT_H

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace benchmark_support {

/// The exponent p of the power law y = c x^p that fits best in logarithmic scales (least squares). NaN for less than two
/// different x.
inline double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y)
{
  const double n = double(x.size());
  double mean_u = 0., mean_v = 0.;
  for(std::size_t i = 0; i < x.size(); ++i)
  {
    mean_u += std::log(x[i]) / n;
    mean_v += std::log(y[i]) / n;
  }
  double uu = 0., uv = 0.;
  for(std::size_t i = 0; i < x.size(); ++i)
  {
    const double u = std::log(x[i]) - mean_u;
    uu += u * u;
    uv += u * (std::log(y[i]) - mean_v);
  }
  return uu > 0. ? uv / uu : std::numeric_limits<double>::quiet_NaN();
}

} // namespace benchmark_support

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_FITTED_EXPONENT_H
