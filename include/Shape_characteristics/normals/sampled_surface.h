#ifndef SHAPE_CHARACTERISTICS_NORMALS_SAMPLED_SURFACE_H
#define SHAPE_CHARACTERISTICS_NORMALS_SAMPLED_SURFACE_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/internal/large_pages.h>
#include <Shape_characteristics/internal/point_set_parameters.h>
#include <Shape_characteristics/internal/to_eigen.h>
#include <Shape_characteristics/normals/vertex_normals.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>
#include <Shape_characteristics/sampling/Neighborhood.h>
#include <Shape_characteristics/sampling/Point_set_samples.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace Shape_characteristics {
/*!
  \ingroup PkgShapeCharacteristicsNormals

  makes a sampled surface of a mesh: its points, normals and neighborhoods, as named parameters say.

  \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or `CGAL::Parallel_if_available_tag` (default)
  \tparam FaceGraph a model of `FaceListGraph`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh
  \param neighborhood what the neighbors of a vertex are
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below
  \param connectivity what is to be known of the mesh afterwards

  \cgalNamedParamsBegin
    \cgalParamNBegin{vertex_point_map}
      \cgalParamDescription{the points of the vertices}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `%Point_3`}
      \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
    \cgalParamNEnd
    \cgalParamNBegin{vertex_normal_map}
      \cgalParamDescription{the outward normals of the vertices, of any length}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `%Vector_3`}
      \cgalParamDefault{`vertex_normals()` with `normal_weighting`}
    \cgalParamNEnd
    \cgalParamNBegin{normal_weighting}
      \cgalParamDescription{how normals are computed if none are given}
      \cgalParamType{`Normal_weighting`}
      \cgalParamDefault{`Normal_weighting::MAX`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \throws std::invalid_argument if the neighborhood is one of point sets
  \throws std::length_error if the mesh has too many vertices or faces, see `Face_graph_samples`
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
Face_graph_samples
sampled_surface(const FaceGraph& mesh,
                const Neighborhood& neighborhood,
                const NamedParameters& np = parameters::default_values(),
                Face_graph_samples::Connectivity connectivity = Face_graph_samples::Connectivity::NEIGHBORS)
{
  static_assert(internal::number_of_neighborhoods<NamedParameters> <= 1,
                "give one of number_of_rings and neighbor_radius, not both");
  using Connectivity = Face_graph_samples::Connectivity;
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  const auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                    CGAL::get_const_property_map(CGAL::vertex_point, mesh));
  constexpr bool computes_normals =
      is_default_parameter<NamedParameters, internal_np::vertex_normal_map_t>::value;
  const bool forgets_faces = computes_normals && connectivity == Connectivity::NEIGHBORS;
  Face_graph_samples samples(mesh, vpm, neighborhood,
                             forgets_faces ? Connectivity::NEIGHBORS_AND_FACES : connectivity,
                             ConcurrencyTag());
  if constexpr(computes_normals)
  {
    const Normal_weighting weighting =
        choose_parameter(get_parameter(np, internal_np::normal_weighting), Normal_weighting::MAX);
    samples.set_normals(vertex_normals<ConcurrencyTag>(samples, weighting), Estimation_status::DEGENERATE);
    if(forgets_faces)
      samples.forget_faces();
  }
  else
  {
    const auto normal_map = get_parameter(np, internal_np::vertex_normal_map);
    std::vector<Eigen::Vector3d> normals;
    internal::reserve_large_pages(normals, samples.size());
    for(const auto v : vertices(mesh))
      normals.push_back(internal::to_eigen(get(normal_map, v)));
    samples.set_normals(std::move(normals));
  }
  return samples;
}

/*!
  \ingroup PkgShapeCharacteristicsNormals

  makes a sampled surface of a vertex of a mesh (which becomes sample 0) and of what is reached from it by
  going from neighbors to neighbors `reach` times.

  \tparam FaceGraph a model of `FaceListGraph`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param v the vertex
  \param mesh the mesh
  \param neighborhood what the neighbors of a vertex are
  \param reach how often one goes from neighbors to neighbors, see `Face_graph_samples`
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters", as for the whole mesh

  \throws std::invalid_argument as for the whole mesh
  \throws std::length_error as for the whole mesh
*/
template <typename FaceGraph, typename NamedParameters = parameters::Default_named_parameters>
Face_graph_samples sampled_surface(typename internal::Vertex_descriptor<FaceGraph>::type v,
                                   const FaceGraph& mesh,
                                   const Neighborhood& neighborhood,
                                   unsigned int reach,
                                   const NamedParameters& np = parameters::default_values())
{
  static_assert(internal::number_of_neighborhoods<NamedParameters> <= 1,
                "give one of number_of_rings and neighbor_radius, not both");
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::is_default_parameter;
  using vertex_descriptor = typename boost::graph_traits<FaceGraph>::vertex_descriptor;

  const auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                    CGAL::get_const_property_map(CGAL::vertex_point, mesh));
  std::vector<vertex_descriptor> copied;
  Face_graph_samples samples(v, mesh, vpm, neighborhood, reach, copied);
  if constexpr(is_default_parameter<NamedParameters, internal_np::vertex_normal_map_t>::value)
  {
    const Normal_weighting weighting =
        choose_parameter(get_parameter(np, internal_np::normal_weighting), Normal_weighting::MAX);
    samples.set_normals(vertex_normals<CGAL::Sequential_tag>(samples, weighting),
                        Estimation_status::DEGENERATE);
  }
  else
  {
    const auto normal_map = get_parameter(np, internal_np::vertex_normal_map);
    std::vector<Eigen::Vector3d> normals;
    internal::reserve_large_pages(normals, samples.size());
    for(const vertex_descriptor w : copied)
      normals.push_back(internal::to_eigen(get(normal_map, w)));
    samples.set_normals(std::move(normals));
  }
  return samples;
}

/*!
  \ingroup PkgShapeCharacteristicsNormals

  makes a sampled surface of a point set: its points, normals and neighborhoods, as named parameters say.

  \tparam PointRange a model of `ConstRange`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param points the point set
  \param neighborhood what the neighbors of a point are
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{point_map}
      \cgalParamDescription{the points of the elements of the range}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `%Point_3`}
      \cgalParamDefault{`CGAL::Identity_property_map`, or the map of a `CGAL::Point_set_3`}
    \cgalParamNEnd
    \cgalParamNBegin{normal_map}
      \cgalParamDescription{the outward normals of the elements of the range, of any length}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `%Vector_3`}
      \cgalParamDefault{the map of a `CGAL::Point_set_3`; other ranges need it}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \throws std::invalid_argument if there is no normal map, or the neighborhood is one of meshes
  \throws std::length_error if there are too many points, see `Point_set_samples`
*/
template <typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_point_range<PointRange> >,
          typename = void>
Point_set_samples sampled_surface(const PointRange& points,
                                  const Neighborhood& neighborhood,
                                  const NamedParameters& np = parameters::default_values())
{
  using Helper = internal::Point_set_helper<PointRange, NamedParameters>;

  internal::require_normal_map(points, np);
  Point_set_samples samples(points, Helper::get_const_point_map(points, np), neighborhood);
  if constexpr(internal::may_have_normal_map<PointRange, NamedParameters>)
  {
    const auto normal_map = Helper::get_normal_map(points, np);
    std::vector<Eigen::Vector3d> normals;
    internal::reserve_large_pages(normals, samples.size());
    for(const auto& item : points)
      normals.push_back(internal::to_eigen(get(normal_map, item)));
    samples.set_normals(std::move(normals));
  }
  return samples;
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_NORMALS_SAMPLED_SURFACE_H
