#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_NOSE_TIP_CANDIDATES_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_NOSE_TIP_CANDIDATES_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/head_features/Nose_tip_candidate.h>
#include <Shape_characteristics/head_features/internal/pose_mean_head.h>
#include <Shape_characteristics/head_features/internal/pose_mirror.h>
#include <Shape_characteristics/head_features/internal/pose_points_of.h>
#include <Shape_characteristics/head_features/internal/pose_search.h>
#include <Shape_characteristics/head_features/internal/pose_surface.h>
#include <Shape_characteristics/internal/is_face_graph.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <set>
#include <type_traits>
#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsHeadFeatures

  finds the places of a mesh that stand out like the tip of a nose (thesis, section 9.1.1).

  As in the work of Yang et al. that the thesis follows, a tip is where all of the surroundings lie below the tangent plane, and farther
  than anywhere nearby. The surroundings are balls with 13 % and 22 % of the radius of the shape. On a head, ears,
  lips, the chin and the ends of the collar bones are among them; those that aren't on the plane of symmetry, by
  Nose_tip_candidate::asymmetry, can't be the nose, as the thesis says. `estimate_head_pose()` tries the others.

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

  \return the candidates, the most prominent first; none if there are too few points

  \throws std::invalid_argument if curvatures are to be estimated and a face is not a triangle

  Complexity: \f$ O(n \log n) \f$ for \f$ n \f$ vertices; the search is among 2500 samples at most.

  \cgalExample{head_features/head_pose.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
auto nose_tip_candidates(const FaceGraph& mesh, const NamedParameters& np = parameters::default_values())
    -> std::vector<Nose_tip_candidate<typename CGAL::GetGeomTraits<FaceGraph, NamedParameters>::type> >
{
  using Kernel = typename CGAL::GetGeomTraits<FaceGraph, NamedParameters>::type;
  using FT = typename Kernel::FT;
  std::vector<Nose_tip_candidate<Kernel> > result;
  const internal::Pose_surface surface(internal::pose_points_of_mesh<ConcurrencyTag>(mesh, np));
  if(!surface.is_valid())
    return result;
  const std::vector<internal::Mirror_fit> mirrors = internal::Mirror_search(surface).run();
  std::set<std::size_t> samples;
  for(const internal::Nose_candidate& c :
      internal::Pose_search(surface, internal::Mean_head::standard()).noses())
  {
    if(!samples.insert(c.sample).second)
      continue; // stands out of the other ball, too, by less
    const Eigen::Vector3d p = surface.center() + surface.size() * surface.points()[c.sample],
                          &n = surface.normals()[c.sample];
    Nose_tip_candidate<Kernel> candidate;
    candidate.point = typename Kernel::Point_3(FT(p[0]), FT(p[1]), FT(p[2]));
    candidate.normal = typename Kernel::Vector_3(FT(n[0]), FT(n[1]), FT(n[2]));
    candidate.prominence = c.prominence;
    if(!mirrors.empty())
      candidate.asymmetry = std::abs(mirrors[0].mirror.height(surface.points()[c.sample]));
    result.push_back(candidate);
  }
  return result;
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_NOSE_TIP_CANDIDATES_H
