#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_FACTORIZATIONS_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_FACTORIZATIONS_H

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace speed {

/// What the estimators of Hermite radial basis functions spend their time with: systems of equations of the size of a
/// neighbourhood are factorized.
struct Factorization
{
  std::string name;
  std::size_t equations;
  double operations;         ///< multiplications and additions of one run
  std::function<bool()> run; ///< returns whether all systems were solved
};

/// The operations of a Cholesky factorization: n^3 / 3 and what is below.
double operations_of_cholesky(std::size_t equations);

/// Those of the library, on systems of 3m + 1 equations for 1, 2, 3 and 4 rings of a mesh: m = 7, 19, 37, 61.
std::vector<Factorization> factorizations();

} // namespace speed

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_FACTORIZATIONS_H
