#include "Plot.h"

#include "Ticks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace support {

namespace {

// Okabe and Ito's colours without the yellow, which is too light on white, and two more.
constexpr Rgba colors[] = {{0, 105, 175, 255}, {213, 84, 0, 255},   {0, 150, 110, 255}, {190, 90, 150, 255},
                           {225, 150, 0, 255}, {70, 170, 225, 255}, {60, 62, 68, 255},  {130, 80, 40, 255}};
constexpr Rgba comparison_color = {140, 143, 148, 255};
constexpr Marker markers[] = {Marker::DISC,    Marker::SQUARE, Marker::TRIANGLE,
                              Marker::DIAMOND, Marker::CROSS,  Marker::INVERTED_TRIANGLE,
                              Marker::RING};
constexpr Rgba text_color = {40, 42, 46, 255}, frame_color = {120, 123, 128, 255};
constexpr Rgba grid_color = {226, 228, 231, 255}, fine_grid_color = {241, 242, 244, 255};

// One axis: values to fractions of its length.
struct Axis
{
  bool logarithmic;
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  Ticks ticks = {};

  bool shows(double v) const { return std::isfinite(v) && (!logarithmic || v > 0); }
  double scaled(double v) const { return logarithmic ? std::log10(v) : v; }
  double position(double v) const { return (scaled(v) - scaled(low)) / (scaled(high) - scaled(low)); }

  void include(double v)
  {
    low = std::min(low, v);
    high = std::max(high, v);
  }

  void finish(bool from_zero, int wished)
  {
    if(!(low <= high))
      low = high = 1;
    if(logarithmic)
    {
      const double room = std::max(0.04 * (std::log10(high) - std::log10(low)), 0.05);
      low *= std::pow(10., -room);
      high *= std::pow(10., room);
      // a whole decade if it is near anyway: its label then stands at the axis's end
      const double first = std::pow(10., std::floor(std::log10(low)));
      const double last = std::pow(10., std::ceil(std::log10(high)));
      if(high > 5 * low)
      {
        low = low < 2.2 * first ? first : low;
        high = high > last / 2.2 ? last : high;
      }
      ticks = logarithmic_ticks(low, high, wished);
      return;
    }
    const double size = std::max(std::abs(low), std::abs(high));
    double room = 0.05 * (high - low);
    if(!(room > 1e-12 * size))
      room = size > 0 ? 0.1 * size : 1;
    const bool nonnegative = low >= 0, nonpositive = high <= 0;
    low = from_zero && nonnegative ? 0 : low - room;
    high = from_zero && nonpositive ? 0 : high + room;
    ticks = linear_ticks(low, high, wished);
  }

  // 2 to 9 times the powers of ten
  std::vector<double> fine_ticks() const
  {
    std::vector<double> fine;
    if(logarithmic && std::log10(high) - std::log10(low) < 12)
      for(double e = std::floor(std::log10(low)); e <= std::log10(high); ++e)
        for(int digit = 2; digit < 10; ++digit)
          if(digit * std::pow(10., e) > low && digit * std::pow(10., e) < high)
            fine.push_back(digit * std::pow(10., e));
    return fine;
  }
};

} // namespace

