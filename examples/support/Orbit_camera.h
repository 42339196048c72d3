#ifndef SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_ORBIT_CAMERA_H
#define SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_ORBIT_CAMERA_H

#include "Mesh_renderer.h"

#include <Shape_characteristics/screen_space/Camera.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace support {

/// A camera that looks at the middle of a box, and is moved around it.
class Orbit_camera
{
public:
  /// Looks from where `view` says, from as far away as the ball around the box fills the picture's shorter side. Its field of view is that of the
  /// height of the picture.
  Orbit_camera(const CGAL::Bbox_3& box, const Camera& view)
    : center_(.5 * (box.xmin() + box.xmax()), .5 * (box.ymin() + box.ymax()), .5 * (box.zmin() + box.zmax())),
      radius_(.5 * std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin())),
      angle_(view.field_of_view * CGAL_PI / 180)
  {
    radius_ = radius_ > 0 && std::isfinite(radius_) ? radius_ : 1;
    backwards_ = Eigen::Vector3d(view.towards_eye[0], view.towards_eye[1], view.towards_eye[2]).normalized();
    const Eigen::Vector3d up(view.up[0], view.up[1], view.up[2]);
    up_ = (up - up.dot(backwards_) * backwards_).normalized();
  }

  double radius() const { return radius_; } ///< of the ball around the box

  /// Turns about the middle: `right` and `up` in radians.
  void turn(double right, double up)
  {
    const Eigen::AngleAxisd about_up(-right, up_);
    backwards_ = about_up * backwards_;
    const Eigen::AngleAxisd about_right(-up, up_.cross(backwards_).normalized());
    backwards_ = (about_right * backwards_).normalized();
    up_ = about_right * up_;
    up_ = (up_ - up_.dot(backwards_) * backwards_).normalized();
  }

  /// Moves away (`factor` > 1) or nearer.
  void move(double factor) { factor_ = std::clamp(factor_ * factor, .05, 50.); }

  Shape_characteristics::Camera camera(int width, int height) const
  {
    using Result = Shape_characteristics::Camera;
    const double aspect = double(width) / double(height);
    const double shorter = aspect < 1 ? std::atan(std::tan(.5 * angle_) * aspect) : .5 * angle_;
    const double distance = factor_ * radius_ / std::sin(shorter);
    const double near = std::max(distance - 1.01 * radius_, .01 * distance);
    return Result(Result::look_at(center_ + distance * backwards_, center_, up_),
                  Result::perspective(angle_, aspect, near, distance + 1.01 * radius_));
  }

private:
  Eigen::Vector3d center_, backwards_, up_;
  double radius_, angle_, factor_ = 1;
};

} // namespace support

#endif
