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
  double operations; ///< multiplications and additions of one run, but those of what assembles the systems
  std::function<void()> prepare; ///< comes before each run, and isn't timed
  std::function<bool()> run;     ///< returns whether all systems were solved
};

/// Those of the library, with and without what assembles the systems, and Eigen's: systems of 3m + 1 equations of exact normals, for
/// 1, 2, 3 and 4 rings of a mesh (m = 7, 19, 37, 61), and of 4m of estimated ones, for 4 rings of it and for the largest neighborhood of
/// four rings of another (m = 61, 121). A run solves so many systems that they are about `enough_operations`.
std::vector<Factorization> factorizations(double enough_operations);

} // namespace speed

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_FACTORIZATIONS_H
