#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_DETECT_HEAD_FEATURES_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_DETECT_HEAD_FEATURES_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/head_features/Head_feature_method.h>
#include <Shape_characteristics/head_features/Head_features.h>
#include <Shape_characteristics/head_features/Head_pose.h>
#include <Shape_characteristics/head_features/Head_verdict.h>
#include <Shape_characteristics/head_features/estimate_head_pose.h>
#include <Shape_characteristics/head_features/internal/Head_of_mesh.h>
#include <Shape_characteristics/head_features/internal/Thesis_head_features.h>
#include <Shape_characteristics/head_features/internal/detect_by_surface.h>
#include <Shape_characteristics/head_features/internal/detect_by_thesis.h>
#include <Shape_characteristics/internal/affine_conversions.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/internal/to_eigen.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <Eigen/Geometry>

#include <type_traits>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsHeadFeatures

  finds the feature points and the regions of a human head: eyes, nose, mouth and ears (thesis, chapter 9).

  The pose of the head is estimated first (`estimate_head_pose()`), unless it is given or the head is said to be aligned. What isn't
  a head has no features. Of a pose that was estimated, the pitch is corrected by where the features are, and they are found anew in
  the corrected one: it decides what is highest, and foremost.

  `Head_feature_method::SURFACE`, the default, looks at the surface from the front, from above and from both sides. The proportions
  of heads say where a feature is to be looked for, the shape of the surface says where it is: lids end where the ball of the eye,
  or the hole for it, begins; the mouth is the deepest crease below the nose, followed to both sides until it fades, or an opening;
  ears are what the sharpest folds at the side of the head enclose; the points of the midline are where its profile is bent. Points
  are found between vertices, and no parameter counts vertices: the result hardly depends on the tessellation. What isn't there
  (ears under hair, the top of a scan of a face) is not found. The face must not be turned away by more than about 10 degrees in
  the given pose. N5 to N8 are on the sides of the nose where the proportions of heads put them, at the height of N3 and N4. R1 to R4
  are where an ear is nearest to the corners of the outer side of its box, in the mean over some thousandths of the head's height, and
  R5 is near the mean of these.

  `Head_feature_method::THESIS` is chapter 9 to the letter, for comparison: vertices alone, those with the greatest measure of
  (9.1) and (9.4) to (9.6), and with the smallest of (9.2) and (9.3). ((9.1) is taken as its text says; that eyes are spherical,
  which the text says as well, would ask for the smallest.) Its errors are its own: with the printed radius of 0.6 the chin is the
  tip of the nose, and no mouth is found between the two. Where the pose of a head is given or the mesh is said to be an aligned
  head, it answers whatever the mesh is, and its confidences are all 1.

  Nothing depends on the unit and the place of the mesh, nor, up to the accuracy of its estimate, on the pose.

  \scConcurrencyTag
  \tparam FaceGraph a model of `FaceListGraph`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh. All its faces must be triangles. Where the pose is given or the head is said to be aligned, they may all be inside
         out, but for the thesis's method; where it is estimated, such a head has the obstacle `INSIDE_OUT`.
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{vertex_point_map}
      \cgalParamDescription{the points of the vertices}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `%Point_3`}
      \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
    \cgalParamNEnd
    \cgalParamNBegin{geom_traits}
      \cgalParamDescription{an instance of a geometric traits class}
      \cgalParamType{a model of `Kernel`}
      \cgalParamDefault{deduced from the point type}
    \cgalParamNEnd
    \cgalParamNBegin{head_pose}
      \cgalParamDescription{the pose of the head: its transformation, its verdict, its obstacle and, but for the thesis's method, its
                            `nose_tip`, near which the search begins, are taken as they are. Nothing is found unless the verdict is
                            `HEAD`. Not read if `head_is_aligned`.}
      \cgalParamType{`Head_pose`}
      \cgalParamDefault{found by `estimate_head_pose()`}
    \cgalParamNEnd
    \cgalParamNBegin{head_is_aligned}
      \cgalParamDescription{whether the nose points towards +z and the top towards +y, and the mesh is a head: no pose is estimated}
      \cgalParamType{`bool`}
      \cgalParamDefault{`false`}
    \cgalParamNEnd
    \cgalParamNBegin{head_feature_method}
      \cgalParamDescription{how features are looked for}
      \cgalParamType{`Head_feature_method`}
      \cgalParamDefault{`Head_feature_method::SURFACE`}
    \cgalParamNEnd
    \cgalParamNBegin{curvature_estimator}
      \cgalParamDescription{what estimates the curvatures of the thesis's method, see `head_descriptors()`}
      \cgalParamType{a function object that is called with the mesh and named parameters}
      \cgalParamDefault{`rusinkiewicz_curvatures()`}
    \cgalParamNEnd
    \cgalParamNBegin{averaging_radius}
      \cgalParamDescription{over what radius the thesis's method averages descriptors, in units of the head's box}
      \cgalParamType{`double`}
      \cgalParamDefault{`0.01`}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_eye_vertices}
      \cgalParamDescription{the thesis's N: of how many vertices both eyes consist; needed by its method}
      \cgalParamType{an integer type}
      \cgalParamDefault{none}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_nose_vertices}
      \cgalParamDescription{the thesis's M: of how many vertices the nose consists; needed by its method}
      \cgalParamType{an integer type}
      \cgalParamDefault{none}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_ear_vertices}
      \cgalParamDescription{of how many vertices an ear consists; needed by the thesis's method}
      \cgalParamType{an integer type}
      \cgalParamDefault{none}
    \cgalParamNEnd
    \cgalParamNBegin{detection_radius}
      \cgalParamDescription{the thesis's radius around a vertex of a region within which it has no other, in units of the head's box}
      \cgalParamType{`double`}
      \cgalParamDefault{`0`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return the feature points and regions. Vertices with points that aren't finite are left out, with their faces, and so are those without faces.

  \throws std::invalid_argument if a face is not a triangle; if a parameter is out of its range; if the thesis's method lacks a number
          of vertices

  Complexity: that of the pose, and linear in the size of the mesh.

  \cgalExample{head_features/head_features.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
auto detect_head_features(const FaceGraph& mesh, const NamedParameters& np = parameters::default_values())
    -> Head_features<FaceGraph, typename CGAL::GetGeomTraits<FaceGraph, NamedParameters>::type>
{
  using Kernel = typename CGAL::GetGeomTraits<FaceGraph, NamedParameters>::type;
  using parameters::choose_parameter;
  using parameters::get_parameter;
  constexpr double height_in_pose = .905; // of a head, from top to chin, in the unit of a pose

  const bool is_by_thesis = choose_parameter(get_parameter(np, internal_np::head_feature_method),
                                             Head_feature_method::SURFACE) == Head_feature_method::THESIS;
  const bool is_aligned = choose_parameter(get_parameter(np, internal_np::head_is_aligned), false);
  internal::Thesis_head_features::Options options;
  if(is_by_thesis)
    options = internal::thesis_options(np);

  const auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                    CGAL::get_const_property_map(CGAL::vertex_point, mesh));
  internal::Head_of_mesh<FaceGraph> head(mesh, vpm);
  Head_features<FaceGraph, Kernel> result;
  if(head.surface.triangles.empty())
    return result;

  internal::Expected_head expected;
  bool is_pose_estimated = false;
  if(is_aligned)
  {
    result.verdict = Head_verdict::HEAD;
    result.obstacle = Head_obstacle::NONE;
    head.fit_box();
    expected = internal::expected_in_box(head);
  }
  else
  {
    Head_pose<Kernel> pose;
    if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::head_pose_t>::value)
    {
      pose =
          estimate_head_pose<ConcurrencyTag>(mesh, parameters::vertex_point_map(vpm).geom_traits(Kernel()));
      is_pose_estimated = true;
    }
    else
      pose = get_parameter(np, internal_np::head_pose);
    result.verdict = pose.verdict;
    result.obstacle = pose.obstacle;
    if(!pose.is_head())
      return result;
    const Eigen::Affine3d to_pose = internal::affine_to_eigen(pose.transformation);
    head.transform(to_pose);
    expected.nose_tip = to_pose * internal::to_eigen(pose.nose_tip);
    expected.height = height_in_pose;
    if(is_by_thesis)
      head.fit_box();
  }
  result.transformation = internal::affine_to_cgal<Kernel>(head.to_frame);

  bool has_features = false;
  if(head.is_soup())
    result.obstacle = Head_obstacle::DUPLICATE;
  else if(is_by_thesis)
  {
    internal::detect_by_thesis<ConcurrencyTag>(mesh, head, options, np, result);
    has_features = true;
  }
  else
    has_features = internal::detect_by_surface(head, expected, is_pose_estimated, result);
  if(is_aligned && !has_features) // what was said to be a head
    result.verdict = Head_verdict::NOT_A_HEAD;
  result.is_head = has_features || result.verdict == Head_verdict::HEAD;
  return result;
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_DETECT_HEAD_FEATURES_H
