#include "Image.h"

#include <png.h>

#include <algorithm>
#include <stdexcept>

namespace support {

namespace {

std::uint8_t mix(std::uint8_t below, std::uint8_t above, float opacity)
{
  return std::uint8_t(float(below) + (float(above) - float(below)) * opacity + 0.5f);
}

} // namespace

Image::Image(int width, int height, Rgba fill) : width_(width), height_(height)
{
  if(width <= 0 || height <= 0)
    throw std::invalid_argument("Image: width and height must be positive");
  pixels_.assign(std::size_t(width) * std::size_t(height), fill);
}

void Image::blend(int x, int y, Rgba color, float coverage)
{
  if(x < 0 || y < 0 || x >= width_ || y >= height_ || coverage <= 0)
    return;
  const float opacity = std::min(coverage, 1.f) * float(color.a) / 255.f;
  Rgba& pixel = at(x, y);
  pixel.r = mix(pixel.r, color.r, opacity);
  pixel.g = mix(pixel.g, color.g, opacity);
  pixel.b = mix(pixel.b, color.b, opacity);
  pixel.a = mix(pixel.a, 255, opacity);
}

void Image::paste(const Image& other, int left, int top)
{
  for(int y = std::max(0, -top); y < other.height() && y + top < height_; ++y)
    for(int x = std::max(0, -left); x < other.width() && x + left < width_; ++x)
      at(x + left, y + top) = other.at(x, y);
}

void write_png(const std::string& file_name, const Image& image)
{
  if(image.empty())
    throw std::runtime_error("write_png: the picture for '" + file_name + "' is empty");
  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  png.width = png_uint_32(image.width());
  png.height = png_uint_32(image.height());
  png.format = PNG_FORMAT_RGBA;
  if(!png_image_write_to_file(&png, file_name.c_str(), 0, &image.at(0, 0), 0, nullptr))
    throw std::runtime_error("write_png: cannot write '" + file_name + "': " + png.message);
}

Image read_png(const std::string& file_name)
{
  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  if(!png_image_begin_read_from_file(&png, file_name.c_str()))
    throw std::runtime_error("read_png: cannot read '" + file_name + "': " + png.message);
  png.format = PNG_FORMAT_RGBA;
  Image image(int(png.width), int(png.height));
  if(!png_image_finish_read(&png, nullptr, &image.at(0, 0), 0, nullptr))
    throw std::runtime_error("read_png: cannot read '" + file_name + "': " + png.message);
  return image;
}

} // namespace support
