#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_DETECT_HEAD_FEATURES_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_DETECT_HEAD_FEATURES_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/head_features/Head_feature_method.h>
#include <Shape_characteristics/head_features/Head_features.h>
#include <Shape_characteristics/head_features/Head_pose.h>
#include <Shape_characteristics/head_features/estimate_head_pose.h>
#include <Shape_characteristics/head_features/head_descriptors.h>
#include <Shape_characteristics/head_features/internal/Head_feature_finder.h>
#include <Shape_characteristics/head_features/internal/Thesis_head_features.h>
#include <Shape_characteristics/head_features/internal/pitch_of_features.h>
#include <Shape_characteristics/internal/is_face_graph.h>

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Dynamic_property_map.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// A mesh as the detection sees it: in the frame of the head, without triangles that have corners nowhere.
template <typename FaceGraph>
struct Head_of_mesh
{
  using Vertex_descriptor = typename boost::graph_traits<FaceGraph>::vertex_descriptor;

  Head_surface surface;
  std::vector<Vertex_descriptor> descriptors;             // of the vertices
  Eigen::Affine3d to_frame = Eigen::Affine3d::Identity(); // a similarity

  template <typename VertexPointMap>
  Head_of_mesh(const FaceGraph& mesh, const VertexPointMap& vpm)
  {
    auto index_map = get(CGAL::dynamic_vertex_property_t<Head_surface::Index>(), mesh);
    for(const Vertex_descriptor v : vertices(mesh))
    {
      put(index_map, v, Head_surface::Index(descriptors.size()));
      descriptors.push_back(v);
      surface.points.push_back(to_eigen(get(vpm, v)));
    }
    for(const auto f : faces(mesh))
    {
      std::array<Head_surface::Index, 3> t{};
      std::size_t k = 0;
      bool is_finite = true;
      for(const Vertex_descriptor v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      {
        if(k == 3)
          ++k;
        if(k > 3)
          break;
        t[k] = get(index_map, v);
        is_finite = is_finite && surface.points[t[k]].allFinite();
        ++k;
      }
      if(k != 3)
        throw std::invalid_argument("Shape_characteristics: detect_head_features() needs a triangle mesh");
      if(is_finite)
        surface.triangles.push_back(t);
    }
  }

  void transform(const Eigen::Affine3d& motion)
  {
    for(Eigen::Vector3d& p : surface.points)
      p = motion * p;
    to_frame = motion * to_frame;
  }

  // of the vertices of triangles
  Eigen::AlignedBox3d box() const
  {
    Eigen::AlignedBox3d result;
    for(const auto& t : surface.triangles)
      for(const auto v : t)
        result.extend(surface.points[v]);
    return result;
  }

  // Turns all triangles if the surface is inside out: seen from the back of its box, a head or a scan of a face faces away.
  void orient()
  {
    const Eigen::AlignedBox3d b = box();
    const Eigen::Vector3d back(b.center().x(), b.center().y(), b.min().z());
    double volume = 0.;
    for(const auto& [i, j, k] : surface.triangles)
      volume += (surface.points[i] - back).dot((surface.points[j] - back).cross(surface.points[k] - back));
    if(volume < 0.)
      for(auto& t : surface.triangles)
        std::swap(t[1], t[2]);
  }

  // scales and moves the surface so that its box has the center 0 and the longest side 1
  void fit_box()
  {
    const Eigen::AlignedBox3d b = box();
    if(b.isEmpty() || !(b.sizes().maxCoeff() > 0.))
      return;
    Eigen::Affine3d motion = Eigen::Affine3d::Identity();
    motion.scale(1. / b.sizes().maxCoeff()).translate(-b.center());
    transform(motion);
  }
};

template <typename Kernel>
Eigen::Affine3d affine_to_eigen(const CGAL::Aff_transformation_3<Kernel>& motion)
{
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 4; ++j)
      result.matrix()(i, j) = CGAL::to_double(motion.m(i, j));
  return result;
}

template <typename Kernel>
CGAL::Aff_transformation_3<Kernel> affine_to_cgal(const Eigen::Affine3d& motion)
{
  using FT = typename Kernel::FT;
  const auto m = [&](const int i, const int j) { return FT(motion.matrix()(i, j)); };
  return {m(0, 0), m(0, 1), m(0, 2), m(0, 3), m(1, 0), m(1, 1),
          m(1, 2), m(1, 3), m(2, 0), m(2, 1), m(2, 2), m(2, 3)};
}

