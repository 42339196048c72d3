#ifndef SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_LEGEND_H
#define SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_LEGEND_H

#include "Color_gradient.h"
#include "Image.h"
#include "Painter.h"
#include "Value_range.h"

#include <string>

namespace support {

/// What a colour bar shows.
struct Legend
{
  std::string title; ///< drawn above the bar
  Color_gradient gradient = Color_gradient::blue_green_red();
  Value_range range;         ///< ends that clip values are drawn as arrows
  std::string missing_label; ///< if not empty: a hatched swatch with this text, for missing values
  double text_size = 20;     ///< as in Text_style
};

/// Draws a colour bar with marked values into `where`: a standing one if the rectangle is higher than wide,
/// a lying one otherwise. About 7 times the text size of width (standing) or 5 times of height (lying) is
/// needed. Values grow upwards or to the right.
void draw_legend(Image& image, const Rectangle& where, const Legend& legend);

} // namespace support

#endif
