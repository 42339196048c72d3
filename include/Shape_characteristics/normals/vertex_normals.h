#ifndef SHAPE_CHARACTERISTICS_NORMALS_VERTEX_NORMALS_H
#define SHAPE_CHARACTERISTICS_NORMALS_VERTEX_NORMALS_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/internal/length.h>
#include <Shape_characteristics/internal/to_vector.h>
#include <Shape_characteristics/normals/Normal_weighting.h>
#include <Shape_characteristics/normals/internal/weighted_normal.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>
#include <Shape_characteristics/sampling/for_each_sample.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// of unit length; the null vector where the faces determine no normal
inline Eigen::Vector3d
vertex_normal(const Face_graph_samples& samples, std::size_t i, Normal_weighting weighting)
{
  const Eigen::Vector3d sum = weighted_normal(samples, i, weighting);
  const double square = sum.squaredNorm();
  if(square > 1e-280 && square < 1e280)
    return sum / std::sqrt(square);
  if(const double l = length(sum); l > 0.)
    return (sum / l).normalized();
  return Eigen::Vector3d::Zero();
}

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsNormals

  computes the normals of a set of samples from the faces at them.

  \return unit vectors; the null vector where the faces determine no normal. A sum that shrinks to rounding
          errors (faces that fold back on themselves) determines none.
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag>
std::vector<Eigen::Vector3d> vertex_normals(const Face_graph_samples& samples,
                                            Normal_weighting weighting = Normal_weighting::MAX)
{
  constexpr std::size_t block_size = 1024;
  std::vector<Eigen::Vector3d> normals(samples.size(), Eigen::Vector3d::Zero());
  for_each_sample<ConcurrencyTag, No_workspace>(
      samples.size(),
      [&](const std::size_t i, No_workspace&)
      { normals[i] = internal::vertex_normal(samples, i, weighting); },
      {}, block_size);
  return normals;
}

/*!
  \ingroup PkgShapeCharacteristicsNormals

  computes the unit normals at the vertices of a mesh as weighted sums of the normals of their faces.

  \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or `CGAL::Parallel_if_available_tag` (default)
  \tparam FaceGraph a model of `FaceListGraph`; faces may have any number of vertices
  \tparam VertexNormalMap a model of `WritablePropertyMap` with
          `boost::graph_traits<FaceGraph>::%vertex_descriptor` as key type and `%Vector_3` as value type
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh
  \param normals the property map in which the normals are written, by one thread. They point to the side from
         which the faces look counterclockwise.
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{normal_weighting}
      \cgalParamDescription{the weights of the faces}
      \cgalParamType{`Normal_weighting`}
      \cgalParamDefault{`Normal_weighting::MAX`}
    \cgalParamNEnd
    \cgalParamNBegin{vertex_status_map}
      \cgalParamDescription{a property map in which is written whether each vertex has a normal: `ESTIMATED` or
                            `BORDER`, `UNREFERENCED`, `NON_FINITE_INPUT`, or `DEGENERATE` (its faces have no normal)}
      \cgalParamType{a model of `WritablePropertyMap` with value type `Estimation_status`}
      \cgalParamDefault{unused}
    \cgalParamNEnd
    \cgalParamNBegin{vertex_point_map}
      \cgalParamDescription{the points of the vertices}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `%Point_3`}
      \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
    \cgalParamNEnd
    \cgalParamNBegin{geom_traits}
      \cgalParamDescription{an instance of a geometric traits class}
      \cgalParamType{a model of `Kernel`}
      \cgalParamDefault{deduced from the point type}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return the number of vertices without a normal; quiet NaN is written for them.

  Complexity: linear in the size of the mesh.
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename VertexNormalMap,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
std::size_t vertex_normals(const FaceGraph& mesh,
                           VertexNormalMap normals,
                           const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::is_default_parameter;
  using Vector_3 = typename boost::property_traits<VertexNormalMap>::value_type;

  const auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                    CGAL::get_const_property_map(CGAL::vertex_point, mesh));
  const Normal_weighting weighting =
      choose_parameter(get_parameter(np, internal_np::normal_weighting), Normal_weighting::MAX);

  Face_graph_samples samples(mesh, vpm, Neighborhood::rings(1), Face_graph_samples::Connectivity::FACES,
                             ConcurrencyTag());
  samples.set_normals(vertex_normals<ConcurrencyTag>(samples, weighting), Estimation_status::DEGENERATE);

  std::size_t failures = 0, i = 0;
  for(const auto v : vertices(mesh))
  {
    Eigen::Vector3d n = samples.normal(i);
    if(!is_estimated(samples.status(i)))
    {
      n.setConstant(std::numeric_limits<double>::quiet_NaN());
      ++failures;
    }
    put(normals, v, internal::to_vector<Vector_3>(n));
    if constexpr(!is_default_parameter<NamedParameters, internal_np::vertex_status_map_t>::value)
    {
      const auto status_map = get_parameter(np, internal_np::vertex_status_map);
      put(status_map, v, samples.status(i));
    }
    ++i;
  }
  return failures;
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_NORMALS_VERTEX_NORMALS_H
