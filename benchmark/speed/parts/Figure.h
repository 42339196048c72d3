#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_FIGURE_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_FIGURE_H

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

namespace speed {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

/// What is timed, and the figures that come of it.
struct Figure
{
  std::string group;         ///< the part of the benchmark
  std::string estimator;     ///< or what else is run
  std::string neighbourhood; ///< or how large it is
  std::string surface, order;
  unsigned int threads = 1;
  std::size_t vertices = 0;      ///< that one run deals with; 0 if it isn't about vertices
  double operations = 0.;        ///< multiplications and additions of one run, if they are known
  double size = nan_value;       ///< of a neighbourhood: the mean number of its vertices
  bool has_errors = true;        ///< whether the results can be compared with the truth
  double seconds = nan_value;    ///< of the quickest run: of the processor on one thread, else of the clock
  double mae = nan_value;        ///< mean absolute error of k_max plus that of k_min
  double median = nan_value;     ///< of the sums of both errors
  std::size_t not_estimated = 0; ///< vertices

  std::string label() const { return neighbourhood.empty() ? estimator : estimator + ", " + neighbourhood; }
  double microseconds_per_vertex() const { return 1e6 * seconds / double(vertices); }
  double vertices_per_second() const { return double(vertices) / seconds; }
  double gflops() const { return 1e-9 * operations / seconds; }

  /// whether it was measured, and all its numbers are numbers
  bool is_complete() const
  {
    return seconds > 0. && std::isfinite(seconds) &&
           (vertices == 0 || !has_errors || (std::isfinite(mae) && std::isfinite(median)));
  }
};

} // namespace speed

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_FIGURE_H
