#include <boost/test/unit_test.hpp>

#include "../../examples/support/Contact_sheet.h"
#include "../../examples/support/Mesh_renderer.h"
#include "../../examples/support/Painter.h"
#include "../../examples/support/Plot.h"
#include "../../examples/support/Ply_file.h"
#include "../../examples/support/Progress_bar.h"
#include "../../examples/support/Ticks.h"
#include "../../examples/support/data_file.h"
#include "../../examples/support/drawable_mesh.h"
#include "../../examples/support/local_spacing.h"
#include "../../examples/support/picture.h"

#include <Shape_characteristics/internal/CGAL_compatibility.h>

#include <CGAL/IO/PLY.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(support)

namespace {

using namespace support;

constexpr double pi = CGAL_PI;
constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

struct Temporary_file
{
  std::string name;
  explicit Temporary_file(const std::string& suffix)
  {
    static int count = 0;
    name = (std::filesystem::temp_directory_path() /
            ("support_" + std::to_string(std::random_device()()) + "_" + std::to_string(count++) + suffix))
               .string();
  }
  ~Temporary_file() { std::remove(name.c_str()); }
};

// A sphere of `n` rings by `2n` segments.
Drawable sphere(int n, double radius, const Vector& center)
{
  Drawable s;
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j < 2 * n; ++j)
    {
      const double a = pi * i / n, b = pi * j / n;
      const Vector u = {std::sin(a) * std::cos(b), std::cos(a), -std::sin(a) * std::sin(b)};
      s.points.push_back({center[0] + radius * u[0], center[1] + radius * u[1], center[2] + radius * u[2]});
      s.normals.push_back(u);
    }
  for(std::size_t i = 0; i < std::size_t(n); ++i)
    for(std::size_t j = 0, m = 2 * std::size_t(n); j < m; ++j)
    {
      const std::size_t p = i * m + j, q = i * m + (j + 1) % m;
      s.triangles.push_back({p, p + m, q});
      s.triangles.push_back({q, p + m, q + m});
    }
  return s;
}

// Two triangles in the plane z = 0 that fill [0,2] x [0,2], looked at from +z.
Drawable square()
{
  Drawable s;
  s.points = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  s.triangles = {{0, 1, 2}, {0, 2, 3}};
  return s;
}

Render_options frontal(int width, int height)
{
  Render_options options;
  options.width = width;
  options.height = height;
  options.camera.towards_eye = {0, 0, 1};
  return options;
}

double covered_fraction(const Image& image)
{
  double count = 0;
  for(int y = 0; y < image.height(); ++y)
    for(int x = 0; x < image.width(); ++x)
      count += image.at(x, y) != Rgba{255, 255, 255, 255};
  return count / image.width() / image.height();
}

double hue(Rgba c)
{
  const double r = c.r, g = c.g, b = c.b;
  return std::atan2(std::sqrt(3.) * (g - b), 2 * r - g - b) * 180 / pi;
}

double hue_difference(Rgba a, Rgba b)
{
  const double d = std::abs(hue(a) - hue(b));
  return std::min(d, 360 - d);
}

double saturation(Rgba c)
{
  return 1 - double(std::min({c.r, c.g, c.b})) / std::max({int(c.r), int(c.g), int(c.b), 1});
}

