#include "estimators.h"
#include "fuzzed_mesh.h"

#include <CGAL/boost/graph/helpers.h>

#include <stdexcept>

// Meshes through one of the estimators.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  static const auto estimators = bad_inputs::estimators<fuzz::Mesh>();

  FuzzedDataProvider data(bytes, size);
  const auto& estimator = estimators[data.ConsumeIntegralInRange<std::size_t>(0, estimators.size() - 1)];
  const fuzz::Mesh mesh = fuzz::mesh(data);
  if(estimator.needs_triangles && !CGAL::is_triangle_mesh(mesh))
  {
    try
    {
      estimator.all(mesh);
    }
    catch(const std::invalid_argument&)
    {
      return 0;
    }
    fuzz::require(estimator.name, "a face that isn't a triangle was accepted");
  }
  fuzz::require(estimator.name, bad_inputs::complaint(estimator.all(mesh), mesh));
  if(estimator.one && mesh.number_of_vertices() > 0)
    fuzz::require(estimator.name + ", one vertex",
                  bad_inputs::complaint(estimator.one(*mesh.vertices().begin(), mesh)));
  return 0;
}
