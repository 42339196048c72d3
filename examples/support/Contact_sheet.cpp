#include "Contact_sheet.h"

#include "Painter.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace support {

void Contact_sheet::add(Image image, std::string caption)
{
  Entry entry;
  entry.image = std::move(image);
  std::istringstream lines(caption);
  for(std::string line; std::getline(lines, line);)
    entry.caption.push_back(line);
  entries_.push_back(std::move(entry));
}

void Contact_sheet::set_legend(Legend legend)
{
  legend_.assign(1, std::move(legend));
}

Image Contact_sheet::image(int columns) const
{
  if(entries_.empty())
    throw std::logic_error("Contact_sheet: there is no picture");
  const int count = int(entries_.size());
  if(columns <= 0)
    columns = int(std::ceil(std::sqrt(double(count))));
  columns = std::min(columns, count);
  const int rows = (count + columns - 1) / columns;

  int cell_width = 0, cell_height = 0;
  std::size_t lines = 0;
  for(const Entry& entry : entries_)
  {
    cell_width = std::max(cell_width, entry.image.width());
    cell_height = std::max(cell_height, entry.image.height());
    lines = std::max(lines, entry.caption.size());
  }
  const double text = std::max(13., std::min(cell_width / 20., 40.));
  const int gap = int(text), caption_height = int(std::ceil(double(lines) * 1.45 * text + 0.5 * text));
  const int title_height = title_.empty() ? 0 : int(2.6 * text);
  const int legend_height = legend_.empty() ? 0 : int(6.6 * text);
  const int width = columns * cell_width + (columns + 1) * gap;
  const int height = title_height + rows * (cell_height + caption_height) + (rows + 1) * gap + legend_height;

  Image sheet(width, height);
  Painter painter(sheet);
  Text_style style;
  style.size = 1.3 * text;
  style.bold = true;
  if(!title_.empty())
    painter.text(shortened_text(title_, width - 2 * gap, style), {double(gap), gap + 1.1 * text}, style);
  style.horizontal = Horizontal_alignment::CENTER;
  style.size = text;
  for(int i = 0; i < count; ++i)
  {
    const Entry& entry = entries_[std::size_t(i)];
    const int left = gap + (i % columns) * (cell_width + gap);
    const int top = title_height + gap + (i / columns) * (cell_height + caption_height + gap);
    if(!entry.image.empty())
      sheet.paste(entry.image, left + (cell_width - entry.image.width()) / 2,
                  top + (cell_height - entry.image.height()) / 2);
    for(std::size_t line = 0; line < entry.caption.size(); ++line)
    {
      // the first line names the picture, the others say more
      style.bold = line == 0;
      style.color = line == 0 ? Rgba{40, 42, 46, 255} : Rgba{92, 96, 102, 255};
      painter.text(shortened_text(entry.caption[line], cell_width, style),
                   {left + cell_width / 2., top + cell_height + (1.2 + 1.45 * double(line)) * text}, style);
    }
  }
  if(!legend_.empty())
  {
    Legend legend = legend_.front();
    legend.text_size = text;
    const double bar = std::min(width - 4. * gap, 44 * text);
    draw_legend(sheet, {(width - bar) / 2, double(height - legend_height), bar, legend_height - 1. * gap},
                legend);
  }
  return sheet;
}

} // namespace support
