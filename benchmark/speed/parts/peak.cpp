#include "peak.h"

#include <Eigen/Core>

namespace speed {
namespace {

// Twelve chains, for a chain's next operation waits for its last one: four cycles on two units ask for eight at least,
// and sixteen registers hold twelve besides the two constants.
#define SHAPE_CHARACTERISTICS_CHAINS                                                                         \
  {                                                                                                          \
    V x = V{} + .999999, y = V{} + 1e-6;                                                                     \
    V a = y, b = a + y, c = b + y, d = c + y, e = d + y, f = e + y;                                          \
    V g = f + y, h = g + y, i = h + y, j = i + y, k = j + y, l = k + y;                                      \
    for(std::size_t step = 0; step < steps; ++step)                                                          \
    {                                                                                                        \
      a = a * x + y, b = b * x + y, c = c * x + y, d = d * x + y, e = e * x + y, f = f * x + y;              \
      g = g * x + y, h = h * x + y, i = i * x + y, j = j * x + y, k = k * x + y, l = l * x + y;              \
    }                                                                                                        \
    const V sum = a + b + c + d + e + f + g + h + i + j + k + l;                                             \
    return sum[0];                                                                                           \
  }

constexpr std::size_t operations_per_lane = 2 * 12;

template <int lanes>
struct Lanes
{
  typedef double type __attribute__((vector_size(lanes * sizeof(double))));
};

#ifdef __x86_64__

__attribute__((target("no-avx"))) double run_sse2(std::size_t steps)
{
  using V = Lanes<2>::type;
  SHAPE_CHARACTERISTICS_CHAINS
}

__attribute__((target("avx2,fma"))) double run_avx2(std::size_t steps)
{
  using V = Lanes<4>::type;
  SHAPE_CHARACTERISTICS_CHAINS
}

__attribute__((target("avx512f"))) double run_avx512(std::size_t steps)
{
  using V = Lanes<8>::type;
  SHAPE_CHARACTERISTICS_CHAINS
}

#else

double run_default(std::size_t steps)
{
  using V = Lanes<2>::type;
  SHAPE_CHARACTERISTICS_CHAINS
}

#endif
#undef SHAPE_CHARACTERISTICS_CHAINS

} // namespace

std::vector<Arithmetic_peak> arithmetic_peaks()
{
  std::vector<Arithmetic_peak> peaks;
#ifdef __x86_64__
  peaks.push_back({"SSE2", 2 * operations_per_lane, run_sse2});
  if(__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    peaks.push_back({"AVX2 and FMA", 4 * operations_per_lane, run_avx2});
  if(__builtin_cpu_supports("avx512f"))
    peaks.push_back({"AVX-512", 8 * operations_per_lane, run_avx512});
#else
  peaks.push_back({"two lanes", 2 * operations_per_lane, run_default});
#endif
  return peaks;
}

Matrix_product::Matrix_product(std::size_t size)
  : m_size(size),
    m_a(size * size),
    m_b(size * size),
    m_c(size * size)
{
  for(std::size_t i = 0; i < m_a.size(); ++i)
  {
    m_a[i] = 1. / double(1 + i % 7);
    m_b[i] = 1. / double(1 + i % 11);
  }
}

double Matrix_product::operations() const
{
  return 2. * double(m_size) * double(m_size) * double(m_size);
}

double Matrix_product::run()
{
  const auto n = Eigen::Index(m_size);
  const Eigen::Map<const Eigen::MatrixXd> a(m_a.data(), n, n), b(m_b.data(), n, n);
  Eigen::Map<Eigen::MatrixXd> c(m_c.data(), n, n);
  c.noalias() = a * b;
  return m_c.back();
}

} // namespace speed
