#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_INTERNAL_SCREEN_FRAME_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_INTERNAL_SCREEN_FRAME_H

#include <Shape_characteristics/screen_space/Camera.h>
#include <Shape_characteristics/screen_space/Normal_space.h>

#include <Eigen/Core>

#include <cmath>
#include <limits>

namespace Shape_characteristics {
namespace internal {

// What a pass over the pixels needs of a camera, in the single precision that shaders have. The differences of neighboring pixels come
// from the differences of their depths, which are exact, and not from those of points: their relative error is that of rounding.
struct Screen_frame
{
  Screen_frame(const Camera& camera, Normal_space normal_space, int width, int height)
  {
    const Eigen::Matrix4d& p = camera.projection();
    perspective = camera.is_perspective() ? 1.f : 0.f;

    // The distance is (a + b c) / (g + d c), where c is the depth minus that of the far plane: there the denominator is smallest,
    // and nothing cancels.
    double a = 0., b = 1., g = 1., d = 0.;
    depth_reference = 0.f;
    lowest_depth = (std::numeric_limits<float>::min)();
    highest_depth = (std::numeric_limits<float>::max)();
    if(camera.depth_convention() != Depth_convention::EYE_DISTANCE)
    {
      const double slope = camera.depth_convention() == Depth_convention::WINDOW_DEPTH ? 2. : 1.;
      const double reference = camera.depth_grows() ? 1. : 0.;
      const double ndc = slope * reference + (slope == 2. ? -1. : 0.);
      a = ndc * p(3, 3) - p(2, 3);
      b = slope * p(3, 3);
      g = ndc * p(3, 2) - p(2, 2);
      d = slope * p(3, 2);
      const double scale = 1. / (std::max)(std::abs(g), std::abs(d));
      a *= scale;
      b *= scale;
      g *= scale;
      d *= scale;
      depth_reference = float(reference);
      if(camera.depth_grows())
      {
        lowest_depth = 0.f;
        highest_depth = std::nextafter(1.f, 0.f);
      }
      else
        highest_depth = 1.f;
    }
    numerator[0] = float(a);
    numerator[1] = float(b);
    denominator[0] = float(g);
    denominator[1] = float(d);
    determinant = float(b * g - a * d);
    depth_sign = camera.depth_grows() ? 1.f : -1.f;

    const double sign = camera.is_perspective() ? 1. : -1.;
    const int column = camera.is_perspective() ? 2 : 3;
    const int size[2] = {width, height};
    double step[2];
    for(int i = 0; i < 2; ++i)
    {
      step[i] = 2. / (size[i] * p(i, i));
      ray_step[i] = float(step[i]);
      ray_origin[i] =
          float((1. / size[i] - 1. + sign * p(i, column)) / p(i, i)); // of the first pixel's center
    }
    const double pixel = std::sqrt(std::abs(step[0] * step[1]));
    pixel_size = float(pixel);
    for(int i = 0; i < 2; ++i)
      pixel_edge[i] = float(step[i] / pixel);

    to_view = normal_space == Normal_space::VIEW
                  ? Eigen::Matrix3f(Eigen::Matrix3f::Identity())
                  : Eigen::Matrix3f(camera.view().topLeftCorner<3, 3>().cast<float>());
  }

  bool is_surface(float depth) const { return depth >= lowest_depth && depth <= highest_depth; }

  float distance(float depth) const
  {
    const float c = depth - depth_reference;
    return (numerator[0] + numerator[1] * c) / (denominator[0] + denominator[1] * c);
  }

  // what is scaled to 1: the distance of neighboring pixels in the scene
  float footprint(float depth) const
  {
    return perspective != 0.f ? distance(depth) * pixel_size : pixel_size;
  }

  // the edge from the point of a pixel to that of the pixel `(x, y)`, which is `(dx, dy)` pixels away, in units of the footprint
  Eigen::Vector3f edge(float depth, float footprint, float other_depth, int x, int y, int dx, int dy) const
  {
    const float g = denominator[0] + denominator[1] * (depth - depth_reference);
    const float h = denominator[0] + denominator[1] * (other_depth - depth_reference);
    const float away = determinant * (other_depth - depth) / (g * h) / footprint;
    return {pixel_edge[0] * float(dx) + perspective * away * (ray_origin[0] + ray_step[0] * float(x)),
            pixel_edge[1] * float(dy) + perspective * away * (ray_origin[1] + ray_step[1] * float(y)), -away};
  }

  float depth_reference, lowest_depth, highest_depth, depth_sign;
  float numerator[2], denominator[2], determinant;
  float perspective, ray_origin[2], ray_step[2];
  float pixel_size;    // distance of neighboring pixels, at distance 1 if the camera is perspective
  float pixel_edge[2]; // pixels need not be square: their sides in units of `pixel_size`, with signs
  Eigen::Matrix3f to_view;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_INTERNAL_SCREEN_FRAME_H
