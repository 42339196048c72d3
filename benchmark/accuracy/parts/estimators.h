#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_ACCURACY_PARTS_ESTIMATORS_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_ACCURACY_PARTS_ESTIMATORS_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <functional>
#include <string>
#include <vector>

namespace accuracy {

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Normal_map = Mesh::Property_map<Vertex, Kernel::Vector_3>;
using Curvature_map = Mesh::Property_map<Vertex, SC::Principal_curvatures_and_directions<Kernel>>;
using Status_map = Mesh::Property_map<Vertex, SC::Estimation_status>;

/// What an estimator gets and where it writes.
struct Task
{
  const Mesh& mesh;
  Normal_map normals;
  bool normals_are_exact;
  Curvature_map curvatures;
  Status_map statuses;

  /// The named parameters that all estimators share.
  auto parameters() const
  {
    return SC::parameters::vertex_normal_map(normals)
        .vertex_principal_curvatures_and_directions_map(curvatures)
        .vertex_status_map(statuses);
  }
};

/// In which table an estimator takes part, and under which name the thesis prints it there (empty: it doesn't).
struct Appearance
{
  std::string table, column;
};

/// How long an estimator takes: the costly ones, minutes for all surfaces of a table, are run on the first seed only,
/// unless all seeds are asked for.
enum class Cost
{
  LOW,
  HIGH
};

struct Estimator
{
  std::string name, neighbourhood;
  std::vector<Appearance> appearances;
  std::function<void(const Task&)> run;
  Cost cost = Cost::LOW;

  std::string label() const { return name + ", " + neighbourhood; }
};

/// The estimators that are compared.
const std::vector<Estimator>& estimators();

/// An estimator of normals from a mesh alone.
struct Normal_estimator
{
  std::string name, neighbourhood, column;
  std::function<void(const Mesh&, Normal_map)> run;
  Cost cost = Cost::LOW;

  std::string label() const { return name + ", " + neighbourhood; }
};

/// The estimators of normals that are compared.
const std::vector<Normal_estimator>& normal_estimators();

} // namespace accuracy

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_ACCURACY_PARTS_ESTIMATORS_H
