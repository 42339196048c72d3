// Pictures of a head, from which its features are found.
#include <boost/test/unit_test.hpp>

#include <Shape_characteristics/head_features/internal/Depth_image.h>
#include <Shape_characteristics/head_features/internal/Head_surface.h>
#include <Shape_characteristics/head_features/internal/Scalar_image.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>

BOOST_AUTO_TEST_SUITE(depth_image)

using Eigen::Vector3d;
using Shape_characteristics::internal::Depth_image;
using Shape_characteristics::internal::Head_surface;
using Shape_characteristics::internal::Scalar_image;
using Shape_characteristics::internal::Surface_point;

namespace {

const double not_a_number = std::numeric_limits<double>::quiet_NaN();

Scalar_image random_image(int width, int height, double share_without_value)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> value(-1, 1), chance(0, 1);
  Scalar_image image(width, height);
  for(int j = 0; j < height; ++j)
    for(int i = 0; i < width; ++i)
      image(i, j) = chance(random) < share_without_value ? not_a_number : value(random);
  return image;
}

// the mean of the values about a pixel, with a Gaussian's weights
double smoothed_value(const Scalar_image& image, double sigma, int i, int j)
{
  const int reach = int(std::ceil(3 * sigma));
  double sum = 0, weights = 0;
  for(int dj = -reach; dj <= reach; ++dj)
    for(int di = -reach; di <= reach; ++di)
      if(image.has_value(i + di, j + dj))
      {
        const double weight = std::exp(-.5 * (di * di + dj * dj) / (sigma * sigma));
        sum += weight * image(i + di, j + dj);
        weights += weight;
      }
  return sum / weights;
}

void add_triangle(Head_surface& surface, const Vector3d& a, const Vector3d& b, const Vector3d& c)
{
  const auto first = Head_surface::Index(surface.points.size());
  surface.points.insert(surface.points.end(), {a, b, c});
  surface.triangles.push_back({first, first + 1, first + 2});
}

double slope(double x)
{
  return 1 + .5 * x;
}

// 0: a slope that fills most of an image; 1: nearer, in the middle; 2: in front of that, but seen from behind
Head_surface surface_of_three()
{
  Head_surface surface;
  add_triangle(surface, {-2, -2, slope(-2)}, {2, -2, slope(2)}, {0, 2, slope(0)});
  add_triangle(surface, {-.3, -.3, 3}, {.3, -.3, 3}, {0, .3, 3});
  add_triangle(surface, {-.3, -.3, 4}, {0, .3, 4}, {.3, -.3, 4});
  return surface;
}

// x to the right, or to the left
Depth_image image_of(const Head_surface& surface, double right = 1)
{
  return Depth_image(surface, right * Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ(), -1.47, -1.46,
                     3., 3., .125);
}

} // namespace

BOOST_AUTO_TEST_CASE(smoothed_image)
{
  // wider and narrower than what is summed at a time; a kernel that fits and one that doesn't
  for(const int width : {1, 7, 8, 21})
    for(const double sigma : {.3, 1.7, 4.})
      for(const double share_without_value : {0., .3})
      {
        const Scalar_image image = random_image(width, 13, share_without_value),
                           smooth = image.smoothed(sigma);
        BOOST_TEST_REQUIRE(smooth.width() == width);
        BOOST_TEST_REQUIRE(smooth.height() == 13);
        for(int j = 0; j < 13; ++j)
          for(int i = 0; i < width; ++i)
          {
            BOOST_TEST(smooth.has_value(i, j) == image.has_value(i, j));
            if(image.has_value(i, j))
              BOOST_TEST(std::abs(smooth(i, j) - smoothed_value(image, sigma, i, j)) < 1e-14,
                         "width " << width << ", sigma " << sigma << ", pixel " << i << " " << j);
          }
      }
}

BOOST_AUTO_TEST_CASE(image_that_is_not_smoothed)
{
  const Scalar_image image = random_image(5, 4, .2);
  for(const double sigma : {0., -1., not_a_number})
  {
    const Scalar_image same = image.smoothed(sigma);
    for(int j = 0; j < 4; ++j)
      for(int i = 0; i < 5; ++i)
        BOOST_TEST((image.has_value(i, j) ? same(i, j) == image(i, j) : !same.has_value(i, j)));
  }
  BOOST_TEST(Scalar_image().smoothed(1).width() == 0);
}

