#ifndef SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_PLOT_H
#define SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_PLOT_H

#include "Image.h"
#include "Painter.h"

#include <string>
#include <vector>

namespace support {

/// One line or cloud of points in a plot.
struct Plot_series
{
  std::string name;         ///< for the list at the right; empty: not listed
  std::vector<double> x, y; ///< of equal length
  bool line = true;         ///< the points are connected in their order
  bool markers = true;
  bool dashed = false; ///< a thinner, broken line: for what is only to compare with
  bool grey = false;   ///< grey instead of a colour of its own, likewise
};

/// Line and scatter plots. Colours and markers differ from series to series (in colours that people with
/// defective colour vision can tell apart); points that cannot be shown (NaN, not positive on a
/// logarithmic axis) are left out and interrupt the line.
struct Plot
{
  std::string title, x_label, y_label;
  bool x_logarithmic = false, y_logarithmic = false;
  bool y_from_zero = false; ///< a linear axis that begins (or ends) at 0
  std::vector<Plot_series> series;

  /// Draws the plot. Throws `std::invalid_argument` if a series has not as many x as y.
  Image image(int width = 1200, int height = 800) const;
};

} // namespace support

#endif
