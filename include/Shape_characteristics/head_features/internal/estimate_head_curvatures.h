#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_ESTIMATE_HEAD_CURVATURES_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_ESTIMATE_HEAD_CURVATURES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/given_or_estimated_curvatures.h>
#include <Shape_characteristics/curvature/rusinkiewicz_curvatures.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <vector>

namespace Shape_characteristics {
namespace internal {

// The curvatures of all vertices in the order of `vertices(mesh)`, in double precision whatever the mesh has, and how they were come by.
struct Head_curvatures
{
  std::vector<Principal_curvatures_and_directions<Sample_kernel> > values;
  std::vector<Estimation_status> statuses;
};

// by the parameter `curvature_estimator`, a function object of a mesh and named parameters
template <typename ConcurrencyTag, typename FaceGraph, typename NamedParameters>
Head_curvatures estimate_head_curvatures(const FaceGraph& mesh, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  const auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                    CGAL::get_const_property_map(CGAL::vertex_point, mesh));
  auto curvature_map =
      get(CGAL::dynamic_vertex_property_t<Principal_curvatures_and_directions<Sample_kernel> >(), mesh);
  auto status_map = get(CGAL::dynamic_vertex_property_t<Estimation_status>(), mesh);
  const auto output = parameters::vertex_point_map(vpm)
                          .vertex_principal_curvatures_and_directions_map(curvature_map)
                          .vertex_status_map(status_map);
  if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::curvature_estimator_t>::value)
    rusinkiewicz_curvatures<ConcurrencyTag>(mesh, output);
  else
    get_parameter(np, internal_np::curvature_estimator)(mesh, output);

  Head_curvatures result;
  result.values.reserve(num_vertices(mesh));
  result.statuses.reserve(num_vertices(mesh));
  for(const auto v : vertices(mesh))
  {
    result.values.push_back(get(curvature_map, v));
    result.statuses.push_back(get(status_map, v));
  }
  return result;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_ESTIMATE_HEAD_CURVATURES_H