// the number of vertices that a parameter of the thesis's method gives
template <typename Parameter>
std::size_t number_of_thesis_vertices(const Parameter& given, const char* message)
{
  const auto number = static_cast<std::int64_t>(given);
  if(number < 1)
    throw std::invalid_argument(message);
  return static_cast<std::size_t>(number);
}

} // namespace internal

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

  `Head_feature_method::THESIS` is chapter 9 to the letter, for comparison: vertices alone, each the one with the greatest measure
  (9.1) to (9.6). Its errors are its own: with the printed radius of 0.6 the chin is the tip of the nose, and no mouth is found
  between the two. It answers whatever the mesh is, and its confidences are all 1.

  Nothing depends on the unit and the place of the mesh, nor, up to the accuracy of its estimate, on the pose.

  \scConcurrencyTag
  \tparam FaceGraph a model of `FaceListGraph`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh. All its faces must be triangles. They may all be inside out, but for the thesis's method.
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{vertex_point_map}
      \cgalParamDescription{the points of the vertices}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `%Point_3`}
      \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
    \cgalParamNEnd
    \cgalParamNBegin{head_pose}
      \cgalParamDescription{the pose of the head; its transformation and its verdict are taken as they are}
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

  \return the feature points and regions. Vertices with points that aren't finite are left out, with their faces.

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
  using Point_3 = typename Kernel::Point_3;
  using FT = typename Kernel::FT;
  using Result = Head_features<FaceGraph, Kernel>;
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::is_default_parameter;
  constexpr double height_in_pose = .905; // of a head, from top to chin, in the unit of a pose
  constexpr double top_to_nose = .641;    // in heights of the head

  const Head_feature_method method =
      choose_parameter(get_parameter(np, internal_np::head_feature_method), Head_feature_method::SURFACE);
  const bool is_aligned = choose_parameter(get_parameter(np, internal_np::head_is_aligned), false);
  internal::Thesis_head_features::Options options;
  if(method == Head_feature_method::THESIS)
  {
    options.eye_vertices = internal::number_of_thesis_vertices(
        choose_parameter(get_parameter(np, internal_np::number_of_eye_vertices), 0),
        "Shape_characteristics: the thesis's method needs number_of_eye_vertices, at least 1");
    options.nose_vertices = internal::number_of_thesis_vertices(
        choose_parameter(get_parameter(np, internal_np::number_of_nose_vertices), 0),
        "Shape_characteristics: the thesis's method needs number_of_nose_vertices, at least 1");
    options.ear_vertices = internal::number_of_thesis_vertices(
        choose_parameter(get_parameter(np, internal_np::number_of_ear_vertices), 0),
        "Shape_characteristics: the thesis's method needs number_of_ear_vertices, at least 1");
    options.detection_radius = choose_parameter(get_parameter(np, internal_np::detection_radius), 0.);
    if(!(options.detection_radius >= 0.))
      throw std::invalid_argument("Shape_characteristics: detection_radius must not be negative");
  }

  const auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                    CGAL::get_const_property_map(CGAL::vertex_point, mesh));
  internal::Head_of_mesh<FaceGraph> head(mesh, vpm);
  Result result;
  if(head.surface.triangles.empty())
    return result;

  // the frame, about where the tip of the nose is in it, and about how high the head is
  Eigen::Vector3d nose = Eigen::Vector3d::Zero();
  double height = 0.;
  bool is_pose_estimated = false;
  if(is_aligned)
  {
    result.verdict = Head_verdict::HEAD;
    result.obstacle = Head_obstacle::NONE;
    head.fit_box();
    const double middle = head.box().center().x();
    double forward = -std::numeric_limits<double>::infinity();
    for(const auto& t : head.surface.triangles)
      for(const auto v : t)
      {
        const Eigen::Vector3d& p = head.surface.points[v];
        if(std::abs(p.x() - middle) < .1 && p.z() + .2 * p.y() > forward)
        {
          forward = p.z() + .2 * p.y();
          nose = p;
        }
      }
    height = (head.box().max().y() - nose.y()) / top_to_nose;
  }
  else
  {
    Head_pose<Kernel> pose;
    if constexpr(is_default_parameter<NamedParameters, internal_np::head_pose_t>::value)
    {
      pose = estimate_head_pose<ConcurrencyTag>(mesh, parameters::vertex_point_map(vpm));
      is_pose_estimated = true;
    }
    else
      pose = get_parameter(np, internal_np::head_pose);
    result.verdict = pose.verdict;
    result.obstacle = pose.obstacle;
    if(!pose.is_head())
      return result;
    head.transform(internal::affine_to_eigen(pose.transformation));
    nose = internal::affine_to_eigen(pose.transformation) * internal::to_eigen(pose.nose_tip);
    height = height_in_pose;
    if(method == Head_feature_method::THESIS)
      head.fit_box();
  }
  result.transformation = internal::affine_to_cgal<Kernel>(head.to_frame);
  const double scale = std::cbrt(std::abs(head.to_frame.linear().determinant()));

  if(method == Head_feature_method::THESIS)
  {
    auto descriptor_map = get(CGAL::dynamic_vertex_property_t<Head_descriptor>(), mesh);
    Head_pose<Kernel> box; // its size is the unit of the averaging radius
    box.size = 1. / scale;
    const auto common =
        parameters::vertex_point_map(vpm)
            .vertex_head_descriptor_map(descriptor_map)
            .head_pose(box)
            .averaging_radius(choose_parameter(get_parameter(np, internal_np::averaging_radius), .01));
    if constexpr(is_default_parameter<NamedParameters, internal_np::curvature_estimator_t>::value)
      head_descriptors<ConcurrencyTag>(mesh, common);
    else
      head_descriptors<ConcurrencyTag>(
          mesh, common.curvature_estimator(get_parameter(np, internal_np::curvature_estimator)));
    std::vector<Head_descriptor> described;
    described.reserve(head.descriptors.size());
    for(const auto v : head.descriptors)
      described.push_back(get(descriptor_map, v));
    const internal::Thesis_head_features found(head.surface.points, described, options);
    result.is_head = true;
    for(std::size_t k = 0; k < number_of_head_features; ++k)
      if(found.points[k] != internal::Thesis_head_features::none)
        result.points[k] = {true, get(vpm, head.descriptors[found.points[k]]),
                            head.descriptors[found.points[k]], 1.};
    for(std::size_t k = 0; k < number_of_head_regions; ++k)
    {
      std::vector<std::size_t> region = found.regions[k];
      std::sort(region.begin(), region.end());
      for(const std::size_t v : region)
        result.regions[k].vertices.push_back(head.descriptors[v]);
      result.regions[k].is_found = !region.empty();
      result.regions[k].confidence = region.empty() ? 0. : 1.;
    }
    const auto &top = result[Head_feature::TOP], &chin = result[Head_feature::CHIN];
    if(top.is_found && chin.is_found)
      result.head_height = (internal::to_eigen(top.position) - internal::to_eigen(chin.position)).norm();
    return result;
  }

  head.orient();
  double found_height = 0.;
  const auto find_features = [&]()
  {
    internal::Head_feature_finder finder(head.surface, nose, height);
    internal::Found_head_features features = finder.find();
    found_height = finder.height();
    return features;
  };
  internal::Found_head_features found = find_features();
  if(is_pose_estimated)
  {
    // features tell the pitch better than the surface does, and what is highest, or foremost, depends on it
    const Eigen::Affine3d turn(
        Eigen::AngleAxisd(-internal::pitch_of_features(found), Eigen::Vector3d::UnitX()));
    head.transform(turn);
    nose = turn * nose;
    result.transformation = internal::affine_to_cgal<Kernel>(head.to_frame);
    found = find_features();
  }
  const auto is_sure = [&](const Head_region r) { return found[r].is_found() && found[r].confidence > .2; };
  if(!is_sure(Head_region::LEFT_EYE) && !is_sure(Head_region::RIGHT_EYE) && !is_sure(Head_region::MOUTH))
  {
    // a head without a face, or what was said to be an aligned head and isn't
    if(is_aligned)
      result.verdict = Head_verdict::NOT_A_HEAD;
    result.obstacle =
        found[Head_feature::NOSE_TIP].is_found() ? Head_obstacle::SHAPE_DISAGREES : Head_obstacle::NO_NOSE;
    result.is_head = result.verdict == Head_verdict::HEAD;
    return result;
  }
  result.is_head = true;
  result.head_height = found_height / scale;
  const Eigen::Affine3d back = head.to_frame.inverse();
  for(std::size_t k = 0; k < number_of_head_features; ++k)
  {
    if(!found.points[k].is_found())
      continue;
    const Eigen::Vector3d &q = found.points[k].position(), p = back * q;
    const auto& t = head.surface.triangles[found.points[k].place.triangle];
    const auto nearest = *std::min_element(
        t.begin(), t.end(),
        [&](const auto a, const auto b)
        { return (head.surface.points[a] - q).squaredNorm() < (head.surface.points[b] - q).squaredNorm(); });
    result.points[k] = {true, Point_3(FT(p.x()), FT(p.y()), FT(p.z())), head.descriptors[nearest],
                        found.points[k].confidence};
  }
  for(std::size_t k = 0; k < number_of_head_regions; ++k)
  {
    for(const auto v : found.regions[k].vertices)
      result.regions[k].vertices.push_back(head.descriptors[v]);
    result.regions[k].is_found = found.regions[k].is_found();
    result.regions[k].confidence = found.regions[k].confidence;
  }
  return result;
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_DETECT_HEAD_FEATURES_H
