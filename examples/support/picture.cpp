#include "picture.h"

#include "Painter.h"
#include "legend.h"

#include <algorithm>
#include <cmath>

namespace support {

Image picture(Mesh_renderer& renderer, const Drawable& shape, const Picture_options& options)
{
  Image image(options.width, options.height, options.render.background);
  Painter painter(image);
  // texts shrink with the picture, as long as they can be read
  const double unit = std::max(std::min(options.height / 900., options.width / 1200.), 0.55);
  const double border = 28 * unit;
  double top = border;

  Text_style style;
  style.bold = true;
  style.size = 32 * unit;
  const double width = options.width - 2 * border;
  if(!options.title.empty())
  {
    painter.text(shortened_text(options.title, width, style), {border, top + 0.72 * style.size}, style);
    top += 1.25 * style.size;
  }
  style.bold = false;
  style.size = 22 * unit;
  style.color = {92, 96, 102, 255};
  if(!options.subtitle.empty())
  {
    painter.text(shortened_text(options.subtitle, width, style), {border, top + 0.72 * style.size}, style);
    top += 1.4 * style.size;
  }

  double right = options.width - border;
  if(options.legend && !shape.scalars.empty())
  {
    Legend legend;
    legend.title = options.legend_title;
    legend.gradient = options.render.gradient;
    legend.range = options.render.range;
    legend.text_size = 22 * unit;
    for(double s : shape.scalars)
      if(std::isnan(s))
        legend.missing_label = options.missing_label;
    const double legend_width = 8.2 * legend.text_size;
    right -= legend_width;
    const double space = options.height - border - top;
    const double height = std::min(space, 620 * unit);
    draw_legend(image, {right, top + (space - height) / 2, legend_width, height}, legend);
    right -= 0.5 * border;
  }

  Render_options render = options.render;
  const int left = int(std::lround(border)), y = int(std::lround(top));
  render.width = std::max(1, int(std::lround(right)) - left);
  render.height = std::max(1, int(std::lround(options.height - border / 2)) - y);
  image.paste(renderer.render(shape, render), left, y);
  return image;
}

} // namespace support
