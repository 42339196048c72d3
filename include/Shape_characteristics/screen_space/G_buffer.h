#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_G_BUFFER_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_G_BUFFER_H

#include <Shape_characteristics/screen_space/Camera.h>
#include <Shape_characteristics/screen_space/Normal_space.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsScreenSpace

  wraps the arrays of a renderer: for each pixel a depth and a normal. It holds no data of its own, and the arrays have to outlive it.

  Pixels are numbered row by row, the lowest row first, as OpenGL does: that of column `x` and row `y` has the index `y * width + x`.

  \cgalModels{GBuffer}
*/
class G_buffer
{
public:
  /// a G-buffer without pixels
  G_buffer() = default;

  /// wraps arrays.
  ///
  /// \param width number of columns; may be 0
  /// \param height number of rows; may be 0
  /// \param depths the depth of each pixel, `width * height` numbers
  /// \param normals the outward normal of each pixel, of any length
  /// \param camera the camera, and what depths mean
  /// \param normal_space whether normals are in view or in world space
  /// \param normal_stride how many numbers further on the normal of the next pixel is: 3, or 4 for textures with four channels
  ///
  /// \throws std::invalid_argument if a size is negative, an array is missing, or `normal_stride` is less than 3
  G_buffer(int width,
           int height,
           const float* depths,
           const float* normals,
           const Camera& camera,
           Normal_space normal_space = Normal_space::VIEW,
           int normal_stride = 3)
    : m_width(width),
      m_height(height),
      m_depths(depths),
      m_normals(normals),
      m_stride(normal_stride),
      m_camera(camera),
      m_normal_space(normal_space)
  {
    if(width < 0 || height < 0)
      throw std::invalid_argument("Shape_characteristics: the size of a G-buffer must not be negative");
    if(normal_stride < 3)
      throw std::invalid_argument(
          "Shape_characteristics: the stride of the normals of a G-buffer must be at least 3");
    if(size() > 0 && (!depths || !normals))
      throw std::invalid_argument(
          "Shape_characteristics: a G-buffer needs an array of depths and one of normals");
  }

  int width() const noexcept { return m_width; }   ///< number of columns
  int height() const noexcept { return m_height; } ///< number of rows
  /// number of pixels
  std::size_t size() const noexcept { return std::size_t(m_width) * std::size_t(m_height); }
  /// index of the pixel in column `x` and row `y`
  std::size_t index(int x, int y) const noexcept
  {
    return std::size_t(y) * std::size_t(m_width) + std::size_t(x);
  }
  const Camera& camera() const noexcept { return m_camera; }                ///< the camera
  Normal_space normal_space() const noexcept { return m_normal_space; }     ///< of the normals
  float depth(std::size_t pixel) const noexcept { return m_depths[pixel]; } ///< depth as it is stored
  /// normal as it is stored
  Eigen::Vector3f normal(std::size_t pixel) const noexcept
  {
    return Eigen::Map<const Eigen::Vector3f>(m_normals + pixel * std::size_t(m_stride));
  }

  /// returns whether a surface is seen in a pixel, whose depth and normal can be used: both are finite, and the normal isn't zero
  /// (nor as short as what processors take for it).
  bool is_valid(std::size_t pixel) const
  {
    const float d = depth(pixel);
    const Eigen::Vector3f n = normal(pixel);
    return std::isfinite(d) && !m_camera.is_background(d) && n.allFinite() &&
           n.cwiseAbs().maxCoeff() >= (std::numeric_limits<float>::min)();
  }

  /// returns the point in view space that is seen at the center of a pixel, which has to be valid.
  Eigen::Vector3d view_point(std::size_t pixel) const
  {
    const std::size_t width = std::size_t(m_width);
    return m_camera.view_point(double(pixel % width) + 0.5, double(pixel / width) + 0.5, depth(pixel),
                               m_width, m_height);
  }

  /// returns the unit normal of a valid pixel in view space.
  Eigen::Vector3d view_normal(std::size_t pixel) const
  {
    const Eigen::Vector3d n = normal(pixel).template cast<double>().stableNormalized();
    return m_normal_space == Normal_space::VIEW ? n
                                                : Eigen::Vector3d(m_camera.view().topLeftCorner<3, 3>() * n);
  }

private:
  int m_width = 0, m_height = 0;
  const float* m_depths = nullptr;
  const float* m_normals = nullptr;
  int m_stride = 3;
  Camera m_camera = Camera(Eigen::Matrix4d::Identity(), Camera::orthographic(2., 1., -1., 1.));
  Normal_space m_normal_space = Normal_space::VIEW;
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_G_BUFFER_H
