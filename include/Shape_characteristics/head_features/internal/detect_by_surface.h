#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_DETECT_BY_SURFACE_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_DETECT_BY_SURFACE_H

#include <Shape_characteristics/head_features/Head_features.h>
#include <Shape_characteristics/head_features/Head_verdict.h>
#include <Shape_characteristics/head_features/internal/Found_head_features.h>
#include <Shape_characteristics/head_features/internal/Head_feature_finder.h>
#include <Shape_characteristics/head_features/internal/Head_of_mesh.h>
#include <Shape_characteristics/head_features/internal/pitch_of_features.h>
#include <Shape_characteristics/internal/affine_conversions.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace Shape_characteristics {
namespace internal {

// About where the tip of the nose is, and how high the head: in the frame of a `Head_of_mesh`.
struct Expected_head
{
  Eigen::Vector3d nose_tip = Eigen::Vector3d::Zero();
  double height = 0.;
};

// Of a head that is aligned, in its box of size 1: the tip of its nose is what reaches farthest to the front, and a little upward,
// near the middle.
template <typename FaceGraph>
Expected_head expected_in_box(const Head_of_mesh<FaceGraph>& head)
{
  constexpr double top_to_nose = .641; // in heights of the head

  Expected_head result;
  const double middle = head.box().center().x();
  double forward = -std::numeric_limits<double>::infinity();
  for(const auto& t : head.surface.triangles)
    for(const auto v : t)
    {
      const Eigen::Vector3d& p = head.surface.points[v];
      if(std::abs(p.x() - middle) < .1 && p.z() + .2 * p.y() > forward)
      {
        forward = p.z() + .2 * p.y();
        result.nose_tip = p;
      }
    }
  result.height = (head.box().max().y() - result.nose_tip.y()) / top_to_nose;
  return result;
}

// Finds features and regions where the surface has the shape of them, in the frame of `head`: it is turned if the pose was estimated.
// Without a face, which false says, nothing is found.
template <typename FaceGraph, typename Kernel>
bool detect_by_surface(Head_of_mesh<FaceGraph>& head,
                       Expected_head expected,
                       const bool is_pose_estimated,
                       Head_features<FaceGraph, Kernel>& result)
{
  using Point_3 = typename Kernel::Point_3;
  using FT = typename Kernel::FT;

  const double scale = head.scale();
  head.orient();
  double found_height = 0.;
  const auto find_features = [&]()
  {
    Head_feature_finder finder(head.surface, expected.nose_tip, expected.height);
    Found_head_features features = finder.find();
    found_height = finder.height();
    return features;
  };
  Found_head_features found = find_features();
  if(is_pose_estimated)
  {
    // features tell the pitch better than the surface does, and what is highest, or foremost, depends on it
    const Eigen::Affine3d turn(Eigen::AngleAxisd(-pitch_of_features(found), Eigen::Vector3d::UnitX()));
    head.transform(turn);
    expected.nose_tip = turn * expected.nose_tip;
    result.transformation = affine_to_cgal<Kernel>(head.to_frame);
    found = find_features();
  }
  const auto is_sure = [&](const Head_region r) { return found[r].is_found() && found[r].confidence > .2; };
  if(!is_sure(Head_region::LEFT_EYE) && !is_sure(Head_region::RIGHT_EYE) && !is_sure(Head_region::MOUTH))
  {
    result.obstacle =
        found[Head_feature::NOSE_TIP].is_found() ? Head_obstacle::SHAPE_DISAGREES : Head_obstacle::NO_NOSE;
    return false;
  }
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
  return true;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_DETECT_BY_SURFACE_H
