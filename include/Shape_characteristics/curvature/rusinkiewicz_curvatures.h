#ifndef SHAPE_CHARACTERISTICS_CURVATURE_RUSINKIEWICZ_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_RUSINKIEWICZ_CURVATURES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/internal/Triangle_shape_operator.h>
#include <Shape_characteristics/curvature/internal/estimate_from_triangles.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>

#include <cstddef>
#include <type_traits>

namespace Shape_characteristics {
namespace internal {

class Rusinkiewicz_estimator
{
public:
  using Workspace = Face_graph_samples::Workspace;

  template <typename NamedParameters>
  Rusinkiewicz_estimator(const Face_graph_samples& samples, const NamedParameters&) : m_samples(samples)
  {
    require_triangles(samples, "rusinkiewicz_curvatures");
  }

  Curvature_estimate operator()(std::size_t i, Workspace& workspace) const
  {
    const Estimation_status status = status_at_vertex(m_samples, i, workspace);
    if(!is_estimated(status))
      return Curvature_estimate(status);

    const Tangent_frame frame(m_samples.normal(i));
    Mean_shape_operator mean;
    const auto [begin, end] = m_samples.incident_faces(i);
    for(const auto* f = begin; f != end; ++f)
    {
      const Triangle_shape_operator triangle(m_samples, frame, i, *f, 3);
      if(triangle.is_valid() && triangle.corner_area() > 0.)
        mean.add(triangle, triangle.corner_area());
    }
    return mean.is_valid() ? Curvature_estimate(status, mean.eigen(frame))
                           : Curvature_estimate(Estimation_status::DEGENERATE);
  }

private:
  const Face_graph_samples& m_samples;
};

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at the vertices of a triangle mesh by Rusinkiewicz's method \cgalCite{rusinkiewicz} (thesis,
  section 5.1.2).

  The second fundamental form of each triangle is the one that, by least squares, best explains how the vertices'
  normals differ along its edges (5.1). That of a vertex is the mean of those of its triangles, each turned into the tangent plane
  of the vertex, and weighted with the part of the triangle that belongs to the vertex (the mixed area of M. Meyer et
  al., Discrete differential-geometry operators for triangulated 2-manifolds, 2003). The principal curvatures and
  directions are its eigenvalues and eigenvectors.

  One of the fastest estimators (`batagelo_wu_curvatures()` is the fastest). The result is as good as the normals; with exact
  ones its error falls with the square of the edge length on regular meshes, and linearly on others. With normals computed
  from the mesh it doesn't vanish on irregular meshes.

  Triangles without an area, or with points or normals that are not finite, count for nothing.

  \scConcurrencyTag
  \tparam FaceGraph a model of `FaceListGraph`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh. All its faces must be triangles.
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scMeshOutputParameters
    \scMeshInputParameters
    \scCallbackParameter
  \cgalNamedParamsEnd

  \return the number of vertices that could not be estimated. Their values are quiet NaN, their status says why.

  \throws std::invalid_argument if a face is not a triangle

  Complexity: linear in the size of the mesh.

  \cgalExample{curvature/rusinkiewicz_curvatures.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
std::size_t rusinkiewicz_curvatures(const FaceGraph& mesh,
                                    const NamedParameters& np = parameters::default_values())
{
  return internal::estimate_from_triangles<ConcurrencyTag, internal::Rusinkiewicz_estimator>(mesh, np);
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at one vertex of a triangle mesh: those that `rusinkiewicz_curvatures()` of the whole mesh
  gives, bit for bit.

  \param v the vertex
  \param mesh the mesh. Its faces near the vertex must be triangles.
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scVertexOutputParameters
    \scMeshInputParameters
  \cgalNamedParamsEnd

  \return whether the curvatures were estimated, or why not

  \throws std::invalid_argument if a face near the vertex is not a triangle

  Complexity: that of the neighborhood, whatever the size of the mesh.
*/
template <typename FaceGraph, typename NamedParameters = parameters::Default_named_parameters>
Estimation_status rusinkiewicz_curvatures(typename internal::Vertex_descriptor<FaceGraph>::type v,
                                          const FaceGraph& mesh,
                                          const NamedParameters& np = parameters::default_values())
{
  return internal::estimate_from_triangles<internal::Rusinkiewicz_estimator>(v, mesh, np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_RUSINKIEWICZ_CURVATURES_H
