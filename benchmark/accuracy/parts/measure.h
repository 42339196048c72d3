#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_ACCURACY_PARTS_MEASURE_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_ACCURACY_PARTS_MEASURE_H

#include "Sample.h"
#include "estimators.h"

#include "Error_statistics.h"

namespace accuracy {

/// The errors of one estimator on one surface, over all seeds.
struct Errors
{
  benchmark_support::Error_statistics all, inner; ///< of the principal curvatures
  benchmark_support::Error_statistics gaussian_all, gaussian_inner;
  double seconds = 0.;

  void add(const Errors& other);
};

/// Runs an estimator.
Errors measure(const Estimator& estimator, Sample& sample, Normal_map normals, bool normals_are_exact);

/// 1 - n . n_estimated (equation 8.9), over all seeds.
struct Normal_errors
{
  double sum_all = 0., sum_inner = 0.;
  std::size_t all = 0, inner = 0, flagged = 0;

  double mean_all() const { return sum_all / double(all - flagged); }
  double mean_inner() const { return sum_inner / double(inner); }
};

/// Runs an estimator of normals, adds its errors, and returns what it estimated.
Normal_map measure(const Normal_estimator& estimator, Sample& sample, Normal_errors& errors);

} // namespace accuracy

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_ACCURACY_PARTS_MEASURE_H
