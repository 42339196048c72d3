#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_ESTIMATORS_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_ESTIMATORS_H

#include "Workload.h"

#include <functional>
#include <string>
#include <vector>

namespace speed {

/// One that is timed: a whole call, with the copy of the mesh, the search of neighbours, and the results written to
/// the workload's maps.
struct Estimator
{
  std::string name, neighbourhood;
  bool is_slow; ///< too slow for millions of vertices, unless one insists
  std::function<void(Workload&, unsigned int threads)> run;

  std::string label() const { return name + ", " + neighbourhood; }
};

/// All estimators of the library: a new one is a new line there.
const std::vector<Estimator>& estimators();

/// \throws std::out_of_range if there is no such estimator
const Estimator& estimator(const std::string& label);

/// HRBF with exact normals on `rings` rings.
Estimator hrbf_exact(unsigned int rings);
/// HRBF with exact normals on point sets, `neighbours` nearest.
Estimator hrbf_exact_nearest(unsigned int neighbours);
/// The thesis's system of 4m equations for r^5, solved by LU.
Estimator thesis_path(unsigned int rings);
/// CGAL's jets on our neighbourhoods, by our function.
Estimator jet(unsigned int degree, unsigned int rings);

/// The mean number of samples in a neighbourhood, the one in the middle included.
double mean_size_of_rings(const Workload& workload, unsigned int rings);

} // namespace speed

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_ESTIMATORS_H
