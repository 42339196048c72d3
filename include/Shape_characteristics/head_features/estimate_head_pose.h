#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_ESTIMATE_HEAD_POSE_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_ESTIMATE_HEAD_POSE_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/head_features/Head_pose.h>
#include <Shape_characteristics/internal/is_face_graph.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <type_traits>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsHeadFeatures

  finds out whether a mesh is a human head, and in which pose: from any rotation, in any unit.
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
auto estimate_head_pose(const FaceGraph& mesh, const NamedParameters& np = parameters::default_values())
    -> Head_pose<typename CGAL::GetGeomTraits<FaceGraph, NamedParameters>::type>;

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_ESTIMATE_HEAD_POSE_H
