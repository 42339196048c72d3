#ifndef SHAPE_CHARACTERISTICS_CURVATURE_HRBF_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_HRBF_CURVATURES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/internal/shape_operator.h>
#include <Shape_characteristics/curvature/internal/write_curvatures.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/interpolation/fit_hermite_rbf.h>
#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

template <typename ConcurrencyTag, typename SampledSurface, typename NamedParameters>
std::vector<Curvature_estimate>
hrbf_estimates(SampledSurface& surface, std::size_t size, const NamedParameters& np)
{
  return fit_hermite_rbf<ConcurrencyTag, Curvature_estimate>(
      surface, size,
      [](std::size_t, const Local_implicit_surface& local)
      {
        return is_estimated(local.status)
                   ? Curvature_estimate(local.status, curvatures_of_implicit(local.gradient, local.hessian))
                   : Curvature_estimate(local.status);
      },
      np);
}

} // namespace internal

template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
std::size_t hrbf_curvatures(const FaceGraph& mesh, const NamedParameters& np = parameters::default_values())
{
  Face_graph_samples surface = sampled_surface<ConcurrencyTag>(mesh, internal::mesh_neighborhood(np), np);
  auto estimates = internal::hrbf_estimates<ConcurrencyTag>(surface, surface.size(), np);
  internal::mark_duplicates(surface, estimates);
  return internal::write_to_mesh(mesh, estimates, np);
}

template <typename FaceGraph, typename NamedParameters = parameters::Default_named_parameters>
Estimation_status hrbf_curvatures(typename internal::Vertex_descriptor<FaceGraph>::type v,
                                  const FaceGraph& mesh,
                                  const NamedParameters& np = parameters::default_values())
{
  Face_graph_samples surface =
      sampled_surface(v, mesh, internal::mesh_neighborhood(np), internal::reach_of_hermite_rbf, np);
  const auto estimates = internal::hrbf_estimates<CGAL::Sequential_tag>(surface, 1, np);
  return internal::write_to_references(estimates[0], np);
}

template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_point_range<PointRange> >,
          typename = void>
std::size_t hrbf_curvatures(PointRange&& points, const NamedParameters& np = parameters::default_values())
{
  Point_set_samples surface = sampled_surface(points, internal::point_set_neighborhood(np), np);
  const auto estimates = internal::hrbf_estimates<ConcurrencyTag>(surface, surface.size(), np);
  return internal::write_to_points(points, estimates, np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_HRBF_CURVATURES_H
