#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_DETECT_SYMMETRY_PLANE_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_DETECT_SYMMETRY_PLANE_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/head_features/Symmetry_detection.h>
#include <Shape_characteristics/head_features/internal/pose_mirror.h>
#include <Shape_characteristics/head_features/internal/pose_points_of.h>
#include <Shape_characteristics/head_features/internal/pose_surface.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/internal/point_set_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

template <typename Kernel>
typename Kernel::Plane_3 plane_of_mirror(const Mirror& mirror, const Pose_surface& surface)
{
  using FT = typename Kernel::FT;
  const Eigen::Vector3d &n = mirror.normal, point = surface.center() + surface.size() * mirror.offset * n;
  return {FT(n[0]), FT(n[1]), FT(n[2]), FT(-n.dot(point))};
}

template <typename Kernel>
Symmetry_detection<Kernel> detect_symmetry_plane_of(const Pose_points& points)
{
  Symmetry_detection<Kernel> result;
  const Pose_surface surface(points);
  const std::vector<Mirror_fit> found = Mirror_search(surface).run();
  if(found.empty())
    return result;
  const auto candidate = [&](const Mirror_fit& f)
  {
    typename Symmetry_detection<Kernel>::Candidate c;
    c.plane = plane_of_mirror<Kernel>(f.mirror, surface);
    c.support = f.support;
    c.deviation = f.deviation * surface.size();
    return c;
  };
  result.best = candidate(found[0]);
  for(std::size_t k = 1; k < found.size(); ++k)
    result.alternatives.push_back(candidate(found[k]));
  // Any round shape has planes with which half of it agrees, none of them better than others. Where several are meant, they are good.
  const double second = found.size() > 1 ? found[1].evidence / found[0].evidence : 0.;
  if(found[0].support < .5 || (found[0].support < .8 && second > .9))
    return result;
  result.verdict = second > .9 ? Symmetry_verdict::SEVERAL : Symmetry_verdict::ONE;
  const double fit = (std::min)((found[0].evidence - .35) / .5, 1.),
               alone = 1. - second * second * second * second;
  result.confidence = (std::max)(fit, 0.) * (std::max)(alone, 0.);
  return result;
}

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsHeadFeatures

  finds the plane of symmetry of the surface of a mesh, after Sipiran et al. (I. Sipiran, R. Gregor, T. Schreck, Approximate
  symmetry detection in partial 3D meshes, Computer Graphics Forum 33, 2014).

  Samples of the surface with much Gaussian curvature are paired with those that are curved alike, at two scales, and whose
  normals are mirror images of each other. Each pair votes for the plane between its points. The planes with most votes, and those
  through the axes of inertia, are tried on samples of the whole surface, refined there by iterative closest points, and
  judged by the share of the surface that meets its own image: within 4 % of the radius of the shape (the largest distance of a
  point from the center), with normals at most 37° apart. So the plane needs to be neither near the center of mass nor
  exact, and parts may be missing on one side.

  Small pieces of the surface that are far from all else are left out: those of less than 1 % of the samples, behind a gap of more
  than a quarter of the median distance of samples from the middle. The curvatures and normals are averaged over 6 % of the
  radius, and the samples are evenly spread: noise and tessellation have little influence. Nothing depends on the unit, the place
  and the pose of the shape, up to the choice of samples.

  \scConcurrencyTag
  \tparam FaceGraph a model of `FaceListGraph`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scMeshInputParameters
    \cgalParamNBegin{vertex_principal_curvatures_and_directions_map}
      \cgalParamDescription{the principal curvatures of the vertices, which are read here}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `Principal_curvatures_and_directions<GeomTraits>` or the type
                     of the same name of \cgal 6}
      \cgalParamDefault{estimated by `rusinkiewicz_curvatures()`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return the plane and the verdict. Vertices that aren't finite are left out; with less than 100 samples of the surface the
          verdict is `NONE`. Large faces have samples within, so that a box of twelve triangles has enough.

  \throws std::invalid_argument if curvatures are to be estimated and a face is not a triangle

  Complexity: \f$ O(n \log n) \f$ for \f$ n \f$ vertices; the search is among 2500 samples at most.

  \cgalExample{head_features/symmetry_plane.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
auto detect_symmetry_plane(const FaceGraph& mesh, const NamedParameters& np = parameters::default_values())
    -> Symmetry_detection<typename CGAL::GetGeomTraits<FaceGraph, NamedParameters>::type>
{
  using Kernel = typename CGAL::GetGeomTraits<FaceGraph, NamedParameters>::type;
  return internal::detect_symmetry_plane_of<Kernel>(internal::pose_points_of_mesh<ConcurrencyTag>(mesh, np));
}

/*!
  \ingroup PkgShapeCharacteristicsHeadFeatures

  finds the plane of symmetry of a point set with normals, as `detect_symmetry_plane()` of a mesh does.

  \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or `CGAL::Parallel_if_available_tag` (default)
  \tparam PointRange a model of `ConstRange`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param points the point set
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scPointSetInputParameters
    \cgalParamNBegin{principal_curvatures_and_directions_map}
      \cgalParamDescription{the principal curvatures of the points, which are read here}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `Principal_curvatures_and_directions<GeomTraits>` or the type
                     of the same name of \cgal 6}
      \cgalParamDefault{estimated by `hrbf_curvatures()` with its default neighborhood}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return the plane and the verdict

  \throws std::invalid_argument if there is no normal map

  Complexity: \f$ O(n \log n) \f$ for \f$ n \f$ points; the search is among 2500 samples at most.
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_point_range<PointRange> >,
          typename = void>
auto detect_symmetry_plane(const PointRange& points, const NamedParameters& np = parameters::default_values())
    -> Symmetry_detection<typename internal::Point_set_helper<PointRange, NamedParameters>::Geom_traits>
{
  using Kernel = typename internal::Point_set_helper<PointRange, NamedParameters>::Geom_traits;
  return internal::detect_symmetry_plane_of<Kernel>(
      internal::pose_points_of_range<ConcurrencyTag>(points, np));
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_DETECT_SYMMETRY_PLANE_H
