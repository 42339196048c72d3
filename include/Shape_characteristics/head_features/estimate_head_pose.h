#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_ESTIMATE_HEAD_POSE_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_ESTIMATE_HEAD_POSE_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/head_features/Head_pose.h>
#include <Shape_characteristics/head_features/internal/head_pose_of.h>
#include <Shape_characteristics/head_features/internal/pose_points_of.h>
#include <Shape_characteristics/internal/callback_of.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/internal/point_set_parameters.h>
#include <Shape_characteristics/internal/to_eigen.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <stdexcept>
#include <type_traits>

namespace Shape_characteristics {
namespace internal {

// the upward direction of the named parameters, of unit length; zero if there is none
template <typename NamedParameters>
Eigen::Vector3d upward_direction_of(const NamedParameters& np)
{
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::upward_direction_t>::value)
  {
    const Eigen::Vector3d upward =
        to_eigen(parameters::get_parameter(np, internal_np::upward_direction)).stableNormalized();
    if(!upward.allFinite() || upward.isZero())
      throw std::invalid_argument("Shape_characteristics: upward_direction must be finite and not zero");
    return upward;
  }
  else
    return Eigen::Vector3d::Zero();
}

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsHeadFeatures

  finds out whether a mesh is a human head, and in which pose: from any rotation, in any unit.

  As the thesis (section 9.1.1) proposes, the plane of symmetry comes from `detect_symmetry_plane()`, and the tip of the nose is one of
  `nose_tip_candidates()` on that plane. The five best planes and the ten most prominent tips on each are tried, with a mean head that is
  turned and scaled about the tip, and brought to the surface by iterative closest points; the placement where most of the mean
  head meets the surface, with the same normals, wins. Then

  - the plane of symmetry becomes that of the face alone, since shoulders, hair and the back of the head are less symmetric;
  - the pitch, which no single point determines, the scale and the center become those of the mean head's upper face after it was bent
    onto the surface: so they don't depend on the jaw, nor on what happens to be highest.

  The verdict depends on how well face, nose and cranium agree with the mean head, before and after it is bent, on each side, with
  its mouth closed or open. Caps and hair cost certainty; a face that is seen from 45° to the side is enough, half a face isn't. As a
  head may be turned in any way, one that is upside down is fine, and its pose tells so; where the way up is known, say it by
  `upward_direction`.

  Small pieces and points that are far from all else, as scanners leave them, are left out.

  The frame isn't the one in which another would have placed the head: faces differ, and what is "level" is a matter of
  definition. On heads of ICT-FaceKit that the mean head doesn't contain, pitch differs by some 2° from that model's (root mean
  square), yaw and roll by 0.3°; `detect_head_features()` knows the pitch better. The same head in another pose gets the same frame
  up to about a tenth of that.

  \scConcurrencyTag
  \tparam FaceGraph a model of `FaceListGraph`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh: a head, a bust, or the scan of a face
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scMeshInputParameters
    \cgalParamNBegin{vertex_principal_curvatures_and_directions_map}
      \cgalParamDescription{the principal curvatures of the vertices, which are read here}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `Principal_curvatures_and_directions<GeomTraits>` or the type
                     of the same name of \cgal 6}
      \cgalParamDefault{estimated by `rusinkiewicz_curvatures()`}
    \cgalParamNEnd
    \cgalParamNBegin{upward_direction}
      \cgalParamDescription{where the top of the head is, within 60°: a head that is the other way up is refused}
      \cgalParamType{`%Vector_3`}
      \cgalParamDefault{unknown: any way up will do}
    \cgalParamNEnd
    \scPoseCallbackParameter
  \cgalNamedParamsEnd

  \return the pose and the verdict. Vertices that aren't finite are left out; with less than 100 samples of the surface the
          verdict is `NOT_A_HEAD`.

  \throws std::invalid_argument if curvatures are to be estimated and a face is not a triangle, or `upward_direction` has no
          direction

  Complexity: \f$ O(n \log n) \f$ for \f$ n \f$ vertices; the search is among 2500 samples at most and takes about a second.

  \cgalExample{head_features/head_pose.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
auto estimate_head_pose(const FaceGraph& mesh, const NamedParameters& np = parameters::default_values())
    -> Head_pose<typename CGAL::GetGeomTraits<FaceGraph, NamedParameters>::type>
{
  using Kernel = typename CGAL::GetGeomTraits<FaceGraph, NamedParameters>::type;
  return internal::head_pose_of<Kernel>(internal::pose_points_of_mesh<ConcurrencyTag>(mesh, np),
                                        internal::upward_direction_of(np), internal::callback_of(np));
}

/*!
  \ingroup PkgShapeCharacteristicsHeadFeatures

  finds out whether a point set with normals is a human head, and in which pose, as `estimate_head_pose()` of a mesh does.

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
    \cgalParamNBegin{upward_direction}
      \cgalParamDescription{where the top of the head is, within 60°: a head that is the other way up is refused}
      \cgalParamType{`%Vector_3`}
      \cgalParamDefault{unknown: any way up will do}
    \cgalParamNEnd
    \scPoseCallbackParameter
  \cgalNamedParamsEnd

  \return the pose and the verdict

  \throws std::invalid_argument if there is no normal map, or `upward_direction` has no direction

  Complexity: \f$ O(n \log n) \f$ for \f$ n \f$ points
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_point_range<PointRange> >,
          typename = void>
auto estimate_head_pose(const PointRange& points, const NamedParameters& np = parameters::default_values())
    -> Head_pose<typename internal::Point_set_helper<PointRange, NamedParameters>::Geom_traits>
{
  using Kernel = typename internal::Point_set_helper<PointRange, NamedParameters>::Geom_traits;
  return internal::head_pose_of<Kernel>(internal::pose_points_of_range<ConcurrencyTag>(points, np),
                                        internal::upward_direction_of(np), internal::callback_of(np));
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_ESTIMATE_HEAD_POSE_H
