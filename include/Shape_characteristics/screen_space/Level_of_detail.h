#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_LEVEL_OF_DETAIL_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_LEVEL_OF_DETAIL_H

#include <Shape_characteristics/screen_space/Camera.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsScreenSpace

  says how many pixels away the neighbors of a pixel are taken, by its depth.

  One pixel away (`none()`) shows every detail, the faces of a coarse mesh among them: normals that are interpolated within a
  triangle make one curvature for all of it. Wider steps smooth them.
*/
class Level_of_detail
{
public:
  /// the largest step
  static constexpr int maximum_step = 32;

  /// a step of one pixel everywhere
  static Level_of_detail none() { return Level_of_detail(); }

  /// the thesis's equation 7.12: \f$ \lfloor s f^{-2d} + 1 \rfloor \f$ pixels, where f is the distance of the camera's far plane, at least
  /// 100, d the distance from the eye divided by that of the far plane, and s is `size`, in (0, 31]. What it means depends on the unit of
  /// length and on the far plane. (The thesis doesn't say whether d is linear. If it were window depth, hardly anything beyond the near plane would
  /// get more than one pixel.)
  /// \throws std::invalid_argument if `size` is out of its range
  static Level_of_detail by_depth(double size)
  {
    if(!(size > 0. && size <= maximum_step - 1))
      throw std::invalid_argument("Shape_characteristics: the size of a level of detail must be in (0, 31]");
    return Level_of_detail(Kind::BY_DEPTH, size);
  }

  /// ours: as many whole pixels as have the length `length` at that depth, at least 1 and at most 32. Estimates don't depend on the
  /// distance of the camera; a length of about the mesh's edges hides its faces.
  /// \param length in the unit of the scene, positive
  /// \throws std::invalid_argument if `length` is out of its range
  static Level_of_detail by_length(double length)
  {
    if(!(length > 0. && std::isfinite(length)))
      throw std::invalid_argument("Shape_characteristics: the length of a level of detail must be positive");
    return Level_of_detail(Kind::BY_LENGTH, length);
  }

  /// a step of `step` pixels everywhere
  /// \throws std::invalid_argument if `step` isn't in [1, 32]
  static Level_of_detail by_pixels(int step)
  {
    if(step < 1 || step > maximum_step)
      throw std::invalid_argument("Shape_characteristics: the step of a level of detail must be in [1, 32]");
    return Level_of_detail(Kind::BY_PIXELS, step);
  }

  /// fills a table by which the step of a pixel is looked up with comparisons alone, so that all processors come to the same: the
  /// step is at least `i + 1` where the depth is at most `table[i]`, or at least where depths fall with the distance. Returns the largest step.
  ///
  /// \param camera the camera
  /// \param pixel_size the distance of neighboring pixels in the scene, at distance 1 if the camera is perspective
  /// \param table `maximum_step` numbers. The first one is not used.
  int fill_table(const Camera& camera, double pixel_size, std::array<float, maximum_step>& table) const
  {
    const bool grows = camera.depth_grows();
    const double never = grows ? -std::numeric_limits<float>::max() : std::numeric_limits<float>::max();
    table.fill(float(never));
    int largest = 1;
    for(int step = 2; step <= maximum_step; ++step)
    {
      double limit = never;
      switch(m_kind)
      {
      case Kind::NONE:
        return 1;
      case Kind::BY_PIXELS:
        limit = step <= m_size ? -never : never;
        break;
      case Kind::BY_DEPTH:
      { // s f^(-2d) >= step - 1
        const double far = camera.far_plane();
        if(std::isinf(far))
          limit = step - 1 <= m_size ? -never : never; // d is 0
        else if(step - 1 <= m_size)
          limit =
              clamped(camera, far * std::log(m_size / (step - 1)) / (2. * std::log((std::max)(far, 100.))));
        break;
      }
      case Kind::BY_LENGTH:
      {
        const double distance = m_size / (step * pixel_size);
        if(camera.is_perspective() && std::isfinite(distance))
          limit = clamped(camera, distance);
        else
          limit = distance >= 1. ? -never : never;
        break;
      }
      }
      if(limit == never)
        break;
      table[std::size_t(step - 1)] = float(limit);
      largest = step;
    }
    return largest;
  }

private:
  enum class Kind
  {
    NONE,
    BY_DEPTH,
    BY_LENGTH,
    BY_PIXELS
  };

  Level_of_detail() = default;
  Level_of_detail(Kind kind, double size) : m_kind(kind), m_size(size) {}

  // the depth of a distance; nothing that is seen is nearer than the near plane
  static double clamped(const Camera& camera, double distance)
  {
    return camera.depth((std::max)(distance, 0.5 * camera.near_plane()));
  }

  Kind m_kind = Kind::NONE;
  double m_size = 1.;
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_LEVEL_OF_DETAIL_H
