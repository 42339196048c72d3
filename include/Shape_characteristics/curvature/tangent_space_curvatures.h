#ifndef SHAPE_CHARACTERISTICS_CURVATURE_TANGENT_SPACE_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_TANGENT_SPACE_CURVATURES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/Face_weighting.h>
#include <Shape_characteristics/curvature/internal/Triangle_shape_operator.h>
#include <Shape_characteristics/curvature/internal/estimate_from_triangles.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>

#include <cstddef>
#include <stdexcept>
#include <type_traits>

namespace Shape_characteristics {
namespace internal {

class Tangent_space_estimator
{
public:
  using Workspace = Face_graph_samples::Workspace;

  template <typename NamedParameters>
  Tangent_space_estimator(const Face_graph_samples& samples, const NamedParameters& np) : m_samples(samples)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    require_triangles(samples, "tangent_space_curvatures");
    const auto edges = choose_parameter(get_parameter(np, internal_np::number_of_edges), 3);
    m_weighting = choose_parameter(get_parameter(np, internal_np::face_weighting), Face_weighting::UNIFORM);
    if(edges != 2 && edges != 3)
      throw std::invalid_argument("Shape_characteristics: number_of_edges must be 2 or 3");
    m_number_of_edges = edges == 2 ? 2 : 3;
  }

  Curvature_estimate operator()(std::size_t i, Workspace& workspace) const
  {
    const Estimation_status status = status_at_vertex(m_samples, i, workspace);
    if(!is_estimated(status))
      return Curvature_estimate(status);

    const Tangent_frame frame(m_samples.normal(i));
    Mean_shape_operator mean;
    double min_sum = 0., max_sum = 0., weights = 0.;
    const auto [begin, end] = m_samples.incident_faces(i);
    for(const auto* f = begin; f != end; ++f)
    {
      const Triangle_shape_operator triangle(m_samples, frame, i, *f, m_number_of_edges);
      const double weight = m_weighting == Face_weighting::AREA ? triangle.area() : 1.;
      if(!triangle.is_valid() || !(weight > 0.))
        continue;
      const auto [k_min, k_max] = eigenvalues_of_shape_operator(triangle.l(), triangle.m(), triangle.n());
      mean.add(triangle, weight);
      min_sum += weight * k_min;
      max_sum += weight * k_max;
      weights += weight;
    }
    if(!mean.is_valid())
      return Curvature_estimate(Estimation_status::DEGENERATE);
    Shape_operator_eigen result = mean.eigen(frame);
    result.min_curvature = min_sum / weights;
    result.max_curvature = max_sum / weights;
    return Curvature_estimate(status, result);
  }

private:
  const Face_graph_samples& m_samples;
  Face_weighting m_weighting;
  unsigned int m_number_of_edges;
};

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at the vertices of a triangle mesh from the shape operators of its triangles (thesis,
  section 7.1).

  The shape operator of a triangle is, by least squares, the one that best explains how the vertices' normals differ
  along its edges (7.1 to 7.9); its eigenvalues are the principal curvatures of the triangle. Those of a vertex are
  the means of the ones of its triangles.

  Where the principal directions differ between the triangles of a vertex, averaging eigenvalues, and not operators,
  overestimates the largest and underestimates the smallest curvature: `rusinkiewicz_curvatures()` averages operators.
  The thesis gives no principal directions; here they are those of the operators' mean, turned into the tangent
  plane of the vertex.

  Of triangles with hardly any area whose corners' normals differ, the curvature across is as large as the triangle is thin.
  In uniform means they drown the others: on meshes that have any (of CAD models, say), give `Face_weighting::AREA`, which
  elsewhere is mostly the less accurate one.

  Triangles without an area, or with points or normals that are not finite, count for nothing.

  \scConcurrencyTag
  \tparam FaceGraph a model of `FaceListGraph`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh. All its faces must be triangles.
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scMeshOutputParameters
    \scMeshInputParameters
    \cgalParamNBegin{number_of_edges}
      \cgalParamDescription{how many edges of a triangle are used, 2 or 3}
      \cgalParamType{an integer type}
      \cgalParamDefault{`3`}
      \cgalParamExtra{The two are those at the second vertex, counted counterclockwise from the one whose point is
                      lexicographically smallest: in contrast to three, they depend on how the mesh lies in space.}
    \cgalParamNEnd
    \cgalParamNBegin{face_weighting}
      \cgalParamDescription{the weights of the triangles in the means}
      \cgalParamType{`Face_weighting`}
      \cgalParamDefault{`Face_weighting::UNIFORM`}
    \cgalParamNEnd
    \scCallbackParameter
  \cgalNamedParamsEnd

  \return the number of vertices that could not be estimated. Their values are quiet NaN, their status says why.

  \throws std::invalid_argument if a face is not a triangle, or `number_of_edges` is neither 2 nor 3

  Complexity: linear in the size of the mesh.

  \cgalExample{curvature/tangent_space_curvatures.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
std::size_t tangent_space_curvatures(const FaceGraph& mesh,
                                     const NamedParameters& np = parameters::default_values())
{
  return internal::estimate_from_triangles<ConcurrencyTag, internal::Tangent_space_estimator>(mesh, np);
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at one vertex of a triangle mesh: those that `tangent_space_curvatures()` of the whole mesh
  gives, bit for bit.

  \param v the vertex
  \param mesh the mesh. Its faces near the vertex must be triangles.
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters": `number_of_edges` and `face_weighting`
         as for the whole mesh, and the ones listed below

  \cgalNamedParamsBegin
    \scVertexOutputParameters
    \scMeshInputParameters
  \cgalNamedParamsEnd

  \return whether the curvatures were estimated, or why not

  \throws std::invalid_argument if a face near the vertex is not a triangle, or `number_of_edges` is neither 2 nor 3

  Complexity: that of the neighborhood, whatever the size of the mesh.
*/
template <typename FaceGraph, typename NamedParameters = parameters::Default_named_parameters>
Estimation_status tangent_space_curvatures(typename internal::Vertex_descriptor<FaceGraph>::type v,
                                           const FaceGraph& mesh,
                                           const NamedParameters& np = parameters::default_values())
{
  return internal::estimate_from_triangles<internal::Tangent_space_estimator>(v, mesh, np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_TANGENT_SPACE_CURVATURES_H
