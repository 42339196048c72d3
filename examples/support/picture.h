#ifndef SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_PICTURE_H
#define SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_PICTURE_H

#include "Mesh_renderer.h"

#include <string>

namespace support {

struct Picture_options
{
  int width = 1200, height = 900;
  std::string title;    ///< above the shape, in bold
  std::string subtitle; ///< below the title, smaller: who computed it, how many samples
  std::string legend_title;
  bool legend = true;                          ///< if the shape has scalars
  std::string missing_label = "not estimated"; ///< shown in the legend if a scalar is missing
  Render_options render;                       ///< but for the size, which follows from the picture's
};

/// A whole picture: the shape, its colours explained by a legend at the right, and its title.
/// `options.render.range` is not chosen here, so that pictures can share one.
Image picture(Mesh_renderer& renderer, const Drawable& shape, const Picture_options& options);

} // namespace support

#endif
