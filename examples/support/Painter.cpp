#include "Painter.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <sstream>

namespace support {

namespace {

// ---------------------------------------------------------------------------------------- typeface

// A letter is drawn with a round pen. Its path is written as
//   M x y                  lift the pen and go to (x,y)
//   L x y                  straight line to (x,y)
//   A cx cy rx ry a0 a1    arc of an ellipse from angle a0 to a1 (degrees, counterclockwise positive);
//                          a straight line leads to its beginning if the pen is down
//   D x y                  a dot
// in units in which a capital letter is 7 high and x is 5 high; y goes up from the baseline.
struct Glyph_source
{
  char32_t code;
  double width;
  const char* path;
};

constexpr Glyph_source glyph_sources[] = {
    {U' ', 1.6, ""},
    {U'0', 4, "A 2 5 2 2 180 0 A 2 2 2 2 0 -180 L 0 5"},
    {U'1', 4, "M .6 5.5 L 2.4 7 L 2.4 0"},
    {U'2', 4, "A 2 5 2 2 165 -43 L 0 0 L 4 0"},
    {U'3', 4, "A 1.9 5.35 1.75 1.65 155 -90 A 1.9 1.85 2.1 1.85 90 -160"},
    {U'4', 4, "M 3.1 0 L 3.1 7 L 0 1.9 L 4.2 1.9"},
    {U'5', 4, "M 3.6 7 L .6 7 L .3 3.7 A 1.9 2.25 2.1 2.25 140 -155"},
    {U'6', 4, "M 2.5 7 L .27 3.15 A 2 2.1 2 2.1 150 510"},
    {U'7', 4, "M 0 7 L 4 7 L 1.3 0"},
    {U'8', 4, "A 2 5.35 1.75 1.65 0 360 M 4 1.85 A 2 1.85 2 1.85 0 360"},
    {U'9', 4, "M 1.5 0 L 3.73 3.85 A 2 4.9 2 2.1 -30 330"},
    {U'A', 5, "M 0 0 L 2.5 7 L 5 0 M .9 2.4 L 4.1 2.4"},
    {U'B', 4.1,
     "M 0 0 L 0 7 L 2.2 7 A 2.2 5.3 1.6 1.7 90 -90 L 0 3.6 M 2.2 3.6 A 2.3 1.8 1.9 1.8 90 -90 L 0 0"},
    {U'C', 4.5, "A 2.4 4.6 2.4 2.4 35 180 A 2.4 2.4 2.4 2.4 180 325"},
    {U'D', 4.5, "M 0 0 L 0 7 L 2 7 A 2 4.5 2.5 2.5 90 0 A 2 2.5 2.5 2.5 0 -90 L 0 0"},
    {U'E', 3.6, "M 3.6 7 L 0 7 L 0 0 L 3.6 0 M 0 3.6 L 3.1 3.6"},
    {U'F', 3.5, "M 3.5 7 L 0 7 L 0 0 M 0 3.4 L 3 3.4"},
    {U'G', 4.8, "A 2.4 4.6 2.4 2.4 35 180 A 2.4 2.4 2.4 2.4 180 360 L 4.8 3.3 L 2.8 3.3"},
    {U'H', 4.4, "M 0 0 L 0 7 M 4.4 0 L 4.4 7 M 0 3.6 L 4.4 3.6"},
    {U'I', 0, "M 0 0 L 0 7"},
    {U'J', 3, "M 3 7 L 3 1.9 A 1.2 1.9 1.8 1.9 0 -140"},
    {U'K', 4.3, "M 0 0 L 0 7 M 4.1 7 L 0 2.6 M 1.5 4.2 L 4.3 0"},
    {U'L', 3.4, "M 0 7 L 0 0 L 3.4 0"},
    {U'M', 5.4, "M 0 0 L 0 7 L 2.7 2 L 5.4 7 L 5.4 0"},
    {U'N', 4.5, "M 0 0 L 0 7 L 4.5 0 L 4.5 7"},
    {U'O', 4.8, "A 2.4 4.6 2.4 2.4 180 0 A 2.4 2.4 2.4 2.4 0 -180 L 0 4.6"},
    {U'P', 4.1, "M 0 0 L 0 7 L 2.2 7 A 2.2 5.05 1.9 1.95 90 -90 L 0 3.1"},
    {U'Q', 4.8, "A 2.4 4.6 2.4 2.4 180 0 A 2.4 2.4 2.4 2.4 0 -180 L 0 4.6 M 3 1.7 L 5 -.4"},
    {U'R', 4.2, "M 0 0 L 0 7 L 2.2 7 A 2.2 5.05 1.9 1.95 90 -90 L 0 3.1 M 2.1 3.1 L 4.2 0"},
    {U'S', 4, "A 2.05 5.25 1.9 1.75 30 250 A 2 1.75 2 1.75 70 -150"},
    {U'T', 4.4, "M 0 7 L 4.4 7 M 2.2 7 L 2.2 0"},
    {U'U', 4.4, "M 0 7 A 2.2 2.2 2.2 2.2 180 360 L 4.4 7"},
    {U'V', 4.8, "M 0 7 L 2.4 0 L 4.8 7"},
    {U'W', 6.6, "M 0 7 L 1.7 0 L 3.3 6.2 L 4.9 0 L 6.6 7"},
    {U'X', 4.5, "M 0 0 L 4.4 7 M .1 7 L 4.5 0"},
    {U'Y', 4.6, "M 0 7 L 2.3 3.2 L 4.6 7 M 2.3 3.2 L 2.3 0"},
    {U'Z', 4.2, "M .1 7 L 4.1 7 L 0 0 L 4.2 0"},
    {U'a', 3.6,
     "A 1.75 3.4 1.75 1.6 150 0 L 3.5 0 M 3.5 2.9 A 1.5 1.45 1.5 1.45 90 270 A 1.9 1.4 1.6 1.4 270 345"},
    {U'b', 3.8, "M 0 0 L 0 7 M 0 3.1 A 1.9 3.1 1.9 1.9 180 0 A 1.9 1.9 1.9 1.9 0 -180"},
    {U'c', 3.4, "A 1.9 3.1 1.9 1.9 38 180 A 1.9 1.9 1.9 1.9 180 322"},
    {U'd', 3.8, "M 3.8 7 L 3.8 0 M 3.8 3.1 A 1.9 3.1 1.9 1.9 0 180 A 1.9 1.9 1.9 1.9 180 360"},
    {U'e', 3.8, "M 0 2.6 L 3.8 2.6 L 3.8 3.1 A 1.9 3.1 1.9 1.9 0 180 A 1.9 1.9 1.9 1.9 180 322"},
    {U'f', 2.3, "M 0 4.8 L 2.2 4.8 M .8 0 A 2.1 5.6 1.3 1.4 180 85"},
    {U'g', 3.8,
     "M 3.8 3.1 A 1.9 3.1 1.9 1.9 0 180 A 1.9 1.9 1.9 1.9 180 360 M 3.8 5 A 1.9 -.4 1.9 1.6 0 -145"},
    {U'h', 3.6, "M 0 0 L 0 7 M 0 3.2 A 1.8 3.2 1.8 1.8 180 0 L 3.6 0"},
    {U'i', 0, "M 0 0 L 0 5 D 0 6.8"},
    {U'j', .9, "M .9 5 L .9 -.7 A -.4 -.7 1.3 1.2 0 -90 D .9 6.8"},
    {U'k', 3.4, "M 0 0 L 0 7 M 3.2 5 L 0 1.8 M 1.25 3.05 L 3.4 0"},
    {U'l', .9, "M 0 7 A 1.1 1.1 1.1 1.1 180 265"},
    {U'm', 5.8,
     "M 0 0 L 0 5 M 0 3.4 A 1.45 3.55 1.45 1.45 180 0 L 2.9 0 M 2.9 3.55 A 4.35 3.55 1.45 1.45 180 0 L 5.8 "
     "0"},
    {U'n', 3.6, "M 0 0 L 0 5 M 0 3.2 A 1.8 3.2 1.8 1.8 180 0 L 3.6 0"},
    {U'o', 3.8, "A 1.9 3.1 1.9 1.9 180 0 A 1.9 1.9 1.9 1.9 0 -180 L 0 3.1"},
    {U'p', 3.8, "M 0 -2 L 0 5 M 0 3.1 A 1.9 3.1 1.9 1.9 180 0 A 1.9 1.9 1.9 1.9 0 -180"},
    {U'q', 3.8, "M 3.8 -2 L 3.8 5 M 3.8 3.1 A 1.9 3.1 1.9 1.9 0 180 A 1.9 1.9 1.9 1.9 180 360"},
    {U'r', 2.1, "M 0 0 L 0 5 M 0 3.1 A 1.8 3.2 1.8 1.8 180 80"},
    {U's', 3.3, "A 1.7 3.75 1.55 1.25 30 250 A 1.65 1.3 1.65 1.3 70 -150"},
    {U't', 2.3, "M 0 4.8 L 2.2 4.8 M .8 6.5 A 2 1.3 1.2 1.3 180 280"},
    {U'u', 3.6, "M 0 5 A 1.8 1.8 1.8 1.8 180 360 M 3.6 5 L 3.6 0"},
    {U'v', 3.8, "M 0 5 L 1.9 0 L 3.8 5"},
    {U'w', 5.4, "M 0 5 L 1.35 0 L 2.7 4.5 L 4.05 0 L 5.4 5"},
    {U'x', 3.5, "M 0 0 L 3.4 5 M .1 5 L 3.5 0"},
    {U'y', 3.8, "M 0 5 L 1.95 .1 M 3.8 5 L 1.6 -.9 A .2 -.6 1.4 1.4 -15 -90"},
    {U'z', 3.2, "M .1 5 L 3.1 5 L 0 0 L 3.2 0"},
    {U'.', 0, "D 0 .1"},
    {U',', .2, "M .2 .1 L -.2 -1.2"},
    {U':', 0, "D 0 .4 D 0 4.4"},
    {U';', .2, "D .1 4.4 M .2 .2 L -.2 -1.1"},
    {U'!', 0, "M 0 7 L 0 2.2 D 0 .1"},
    {U'?', 3.2, "A 1.6 5.4 1.6 1.6 160 -55 L 1.5 3.2 L 1.5 2.2 D 1.5 .1"},
    {U'\'', 0, "M 0 7 L 0 5.2"},
    {U'"', 1.4, "M 0 7 L 0 5.2 M 1.4 7 L 1.4 5.2"},
    {U'(', 1.5, "A 3 3 3 5.2 122 238"},
    {U')', 1.5, "A -1.5 3 3 5.2 58 -58"},
    {U'[', 1.4, "M 1.4 7.4 L 0 7.4 L 0 -1.4 L 1.4 -1.4"},
    {U']', 1.4, "M 0 7.4 L 1.4 7.4 L 1.4 -1.4 L 0 -1.4"},
    {U'{', 2, "A 2 6.4 1 1 90 180 L 1 4 A 0 4 1 1 0 -90 M 0 3 A 0 2 1 1 90 0 L 1 -.4 A 2 -.4 1 1 180 270"},
    {U'}', 2, "A 0 6.4 1 1 90 0 L 1 4 A 2 4 1 1 180 270 M 2 3 A 2 2 1 1 90 180 L 1 -.4 A 0 -.4 1 1 0 -90"},
    {U'<', 3.8, "M 3.8 5.8 L 0 3.4 L 3.8 1"},
    {U'>', 3.8, "M 0 5.8 L 3.8 3.4 L 0 1"},
    {U'=', 4, "M 0 4.5 L 4 4.5 M 0 2.4 L 4 2.4"},
    {U'+', 4, "M 0 3.4 L 4 3.4 M 2 1.4 L 2 5.4"},
    {U'-', 2.4, "M 0 3 L 2.4 3"},
    {U'_', 4, "M 0 -1.2 L 4 -1.2"},
    {U'/', 3, "M 0 -1 L 3 7.6"},
    {U'\\', 3, "M 0 7.6 L 3 -1"},
    {U'|', 0, "M 0 -1.6 L 0 7.6"},
    {U'*', 3, "M 1.5 7 L 1.5 3.8 M .1 6.2 L 2.9 4.6 M 2.9 6.2 L .1 4.6"},
    {U'#', 4.6, "M 1.7 7 L .9 0 M 3.8 7 L 3 0 M .2 4.8 L 4.6 4.8 M 0 2.2 L 4.4 2.2"},
    {U'%', 6, "A 1.3 5.5 1.3 1.5 0 360 M 6 1.5 A 4.7 1.5 1.3 1.5 0 360 M 4.6 7 L 1.4 0"},
    {U'&', 4.8, "M 4.7 0 L 1.1 4.6 A 2 5.7 1.3 1.3 220 -30 L 1 3.4 A 1.8 1.8 1.8 1.8 118 300 L 4.5 3.2"},
    {U'@', 6.2,
     "M 4.4 4.4 L 4.4 2 A 5.3 2.2 .9 .9 180 360 L 6.2 3.4 A 3.1 3.2 3.1 3.4 0 305 M 4.4 3.2 A 3 3.2 1.4 1.4 "
     "0 360"},
    {U'$', 4, "A 2.05 5 1.9 1.5 30 250 A 2 2 2 1.5 70 -150 M 2 7.5 L 2 -.5"},
    {U'^', 3, "M 0 4.6 L 1.5 7 L 3 4.6"},
    {U'~', 4, "A 1 3 1 .8 180 30 A 3 3.8 1 .8 210 360"},
    {U'`', 1, "M 0 7.2 L 1 6"},
    {U'\u2212', 4, "M 0 3.4 L 4 3.4"},
    {U'\u2013', 3.6, "M 0 3 L 3.6 3"},
    {U'\u2014', 6, "M 0 3 L 6 3"},
    {U'\u2026', 4, "D 0 .1 D 2 .1 D 4 .1"},
    {U'\u00d7', 3.4, "M .2 1.9 L 3.2 4.9 M .2 4.9 L 3.2 1.9"},
    {U'\u00b7', 0, "D 0 3.4"},
    {U'\u00b1', 4, "M 0 4.2 L 4 4.2 M 2 2.2 L 2 6.2 M 0 .6 L 4 .6"},
    {U'\u00b0', 2.2, "A 1.1 6 1.1 1.1 0 360"},
    {U'\u00b2', 2.2, "A 1.1 6.1 1.1 .9 165 -43 L 0 3.8 L 2.3 3.8"},
    {U'\u00b3', 2.2, "A 1.05 6.25 .95 .75 155 -90 A 1.05 4.7 1.1 .85 90 -160"},
    {U'\u2264', 3.8, "M 3.8 6 L 0 3.9 L 3.8 1.8 M 0 .4 L 3.8 .4"},
    {U'\u2265', 3.8, "M 0 6 L 3.8 3.9 L 0 1.8 M 0 .4 L 3.8 .4"},
    {U'\u2248', 4, "A 1 4.2 1 .8 180 30 A 3 5 1 .8 210 360 M 0 1.8 A 1 1.8 1 .8 180 30 A 3 2.6 1 .8 210 360"},
    {U'\u2192', 5.2, "M 0 3.2 L 5.2 3.2 M 3.4 5 L 5.2 3.2 L 3.4 1.4"},
    {U'\u00b5', 3.6, "M 0 -2 L 0 5 M 0 1.8 A 1.8 1.8 1.8 1.8 180 360 M 3.6 5 L 3.6 0"},
    {U'\u03bc', 3.6, "M 0 -2 L 0 5 M 0 1.8 A 1.8 1.8 1.8 1.8 180 360 M 3.6 5 L 3.6 0"},
    {U'\u03ba', 3.4, "M 0 0 L 0 5 M 3.2 5 L 0 2 M 1.2 3.1 L 3.4 0"},
    {U'\u03bb', 3.8, "M .3 7 L 1 7 L 3.8 0 M 2 4.5 L 0 0"},
    {U'\u03c3', 4.2, "M 4.2 5 L 1.9 5 A 1.9 2.5 1.9 2.5 90 450"},
    {U'\u03b5', 3.2, "A 1.7 3.8 1.5 1.2 30 270 L 2.2 2.6 M 1.7 2.6 A 1.7 1.3 1.7 1.3 90 330"},
    {U'\u03b1', 4.2, "M 4.1 5 L 3.4 2 A 1.8 2.5 1.8 2.5 40 320 M 3.4 2 A 4.4 1.1 .9 1.1 190 260"},
    {U'\u03c0', 4.2, "M 0 4.9 L 4.2 4.9 M 1 4.9 L 1 0 M 3.2 4.9 L 3.2 0"},
    {U'\u03c6', 4.6, "A 2.3 2.5 2.3 2.5 0 360 M 2.3 -2 L 2.3 7"},
    {U'\u0394', 5, "M 0 0 L 2.5 7 L 5 0 L 0 0"},
};

constexpr Glyph_source unknown_glyph = {0, 3.6, "M 0 0 L 0 7 L 3.6 7 L 3.6 0 L 0 0"};

struct Segment
{
  Pixel_point a, b;
};

struct Glyph
{
  double width = 0;
  std::vector<Segment> segments;
};

Glyph read_glyph(const Glyph_source& source)
{
  Glyph glyph;
  glyph.width = source.width;
  std::istringstream path(source.path);
  std::string command;
  Pixel_point pen;
  bool down = false;
  const auto line_to = [&](Pixel_point p)
  {
    if(down)
      glyph.segments.push_back({pen, p});
    pen = p;
    down = true;
  };
  while(path >> command)
  {
    if(command == "A")
    {
      double cx, cy, rx, ry, from, to;
      path >> cx >> cy >> rx >> ry >> from >> to;
      const int steps = std::max(2, int(std::abs(to - from) / 9));
      for(int i = 0; i <= steps; ++i)
      {
        const double angle = (from + (to - from) * i / steps) * CGAL_PI / 180;
        line_to({cx + rx * std::cos(angle), cy + ry * std::sin(angle)});
      }
      continue;
    }
    Pixel_point p;
    path >> p.x >> p.y;
    if(command != "L")
      down = false;
    line_to(p);
    if(command == "D")
    {
      glyph.segments.push_back({p, p});
      down = false;
    }
  }
  return glyph;
}

const Glyph& glyph(char32_t code)
{
  static const std::map<char32_t, Glyph> glyphs = []
  {
    std::map<char32_t, Glyph> read;
    for(const Glyph_source& source : glyph_sources)
      read[source.code] = read_glyph(source);
    return read;
  }();
  static const Glyph unknown = read_glyph(unknown_glyph);
  const auto found = glyphs.find(code);
  return found == glyphs.end() ? unknown : found->second;
}

// The code points of a UTF-8 text; a byte that doesn't belong there becomes U+FFFD.
std::u32string decoded(const std::string& utf8)
{
  std::u32string text;
  for(std::size_t i = 0; i < utf8.size();)
  {
    const unsigned char lead = static_cast<unsigned char>(utf8[i++]);
    const int more = lead < 0x80 ? 0 : lead >> 5 == 6 ? 1 : lead >> 4 == 14 ? 2 : lead >> 3 == 30 ? 3 : -1;
    char32_t code = more <= 0 ? lead : lead & (0x3f >> more);
    bool good = more >= 0;
    for(int k = 0; good && k < more; ++k)
    {
      good = i < utf8.size() && (static_cast<unsigned char>(utf8[i]) & 0xc0) == 0x80;
      if(good)
        code = code << 6 | (static_cast<unsigned char>(utf8[i++]) & 0x3f);
    }
    text += good ? code : char32_t(0xfffd);
  }
  return text;
}

std::string encoded(const std::u32string& text)
{
  std::string utf8;
  for(char32_t c : text)
  {
    if(c < 0x80)
      utf8 += char(c);
    else if(c < 0x800)
      (utf8 += char(0xc0 | c >> 6)) += char(0x80 | (c & 0x3f));
    else if(c < 0x10000)
      ((utf8 += char(0xe0 | c >> 12)) += char(0x80 | (c >> 6 & 0x3f))) += char(0x80 | (c & 0x3f));
    else
      (((utf8 += char(0xf0 | c >> 18)) += char(0x80 | (c >> 12 & 0x3f))) += char(0x80 | (c >> 6 & 0x3f))) +=
          char(0x80 | (c & 0x3f));
  }
  return utf8;
}

struct Placed_glyph
{
  const Glyph* glyph;
  double x, y, scale; // the glyph's origin and unit, in units of the text
};

constexpr double letter_spacing = 1.75;

// Lays out a line of text in units of the typeface; `width` receives its length.
std::vector<Placed_glyph> laid_out(const std::string& utf8, bool bold, double& width)
{
  const std::u32string text = decoded(utf8);
  const double spacing = letter_spacing + (bold ? 0.25 : 0);
  std::vector<Placed_glyph> line;
  double x = 0, y = 0, scale = 1;
  for(std::size_t i = 0; i < text.size(); ++i)
  {
    if((text[i] == U'^' || text[i] == U'_') && i + 1 < text.size() && text[i + 1] == U'{' && scale == 1 &&
       text.find(U'}', i) != std::u32string::npos)
    {
      y = text[i] == U'^' ? 3.4 : -1.5;
      scale = 0.68;
      ++i;
      continue;
    }
    if(text[i] == U'}' && scale != 1)
    {
      y = 0;
      scale = 1;
      continue;
    }
    const Glyph& g = glyph(text[i]);
    line.push_back({&g, x, y, scale});
    x += scale * (g.width + spacing);
  }
  width = line.empty() ? 0 : x - spacing * line.back().scale;
  return line;
}

// ---------------------------------------------------------------------------------------- coverage

double squared_distance(double x, double y, const Segment& s)
{
  const double dx = s.b.x - s.a.x, dy = s.b.y - s.a.y;
  const double length2 = dx * dx + dy * dy;
  double t = length2 > 0 ? ((x - s.a.x) * dx + (y - s.a.y) * dy) / length2 : 0;
  t = std::min(std::max(t, 0.), 1.);
  const double ex = x - s.a.x - t * dx, ey = y - s.a.y - t * dy;
  return ex * ex + ey * ey;
}

// Pixels within `radius` of the union of the segments: each pixel is blended once, so that joints don't
// show.
void stroke(Image& image, const std::vector<Segment>& segments, double radius, Rgba color)
{
  if(segments.empty())
    return;
  double left = image.width(), right = 0, top = image.height(), bottom = 0;
  for(const Segment& s : segments)
  {
    left = std::min({left, s.a.x, s.b.x});
    right = std::max({right, s.a.x, s.b.x});
    top = std::min({top, s.a.y, s.b.y});
    bottom = std::max({bottom, s.a.y, s.b.y});
  }
  const double reach = radius + 1;
  const auto first = [&](double from) { return int(std::floor(std::max(from - reach, 0.))); };
  const auto last = [&](double to, int size) { return int(std::ceil(std::min(to + reach, double(size)))); };
  const int x0 = first(left), y0 = first(top);
  const int x1 = last(right, image.width()), y1 = last(bottom, image.height());
  if(x0 >= x1 || y0 >= y1)
    return;
  // Strokes thinner than a pixel fade instead of breaking up.
  const double drawn = std::max(radius, 0.5), fade = radius / drawn;
  std::vector<float> mask(std::size_t(x1 - x0) * std::size_t(y1 - y0), 0.f);
  for(const Segment& s : segments)
  {
    const int sx0 = std::max(x0, first(std::min(s.a.x, s.b.x)));
    const int sx1 = std::min(x1, last(std::max(s.a.x, s.b.x), image.width()));
    const int sy0 = std::max(y0, first(std::min(s.a.y, s.b.y)));
    const int sy1 = std::min(y1, last(std::max(s.a.y, s.b.y), image.height()));
    for(int y = sy0; y < sy1; ++y)
      for(int x = sx0; x < sx1; ++x)
      {
        const double d2 = squared_distance(x + 0.5, y + 0.5, s);
        if(d2 < (drawn + 0.5) * (drawn + 0.5))
        {
          float& m = mask[std::size_t(y - y0) * std::size_t(x1 - x0) + std::size_t(x - x0)];
          m = std::max(m, float(std::min(drawn + 0.5 - std::sqrt(d2), 1.) * fade));
        }
      }
  }
  for(int y = y0; y < y1; ++y)
    for(int x = x0; x < x1; ++x)
      image.blend(x, y, color, mask[std::size_t(y - y0) * std::size_t(x1 - x0) + std::size_t(x - x0)]);
}

double text_unit(const Text_style& style)
{
  return style.size / 10;
}
double pen_radius(const Text_style& style)
{
  return (style.bold ? 0.66 : 0.45) * text_unit(style);
}

} // namespace

double Painter::text_width(const std::string& utf8, const Text_style& style)
{
  double width = 0;
  laid_out(utf8, style.bold, width);
  return width * text_unit(style) + 2 * pen_radius(style);
}

void Painter::text(const std::string& utf8, Pixel_point at, const Text_style& style)
{
  double width = 0;
  const std::vector<Placed_glyph> line = laid_out(utf8, style.bold, width);
  const double unit = text_unit(style), radius = pen_radius(style);
  const double x0 = style.horizontal == Horizontal_alignment::LEFT     ? radius
                    : style.horizontal == Horizontal_alignment::CENTER ? -width * unit / 2
                                                                       : -width * unit - radius;
  const double y0 = style.vertical == Vertical_alignment::MIDDLE ? -3.5 * unit : 0;
  const double c = std::cos(style.angle * CGAL_PI / 180), s = std::sin(style.angle * CGAL_PI / 180);
  for(const Placed_glyph& placed : line)
  {
    const auto placed_point = [&](Pixel_point p)
    {
      const double x = x0 + unit * (placed.x + placed.scale * p.x);
      const double y = y0 + unit * (placed.y + placed.scale * p.y);
      return Pixel_point{at.x + c * x - s * y, at.y - s * x - c * y};
    };
    std::vector<Segment> segments;
    for(const Segment& segment : placed.glyph->segments)
      segments.push_back({placed_point(segment.a), placed_point(segment.b)});
    stroke(image_, segments, radius * std::sqrt(placed.scale), style.color);
  }
}

void Painter::polyline(const std::vector<Pixel_point>& points, double width, Rgba color, double dash)
{
  std::vector<Segment> segments;
  double length = 0; // so far, modulo a dash and its gap
  for(std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    const Pixel_point a = points[i], b = points[i + 1];
    const double whole = std::hypot(b.x - a.x, b.y - a.y);
    if(dash <= 0 || whole == 0)
    {
      segments.push_back({a, b});
      continue;
    }
    const auto along = [&](double t) {
      return Pixel_point{a.x + (b.x - a.x) * t / whole, a.y + (b.y - a.y) * t / whole};
    };
    const double period = dash + std::max(0.7 * dash, 2 * width);
    double t = 0;
    while(t < whole)
    {
      const bool on = length < dash;
      const double step = std::min(whole - t, (on ? dash : period) - length);
      if(on)
        segments.push_back({along(t), along(t + step)});
      t += step;
      length += step;
      if(length >= period * (1 - 1e-12))
        length = 0;
    }
  }
  stroke(image_, segments, width / 2, color);
}

void Painter::fill(const Rectangle& r, Rgba color)
{
  const auto overlap = [](double a, double b, int pixel)
  { return std::max(0., std::min(b, pixel + 1.) - std::max(a, double(pixel))); };
  const int x1 = int(std::min(std::ceil(r.right()), double(image_.width())));
  const int y1 = int(std::min(std::ceil(r.bottom()), double(image_.height())));
  for(int y = int(std::max(std::floor(r.top), 0.)); y < y1; ++y)
    for(int x = int(std::max(std::floor(r.left), 0.)); x < x1; ++x)
      image_.blend(x, y, color, float(overlap(r.left, r.right(), x) * overlap(r.top, r.bottom(), y)));
}

void Painter::frame(const Rectangle& r, double width, Rgba color)
{
  fill({r.left, r.top, r.width, width}, color);
  fill({r.left, r.bottom() - width, r.width, width}, color);
  fill({r.left, r.top + width, width, r.height - 2 * width}, color);
  fill({r.right() - width, r.top + width, width, r.height - 2 * width}, color);
}

void Painter::convex_polygon(const std::vector<Pixel_point>& corners, Rgba color)
{
  if(corners.size() < 3)
    return;
  double left = corners[0].x, right = left, top = corners[0].y, bottom = top, area = 0;
  for(std::size_t i = 0; i < corners.size(); ++i)
  {
    const Pixel_point p = corners[i], q = corners[(i + 1) % corners.size()];
    left = std::min(left, p.x);
    right = std::max(right, p.x);
    top = std::min(top, p.y);
    bottom = std::max(bottom, p.y);
    area += p.x * q.y - q.x * p.y;
  }
  const double turn = area < 0 ? -1 : 1;
  const int x1 = int(std::min(std::ceil(right + 1), double(image_.width())));
  const int y1 = int(std::min(std::ceil(bottom + 1), double(image_.height())));
  for(int y = int(std::max(std::floor(top - 1), 0.)); y < y1; ++y)
    for(int x = int(std::max(std::floor(left - 1), 0.)); x < x1; ++x)
    {
      double inside = std::numeric_limits<double>::infinity();
      for(std::size_t i = 0; i < corners.size(); ++i)
      {
        const Pixel_point p = corners[i], q = corners[(i + 1) % corners.size()];
        const double length = std::hypot(q.x - p.x, q.y - p.y);
        if(length > 0)
          inside = std::min(inside,
                            turn * ((q.x - p.x) * (y + 0.5 - p.y) - (q.y - p.y) * (x + 0.5 - p.x)) / length);
      }
      image_.blend(x, y, color, float(std::min(inside + 0.5, 1.)));
    }
}

void Painter::marker(Marker kind, Pixel_point at, double diameter, Rgba color)
{
  const double r = diameter / 2;
  const auto polygon = [&](int corners, double start, double radius)
  {
    std::vector<Pixel_point> points;
    for(int i = 0; i < corners; ++i)
    {
      const double angle = (start + 360. * i / corners) * CGAL_PI / 180;
      points.push_back({at.x + radius * std::cos(angle), at.y - radius * std::sin(angle)});
    }
    convex_polygon(points, color);
  };
  switch(kind)
  {
  case Marker::NONE:
    break;
  case Marker::DISC:
    stroke(image_, {{at, at}}, r, color);
    break;
  case Marker::SQUARE:
    polygon(4, 45, 1.25 * r);
    break;
  case Marker::TRIANGLE:
    polygon(3, 90, 1.32 * r);
    break;
  case Marker::INVERTED_TRIANGLE:
    polygon(3, 270, 1.32 * r);
    break;
  case Marker::DIAMOND:
    polygon(4, 0, 1.3 * r);
    break;
  case Marker::CROSS:
    stroke(image_,
           {{{at.x - .8 * r, at.y - .8 * r}, {at.x + .8 * r, at.y + .8 * r}},
            {{at.x - .8 * r, at.y + .8 * r}, {at.x + .8 * r, at.y - .8 * r}}},
           0.3 * r, color);
    break;
  case Marker::RING:
  {
    std::vector<Pixel_point> circle;
    for(int i = 0; i <= 32; ++i)
      circle.push_back(
          {at.x + .8 * r * std::cos(i * CGAL_PI / 16), at.y + .8 * r * std::sin(i * CGAL_PI / 16)});
    polyline(circle, 0.5 * r, color);
    break;
  }
  }
}

std::string shortened_text(const std::string& utf8, double width, const Text_style& style)
{
  if(Painter::text_width(utf8, style) <= width)
    return utf8;
  std::u32string text = decoded(utf8);
  while(!text.empty() && Painter::text_width(encoded(text) + "\u2026", style) > width)
    text.pop_back();
  return encoded(text) + "\u2026";
}

} // namespace support
