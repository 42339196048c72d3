#ifndef SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_CONTACT_SHEET_H
#define SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_CONTACT_SHEET_H

#include "Image.h"
#include "legend.h"

#include <string>
#include <vector>

namespace support {

/// Several pictures side by side, each with a caption below: the estimators compared, say, with one legend
/// for all at the bottom.
class Contact_sheet
{
public:
  explicit Contact_sheet(std::string title = {}) : title_(std::move(title)) {}

  /// Adds a picture; `\n` breaks the caption into lines.
  void add(Image image, std::string caption);

  /// One legend for all pictures.
  void set_legend(Legend legend);

  /// The pictures in rows of `columns` (0: a near-square arrangement). Throws `std::logic_error` if there
  /// are none.
  Image image(int columns = 0) const;

private:
  struct Entry
  {
    Image image;
    std::vector<std::string> caption;
  };
  std::string title_;
  std::vector<Entry> entries_;
  std::vector<Legend> legend_; // none or one
};

} // namespace support

#endif
