#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_HEAD_POSE_OF_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_HEAD_POSE_OF_H

#include <Shape_characteristics/head_features/Head_feature.h>
#include <Shape_characteristics/head_features/Head_pose.h>
#include <Shape_characteristics/head_features/Head_verdict.h>
#include <Shape_characteristics/head_features/internal/pose_mean_head.h>
#include <Shape_characteristics/head_features/internal/pose_mirror.h>
#include <Shape_characteristics/head_features/internal/pose_search.h>
#include <Shape_characteristics/head_features/internal/pose_surface.h>
#include <Shape_characteristics/internal/affine_conversions.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
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

// `upward`: of length 1, or zero where it isn't known
template <typename Kernel>
Head_pose<Kernel> head_pose_of(const Pose_points& points,
                               const Eigen::Vector3d& upward,
                               const std::function<bool(double)>& callback,
                               const bool is_reversed = false)
{
  using FT = typename Kernel::FT;
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
  // those without a number lie between vertices
  const std::vector<std::uint32_t>& numbers = surface.all().numbers;
  const auto between = std::size_t(std::count(numbers.begin(), numbers.end(), Pose_points::none));
  if(numbers.size() - between < number_of_head_features)
    return pose;
  if(surface.is_inside_out() && !is_reversed)
  {
    // nothing stands out of it as a nose does; the other way round, it may tell what is wrong
    pose = head_pose_of<Kernel>(reversed(points), upward, callback, true);
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
  const Eigen::Vector3d middle = surface.center() + surface.size() * place.translation,
                        axis = place.rotation.col(0);
  Eigen::Affine3d to_frame = Eigen::Affine3d::Identity();
  to_frame.linear() = place.rotation.transpose() / size;
  to_frame.translation() = -(to_frame.linear() * middle);
  pose.size = size;
  pose.transformation = affine_to_cgal<Kernel>(to_frame);
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
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_HEAD_POSE_OF_H
