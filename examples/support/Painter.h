#ifndef SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_PAINTER_H
#define SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_PAINTER_H

#include "Image.h"

#include <string>
#include <vector>

namespace support {

/// A position in a picture: in pixels from the top left corner, x to the right, y downwards.
struct Pixel_point
{
  double x = 0, y = 0;
};

/// An axis-parallel rectangle in a picture.
struct Rectangle
{
  double left = 0, top = 0, width = 0, height = 0;
  double right() const { return left + width; }
  double bottom() const { return top + height; }
};

/// The point of a text that is put at the given place.
enum class Horizontal_alignment
{
  LEFT,
  CENTER,
  RIGHT
};
enum class Vertical_alignment
{
  BASELINE,
  MIDDLE ///< half the height of a capital letter above the baseline
};

/// How a text looks. Capital letters and digits are `0.7 * size` pixels high.
struct Text_style
{
  double size = 20;
  Rgba color = {40, 42, 46, 255};
  bool bold = false;
  Horizontal_alignment horizontal = Horizontal_alignment::LEFT;
  Vertical_alignment vertical = Vertical_alignment::BASELINE;
  double angle = 0; ///< in degrees, counterclockwise
};

enum class Marker
{
  NONE,
  DISC,
  SQUARE,
  TRIANGLE,
  DIAMOND,
  CROSS,
  INVERTED_TRIANGLE,
  RING
};

/// Draws into an image with smooth edges: the coverage of a pixel is found from its distance to the shape.
///
/// The typeface is of strokes and built in; it knows ASCII, a few Greek letters and signs in UTF-8 (others
/// show as a box). `^{...}` and `_{...}` raise and lower a part of a text: `"k_{max} in 10^{-3}/mm"`.
class Painter
{
public:
  /// `image` must outlive the painter.
  explicit Painter(Image& image) : image_(image) {}

  /// Draws one line of text.
  void text(const std::string& utf8, Pixel_point at, const Text_style& style = {});

  /// The length of one line of text in pixels.
  static double text_width(const std::string& utf8, const Text_style& style = {});

  /// Draws the connected segments with round joints and ends. `dash` > 0 breaks them into dashes of
  /// that length.
  void polyline(const std::vector<Pixel_point>& points, double width, Rgba color, double dash = 0);

  void fill(const Rectangle& rectangle, Rgba color);

  /// The outline lies inside of `rectangle`.
  void frame(const Rectangle& rectangle, double width, Rgba color);

  /// Fills a convex polygon.
  void convex_polygon(const std::vector<Pixel_point>& corners, Rgba color);

  /// A marker of about the given diameter, all kinds about equally heavy.
  void marker(Marker kind, Pixel_point center, double diameter, Rgba color);

private:
  Image& image_;
};

/// Shortens `utf8` with an ellipsis until it is at most `width` pixels long.
std::string shortened_text(const std::string& utf8, double width, const Text_style& style);

} // namespace support

#endif
