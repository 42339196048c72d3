#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_ADAPTIVE_ESTIMATE_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_ADAPTIVE_ESTIMATE_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <string>
#include <vector>

namespace adaptive {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Normal_map = Mesh::Property_map<Mesh::Vertex_index, Kernel::Vector_3>;

/// What an estimator says of the vertices.
struct Estimates
{
  Mesh::Property_map<Mesh::Vertex_index, Shape_characteristics::Principal_curvatures_and_directions<Kernel>>
      curvatures;
  Mesh::Property_map<Mesh::Vertex_index, Shape_characteristics::Estimation_status> statuses;
};

/// Maps of the mesh to write to.
Estimates make_estimates(Mesh& mesh);

/// `adaptive_curvatures()`
Estimates estimate_adaptively(Mesh& mesh, Normal_map normals, bool fits_are_shared);

/// An estimator to compare with.
struct Other_estimator
{
  std::string name;
  Estimates (*run)(Mesh&, Normal_map);
};

/// Those that are best on some of the data, beside the candidates themselves.
const std::vector<Other_estimator>& other_estimators();

} // namespace adaptive

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_ADAPTIVE_ESTIMATE_H
