#ifndef SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ESTIMATE_FROM_TRIANGLES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ESTIMATE_FROM_TRIANGLES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/curvature/internal/estimate_curvatures.h>
#include <Shape_characteristics/curvature/internal/write_curvatures.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <cstddef>

namespace Shape_characteristics {
namespace internal {

// What an estimator that looks at the triangles at a vertex alone says of all vertices of a mesh, and of one.

template <typename ConcurrencyTag, typename Estimator, typename FaceGraph, typename NamedParameters>
std::size_t estimate_from_triangles(const FaceGraph& mesh, const NamedParameters& np)
{
  const Face_graph_samples samples = sampled_surface<ConcurrencyTag>(mesh, Neighborhood::rings(1), np,
                                                                     Face_graph_samples::Connectivity::FACES);
  const Estimator estimator(samples, np);
  return estimate_vertices<ConcurrencyTag>(mesh, samples, estimator, np);
}

template <typename Estimator, typename FaceGraph, typename NamedParameters>
Estimation_status estimate_from_triangles(typename Vertex_descriptor<FaceGraph>::type v,
                                          const FaceGraph& mesh,
                                          const NamedParameters& np)
{
  const Face_graph_samples samples = sampled_surface(v, mesh, Neighborhood::rings(1), 1, np);
  const Estimator estimator(samples, np);
  typename Estimator::Workspace workspace;
  return write_to_references(estimator(0, workspace), np);
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ESTIMATE_FROM_TRIANGLES_H