int difference(const Image& a, const Image& b)
{
  BOOST_REQUIRE_EQUAL(a.width(), b.width());
  BOOST_REQUIRE_EQUAL(a.height(), b.height());
  int largest = 0;
  for(int y = 0; y < a.height(); ++y)
    for(int x = 0; x < a.width(); ++x)
    {
      const Rgba p = a.at(x, y), q = b.at(x, y);
      largest = std::max({largest, std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
    }
  return largest;
}

} // namespace

BOOST_AUTO_TEST_CASE(png_is_read_as_it_was_written)
{
  std::mt19937 random(1);
  Image image(37, 23);
  for(int y = 0; y < 23; ++y)
    for(int x = 0; x < 37; ++x)
      image.at(x, y) = {std::uint8_t(random()), std::uint8_t(random()), std::uint8_t(random()),
                        std::uint8_t(random())};
  const Temporary_file file(".png");
  write_png(file.name, image);
  const Image again = read_png(file.name);
  BOOST_REQUIRE_EQUAL(again.width(), 37);
  BOOST_REQUIRE_EQUAL(again.height(), 23);
  for(int y = 0; y < 23; ++y)
    for(int x = 0; x < 37; ++x)
      BOOST_REQUIRE(image.at(x, y) == again.at(x, y));
  // a file made by hand: red, blue; (1,2,3), green
  const unsigned char bytes[] = {0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49,
                                 0x48, 0x44, 0x52, 0x00, 0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x02, 0x08, 0x02,
                                 0x00, 0x00, 0x00, 0xfd, 0xd4, 0x9a, 0x73, 0x00, 0x00, 0x00, 0x14, 0x49, 0x44,
                                 0x41, 0x54, 0x78, 0xda, 0x63, 0xf8, 0xcf, 0x00, 0x04, 0x27, 0x18, 0x18, 0x99,
                                 0x98, 0x19, 0x1a, 0x18, 0x00, 0x14, 0x5d, 0x02, 0x4e, 0x53, 0x83, 0x52, 0xf6,
                                 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
  std::ofstream(file.name, std::ios::binary).write(reinterpret_cast<const char*>(bytes), sizeof bytes);
  const Image known = read_png(file.name);
  BOOST_REQUIRE_EQUAL(known.width(), 2);
  BOOST_REQUIRE_EQUAL(known.height(), 2);
  BOOST_CHECK(known.at(0, 0) == (Rgba{255, 0, 0, 255}));
  BOOST_CHECK(known.at(1, 0) == (Rgba{0, 0, 200, 255}));
  BOOST_CHECK(known.at(0, 1) == (Rgba{1, 2, 3, 255}));
  BOOST_CHECK(known.at(1, 1) == (Rgba{0, 128, 0, 255}));
  BOOST_CHECK_THROW(write_png("/no such folder/picture.png", image), std::runtime_error);
  BOOST_CHECK_THROW(write_png(file.name, Image()), std::runtime_error);
  BOOST_CHECK_THROW(read_png("/no such folder/picture.png"), std::runtime_error);
  BOOST_CHECK_THROW(Image(0, 5), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(percentiles)
{
  // 0, 1 ... 100 in another order
  std::vector<double> values;
  for(int i = 0; i <= 100; ++i)
    values.push_back((37 * i) % 101);
  BOOST_CHECK_EQUAL(percentile(values, 0), 0);
  BOOST_CHECK_EQUAL(percentile(values, 0.02), 2);
  BOOST_CHECK_EQUAL(percentile(values, 0.5), 50);
  BOOST_CHECK_EQUAL(percentile(values, 1), 100);
  BOOST_CHECK_CLOSE(percentile(values, 0.255), 25.5, 1e-9);
  BOOST_CHECK_CLOSE(percentile({1, nan_value, 2, INFINITY, -INFINITY}, 0.25), 1.25, 1e-12);
  BOOST_CHECK_THROW(percentile({nan_value}, 0.5), std::invalid_argument);
  BOOST_CHECK_THROW(percentile({1}, 1.5), std::invalid_argument);
  BOOST_CHECK_THROW(percentile({1}, nan_value), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(ranges_are_clipped_and_never_empty)
{
  std::vector<double> values;
  for(int i = 0; i <= 100; ++i)
    values.push_back(i);
  Value_range range = percentile_range(values, 0.02);
  BOOST_CHECK_EQUAL(range.low, 2);
  BOOST_CHECK_EQUAL(range.high, 98);
  BOOST_CHECK(range.clips_low && range.clips_high);
  values.back() = 1e30; // an outlier changes nothing
  values.push_back(nan_value);
  range = percentile_range(values, 0.02);
  BOOST_CHECK_EQUAL(range.high, 98);

  range = percentile_range({-1, 0, 3}, 0, true);
  BOOST_CHECK_EQUAL(range.low, -3);
  BOOST_CHECK_EQUAL(range.high, 3);
  BOOST_CHECK_EQUAL(range.position(0), 0.5);
  BOOST_CHECK(!range.clips_low && !range.clips_high);

  for(const std::vector<double>& odd : {std::vector<double>{},
                                        {nan_value, INFINITY},
                                        {0, 0, 0},
                                        {5},
                                        {-7, -7 - 1e-12},
                                        {1e-300, 1e-300},
                                        {1e300}})
    for(bool symmetric : {false, true})
    {
      range = percentile_range(odd, 0.02, symmetric);
      BOOST_CHECK(std::isfinite(range.low) && std::isfinite(range.high) && range.low < range.high);
      for(double v : odd)
        if(std::isfinite(v))
          BOOST_CHECK(range.position(v) >= 0 && range.position(v) <= 1);
    }
  // equal values are in the middle; mostly equal values don't hide the others
  BOOST_CHECK_CLOSE(percentile_range({5, 5}).position(5), 0.5, 1e-9);
  std::vector<double> flat(1000, 0.);
  flat[3] = -2;
  flat[7] = 4;
  range = percentile_range(flat, 0.02);
  BOOST_CHECK(range.low < 0 && range.low >= -2 && range.high > 0 && range.high <= 4);
  BOOST_CHECK_THROW(percentile_range({1}, 0.5), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(gradient_is_blue_green_red)
{
  const Color_gradient gradient = Color_gradient::blue_green_red();
  BOOST_CHECK_SMALL(hue_difference(gradient.pixel(0), {0, 0, 255, 255}), 15.);
  BOOST_CHECK_SMALL(hue_difference(gradient.pixel(0.5), {0, 255, 0, 255}), 15.);
  BOOST_CHECK_SMALL(hue_difference(gradient.pixel(1), {255, 0, 0, 255}), 15.);
  BOOST_CHECK(gradient.pixel(-3) == gradient.pixel(0));
  BOOST_CHECK(gradient.pixel(7) == gradient.pixel(1));
  // the hue runs one way, without jumps, and is never as pale as the grey of missing values
  double last = hue(gradient.pixel(0));
  for(int i = 1; i <= 1000; ++i)
  {
    const Rgba c = gradient.pixel(i / 1000.);
    double step = last - hue(c);
    step = step < -180 ? step + 360 : step;
    BOOST_REQUIRE_GT(step, -1.5); // 8 bits per channel
    BOOST_REQUIRE_LT(step, 3);
    BOOST_REQUIRE_GT(saturation(c), 0.5);
    last = hue(c);
  }
  BOOST_CHECK_LT(saturation(missing_value_color), 0.05);
  // passes through its stops; monotone between them
  const Color_gradient grey({{0, 0, 0}, {0.2, 0.2, 0.2}, {1, 1, 1}});
  BOOST_CHECK_EQUAL(grey(0.5)[0], 0.2);
  for(int i = 0; i < 100; ++i)
    BOOST_CHECK_LE(grey(i / 100.)[1], grey((i + 1) / 100.)[1]);
  BOOST_CHECK_THROW(Color_gradient(std::vector<Color_gradient::Rgb>(1)), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(spacing_against_all_pairs)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform;
  std::vector<Vector> points;
  for(int i = 0; i < 500; ++i)
    points.push_back({uniform(random), std::pow(uniform(random), 4), i % 3 ? 0. : uniform(random)});
  points[7] = points[8];
  points[100] = {nan_value, 0, 0};
  const std::vector<double> spacing = local_spacing(points, 5);
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    if(i == 100)
    {
      BOOST_CHECK_EQUAL(spacing[i], 0);
      continue;
    }
    std::vector<double> distances;
    for(std::size_t j = 0; j < points.size(); ++j)
      if(j != i && j != 100)
        distances.push_back(std::hypot(points[i][0] - points[j][0], points[i][1] - points[j][1],
                                       points[i][2] - points[j][2]));
    std::sort(distances.begin(), distances.end());
    double mean = 0;
    for(int k = 0; k < 5; ++k)
      mean += distances[std::size_t(k)] / 5;
    BOOST_REQUIRE_CLOSE(spacing[i], mean, 1e-9);
  }
  BOOST_CHECK_EQUAL(local_spacing({{1, 2, 3}}).at(0), 0);
}

BOOST_AUTO_TEST_CASE(sphere_fills_the_frame)
{
  Mesh_renderer renderer;
  BOOST_TEST_MESSAGE(renderer.description());
  Render_options options = frontal(300, 300);
  options.margin = 0.05;
  const Drawable ball = sphere(80, 1, {0, 0, 0});
  const Image reference = renderer.render(ball, options);
  BOOST_CHECK_CLOSE(covered_fraction(reference), pi / 4 * 0.9 * 0.9, 2.);
  // in a wide picture it is as high as in the square one
  options.width = 600;
  BOOST_CHECK_CLOSE(covered_fraction(renderer.render(ball, options)), pi / 8 * 0.9 * 0.9, 2.);
  options.width = 300;
  // from anywhere
  options.camera.towards_eye = {0, 5, 0};
  BOOST_CHECK_CLOSE(covered_fraction(renderer.render(ball, options)), pi / 4 * 0.9 * 0.9, 2.);
  options.camera.towards_eye = {0, 0, 1};
  // of any size, anywhere
  for(const Drawable& other : {sphere(80, 1e-9, {0, 0, 0}), sphere(80, 1e9, {1e10, 0, 0}),
                               sphere(80, 1, {1e7, -3e7, 5e6}), sphere(80, 1e305, {0, 0, 0})})
    BOOST_CHECK_LE(difference(reference, renderer.render(other, options)), 4);
  // its points alone
  Drawable cloud = ball;
  cloud.triangles.clear();
  BOOST_CHECK_CLOSE(covered_fraction(renderer.render(cloud, options)), pi / 4 * 0.9 * 0.9, 6.);
  // computed normals are nearly the exact ones
  Drawable without = ball;
  without.normals.clear();
  int different = 0;
  const Image computed = renderer.render(without, options);
  for(int y = 0; y < 300; ++y)
    for(int x = 0; x < 300; ++x)
      different += std::abs(computed.at(x, y).g - reference.at(x, y).g) > 8;
  BOOST_CHECK_LT(different, 300);
}

BOOST_AUTO_TEST_CASE(colours_show_the_scalars)
{
  Mesh_renderer renderer;
  Render_options options = frontal(200, 200);
  options.margin = 0;
  options.range = percentile_range({-1, 1}, 0);
  Drawable s = square();
  s.scalars = {-1, 1, 1, -1}; // grows to the right
  const Image image = renderer.render(s, options);
  for(int x = 10; x < 200; x += 10)
    BOOST_CHECK_SMALL(hue_difference(image.at(x, 60), options.gradient.pixel((x + 0.5) / 200)), 8.);
  // a far value makes the colours steeper, within the triangle, instead of shifting them
  s.scalars = {-11, 9, 9, -11};
  const Image steep = renderer.render(s, options);
  for(int x = 10; x < 200; x += 10)
  {
    const double value = -11 + 20 * (x + 0.5) / 200;
    BOOST_CHECK_SMALL(hue_difference(steep.at(x, 150), options.gradient.pixel((value + 1) / 2)), 8.);
  }
  // y grows upwards
  s.scalars = {-1, -1, 1, 1};
  const Image upward = renderer.render(s, options);
  BOOST_CHECK_SMALL(hue_difference(upward.at(100, 5), options.gradient.pixel(1)), 12.);
  BOOST_CHECK_SMALL(hue_difference(upward.at(100, 195), options.gradient.pixel(0)), 12.);
  // the colour is readable: not much darker than the legend's
  const Rgba middle = upward.at(100, 100), legend = options.gradient.pixel(0.5);
  BOOST_CHECK_GT(middle.g, 0.8 * legend.g);
}

BOOST_AUTO_TEST_CASE(missing_scalars_are_grey)
{
  Mesh_renderer renderer;
  Render_options options = frontal(200, 200);
  options.margin = 0;
  Drawable s = square();
  for(double missing : {nan_value, -nan_value})
  {
    s.scalars = {missing, 1, 1, 1};
    const Image image = renderer.render(s, options);
    BOOST_CHECK_LT(saturation(image.at(12, 185)), 0.1);
    BOOST_CHECK_GT(saturation(image.at(190, 10)), 0.5);
    // the neighbours keep their value right up to where the grey begins
    BOOST_CHECK_SMALL(hue_difference(image.at(110, 90), options.gradient.pixel(1)), 8.);
    s.scalars = {missing, missing, missing, missing};
    const Image grey = renderer.render(s, options);
    int darkest = 255, lightest = 0;
    for(int y = 0; y < 200; ++y)
      for(int x = 0; x < 200; ++x)
      {
        BOOST_REQUIRE_LT(saturation(grey.at(x, y)), 0.1);
        darkest = std::min(darkest, int(grey.at(x, y).g));
        lightest = std::max(lightest, int(grey.at(x, y).g));
      }
    BOOST_CHECK_GT(lightest - darkest, 20); // hatched
  }
  s.scalars = {INFINITY, INFINITY, INFINITY, INFINITY};
  BOOST_CHECK_SMALL(hue_difference(renderer.render(s, options).at(100, 100), options.gradient.pixel(1)), 8.);
}

BOOST_AUTO_TEST_CASE(bad_shapes_and_options)
{
  Mesh_renderer renderer;
  const Render_options options = frontal(64, 64);
  BOOST_CHECK_EQUAL(covered_fraction(renderer.render({}, options)), 0);
  Drawable s = square();
  s.triangles.push_back({0, 1, 99});
  s.points.push_back({nan_value, 0, 0});
  s.points.push_back({INFINITY, 0, 0});
  s.triangles.push_back({0, 1, 4});
  s.triangles.push_back({0, 5, 2});
  s.triangles.push_back({0, 0, 0});
  BOOST_CHECK_EQUAL(difference(renderer.render(s, options), renderer.render(square(), options)), 0);
  // triangles without area, last
  for(const std::array<std::size_t, 3>& none : {std::array<std::size_t, 3>{0, 0, 1}, {0, 6, 2}})
  {
    Drawable d = square();
    d.points.resize(6);
    d.points.push_back({1, 1, 0});
    d.triangles.push_back(none);
    BOOST_CHECK_EQUAL(difference(renderer.render(d, options), renderer.render(square(), options)), 0);
  }
  s.triangles = {{0, 4, 5}};
  BOOST_CHECK_EQUAL(covered_fraction(renderer.render(s, options)), 0);
  Drawable one;
  one.points = {{3, 4, 5}};
  BOOST_CHECK_GT(covered_fraction(renderer.render(one, options)), 0.3);
  one.points.assign(4, {3, 4, 5});
  renderer.render(one, options);
  one.scalars = {1};
  BOOST_CHECK_THROW(renderer.render(one, options), std::invalid_argument);
  one.scalars.clear();
  one.normals = {{0, 0, 1}};
  BOOST_CHECK_THROW(renderer.render(one, options), std::invalid_argument);
  Render_options bad = options;
  bad.range.high = bad.range.low;
  BOOST_CHECK_THROW(renderer.render(square(), bad), std::invalid_argument);
  bad = options;
  bad.camera.towards_eye = {0, 0, 0};
  BOOST_CHECK_THROW(renderer.render(square(), bad), std::invalid_argument);
  bad = options;
  bad.camera.field_of_view = nan_value;
  BOOST_CHECK_THROW(renderer.render(square(), bad), std::invalid_argument);
  bad = options;
  bad.width = 0;
  BOOST_CHECK_THROW(renderer.render(square(), bad), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(two_renderers_at_a_time)
{
  const Render_options options = frontal(64, 64);
  Mesh_renderer first;
  const Image reference = first.render(square(), options);
  {
    Mesh_renderer second;
    BOOST_CHECK_EQUAL(difference(second.render(square(), options), reference), 0);
    BOOST_CHECK_EQUAL(difference(first.render(square(), options), reference), 0);
  }
  BOOST_CHECK_EQUAL(difference(first.render(square(), options), reference), 0);
}

BOOST_AUTO_TEST_CASE(ticks)
{
  Ticks t = linear_ticks(-0.31, 0.32, 7);
  BOOST_CHECK((t.labels ==
               std::vector<std::string>{"\u22120.3", "\u22120.2", "\u22120.1", "0.0", "0.1", "0.2", "0.3"}));
  BOOST_CHECK_EQUAL(t.factor, "");
  t = linear_ticks(0, 5.1e-7, 6);
  BOOST_CHECK_EQUAL(t.factor, "\u00d710^{\u22127}");
  BOOST_CHECK_EQUAL(t.labels.back(), "5");
  BOOST_CHECK_CLOSE(t.values.back(), 5e-7, 1e-9);
  t = logarithmic_ticks(1e-9, 1, 5);
  BOOST_CHECK_EQUAL(t.labels.front(), "10^{\u22129}");
  BOOST_CHECK_LE(t.values.size(), 6u);
  t = logarithmic_ticks(0.5, 200, 5);
  BOOST_CHECK((t.labels == std::vector<std::string>{"1", "10", "100"}));
  BOOST_CHECK(linear_ticks(1, 1, 5).values.empty());
  BOOST_CHECK(logarithmic_ticks(-1, 1, 5).values.empty());
}

BOOST_AUTO_TEST_CASE(texts_and_lines)
{
  Text_style style;
  style.size = 40;
  BOOST_CHECK_GT(Painter::text_width("mm", style), 1.8 * Painter::text_width("m", style));
  BOOST_CHECK_LT(Painter::text_width("k_{max}", style), Painter::text_width("kmax", style));
  BOOST_CHECK_LE(Painter::text_width(shortened_text("a long name of something", 200, style), style), 200);
  BOOST_CHECK_EQUAL(shortened_text("short", 200, style), "short");
  // a text stays within its width and is there
  Image image(400, 100);
  const double width = Painter::text_width("Hg 0.5\xff", style); // a stray byte is no problem
  Painter(image).text("Hg 0.5\xff", {100, 60}, style);
  int left = 400, right = -1;
  for(int y = 0; y < 100; ++y)
    for(int x = 0; x < 400; ++x)
      if(image.at(x, y).g < 128)
      {
        left = std::min(left, x);
        right = std::max(right, x);
      }
  BOOST_CHECK_SMALL(left - 100., 2.);
  BOOST_CHECK_SMALL(right - 100. - width, 2.);
  // the ink of a line is its area, whatever its slope
  for(double angle : {0., 0.3, 0.9, 1.5})
  {
    Image line(200, 200);
    const double dx = 80 * std::cos(angle), dy = 80 * std::sin(angle);
    Painter(line).polyline({{100 - dx, 100 - dy}, {100 + dx, 100 + dy}}, 3, {0, 0, 0, 255});
    double ink = 0;
    for(int y = 0; y < 200; ++y)
      for(int x = 0; x < 200; ++x)
        ink += 1 - line.at(x, y).g / 255.;
    BOOST_CHECK_CLOSE(ink, 160 * 3 + pi * 2.25, 2.);
  }
  // what is outside the picture is cut off
  Painter(image).fill({-50, -50, 1000, 1000}, {1, 2, 3, 255});
  BOOST_CHECK(image.at(399, 99) == (Rgba{1, 2, 3, 255}));
  Painter(image).polyline({{-1e5, -1e5}, {1e5, 1e5}}, 5, {});
  Painter(image).convex_polygon({{-1e3, 0}, {1e3, -1e3}, {1e3, 1e3}}, {});
}

BOOST_AUTO_TEST_CASE(legend_has_the_gradient_and_says_what_is_clipped)
{
  for(bool standing : {true, false})
  {
    Image image(400, 400);
    Legend legend;
    legend.range = {-1, 1, false, true};
    legend.text_size = 20;
    if(standing)
      draw_legend(image, {20, 20, 160, 360}, legend);
    else
      draw_legend(image, {20, 20, 360, 100}, legend);
    // along the bar's axis: blue to red
    std::vector<Rgba> colours;
    for(int i = 0; i < 400; ++i)
    {
      const Rgba c = standing ? image.at(31, 399 - i) : image.at(i, 31);
      if(saturation(c) > 0.5)
        colours.push_back(c);
    }
    BOOST_REQUIRE_GT(colours.size(), 280u);
    BOOST_CHECK(colours.front() == legend.gradient.pixel(0) ||
                hue_difference(colours.front(), legend.gradient.pixel(0)) < 4);
    BOOST_CHECK_SMALL(hue_difference(colours.back(), legend.gradient.pixel(1)), 4.);
    // nothing shines through but at the ends' soft edges
    for(std::size_t i = 30; i + 30 < colours.size(); ++i)
      BOOST_CHECK_GT(saturation(colours[i]), 0.7);
  }
}

BOOST_AUTO_TEST_CASE(pictures_and_sheets)
{
  Mesh_renderer renderer;
  Drawable ball = sphere(30, 1, {0, 0, 0});
  for(const Vector& p : ball.points)
    ball.scalars.push_back(p[1]);
  ball.scalars[100] = nan_value;
  Picture_options options;
  options.width = 600;
  options.height = 450;
  options.title = "A ball";
  options.legend_title = "height";
  options.render.range = percentile_range(ball.scalars);
  const Image image = picture(renderer, ball, options);
  BOOST_CHECK_EQUAL(image.width(), 600);
  BOOST_CHECK_EQUAL(image.height(), 450);
  BOOST_CHECK(image.at(599, 449) == (Rgba{255, 255, 255, 255}));

  Contact_sheet sheet("Balls");
  BOOST_CHECK_THROW(sheet.image(), std::logic_error);
  for(int i = 0; i < 5; ++i)
    sheet.add(image, "ball " + std::to_string(i) + "\nof five");
  const Image wide = sheet.image(5), square_one = sheet.image();
  BOOST_CHECK_GT(wide.width(), 5 * 600);
  BOOST_CHECK_GT(square_one.width(), 3 * 600);
  BOOST_CHECK_LT(square_one.width(), 4 * 600);
  BOOST_CHECK_GT(square_one.height(), 2 * 450);
}

BOOST_AUTO_TEST_CASE(plots)
{
  Plot plot;
  plot.x_logarithmic = true;
  plot.series.push_back({"one", {1, 10, 100, -5, nan_value}, {1, 2, 3, 4, 5}});
  const Image image = plot.image(600, 400);
  int blue = 0;
  for(int y = 0; y < 400; ++y)
    for(int x = 0; x < 600; ++x)
      blue += saturation(image.at(x, y)) > 0.7 && hue_difference(image.at(x, y), {0, 105, 175, 255}) < 10;
  BOOST_CHECK_GT(blue, 300);
  plot.series.push_back({"nothing", {}, {}});
  plot.series.push_back({"constant", {3}, {3}});
  plot.image();
  Plot().image();
  plot.series.push_back({"unequal", {1, 2}, {1}});
  BOOST_CHECK_THROW(plot.image(), std::invalid_argument);
  BOOST_CHECK_THROW(Plot().image(0, 20), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(ply_is_read_back_by_cgal)
{
  typedef CGAL::Simple_cartesian<double> Kernel;
  typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
  const Drawable ball = sphere(6, 1, {0.1, 1. / 3, 1e7});
  std::vector<double> values;
  std::vector<std::uint8_t> status;
  for(std::size_t i = 0; i < ball.points.size(); ++i)
  {
    values.push_back(std::sin(double(i)) * std::pow(10., double(i % 40) - 20));
    status.push_back(std::uint8_t(17 * i));
  }
  for(Ply_format format : {Ply_format::BINARY_LITTLE_ENDIAN, Ply_format::ASCII})
  {
    if(format == Ply_format::BINARY_LITTLE_ENDIAN)
      values[5] = nan_value;
    else
      values[5] = 5;
    Ply_file ply(ball.points);
    // a closed surface: without the degenerate triangles at the poles
    std::vector<std::array<std::size_t, 3>> triangles(ball.triangles.begin() + 12, ball.triangles.end() - 12);
    ply.set_triangles(triangles);
    ply.add_comment("written by a test");
    ply.add_normals(ball.normals);
    ply.add_scalar("mean_curvature", values);
    ply.add_vector("max_direction", ball.normals);
    ply.add_uchar("status", status);
    const Temporary_file file(".ply");
    ply.write(file.name, format);

    std::ifstream in(file.name, std::ios::binary);
    Mesh mesh;
    std::string comments;
    BOOST_REQUIRE(CGAL::IO::read_PLY(in, mesh, comments));
    BOOST_CHECK(comments.find("written by a test") != std::string::npos);
    BOOST_REQUIRE_EQUAL(mesh.number_of_vertices(), ball.points.size());
    BOOST_CHECK_EQUAL(mesh.number_of_faces(), triangles.size());
    using Shape_characteristics::internal::to_optional;
    const auto mean = to_optional(mesh.property_map<Mesh::Vertex_index, double>("v:mean_curvature"));
    const auto direction = to_optional(mesh.property_map<Mesh::Vertex_index, double>("v:max_direction_z"));
    const auto flags = to_optional(mesh.property_map<Mesh::Vertex_index, std::uint8_t>("v:status"));
    BOOST_REQUIRE((mean && direction && flags));
    for(Mesh::Vertex_index v : mesh.vertices())
    {
      const std::size_t i = std::size_t(v);
      for(int c = 0; c < 3; ++c)
        BOOST_CHECK_EQUAL(mesh.point(v)[c], ball.points[i][std::size_t(c)]);
      BOOST_CHECK((*mean)[v] == values[i] || (std::isnan((*mean)[v]) && std::isnan(values[i])));
      BOOST_CHECK_EQUAL((*direction)[v], ball.normals[i][2]);
      BOOST_CHECK_EQUAL(int((*flags)[v]), int(status[i]));
    }
    std::size_t f = 0;
    for(Mesh::Face_index face : mesh.faces())
    {
      std::vector<std::size_t> corners;
      for(auto v : CGAL::vertices_around_face(mesh.halfedge(face), mesh))
        corners.push_back(std::size_t(v));
      std::vector<std::size_t> expected(triangles[f].begin(), triangles[f].end());
      std::sort(corners.begin(), corners.end());
      std::sort(expected.begin(), expected.end());
      BOOST_CHECK(corners == expected);
      ++f;
    }
  }
}

BOOST_AUTO_TEST_CASE(ply_refuses_nonsense)
{
  Ply_file ply({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  BOOST_CHECK_THROW(ply.add_scalar("short", {1, 2}), std::invalid_argument);
  BOOST_CHECK_THROW(ply.add_scalar("two words", {1, 2, 3}), std::invalid_argument);
  BOOST_CHECK_THROW(ply.add_scalar("x", {1, 2, 3}), std::invalid_argument);
  ply.add_scalar("a", {1, 2, 3});
  BOOST_CHECK_THROW(ply.add_uchar("a", {1, 2, 3}), std::invalid_argument);
  BOOST_CHECK_THROW(ply.set_triangles({{{0, 1, 3}}}), std::invalid_argument);
  BOOST_CHECK_THROW(ply.set_faces({{0, 1}}), std::invalid_argument);
  BOOST_CHECK_THROW(ply.add_comment("two\nlines"), std::invalid_argument);
  BOOST_CHECK_THROW(ply.write("/no such folder/mesh.ply"), std::runtime_error);

  const Temporary_file file(".ply");
  ply.add_colors(std::vector<Rgba>(3, Rgba{1, 2, 3, 255}));
  ply.write(file.name, Ply_format::ASCII);
  std::ifstream in(file.name);
  std::stringstream text;
  text << in.rdbuf();
  BOOST_CHECK_EQUAL(text.str(),
                    "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
                    "property double z\nproperty double a\nproperty uchar red\nproperty uchar green\n"
                    "property uchar blue\nend_header\n0 0 0 1 1 2 3\n1 0 0 2 1 2 3\n0 1 0 3 1 2 3\n");
}

BOOST_AUTO_TEST_CASE(face_graphs_are_drawn)
{
  typedef CGAL::Simple_cartesian<double> Kernel;
  CGAL::Polyhedron_3<Kernel> tetrahedron;
  tetrahedron.make_tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  const Drawable t = drawable_mesh(tetrahedron);
  BOOST_CHECK_EQUAL(t.points.size(), 4u);
  BOOST_CHECK_EQUAL(t.triangles.size(), 4u);

  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  std::vector<CGAL::SM_Vertex_index> v;
  for(int i = 0; i < 5; ++i)
    v.push_back(mesh.add_vertex({std::cos(2 * pi * i / 5), std::sin(2 * pi * i / 5), 0}));
  mesh.add_face(v);
  const Drawable p = drawable_mesh(mesh);
  BOOST_REQUIRE_EQUAL(p.triangles.size(), 3u);
  double area = 0;
  for(const auto& [a, b, c] : p.triangles)
    area += ((p.points[b][0] - p.points[a][0]) * (p.points[c][1] - p.points[a][1]) -
             (p.points[b][1] - p.points[a][1]) * (p.points[c][0] - p.points[a][0])) /
            2;
  BOOST_CHECK_CLOSE(area, 2.5 * std::sin(2 * pi / 5), 1e-9);
}

BOOST_AUTO_TEST_CASE(progress)
{
  std::ostringstream log, screen;
  {
    const Progress_bar lines("step", log, false, 0);
    const Progress_bar copy = lines;
    BOOST_CHECK(copy(0.5));
    BOOST_CHECK(lines(1));
  }
  BOOST_CHECK(log.str().find("step") != std::string::npos && log.str().find("50 %") != std::string::npos);
  BOOST_CHECK_EQUAL(log.str().find('\r'), std::string::npos);
  BOOST_CHECK_EQUAL(log.str().back(), '\n');
  std::ostringstream quick;
  const Progress_bar rare("step", quick, false, 1000);
  for(int i = 0; i <= 100; ++i)
    rare(i / 100.);
  BOOST_CHECK_EQUAL(quick.str(), "");
}

BOOST_AUTO_TEST_CASE(data_files)
{
  const std::filesystem::path folder = Temporary_file("").name;
  std::filesystem::create_directories(folder / "meshes");
  std::ofstream(folder / "meshes" / "a.off") << "OFF";
  const char* before = std::getenv("SHAPE_CHARACTERISTICS_DATA");
  const std::string kept = before ? before : "";
  setenv("SHAPE_CHARACTERISTICS_DATA", folder.c_str(), 1);
  BOOST_CHECK_EQUAL(data_file("meshes/a.off"), (folder / "meshes/a.off").string());
  try
  {
    data_file("meshes/no such mesh.off");
    BOOST_ERROR("no exception");
  }
  catch(const std::runtime_error& error)
  {
    BOOST_CHECK(std::string(error.what()).find("no such mesh.off") != std::string::npos);
    BOOST_CHECK(std::string(error.what()).find(folder.string()) != std::string::npos);
  }
  if(before)
    setenv("SHAPE_CHARACTERISTICS_DATA", kept.c_str(), 1);
  else
    unsetenv("SHAPE_CHARACTERISTICS_DATA");
  std::filesystem::remove_all(folder);
}

BOOST_AUTO_TEST_SUITE_END()
