#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_RANDOM_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_RANDOM_H

#include <cmath>
#include <cstdint>
#include <random>

namespace benchmark_support {

/// Random numbers that are the same with every standard library: the engine is specified bit for bit, the
/// distributions of <random> are not, so the mappings are written here.
class Random
{
public:
  explicit Random(std::uint64_t seed) : m_engine(seed) {}

  /// uniform in [0, 1): the 53 leading bits
  double uniform() { return double(m_engine() >> 11) * 0x1p-53; }

  double uniform(double lower, double upper) { return lower + (upper - lower) * uniform(); }

  /// standard normal, by Box and Muller; the second value of each pair is dropped, so that one call takes
  /// two numbers of the engine whatever was called before
  double gaussian()
  {
    const double u = 1. - uniform(); // in (0, 1]: the logarithm stays finite
    const double v = uniform();
    return std::sqrt(-2. * std::log(u)) * std::cos(6.283185307179586476925 * v);
  }

private:
  std::mt19937_64 m_engine;
};

} // namespace benchmark_support

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_RANDOM_H
