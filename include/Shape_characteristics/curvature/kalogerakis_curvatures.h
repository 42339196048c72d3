#ifndef SHAPE_CHARACTERISTICS_CURVATURE_KALOGERAKIS_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_KALOGERAKIS_CURVATURES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/internal/Kalogerakis_estimator.h>
#include <Shape_characteristics/curvature/internal/estimate_curvatures.h>
#include <Shape_characteristics/curvature/internal/write_curvatures.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <cstddef>
#include <type_traits>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at the vertices of a mesh by robust statistics \cgalCite{kalogerakis} (thesis, section 5.1.3).

  Every pair of points in the neighborhood of a vertex, the vertex included, is a sample of the shape operator: it takes the
  difference of the points in the tangent plane to the difference of their normals. Samples that don't fit, of noise or
  from beyond a feature line, get small weights:
  - the first guess is the one whose residuals at the vertex have the least median, of three fits by least squares (to the
    nearest points, to the nearer ones, and to all) and of fits to the vertex and two neighbors;
  - reweighted least squares refine it, with the weights of Geman's and McClure's M-estimator. The deviation comes
    from the first guess's median of residuals. Samples farther than three deviations are cut off, unless almost all that
    tell of the bend in one direction would be, as along rows of long triangles: then all count alike;
  - the normal of each sample is estimated anew, as the mean of its own and of what the normals of its neighbors and the shape
    operator say of it, with the weights of the fit, so that it is never smoothed across a feature. All of this is done
    `number_of_passes` times before the curvatures are estimated.

  So normals are not trusted: exact ones are no great advantage. On smooth surfaces the result is one of a fit by least
  squares, and its error falls with the square of the size of the neighborhood on regular meshes. The shape parameters of
  the paper that learn weights for boundaries are replaced by the cut-off.

  \scConcurrencyTag
  \tparam FaceGraph a model of `FaceListGraph`; faces may have any number of vertices
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scMeshOutputParameters
    \scMeshInputParameters
    \cgalParamNBegin{number_of_rings}
      \cgalParamDescription{the size of the neighborhood, in edges}
      \cgalParamType{`unsigned int`}
      \cgalParamDefault{`2`}
      \cgalParamExtra{Where the neighbors are fewer than three, or on a line, up to two rings are added. If that isn't
                      enough, the status is `FEW_NEIGHBOURS` or `DEGENERATE`.}
    \cgalParamNEnd
    \scRadiusOfMeshParameter
    \cgalParamNBegin{number_of_passes}
      \cgalParamDescription{how often normals are estimated anew}
      \cgalParamType{`unsigned int`}
      \cgalParamDefault{`2`}
      \cgalParamExtra{One pass is more accurate where the input is clean, and none where normals are exact; more passes
                      smooth more.}
    \cgalParamNEnd
    \scCallbackParameter
  \cgalNamedParamsEnd

  The directions are orthogonal to the normal that was estimated anew, that of `kalogerakis_normals()`. The
  callback sees what comes after the passes.

  \return the number of vertices that could not be estimated. Their values are quiet NaN, their status says why.

  \throws std::invalid_argument if `number_of_rings`, `neighbor_radius` or `number_of_passes` is out of its range

  Complexity: \f$ O(n m^2) \f$ for \f$ n \f$ vertices with neighborhoods of \f$ m \f$.

  \cgalExample{curvature/kalogerakis_curvatures.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
std::size_t kalogerakis_curvatures(const FaceGraph& mesh,
                                   const NamedParameters& np = parameters::default_values())
{
  Face_graph_samples surface = sampled_surface<ConcurrencyTag>(mesh, internal::mesh_neighborhood(np), np);
  const internal::Kalogerakis_estimator<Face_graph_samples> estimator(
      surface, internal::passes_of_kalogerakis(np, 0), ConcurrencyTag());
  return internal::estimate_vertices<ConcurrencyTag>(mesh, surface, estimator, np);
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at one vertex of a mesh: those that `kalogerakis_curvatures()` of the whole mesh gives, bit for
  bit.

  \param v the vertex
  \param mesh the mesh
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters": `number_of_rings`, `neighbor_radius`
         and `number_of_passes` as for the whole mesh, and the ones listed below

  \cgalNamedParamsBegin
    \scVertexOutputParameters
    \scMeshInputParameters
  \cgalNamedParamsEnd

  \return whether the curvatures were estimated, or why not

  \throws std::invalid_argument as for the whole mesh

  Complexity: that of the neighborhoods of the vertex, of its neighbors, and of theirs, once for each pass, whatever the size of
  the mesh.
*/
template <typename FaceGraph, typename NamedParameters = parameters::Default_named_parameters>
Estimation_status kalogerakis_curvatures(typename internal::Vertex_descriptor<FaceGraph>::type v,
                                         const FaceGraph& mesh,
                                         const NamedParameters& np = parameters::default_values())
{
  using Estimator = internal::Kalogerakis_estimator<Face_graph_samples>;
  const unsigned int passes = internal::passes_of_kalogerakis(np, 0);
  Face_graph_samples surface = sampled_surface(v, mesh, internal::mesh_neighborhood(np), passes + 1, np);
  const Estimator estimator(surface, passes);
  typename Estimator::Workspace workspace;
  return internal::write_to_references(estimator(0, workspace), np);
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at the points of a point set with normals, as `kalogerakis_curvatures()` of a mesh does.

  \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or `CGAL::Parallel_if_available_tag` (default)
  \tparam PointRange a model of `ConstRange`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param points the point set
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scPointSetOutputParameters
    \scPointSetInputParameters
    \cgalParamNBegin{number_of_neighbors}
      \cgalParamDescription{the size of the neighborhood: as many nearest points}
      \cgalParamType{`unsigned int`}
      \cgalParamDefault{`18`}
      \cgalParamExtra{With fewer than three, every status is `FEW_NEIGHBOURS`. With all of them in one
                      row, as in scans whose rows are far apart, it is `DEGENERATE`.}
    \cgalParamNEnd
    \scRadiusOfPointSetParameter
    \cgalParamNBegin{number_of_passes}
      \cgalParamDescription{how often normals are estimated anew}
      \cgalParamType{`unsigned int`}
      \cgalParamDefault{`2`}
      \cgalParamExtra{One pass is more accurate where the input is clean, and none where normals are exact; more passes
                      smooth more.}
    \cgalParamNEnd
    \scCallbackParameter
  \cgalNamedParamsEnd

  \return the number of points that could not be estimated. Their values are quiet NaN, their status says why.

  \throws std::invalid_argument as for meshes, and if there is no normal map

  Complexity: \f$ O(n (\log n + m^2)) \f$ for \f$ n \f$ points with neighborhoods of \f$ m \f$.
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_point_range<PointRange> >,
          typename = void>
std::size_t kalogerakis_curvatures(PointRange&& points,
                                   const NamedParameters& np = parameters::default_values())
{
  Point_set_samples surface = sampled_surface(points, internal::point_set_neighborhood(np), np);
  const internal::Kalogerakis_estimator<Point_set_samples> estimator(
      surface, internal::passes_of_kalogerakis(np, 0), ConcurrencyTag());
  return internal::estimate_points<ConcurrencyTag>(points, surface.size(), estimator, np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_KALOGERAKIS_CURVATURES_H
