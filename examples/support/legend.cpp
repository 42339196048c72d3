#include "legend.h"

#include "Ticks.h"

#include <algorithm>
#include <cmath>

namespace support {

namespace {

constexpr Rgba line_color = {70, 73, 78, 255};

// The bar, with a triangle at each end that clips values. `along` runs in the direction of the values,
// `across` is the bar's other direction; `pixel` says which pixel belongs to a place in that system.
void draw_bar(Image& image, const Rectangle& bar, bool standing, const Legend& legend)
{
  Painter painter(image);
  const double thickness = standing ? bar.width : bar.height, tip = 0.55 * thickness;
  const auto end = [&](double at, double direction, double t)
  {
    const auto place = [&](double along, double across) {
      return standing ? Pixel_point{bar.left + across, along} : Pixel_point{along, bar.top + across};
    };
    painter.convex_polygon({place(at, 0), place(at + direction * tip, thickness / 2), place(at, thickness)},
                           legend.gradient.pixel(t));
  };
  const double gap = 0.12 * thickness;
  const double low_end = standing ? bar.bottom() + gap : bar.left - gap;
  const double high_end = standing ? bar.top - gap : bar.right() + gap;
  if(legend.range.clips_low)
    end(low_end, standing ? 1 : -1, 0);
  if(legend.range.clips_high)
    end(high_end, standing ? -1 : 1, 1);
  // pixel by pixel: adjoining strips would let the background shine through their seams
  const auto covered = [](double from, double to, int pixel)
  { return std::max(0., std::min(to, pixel + 1.) - std::max(from, double(pixel))); };
  for(int y = int(std::floor(bar.top)); y < bar.bottom(); ++y)
    for(int x = int(std::floor(bar.left)); x < bar.right(); ++x)
    {
      const double t = standing ? (bar.bottom() - y - 0.5) / bar.height : (x + 0.5 - bar.left) / bar.width;
      image.blend(x, y, legend.gradient.pixel(t),
                  float(covered(bar.left, bar.right(), x) * covered(bar.top, bar.bottom(), y)));
    }
}

void draw_swatch(Image& image, const Rectangle& swatch)
{
  const auto shade = [](double factor)
  {
    return Rgba{std::uint8_t(missing_value_color.r * factor), std::uint8_t(missing_value_color.g * factor),
                std::uint8_t(missing_value_color.b * factor), 255};
  };
  Painter painter(image);
  painter.fill(swatch, shade(1.12));
  const double step = swatch.height / 2;
  Image stripes(int(std::ceil(swatch.width)), int(std::ceil(swatch.height)), shade(1.12));
  Painter inner(stripes);
  for(double x = -swatch.height; x < swatch.width + swatch.height; x += step)
    inner.polyline({{x, 0.}, {x + swatch.height, swatch.height}}, step / 2.8, shade(0.78));
  image.paste(stripes, int(std::lround(swatch.left)), int(std::lround(swatch.top)));
}

} // namespace

void draw_legend(Image& image, const Rectangle& where, const Legend& legend)
{
  Painter painter(image);
  const double size = legend.text_size, thickness = 1.15 * size, tick = 0.3 * size;
  const double tip = 0.75 * thickness; // room for an end's triangle
  const bool standing = where.height > where.width;
  Text_style style;
  style.size = size;
  style.vertical = Vertical_alignment::MIDDLE;
  Text_style title = style;
  title.bold = true;
  title.size = size;

  double top = where.top;
  if(!legend.title.empty())
  {
    // shrunk rather than cut: the name is what the picture is about
    const double length = Painter::text_width(legend.title, title);
    if(length > where.width)
      title.size *= std::max(0.75, where.width / length);
    if(!standing)
      title.horizontal = Horizontal_alignment::CENTER;
    painter.text(shortened_text(legend.title, where.width, title),
                 {standing ? where.left : where.left + where.width / 2, top + 0.5 * size}, title);
    top += 1.7 * size;
  }

  const double length = standing ? where.bottom() - top : where.width;
  Ticks ticks = linear_ticks(legend.range.low, legend.range.high,
                             std::max(2, int(length / (standing ? 3.2 * size : 5.5 * size))));
  if(standing && !ticks.factor.empty())
  {
    painter.text(ticks.factor, {where.left, top + 0.5 * size}, style);
    top += 1.7 * size;
  }
  const double missing_height = legend.missing_label.empty() ? 0 : 2.0 * size;

  Rectangle bar;
  if(standing)
    bar = {where.left, top + tip, thickness, where.bottom() - missing_height - top - 2 * tip};
  else
    bar = {where.left + tip, top, where.width - 2 * tip, thickness};
  if(bar.width <= 0 || bar.height <= 0)
    return;
  draw_bar(image, bar, standing, legend);

  for(std::size_t i = 0; i < ticks.values.size(); ++i)
  {
    const double t = legend.range.position(ticks.values[i]);
    if(standing)
    {
      const double y = bar.bottom() - t * bar.height;
      painter.polyline({{bar.right(), y}, {bar.right() + tick, y}}, 0.075 * size, line_color);
      painter.text(ticks.labels[i], {bar.right() + tick + 0.35 * size, y}, style);
    }
    else
    {
      const double x = bar.left + t * bar.width;
      painter.polyline({{x, bar.bottom()}, {x, bar.bottom() + tick}}, 0.075 * size, line_color);
      Text_style centered = style;
      centered.horizontal = Horizontal_alignment::CENTER;
      painter.text(ticks.labels[i], {x, bar.bottom() + tick + 0.8 * size}, centered);
    }
  }
  if(!standing && !ticks.factor.empty())
  {
    Text_style right = style;
    right.horizontal = Horizontal_alignment::RIGHT;
    painter.text(ticks.factor, {where.right(), bar.bottom() + tick + 2.2 * size}, right);
  }

  if(!legend.missing_label.empty())
  {
    const double y = standing ? where.bottom() - size : bar.bottom() + tick + 1.75 * size;
    draw_swatch(image, {where.left, y, thickness, 0.9 * size});
    painter.text(legend.missing_label, {where.left + thickness + 0.5 * size, y + 0.45 * size}, style);
  }
}

} // namespace support