BOOST_AUTO_TEST_CASE(part_of_an_image)
{
  const Scalar_image image = random_image(6, 5, 0), part = image.part(-2, 3, 2, 9),
                     none = image.part(4, 3, 0, 4);
  BOOST_TEST_REQUIRE(part.width() == 4);
  BOOST_TEST_REQUIRE(part.height() == 3);
  for(int j = 0; j < 3; ++j)
    for(int i = 0; i < 4; ++i)
      BOOST_TEST(part(i, j) == image(i, j + 2));
  BOOST_TEST(none.width() == 0);
  BOOST_TEST(!none.has_value(0, 0));
}

BOOST_AUTO_TEST_CASE(nearest_triangle_that_faces_the_eye)
{
  for(const bool is_drawn_backwards : {false, true})
    for(const double right : {1., -1.})
    {
      Head_surface surface = surface_of_three();
      if(is_drawn_backwards)
        std::reverse(surface.triangles.begin(), surface.triangles.end());
      const std::size_t slope_triangle = is_drawn_backwards ? 2 : 0, middle_triangle = 1;
      const Depth_image image = image_of(surface, right);
      std::size_t of_slope = 0, of_middle = 0;
      for(int j = 0; j < image.depth().height(); ++j)
        for(int i = 0; i < image.depth().width(); ++i)
        {
          const double x = right * image.u(i), y = image.v(j);
          // no pixel lies on an edge, where rounding would decide
          const auto is_inside = [&](const double size) { return y > -size && 2 * std::abs(x) < size - y; };
          const bool is_middle = is_inside(.3), is_slope = !is_middle && is_inside(2.);
          BOOST_TEST(image.triangle(i, j) == (is_middle  ? middle_triangle
                                              : is_slope ? slope_triangle
                                                         : Surface_point::no_triangle),
                     "pixel " << i << " " << j);
          BOOST_TEST(image.depth().has_value(i, j) == (is_slope || is_middle));
          if(is_slope || is_middle)
            BOOST_TEST(std::abs(image.depth()(i, j) - (is_middle ? 3. : slope(x))) < 1e-12);
          of_slope += is_slope;
          of_middle += is_middle;
        }
      BOOST_TEST(of_slope > 300u);
      BOOST_TEST(of_middle > 5u);
    }
}

BOOST_AUTO_TEST_CASE(points_that_are_seen)
{
  const Head_surface surface = surface_of_three();
  for(const double right : {1., -1.})
  {
    const Depth_image image = image_of(surface, right);
    const Surface_point on_slope = image.point(right * .51, -.72),
                        in_the_middle = image.point(right * .01, .02);
    BOOST_TEST_REQUIRE(on_slope.is_valid());
    BOOST_TEST(on_slope.triangle == 0u);
    BOOST_TEST((on_slope.position - Vector3d(.51, -.72, slope(.51))).norm() < 1e-12);
    BOOST_TEST_REQUIRE(in_the_middle.is_valid());
    BOOST_TEST(in_the_middle.triangle == 1u);
    BOOST_TEST((in_the_middle.position - Vector3d(.01, .02, 3)).norm() < 1e-12);

    // just beyond an edge, the point of the edge; far from all, none
    const Surface_point beyond = image.point(right * .8, .45);
    BOOST_TEST_REQUIRE(beyond.is_valid());
    BOOST_TEST(beyond.triangle == 0u);
    BOOST_TEST(std::abs(2 * beyond.position.x() + beyond.position.y() - 2) < 1e-12);
    BOOST_TEST(!image.point(right * 1.4, 1.4).is_valid());
    for(const double nowhere : {1e3, 1e300, not_a_number})
      BOOST_TEST(!image.point(nowhere, 0).is_valid());

    // where the middle's pixels don't count, what is behind it
    const Surface_point behind =
        image.point(right * .01, .02, [&](const int i, const int j) { return image.triangle(i, j) == 0; });
    BOOST_TEST(behind.triangle == 0u);
  }
}

BOOST_AUTO_TEST_CASE(triangles_that_are_not_drawn)
{
  Head_surface surface = surface_of_three();
  add_triangle(surface, {0, 0, 9}, {0, 0, 9}, {0, 0, 9});
  add_triangle(surface, {0, 0, 9}, {1, 1, 9}, {-1, -1, 9});
  add_triangle(surface, {-1e300, -1e300, 9}, {1e300, -1e300, 9}, {0, 1e300, 9});
  add_triangle(surface, {1e7, 1e7, 9}, {1e7 + 1, 1e7, 9}, {1e7, 1e7 + 1, 9});
  const Depth_image with = image_of(surface), without = image_of(surface_of_three());
  for(int j = 0; j < with.depth().height(); ++j)
    for(int i = 0; i < with.depth().width(); ++i)
      BOOST_TEST(with.triangle(i, j) == without.triangle(i, j));
}

BOOST_AUTO_TEST_SUITE_END()
