#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_PEAK_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_PEAK_H

#include <cstddef>
#include <string>
#include <vector>

namespace speed {

/// A loop of multiplications and additions that depend on nothing but registers: what one core computes at most with an
/// instruction set.
struct Arithmetic_peak
{
  std::string name;
  std::size_t operations_per_step;
  double (*run)(std::size_t steps); ///< the result is to be used, lest the compiler leave out the loop
};

/// Those of the instruction sets that the processor has, the narrowest vectors first.
std::vector<Arithmetic_peak> arithmetic_peaks();

/// Eigen's product of matrices of doubles, compiled as the rest of the program.
class Matrix_product
{
public:
  explicit Matrix_product(std::size_t size);
  double operations() const;
  double run(); ///< returns an entry of the product

private:
  std::size_t m_size;
  std::vector<double> m_a, m_b, m_c;
};

} // namespace speed

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_PEAK_H
