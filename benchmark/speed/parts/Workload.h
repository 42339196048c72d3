#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_WORKLOAD_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_WORKLOAD_H

#include "Error_statistics.h"
#include "exact_curvature.h"

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace speed {

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Curvatures = SC::Principal_curvatures_and_directions<Kernel>;

/// The order of the vertices in memory.
enum class Order
{
  CURVE, ///< along a space-filling curve: neighbors are near each other, as in most files
  RANDOM ///< the worst one for the caches: no vertex is near its neighbors
};

const char* to_string(Order order);

/// A surface with the truth at its vertices, and the maps that estimators write to.
struct Workload
{
  /// \param surface an explicit function (random points, Delaunay triangulation), or an implicit one (marching cubes
  ///        with exact crossings of the edges; `points` is then the samples per axis, and `order` doesn't matter)
  Workload(const std::string& surface, std::size_t points, std::uint64_t seed, Order order);

  std::size_t size() const { return mesh.number_of_vertices(); }

  /// Forgets what the last estimator wrote: what the next one leaves alone must not count as its own.
  void clear_results();

  /// The errors of the curvatures in the maps. Vertices that were not estimated are flagged.
  benchmark_support::Error_statistics errors() const;

  Mesh mesh;
  std::vector<Vertex> vertices; ///< all of them: a range of points
  std::vector<benchmark_support::Exact_curvature> exact;
  Mesh::Property_map<Vertex, Kernel::Vector_3> normals; ///< the exact ones
  Mesh::Property_map<Vertex, Curvatures> curvatures;
  Mesh::Property_map<Vertex, SC::Estimation_status> statuses;
};

} // namespace speed

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_WORKLOAD_H
