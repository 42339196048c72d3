#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_CGAL_JETS_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_CGAL_JETS_H

#include "Workload.h"

#include <cstddef>
#include <vector>

namespace speed {

/// The points of each vertex's neighbourhood, the vertex first.
struct Neighbourhoods
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::size_t> begin; ///< one more than vertices
};

/// The neighbourhoods of `rings` rings, more where these have not the points that degree 4 needs.
Neighbourhoods gather_neighbourhoods(const Workload& workload, unsigned int rings);

/// CGAL::Monge_via_jet_fitting (d=4, d'=2) as a user calls it, on neighbourhoods that were gathered before.
void cgal_jets(Workload& workload, const Neighbourhoods& neighbourhoods);

/// The same, with each neighbourhood gathered before its fit.
void cgal_jets(Workload& workload, unsigned int rings);

} // namespace speed

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_CGAL_JETS_H
