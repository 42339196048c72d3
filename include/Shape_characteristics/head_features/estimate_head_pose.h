#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_ESTIMATE_HEAD_POSE_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_ESTIMATE_HEAD_POSE_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/head_features/Head_pose.h>
#include <Shape_characteristics/head_features/Head_verdict.h>
#include <Shape_characteristics/head_features/internal/pose_mean_head.h>
#include <Shape_characteristics/head_features/internal/pose_mirror.h>
#include <Shape_characteristics/head_features/internal/pose_points_of.h>
#include <Shape_characteristics/head_features/internal/pose_search.h>
#include <Shape_characteristics/head_features/internal/pose_surface.h>
#include <Shape_characteristics/internal/callback_of.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/internal/point_set_parameters.h>
#include <Shape_characteristics/internal/to_eigen.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// Sets verdict, obstacle and confidence. The limits leave room on both sides. Over heads, the agreement of the face with the mean head
// is .68 to .95, and .6 to .9 where the mouth is open, that of the nose above .5, that of the cranium above .9. Over other
// shapes but masks, where the cranium agrees by .7 or more, that of the nose is at most .33; elsewhere, that of the face is at most .68.
template <typename Kernel>
void judge_pose(const Placement_fit& fit, const Eigen::Vector3d& upward, Head_pose<Kernel>& pose)
{
  const double face = .5 * (fit.left + fit.right), weaker = (std::min)(fit.left, fit.right);
  // where all of a cranium is there as well, a face may be a rarer one
  const double leniency = .1 * (std::min)((std::max)((fit.cranium - .7) / .2, 0.), 1.), sure = .7 - leniency,
               possible = .66 - leniency;
  if(fit.score < 0.)
  {
    pose.obstacle = Head_obstacle::NO_NOSE;
    return;
  }
  if((std::max)(fit.left, fit.right) > sure && weaker < .45)
    pose.obstacle = Head_obstacle::FACE_IS_INCOMPLETE;
  else if(face < possible || fit.nose < .5)
    pose.obstacle = Head_obstacle::SHAPE_DISAGREES;
  else if(!upward.isZero() && fit.placement.rotation.col(1).dot(upward) < .5)
    pose.obstacle = Head_obstacle::WRONG_WAY_UP;
  else if(fit.cranium < .3)
  {
    // a mask, or a head with a high hat: then the face has to be convincing
    pose.obstacle = Head_obstacle::SHAPE_DISAGREES;
    if(face > sure + .05)
      pose.verdict = Head_verdict::UNCERTAIN;
  }
  else if(face < sure)
  {
    pose.obstacle = Head_obstacle::SHAPE_DISAGREES;
    pose.verdict = Head_verdict::UNCERTAIN;
  }
  else
  {
    pose.obstacle = Head_obstacle::NONE;
    pose.verdict = Head_verdict::HEAD;
  }
  const double confidence = (std::min)(1., (std::max)(0., (face - .6) / .25));
  if(pose.verdict == Head_verdict::HEAD)
    pose.confidence = confidence;
  else if(pose.verdict == Head_verdict::UNCERTAIN)
    pose.confidence = (std::min)(confidence, .3);
}

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

template <typename Kernel, typename NamedParameters>
Head_pose<Kernel>
head_pose_of(const Pose_points& points, const NamedParameters& np, const bool is_reversed = false)
{
  using FT = typename Kernel::FT;
  const Eigen::Vector3d upward = upward_direction_of(np);
  const std::function<bool(double)> callback = callback_of(np);
  Head_pose<Kernel> pose;
  const auto is_cancelled = [&](const double advancement)
  {
    if(!callback || callback(advancement))
      return false;
    pose.obstacle = Head_obstacle::CANCELLED;
    return true;
  };
  if(is_cancelled(0.))
    return pose;
  const Pose_surface surface(points);
  if(!surface.is_valid())
    return pose;
  if(surface.is_inside_out() && !is_reversed)
  {
    // nothing stands out of it as a nose does; the other way round, it may tell what is wrong
    pose = head_pose_of<Kernel>(reversed(points), np, true);
    if(pose.verdict != Head_verdict::NOT_A_HEAD)
      pose.obstacle = Head_obstacle::INSIDE_OUT;
    pose.verdict = Head_verdict::NOT_A_HEAD;
    pose.confidence = 0.;
    return pose;
  }
  const Mirror_search mirrors(surface);
  const std::vector<Mirror_fit> planes = mirrors.run();
  if(is_cancelled(.4))
    return pose;
  const Pose_search search(surface, Mean_head::standard());
  const Placement_fit fit = search.run(mirrors, planes);
  if(is_cancelled(1.))
    return pose;
  judge_pose(fit, upward, pose);
  // a face that is seen from the side has two thirds of it on both
  if(pose.verdict != Head_verdict::NOT_A_HEAD &&
     mirrors.assess(fit.placement.mirror(), search.samples_of_face(fit.placement), .03 * fit.placement.scale)
             .support < .5)
  {
    pose.verdict = Head_verdict::NOT_A_HEAD;
    pose.obstacle = Head_obstacle::NO_SYMMETRY;
    pose.confidence = 0.;
  }
  if(fit.score < 0.)
    return pose;

  // x = center + size * (scale * rotation * m + translation) for m in the frame of the head
  const Head_placement& place = fit.placement;
  const double size = place.scale * surface.size();
  const Eigen::Matrix3d linear = place.rotation.transpose() / size;
  const Eigen::Vector3d middle = surface.center() + surface.size() * place.translation,
                        shift = -(linear * middle), axis = place.rotation.col(0);
  pose.size = size;
  const auto a = [&](const int row, const int column) { return FT(linear(row, column)); };
  pose.transformation =
      CGAL::Aff_transformation_3<Kernel>(a(0, 0), a(0, 1), a(0, 2), FT(shift[0]), a(1, 0), a(1, 1), a(1, 2),
                                         FT(shift[1]), a(2, 0), a(2, 1), a(2, 2), FT(shift[2]));
  pose.symmetry_plane =
      typename Kernel::Plane_3(FT(axis[0]), FT(axis[1]), FT(axis[2]), FT(-axis.dot(middle)));
  // near where the mean head has the tip of its nose, the point that is farthest to the front, and a little upward: lips and
  // moustaches may reach farther
  const Eigen::Vector3d forward = place.rotation.col(2) + .2 * place.rotation.col(1),
                        expected = place(Mean_head::standard().nose_tip());
  double farthest = -std::numeric_limits<double>::infinity();
  Eigen::Vector3d tip = expected;
  for(std::size_t i = 0; i < surface.all().points.size(); ++i)
  {
    const Eigen::Vector3d& p = surface.all().points[i];
    if(surface.all().numbers[i] != Pose_points::none && (p - expected).norm() < .09 * place.scale &&
       p.dot(forward) > farthest)
    {
      farthest = p.dot(forward);
      tip = p;
    }
  }
  tip = surface.center() + surface.size() * tip;
  pose.nose_tip = typename Kernel::Point_3(FT(tip[0]), FT(tip[1]), FT(tip[2]));
  return pose;
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
    \scCallbackParameter
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
  return internal::head_pose_of<Kernel>(internal::pose_points_of_mesh<ConcurrencyTag>(mesh, np), np);
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
    \scCallbackParameter
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
  return internal::head_pose_of<Kernel>(internal::pose_points_of_range<ConcurrencyTag>(points, np), np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_ESTIMATE_HEAD_POSE_H
