#ifndef SHAPE_CHARACTERISTICS_CURVATURE_TAUBIN_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_TAUBIN_CURVATURES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/internal/One_ring.h>
#include <Shape_characteristics/curvature/internal/Triangle_shape_operator.h>
#include <Shape_characteristics/curvature/internal/estimate_from_triangles.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>

#include <Eigen/Core>

#include <cstddef>
#include <type_traits>

namespace Shape_characteristics {
namespace internal {

class Taubin_estimator
{
public:
  struct Workspace
  {
    Face_graph_samples::Workspace neighbors;
    One_ring::Workspace ring;
  };

  template <typename NamedParameters>
  Taubin_estimator(const Face_graph_samples& samples, const NamedParameters&) : m_samples(samples)
  {
    require_triangles(samples, "taubin_curvatures");
  }

  Curvature_estimate operator()(std::size_t i, Workspace& workspace) const
  {
    const Estimation_status status = status_at_vertex(m_samples, i, workspace.neighbors);
    if(!is_estimated(status))
      return Curvature_estimate(status);

    const Tangent_frame frame(m_samples.normal(i));
    const One_ring ring(m_samples, i, workspace.ring);
    double m_11 = 0., m_12 = 0., m_22 = 0., weights = 0.;
    // Each triangle counts with its area at both of its edges: an edge has the areas of the two triangles that it is in.
    const auto add = [&](const Eigen::Vector3d& edge, double square, double weight)
    {
      const double u = edge.dot(frame.t1), v = edge.dot(frame.t2), tangential = u * u + v * v;
      if(!(tangential > 0.))
        return; // along the normal: no direction
      const double factor = weight * (-2. * edge.dot(frame.normal) / square) / tangential;
      m_11 += factor * u * u;
      m_12 += factor * u * v;
      m_22 += factor * v * v;
      weights += weight;
    };
    for(const Ring_triangle& t : ring.triangles())
    {
      add(t.a, t.aa, t.doubled_area);
      add(t.b, t.bb, t.doubled_area);
    }
    if(!(weights > 0.))
      return Curvature_estimate(Estimation_status::DEGENERATE);
    const double factor = ring.scale() / weights;
    return Curvature_estimate(status, eigen_of_shape_operator(frame.normal, factor * (3. * m_11 - m_22),
                                                              4. * factor * m_12, factor * (3. * m_22 - m_11),
                                                              frame.t1, frame.t2));
  }

private:
  const Face_graph_samples& m_samples;
};

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at the vertices of a triangle mesh from the normal curvatures along its edges
  \cgalCite{taubin} (thesis, section 5.2.1).

  The edge \f$ d \f$ from a vertex to its neighbor tells the normal curvature \f$ \kappa = -2 \, n \cdot d / \lVert d \rVert^2 \f$ in the
  direction \f$ t \f$ of its projection on the tangent plane: that of the circle through both points with the normal \f$ n \f$. The
  matrix \f$ M = \sum w \, \kappa \, t t^T \f$, with weights that are the areas of the two triangles at the edge and add up to one, has the
  eigenvalues \f$ m_1 \f$ and \f$ m_2 \f$ in the tangent plane. The principal curvatures are \f$ 3 m_1 - m_2 \f$ and \f$ 3 m_2 - m_1 \f$, the
  directions are the eigenvectors.

  That is right if all directions have the same weight, as around a regular vertex of degree six. On irregular meshes
  the error doesn't vanish when the mesh is refined, not even on a sphere: curvatures leak from one direction into
  the other. The normals matter as much as they do in any method with one ring of neighbors.

  At a border the directions of the edges that there are have to do, which is right for half of a regular ring.
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

  \cgalExample{curvature/taubin_curvatures.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
std::size_t taubin_curvatures(const FaceGraph& mesh, const NamedParameters& np = parameters::default_values())
{
  return internal::estimate_from_triangles<ConcurrencyTag, internal::Taubin_estimator>(mesh, np);
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at one vertex of a triangle mesh: those that `taubin_curvatures()` of the whole mesh gives,
  bit for bit.

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
Estimation_status taubin_curvatures(typename internal::Vertex_descriptor<FaceGraph>::type v,
                                    const FaceGraph& mesh,
                                    const NamedParameters& np = parameters::default_values())
{
  return internal::estimate_from_triangles<internal::Taubin_estimator>(v, mesh, np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_TAUBIN_CURVATURES_H
