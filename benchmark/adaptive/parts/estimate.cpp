#include "estimate.h"

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/curvature/adaptive_curvatures.h>

namespace adaptive {

namespace SC = Shape_characteristics;

Estimates make_estimates(Mesh& mesh)
{
  Estimates result;
  result.curvatures =
      mesh.add_property_map<Mesh::Vertex_index, SC::Principal_curvatures_and_directions<Kernel>>(
              "v:curvatures")
          .first;
  result.statuses = mesh.add_property_map<Mesh::Vertex_index, SC::Estimation_status>("v:statuses").first;
  return result;
}

Estimates estimate_adaptively(Mesh& mesh, Normal_map normals, bool fits_are_shared)
{
  Estimates result = make_estimates(mesh);
  SC::adaptive_curvatures(mesh, SC::parameters::vertex_normal_map(normals)
                                    .vertex_principal_curvatures_and_directions_map(result.curvatures)
                                    .vertex_status_map(result.statuses)
                                    .fits_are_shared(fits_are_shared));
  return result;
}

} // namespace adaptive
