#ifndef SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_IMAGE_H
#define SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_IMAGE_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace support {

/// A colour of 8 bits per channel, not premultiplied by its opacity `a`.
struct Rgba
{
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
};

inline bool operator==(const Rgba& p, const Rgba& q)
{
  return p.r == q.r && p.g == q.g && p.b == q.b && p.a == q.a;
}
inline bool operator!=(const Rgba& p, const Rgba& q)
{
  return !(p == q);
}

/// A picture: `width` times `height` pixels in rows, the top row first.
class Image
{
public:
  Image() = default;
  Image(int width, int height, Rgba fill = {255, 255, 255, 255});

  int width() const { return width_; }
  int height() const { return height_; }
  bool empty() const { return pixels_.empty(); }

  Rgba& at(int x, int y) { return pixels_[std::size_t(y) * std::size_t(width_) + std::size_t(x)]; }
  const Rgba& at(int x, int y) const
  {
    return pixels_[std::size_t(y) * std::size_t(width_) + std::size_t(x)];
  }

  /// Lays `color` over the pixel with the opacity `coverage` in [0,1]; outside the picture nothing happens.
  void blend(int x, int y, Rgba color, float coverage);

  /// Copies `other` with its top left corner at `(left, top)`; what reaches beyond the picture is cut off.
  void paste(const Image& other, int left, int top);

private:
  int width_ = 0, height_ = 0;
  std::vector<Rgba> pixels_;
};

/// Writes `image` as PNG. Throws `std::runtime_error`, naming the file, when that fails.
void write_png(const std::string& file_name, const Image& image);

/// Reads a PNG file of any kind as RGBA. Throws `std::runtime_error`, naming the file, when that fails.
Image read_png(const std::string& file_name);

} // namespace support

#endif
