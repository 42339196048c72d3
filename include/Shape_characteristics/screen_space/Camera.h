#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_CAMERA_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_CAMERA_H

#include <Shape_characteristics/screen_space/Depth_convention.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsScreenSpace

  is where a picture was taken from and how: the view matrix, the projection matrix, and what its depths mean.

  View space has x to the right, y upwards, and z towards the viewer: what is seen has negative z. Its unit is that of the scene, so
  that curvatures come out in 1/unit of the scene.

  Everything is kept in double precision, and matrices are those of OpenGL, for column vectors. Those of a renderer with a view space
  that looks along +z, as Direct3D's is by custom, become such by \f$ D = \mathrm{diag}(1, 1, -1, 1) \f$: the view matrix by \f$ D V \f$, the
  projection by \f$ P D \f$.
*/
class Camera
{
public:
  /// a camera from the matrices of a renderer.
  ///
  /// \param view from world to view space: a rotation and a translation
  /// \param projection from view to clip space: perspective or orthographic, also off center, with a finite or
  ///        infinite far plane, with depth that grows or falls with the distance
  /// \param depth_convention what the depths of pictures of this camera mean. With `EYE_DISTANCE`, which doesn't tell from where to
  ///        where clip space reaches, it is from -1 to 1, but from 0 to 1 where a plane would else be behind the eye.
  ///
  /// \throws std::invalid_argument if `view` scales, shears or mirrors (by more than \f$ 10^{-4} \f$, which matrices of
  ///         single precision keep well), or if `projection` is neither perspective nor orthographic
  Camera(const Eigen::Matrix4d& view,
         const Eigen::Matrix4d& projection,
         Depth_convention depth_convention = Depth_convention::WINDOW_DEPTH)
    : m_view(view),
      m_projection(projection),
      m_depth_convention(depth_convention)
  {
    const auto require = [](const bool condition, const char* message)
    {
      if(!condition)
        throw std::invalid_argument(message);
    };
    require(view.allFinite() && projection.allFinite(),
            "Shape_characteristics: the matrices of a camera must be finite");
    const Eigen::Matrix3d r = view.topLeftCorner<3, 3>();
    require((r * r.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 1e-4 &&
                r.determinant() > 0. && view.row(3) == Eigen::RowVector4d(0., 0., 0., 1.),
            "Shape_characteristics: the view matrix of a camera must be a rotation and a translation");
    Eigen::Matrix4d& p = m_projection;
    const bool perspective = p(3, 2) != 0.;
    require(
        p(3, 0) == 0. && p(3, 1) == 0. && p(0, 1) == 0. && p(1, 0) == 0. && p(2, 0) == 0. && p(2, 1) == 0. &&
            p(0, 0) != 0. && p(1, 1) != 0. && (p(2, 2) != 0. || p(2, 3) != 0.) &&
            (perspective ? p(3, 2) < 0. && p(3, 3) == 0. && p(0, 3) == 0. && p(1, 3) == 0. && p(2, 3) != 0.
                         : p(3, 3) > 0. && p(0, 2) == 0. && p(1, 2) == 0. && p(2, 2) != 0.),
        "Shape_characteristics: the projection matrix of a camera must be perspective or orthographic, of a "
        "view space with what is seen at negative z");
    p /= perspective ? -p(3, 2) : p(3, 3);
    m_least_depth = depth_convention == Depth_convention::WINDOW_DEPTH_ZERO_TO_ONE ? 0. : -1.;
    if(depth_convention == Depth_convention::EYE_DISTANCE && perspective && !(near_plane() > 0.))
      m_least_depth = 0.;
  }

  /// a projection that looks like that of an eye, for `WINDOW_DEPTH`.
  ///
  /// \param vertical_field_of_view the angle between the upper and the lower border of the picture, in radians,
  ///        in (0, \f$ \pi \f$)
  /// \param aspect_ratio width of the picture divided by its height
  /// \param near_plane distance from which on things are seen, positive
  /// \param far_plane distance up to which things are seen
  /// \throws std::invalid_argument if a number is out of its range
  static Eigen::Matrix4d
  perspective(double vertical_field_of_view, double aspect_ratio, double near_plane, double far_plane)
  {
    if(!(vertical_field_of_view > 0. && vertical_field_of_view < CGAL_PI) ||
       !(aspect_ratio > 0. && std::isfinite(aspect_ratio)) ||
       !(near_plane > 0. && far_plane > near_plane && std::isfinite(far_plane)))
      throw std::invalid_argument(
          "Shape_characteristics: a perspective needs an angle in (0, pi), a positive ratio of the "
          "sides, and planes with 0 < near < far");
    const double slope = std::tan(0.5 * vertical_field_of_view);
    Eigen::Matrix4d p = Eigen::Matrix4d::Zero();
    p(0, 0) = 1. / (slope * aspect_ratio);
    p(1, 1) = 1. / slope;
    p(2, 2) = -(far_plane + near_plane) / (far_plane - near_plane);
    p(2, 3) = -2. * far_plane * near_plane / (far_plane - near_plane);
    p(3, 2) = -1.;
    return p;
  }

  /// a parallel projection, for `WINDOW_DEPTH`.
  ///
  /// \param height what the height of the picture is in the scene
  /// \param aspect_ratio width of the picture divided by its height
  /// \param near_plane distance from which on things are seen
  /// \param far_plane distance up to which things are seen
  /// \throws std::invalid_argument if a number is out of its range
  static Eigen::Matrix4d orthographic(double height, double aspect_ratio, double near_plane, double far_plane)
  {
    if(!(height > 0. && std::isfinite(height)) || !(aspect_ratio > 0. && std::isfinite(aspect_ratio)) ||
       !(far_plane > near_plane && std::isfinite(far_plane) && std::isfinite(near_plane)))
      throw std::invalid_argument(
          "Shape_characteristics: a parallel projection needs a positive height and ratio of the "
          "sides, and planes with near < far");
    Eigen::Matrix4d p = Eigen::Matrix4d::Identity();
    p(0, 0) = 2. / (height * aspect_ratio);
    p(1, 1) = 2. / height;
    p(2, 2) = -2. / (far_plane - near_plane);
    p(2, 3) = -(far_plane + near_plane) / (far_plane - near_plane);
    return p;
  }

  /// the view matrix of an eye at `eye` that looks at `target`, with `up` upwards in the picture.
  /// \throws std::invalid_argument if the directions are parallel or have no length
  static Eigen::Matrix4d
  look_at(const Eigen::Vector3d& eye, const Eigen::Vector3d& target, const Eigen::Vector3d& up)
  {
    const Eigen::Vector3d back = (eye - target).stableNormalized();
    const Eigen::Vector3d right = up.stableNormalized().cross(back).stableNormalized();
    if(!(std::abs(right.norm() - 1.) < 1e-6))
      throw std::invalid_argument(
          "Shape_characteristics: look_at() needs an eye away from its target, and up across the view");
    Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
    m.block<1, 3>(0, 0) = right;
    m.block<1, 3>(1, 0) = back.cross(right);
    m.block<1, 3>(2, 0) = back;
    m.block<3, 1>(0, 3) = -m.topLeftCorner<3, 3>() * eye;
    return m;
  }

  const Eigen::Matrix4d& view() const noexcept { return m_view; }             ///< from world to view space
  const Eigen::Matrix4d& projection() const noexcept { return m_projection; } ///< from view to clip space
  Depth_convention depth_convention() const noexcept { return m_depth_convention; } ///< what depths mean
  /// whether what is farther away looks smaller
  bool is_perspective() const noexcept { return m_projection(3, 2) != 0.; }

  /// returns the distance of what has the depth `depth`, along the direction of view.
  double distance(double depth) const
  {
    if(m_depth_convention == Depth_convention::EYE_DISTANCE)
      return depth;
    const auto& p = m_projection;
    const double ndc = m_depth_convention == Depth_convention::WINDOW_DEPTH ? 2. * depth - 1. : depth;
    return (ndc * p(3, 3) - p(2, 3)) / (ndc * p(3, 2) - p(2, 2));
  }

  /// returns the depth of what is at the distance `distance`.
  double depth(double distance) const
  {
    return m_depth_convention == Depth_convention::EYE_DISTANCE ? distance : window_depth(distance);
  }

  /// returns the distance of the near plane.
  double near_plane() const { return (std::min)(plane_at(0.), plane_at(1.)); }
  /// returns the distance of the far plane, which may be infinite.
  double far_plane() const { return (std::max)(plane_at(0.), plane_at(1.)); }
  /// returns whether depths grow with the distance, as they do unless the projection reverses them.
  bool depth_grows() const
  {
    return m_depth_convention == Depth_convention::EYE_DISTANCE || plane_at(0.) < plane_at(1.);
  }

  /// returns whether a pixel with the depth `depth` shows no surface; `false` for NaN.
  bool is_background(float depth) const
  {
    if(m_depth_convention == Depth_convention::EYE_DISTANCE)
      return depth <= 0.f || depth > (std::numeric_limits<float>::max)();
    return depth_grows() ? depth >= 1.f || depth < 0.f : depth <= 0.f || depth > 1.f;
  }

  /// returns the point in view space that is seen in a picture of `width` x `height` pixels at the place `(x, y)`. Pixel `(i, j)` has its
  /// center at `(i + 0.5, j + 0.5)`; `y` grows upwards.
  Eigen::Vector3d view_point(double x, double y, double depth, int width, int height) const
  {
    const auto& p = m_projection;
    const double d = distance(depth), w = is_perspective() ? d : 1.;
    const double u = 2. * x / width - 1., v = 2. * y / height - 1.;
    return {(u * w + p(0, 2) * d - p(0, 3)) / p(0, 0), (v * w + p(1, 2) * d - p(1, 3)) / p(1, 1), -d};
  }

  /// returns the point in world space of a point in view space.
  Eigen::Vector3d world_point(const Eigen::Vector3d& view_point) const
  {
    return m_view.topLeftCorner<3, 3>().transpose() * (view_point - m_view.block<3, 1>(0, 3));
  }

private:
  double window_depth(double distance) const
  {
    const auto& p = m_projection;
    const double ndc = (-p(2, 2) * distance + p(2, 3)) / (-p(3, 2) * distance + p(3, 3));
    return (ndc - m_least_depth) / (1. - m_least_depth);
  }

  // the distance of what has the window depth `depth`, whatever the convention
  double plane_at(double depth) const
  {
    const auto& p = m_projection;
    const double ndc = m_least_depth + (1. - m_least_depth) * depth;
    const double denominator = ndc * p(3, 2) - p(2, 2);
    // infinitely far, rather than a sign that rounding decides
    return denominator == 0. ? std::numeric_limits<double>::infinity()
                             : (ndc * p(3, 3) - p(2, 3)) / denominator;
  }

  Eigen::Matrix4d m_view, m_projection;
  Depth_convention m_depth_convention;
  double m_least_depth = -1.; // of clip space; the largest is 1
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_CAMERA_H
