#ifndef SHAPE_CHARACTERISTICS_NORMALS_HRBF_NORMALS_H
#define SHAPE_CHARACTERISTICS_NORMALS_HRBF_NORMALS_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/internal/write_normals.h>
#include <Shape_characteristics/interpolation/fit_hermite_rbf.h>
#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

template <typename ConcurrencyTag, typename SampledSurface, typename NamedParameters>
std::vector<Normal_estimate>
hrbf_normal_estimates(SampledSurface& surface, std::size_t size, const NamedParameters& np)
{
  return fit_hermite_rbf<ConcurrencyTag, Normal_estimate>(
      surface, size,
      [](std::size_t, const Local_implicit_surface& local)
      {
        Normal_estimate estimate;
        estimate.status = local.status;
        if(is_estimated(local.status))
          estimate.normal = local.gradient.normalized();
        return estimate;
      },
      np);
}

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsNormals

  re-estimates the normals at the vertices of a mesh by Hermite radial basis functions: the normal is the
  direction of the gradient of the function that was fitted to points and normals around the vertex (thesis, section
  8.3).

  On smooth surfaces the result is better by orders of magnitude than the weighted sums of face normals that it starts
  from, and makes every estimator that needs normals better.

  \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or `CGAL::Parallel_if_available_tag` (default)
  \tparam FaceGraph a model of `FaceListGraph`
  \tparam VertexNormalMap a model of `WritablePropertyMap` with
          `boost::graph_traits<FaceGraph>::%vertex_descriptor` as key type and `%Vector_3` as value type
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh
  \param normals the property map in which the unit normals are written, by one thread and after the
         computation: it may be the one that is given as `vertex_normal_map`
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters": `vertex_status_map`, `callback`, and those that
         describe the input and the fit of `hrbf_curvatures()`. `vertex_normal_map` gives the normals to start from; `normals_are_exact`
         should not be set.

  \return the number of vertices without an estimate; quiet NaN is written for them.

  \throws std::invalid_argument as `hrbf_curvatures()`

  \cgalExample{normals/hrbf_normals.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename VertexNormalMap,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
std::size_t hrbf_normals(const FaceGraph& mesh,
                         VertexNormalMap normals,
                         const NamedParameters& np = parameters::default_values())
{
  Face_graph_samples surface = sampled_surface<ConcurrencyTag>(mesh, internal::mesh_neighborhood(np), np);
  const auto estimates = internal::hrbf_normal_estimates<ConcurrencyTag>(surface, surface.size(), np);
  return internal::write_normals_to_mesh(mesh, normals, estimates, np);
}

/*!
  \ingroup PkgShapeCharacteristicsNormals

  re-estimates the normal at one vertex of a mesh.

  \param v the vertex
  \param mesh the mesh
  \param[out] normal the unit normal; quiet NaN if there is none
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters", as for the whole mesh

  \return whether there is a normal, or why not

  \throws std::invalid_argument as for the whole mesh
*/
template <typename FaceGraph,
          typename Vector_3,
          typename NamedParameters = parameters::Default_named_parameters>
Estimation_status hrbf_normals(typename internal::Vertex_descriptor<FaceGraph>::type v,
                               const FaceGraph& mesh,
                               Vector_3& normal,
                               const NamedParameters& np = parameters::default_values())
{
  Face_graph_samples surface =
      sampled_surface(v, mesh, internal::mesh_neighborhood(np), internal::reach_of_hermite_rbf(np), np);
  const auto estimates = internal::hrbf_normal_estimates<CGAL::Sequential_tag>(surface, 1, np);
  normal = internal::to_vector<Vector_3>(estimates[0].normal);
  return estimates[0].status;
}

/*!
  \ingroup PkgShapeCharacteristicsNormals

  re-estimates the normals of a point set.

  \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or `CGAL::Parallel_if_available_tag` (default)
  \tparam PointRange a model of `ConstRange`
  \tparam NormalMap a model of `WritablePropertyMap` with the value type of the range as key type and `%Vector_3` as
          value type
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param points the point set
  \param normals the property map in which the unit normals are written, by one thread and after the
         computation: it may be the one that is given as `normal_map`
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters": `status_map`, `callback`, and those that
         describe the input and the fit of `hrbf_curvatures()`

  \return the number of points without an estimate; quiet NaN is written for them.

  \throws std::invalid_argument as for meshes, and if there is no normal map
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename PointRange,
          typename NormalMap,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_point_range<PointRange> >,
          typename = void>
std::size_t
hrbf_normals(PointRange&& points, NormalMap normals, const NamedParameters& np = parameters::default_values())
{
  Point_set_samples surface = sampled_surface(points, internal::point_set_neighborhood(np), np);
  const auto estimates = internal::hrbf_normal_estimates<ConcurrencyTag>(surface, surface.size(), np);
  return internal::write_normals_to_points(points, normals, estimates, np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_NORMALS_HRBF_NORMALS_H
