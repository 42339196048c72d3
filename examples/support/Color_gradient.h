#ifndef SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_COLOR_GRADIENT_H
#define SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_COLOR_GRADIENT_H

#include "Image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace support {

/// The grey of values that are not there (NaN). The gradient has no grey.
constexpr Rgba missing_value_color = {158, 158, 160, 255};

/// Maps [0,1] to colours that run smoothly (a monotone cubic through equally spaced stops, so that no
/// stop shows as an edge where the values have none).
class Color_gradient
{
public:
  using Rgb = std::array<double, 3>; ///< each channel in [0,1]

  /// The gradient of the thesis's Figure 1.1: low is blue, the middle green, high is red; on the way it
  /// passes through cyan and yellow.
  static Color_gradient blue_green_red()
  {
    return Color_gradient(
        {{0.10, 0.18, 0.86}, {0.08, 0.72, 0.90}, {0.16, 0.76, 0.24}, {0.98, 0.87, 0.12}, {0.86, 0.09, 0.09}});
  }

  /// A gradient through `stops`, at least two. Throws `std::invalid_argument` for fewer.
  explicit Color_gradient(std::vector<Rgb> stops) : stops_(std::move(stops))
  {
    if(stops_.size() < 2)
      throw std::invalid_argument("Color_gradient: stops: at least two are needed");
  }

  /// The colour at `t`, with `t` clamped to [0,1]. `t` must not be NaN.
  Rgb operator()(double t) const
  {
    const double place = std::min(std::max(t, 0.), 1.) * double(stops_.size() - 1);
    const std::size_t i = std::min(std::size_t(place), stops_.size() - 2);
    const double u = place - double(i);
    Rgb color;
    for(std::size_t c = 0; c < 3; ++c)
    {
      const double p = stops_[i][c], q = stops_[i + 1][c], mp = slope(i, c), mq = slope(i + 1, c);
      const double value = p + u * (mp + u * (3 * (q - p) - 2 * mp - mq + u * (2 * (p - q) + mp + mq)));
      color[c] = std::min(std::max(value, 0.), 1.);
    }
    return color;
  }

  /// The same as a pixel.
  Rgba pixel(double t) const
  {
    const Rgb c = (*this)(t);
    return {std::uint8_t(std::lround(255 * c[0])), std::uint8_t(std::lround(255 * c[1])),
            std::uint8_t(std::lround(255 * c[2])), 255};
  }

private:
  // Slope of channel c at stop i that keeps the cubic monotone between the stops (Fritsch and Butland).
  double slope(std::size_t i, std::size_t c) const
  {
    if(i == 0 || i + 1 == stops_.size())
      return i == 0 ? stops_[1][c] - stops_[0][c] : stops_[i][c] - stops_[i - 1][c];
    const double before = stops_[i][c] - stops_[i - 1][c], after = stops_[i + 1][c] - stops_[i][c];
    return before * after <= 0 ? 0 : 2 * before * after / (before + after);
  }

  std::vector<Rgb> stops_;
};

} // namespace support

#endif