Image Plot::image(int width, int height) const
{
  Axis x_axis{x_logarithmic}, y_axis{y_logarithmic};
  for(const Plot_series& s : series)
  {
    if(s.x.size() != s.y.size())
      throw std::invalid_argument("Plot: series '" + s.name + "' has not as many x as y");
    for(std::size_t i = 0; i < s.x.size(); ++i)
      if(x_axis.shows(s.x[i]) && y_axis.shows(s.y[i]))
      {
        x_axis.include(s.x[i]);
        y_axis.include(s.y[i]);
      }
  }

  Image image(width, height);
  Painter painter(image);
  const double unit = std::min(width / 1200., height / 800.);
  const double size = 23 * unit, border = 26 * unit;
  Text_style label;
  label.size = size;
  label.color = text_color;
  label.vertical = Vertical_alignment::MIDDLE;
  Text_style heading = label;
  heading.bold = true;
  heading.size = 1.3 * size;
  Text_style axis_title = label;
  axis_title.horizontal = Horizontal_alignment::CENTER;

  // Where the frame is: what its labels need is known only after the ticks, which depend on its height.
  double list_width = 0;
  for(const Plot_series& s : series)
    if(!s.name.empty())
      list_width = std::max(list_width, 3.1 * size + Painter::text_width(s.name, label));
  list_width = std::min(list_width, 0.4 * width);
  const double top = border + (title.empty() ? 0.4 * size : 2.1 * heading.size);
  const double bottom = height - border - 1.9 * size - (x_label.empty() ? 0 : 1.7 * size);
  y_axis.finish(y_from_zero, std::max(2, int((bottom - top) / (3 * size))));
  double tick_width = 0;
  for(const std::string& text : y_axis.ticks.labels)
    tick_width = std::max(tick_width, Painter::text_width(text, label));
  const double left = border + (y_label.empty() ? 0 : 1.8 * size) + tick_width + 0.6 * size;
  const double right = width - border - (list_width > 0 ? list_width + 0.8 * size : 0.6 * size);
  if(right - left < 10 || bottom - top < 10)
    throw std::invalid_argument("Plot: width and height leave no room");
  x_axis.finish(false, std::max(2, int((right - left) / (4.5 * size))));
  const auto place_x = [&](double v) { return left + x_axis.position(v) * (right - left); };
  const auto place_y = [&](double v) { return bottom - y_axis.position(v) * (bottom - top); };

  if(!title.empty())
    painter.text(shortened_text(title, width - 2 * border, heading), {border, border + 0.6 * heading.size},
                 heading);

  const double hairline = std::max(1., 1.3 * unit);
  for(double v : x_axis.fine_ticks())
    painter.polyline({{place_x(v), top}, {place_x(v), bottom}}, hairline, fine_grid_color);
  for(double v : y_axis.fine_ticks())
    painter.polyline({{left, place_y(v)}, {right, place_y(v)}}, hairline, fine_grid_color);
  for(std::size_t i = 0; i < x_axis.ticks.values.size(); ++i)
  {
    const double x = place_x(x_axis.ticks.values[i]);
    painter.polyline({{x, top}, {x, bottom}}, hairline, grid_color);
    painter.polyline({{x, bottom}, {x, bottom + 0.25 * size}}, hairline, frame_color);
    painter.text(x_axis.ticks.labels[i], {x, bottom + 0.95 * size}, axis_title);
  }
  Text_style right_aligned = label;
  right_aligned.horizontal = Horizontal_alignment::RIGHT;
  for(std::size_t i = 0; i < y_axis.ticks.values.size(); ++i)
  {
    const double y = place_y(y_axis.ticks.values[i]);
    painter.polyline({{left, y}, {right, y}}, hairline, grid_color);
    painter.polyline({{left - 0.25 * size, y}, {left, y}}, hairline, frame_color);
    painter.text(y_axis.ticks.labels[i], {left - 0.5 * size, y}, right_aligned);
  }
  painter.frame({left, top, right - left, bottom - top}, hairline, frame_color);
  const auto with_factor = [](const std::string& text, const Ticks& ticks) {
    return ticks.factor.empty() ? text : text.empty() ? ticks.factor : text + " (" + ticks.factor + ")";
  };
  painter.text(with_factor(x_label, x_axis.ticks), {(left + right) / 2, height - border - 0.2 * size},
               axis_title);
  axis_title.angle = 90;
  painter.text(with_factor(y_label, y_axis.ticks), {border + 0.3 * size, (top + bottom) / 2}, axis_title);

  std::size_t next_color = 0;
  double list_y = top + 0.7 * size;
  for(const Plot_series& s : series)
  {
    const std::size_t number = s.grey ? 0 : next_color++;
    const Rgba color = s.grey ? comparison_color : colors[number % (sizeof colors / sizeof colors[0])];
    const Marker marker = markers[number % (sizeof markers / sizeof markers[0])];
    const double line_width = (s.dashed ? 2.2 : 3) * unit, dash = s.dashed ? 9 * unit : 0;
    const double diameter = (s.line || s.x.size() < 200 ? 12 : 7) * unit;
    const auto drawn = [&](std::size_t i) { return x_axis.shows(s.x[i]) && y_axis.shows(s.y[i]); };
    if(s.line)
    {
      std::vector<Pixel_point> run;
      for(std::size_t i = 0; i <= s.x.size(); ++i)
        if(i < s.x.size() && drawn(i))
          run.push_back({place_x(s.x[i]), place_y(s.y[i])});
        else
        {
          painter.polyline(run, line_width, color, dash);
          run.clear();
        }
    }
    if(s.markers)
      for(std::size_t i = 0; i < s.x.size(); ++i)
        if(drawn(i))
          painter.marker(marker, {place_x(s.x[i]), place_y(s.y[i])}, diameter, color);

    if(s.name.empty())
      continue;
    const double from = right + 0.9 * size, to = from + 1.9 * size;
    if(s.line)
      painter.polyline({{from, list_y}, {to, list_y}}, line_width, color, dash);
    if(s.markers)
      painter.marker(marker, {(from + to) / 2, list_y}, 12 * unit, color);
    painter.text(shortened_text(s.name, width - border / 2 - to - 0.5 * size, label),
                 {to + 0.5 * size, list_y}, label);
    list_y += 1.55 * size;
  }
  return image;
}

} // namespace support
