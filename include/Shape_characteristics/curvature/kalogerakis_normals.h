#ifndef SHAPE_CHARACTERISTICS_CURVATURE_KALOGERAKIS_NORMALS_H
#define SHAPE_CHARACTERISTICS_CURVATURE_KALOGERAKIS_NORMALS_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/curvature/internal/Kalogerakis_estimator.h>
#include <Shape_characteristics/internal/callback_of.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/internal/write_normals.h>
#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <cstddef>
#include <functional>
#include <type_traits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

template <typename ConcurrencyTag, typename SampledSurface, typename NamedParameters>
std::vector<Normal_estimate> kalogerakis_normal_estimates(SampledSurface& surface, const NamedParameters& np)
{
  const std::function<bool(double)> callback = callback_of(np);
  const Kalogerakis_estimator<SampledSurface> estimator(surface, passes_of_kalogerakis(np, 1),
                                                        ConcurrencyTag(), callback);
  std::vector<Normal_estimate> estimates(surface.size());
  for(std::size_t i = 0; i < surface.size(); ++i)
    estimates[i] = estimator.normal(i);
  return estimates;
}

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  re-estimates the normals at the vertices of a mesh by robust statistics \cgalCite{kalogerakis} (thesis, sections 5.1.3 and
  8.3): those from which `kalogerakis_curvatures()` estimates its curvatures.

  A normal is the mean of itself and of what the normals of its neighbors and the shape operator that was fitted to them say of
  it, with the weights of the fit: what lies beyond a feature line has none. This is done `number_of_passes` times. Noise of the
  normals is averaged away; clean ones on a smooth surface don't get better, since they are taken to change linearly within
  a neighborhood.

  \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or `CGAL::Parallel_if_available_tag` (default)
  \tparam FaceGraph a model of `FaceListGraph`
  \tparam VertexNormalMap a model of `WritablePropertyMap` with
          `boost::graph_traits<FaceGraph>::%vertex_descriptor` as key type and `%Vector_3` as value type
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh
  \param normals the property map in which the unit normals are written, by one thread and after the
         computation: it may be the one that is given as `vertex_normal_map`
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters": `vertex_status_map`, `number_of_passes` (at least 1;
         2 by default), `callback`, and those that describe the input and the neighborhood of `kalogerakis_curvatures()`.
         `vertex_normal_map` gives the normals to start from.

  \return the number of vertices without an estimate; quiet NaN is written for them.

  \throws std::invalid_argument as `kalogerakis_curvatures()`, and if `number_of_passes` is 0

  Complexity: \f$ O(n m^2) \f$ for \f$ n \f$ vertices with neighborhoods of \f$ m \f$.

  \cgalExample{curvature/kalogerakis_normals.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename VertexNormalMap,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
std::size_t kalogerakis_normals(const FaceGraph& mesh,
                                VertexNormalMap normals,
                                const NamedParameters& np = parameters::default_values())
{
  Face_graph_samples surface = sampled_surface<ConcurrencyTag>(mesh, internal::mesh_neighborhood(np), np);
  const auto estimates = internal::kalogerakis_normal_estimates<ConcurrencyTag>(surface, np);
  return internal::write_normals_to_mesh(mesh, normals, estimates, np);
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  re-estimates the normal at one vertex of a mesh: the one that `kalogerakis_normals()` of the whole mesh gives, bit for bit.

  \param v the vertex
  \param mesh the mesh
  \param[out] normal the unit normal; quiet NaN if there is none
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters", as for the whole mesh

  \return whether there is a normal, or why not

  \throws std::invalid_argument as for the whole mesh

  Complexity: that of the neighborhoods of the vertex, of its neighbors and of theirs, once for each pass, whatever the size of the mesh.
*/
template <typename FaceGraph,
          typename Vector_3,
          typename NamedParameters = parameters::Default_named_parameters>
Estimation_status kalogerakis_normals(typename internal::Vertex_descriptor<FaceGraph>::type v,
                                      const FaceGraph& mesh,
                                      Vector_3& normal,
                                      const NamedParameters& np = parameters::default_values())
{
  using Estimator = internal::Kalogerakis_estimator<Face_graph_samples>;
  const unsigned int passes = internal::passes_of_kalogerakis(np, 1);
  Face_graph_samples surface = sampled_surface(v, mesh, internal::mesh_neighborhood(np), passes + 1, np);
  const internal::Normal_estimate estimate = Estimator(surface, passes).normal(0);
  normal = internal::to_vector<Vector_3>(estimate.normal);
  return estimate.status;
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  re-estimates the normals of a point set, as `kalogerakis_normals()` of a mesh does.

  \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or `CGAL::Parallel_if_available_tag` (default)
  \tparam PointRange a model of `ConstRange`
  \tparam NormalMap a model of `WritablePropertyMap` with the value type of the range as key type and `%Vector_3` as
          value type
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param points the point set
  \param normals the property map in which the unit normals are written, by one thread and after the
         computation: it may be the one that is given as `normal_map`
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters": `status_map`, `number_of_passes` (at least 1; 2 by
         default), `callback`, and those that describe the input and the neighborhood of `kalogerakis_curvatures()`

  \return the number of points without an estimate; quiet NaN is written for them.

  \throws std::invalid_argument as for meshes, and if there is no normal map

  Complexity: \f$ O(n (\log n + m^2)) \f$ for \f$ n \f$ points with neighborhoods of \f$ m \f$.
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename PointRange,
          typename NormalMap,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_point_range<PointRange> >,
          typename = void>
std::size_t kalogerakis_normals(PointRange&& points,
                                NormalMap normals,
                                const NamedParameters& np = parameters::default_values())
{
  Point_set_samples surface = sampled_surface(points, internal::point_set_neighborhood(np), np);
  const auto estimates = internal::kalogerakis_normal_estimates<ConcurrencyTag>(surface, np);
  return internal::write_normals_to_points(points, normals, estimates, np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_KALOGERAKIS_NORMALS_H
