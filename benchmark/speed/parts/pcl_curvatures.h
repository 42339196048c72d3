#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_PCL_CURVATURES_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_PCL_CURVATURES_H

#include "Workload.h"

#include <functional>

namespace speed {

/// `pcl::PrincipalCurvaturesEstimation` of the workload's points with their exact normals: a function that runs it
/// once, its search tree included, on clouds that are copied here. PCL computes in single precision, and gives
/// eigenvalues of the covariance of normals, which are no curvatures in units of 1/length: there are no errors to
/// compare.
/// \returns an empty function where PCL isn't found
[[gnu::visibility("default")]] std::function<void()> pcl_principal_curvatures(const Workload& workload,
                                                                              unsigned int neighbours);

} // namespace speed

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_PCL_CURVATURES_H
