#include <boost/test/unit_test.hpp>

#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/characteristics/Gaussian_curvature.h>
#include <Shape_characteristics/characteristics/Willmore_energy.h>
#include <Shape_characteristics/characteristics/curvedness.h>
#include <Shape_characteristics/characteristics/is_planar.h>
#include <Shape_characteristics/characteristics/is_sharp.h>
#include <Shape_characteristics/characteristics/is_umbilic.h>
#include <Shape_characteristics/characteristics/mean_curvature.h>
#include <Shape_characteristics/characteristics/shape_index.h>

#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <limits>
#include <random>
#include <type_traits>

BOOST_AUTO_TEST_SUITE(characteristics)

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Curvatures = SC::Principal_curvatures_and_directions<Kernel>;

namespace {

const double quiet_nan = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();
const double largest = std::numeric_limits<double>::max();
const double smallest = std::numeric_limits<double>::denorm_min();

Curvatures curvatures(double k_min, double k_max)
{
  Curvatures result;
  result.min_curvature = k_min;
  result.max_curvature = k_max;
  return result;
}

// another library's type with the same members
struct Foreign
{
  float min_curvature, max_curvature;
};

} // namespace

// x86's long double has 64 bits and a far larger range: the formulas as printed are an oracle for every double
BOOST_AUTO_TEST_CASE(formulas_over_the_range_of_double)
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> mantissa(-1, 1), exponent(-150, 150), apart(-20, 20);
  for(int i = 0; i < 20000; ++i)
  {
    const double scale = std::pow(10, exponent(random));
    double a = scale * mantissa(random), b = scale * mantissa(random);
    if(i % 3 == 0)
      b *= std::pow(10, apart(random));
    if(i % 3 == 1)
      b = a * (1 + std::pow(10, -std::abs(apart(random))));
    const Curvatures c = curvatures(std::min(a, b), std::max(a, b));
    const long double k1 = c.max_curvature, k2 = c.min_curvature;
    const long double size = std::max(std::abs(k1), std::abs(k2));

    BOOST_TEST(std::abs(SC::mean_curvature(c) - (k1 + k2) / 2) <=
               0x1p-53L * size /* half a unit in the last place */);
    if(std::abs(k1 * k2) < largest && std::abs(k1 * k2) > 1e-300)
      BOOST_TEST(std::abs(SC::Gaussian_curvature(c) - k1 * k2) <= 3e-16L * std::abs(k1 * k2));
    BOOST_TEST(std::abs(SC::curvedness(c) - std::sqrt((k1 * k1 + k2 * k2) / 2)) <= 5e-16L * size);
    const long double willmore = (k1 - k2) * (k1 - k2) / 4;
    if(willmore < largest && willmore > 1e-300)
      BOOST_TEST(std::abs(SC::Willmore_energy(c) - willmore) <= 1e-15L * willmore);
    const long double pi = 3.14159265358979323846264338327950288L;
    if(k1 != k2)
      BOOST_TEST(std::abs(SC::shape_index(c) - 2 / pi * std::atan((k1 + k2) / (k1 - k2))) < 5e-16L);
  }
}

BOOST_AUTO_TEST_CASE(identities)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> curvature(-5, 5);
  for(int i = 0; i < 2000; ++i)
  {
    const double a = curvature(random), b = curvature(random);
    const Curvatures c = curvatures(std::min(a, b), std::max(a, b)),
                     flipped = curvatures(-std::max(a, b), -std::min(a, b));
    const double H = SC::mean_curvature(c), K = SC::Gaussian_curvature(c), C = SC::curvedness(c),
                 W = SC::Willmore_energy(c), S = SC::shape_index(c);
    BOOST_TEST(std::abs(W - (H * H - K)) < 1e-13);
    BOOST_TEST(std::abs(C * C - (H * H + W)) < 1e-13);
    // shape index and curvedness are polar coordinates: C sin and C cos of the angle are H and (k1 - k2) / 2
    const double angle = S * 1.5707963267948966;
    BOOST_TEST(std::abs(C * std::sin(angle) - H) < 1e-14);
    BOOST_TEST(std::abs(C * std::cos(angle) - (c.max_curvature - c.min_curvature) / 2) < 1e-14);
    // the other side
    BOOST_TEST(SC::mean_curvature(flipped) == -H);
    BOOST_TEST(SC::Gaussian_curvature(flipped) == K);
    BOOST_TEST(SC::curvedness(flipped) == C);
    BOOST_TEST(SC::Willmore_energy(flipped) == W);
    BOOST_TEST(SC::shape_index(flipped) == -S);
    // another unit of length (a power of two, so that nothing is rounded)
    const Curvatures scaled = curvatures(c.min_curvature * 0x1p40, c.max_curvature * 0x1p40);
    BOOST_TEST(SC::shape_index(scaled) == S);
    BOOST_TEST(SC::mean_curvature(scaled) == H * 0x1p40);
    BOOST_TEST(SC::curvedness(scaled) == C * 0x1p40);
    BOOST_TEST(SC::Gaussian_curvature(scaled) == K * 0x1p80);
    BOOST_TEST(SC::Willmore_energy(scaled) == W * 0x1p80);
  }
}

BOOST_AUTO_TEST_CASE(shape_index_of_the_named_shapes)
{
  for(double k : {smallest, 1e-310, 1e-150, 1., 1e150, largest})
  {
    BOOST_TEST(SC::shape_index(curvatures(k, k)) == 1);                     // cap
    BOOST_TEST(SC::shape_index(curvatures(-k, -k)) == -1);                  // cup
    BOOST_TEST(SC::shape_index(curvatures(-k, k)) == 0);                    // saddle
    BOOST_TEST(std::abs(SC::shape_index(curvatures(0, k)) - 0.5) < 1e-15);  // ridge
    BOOST_TEST(std::abs(SC::shape_index(curvatures(-k, 0)) + 0.5) < 1e-15); // rut
  }
  // a plane is no saddle
  BOOST_TEST(std::isnan(SC::shape_index(curvatures(0, 0))));
  BOOST_TEST(std::isnan(SC::shape_index(curvatures(-0., 0))));
  // next to an umbilic, still in the range
  BOOST_TEST(SC::shape_index(curvatures(1, std::nextafter(1, 2))) <= 1);
  BOOST_TEST(SC::shape_index(curvatures(1, std::nextafter(1, 2))) > 1 - 1e-15);
}

BOOST_AUTO_TEST_CASE(extremes)
{
  BOOST_TEST(SC::mean_curvature(curvatures(largest, largest)) == largest);
  BOOST_TEST(SC::mean_curvature(curvatures(-largest, largest)) == 0);
  BOOST_TEST(std::abs(SC::curvedness(curvatures(largest, largest)) / largest - 1) < 1e-15);
  BOOST_TEST(std::abs(SC::curvedness(curvatures(-1e-200, 1e-200)) / 1e-200 - 1) < 1e-15);
  BOOST_TEST(SC::curvedness(curvatures(0, 0)) == 0);
  BOOST_TEST(SC::Willmore_energy(curvatures(3, 3)) == 0);
  BOOST_TEST(SC::Willmore_energy(curvatures(-largest, largest)) == infinity); // as documented
  BOOST_TEST(std::abs(SC::Willmore_energy(curvatures(-1e150, 1e150)) / 1e300 - 1) < 1e-15);
  // the difference doesn't cancel where H^2 - K would be noise
  const double a = 1, b = 1 + 0x1p-40;
  BOOST_TEST(SC::Willmore_energy(curvatures(a, b)) == 0x1p-82);
}

BOOST_AUTO_TEST_CASE(nan_is_passed_on)
{
  for(const Curvatures& c :
      {curvatures(quiet_nan, 1), curvatures(-1, quiet_nan), curvatures(quiet_nan, quiet_nan),
       curvatures(quiet_nan, infinity), curvatures(-infinity, quiet_nan)})
  {
    BOOST_TEST(std::isnan(SC::mean_curvature(c)));
    BOOST_TEST(std::isnan(SC::Gaussian_curvature(c)));
    BOOST_TEST(std::isnan(SC::shape_index(c)));
    BOOST_TEST(std::isnan(SC::curvedness(c)));
    BOOST_TEST(std::isnan(SC::Willmore_energy(c)));
    BOOST_TEST(!SC::is_umbilic(c));
    BOOST_TEST(!SC::is_planar(c));
    BOOST_TEST(!SC::is_sharp(c, largest));
  }
  BOOST_TEST(std::isnan(SC::shape_index(curvatures(1, infinity))));
  BOOST_TEST(!SC::is_umbilic(curvatures(infinity, infinity)));
  BOOST_TEST(SC::curvedness(curvatures(1, infinity)) == infinity);
}

BOOST_AUTO_TEST_CASE(umbilics)
{
  for(double scale : {1e-310, 1e-150, 1., 1e150, 1e308})
  {
    BOOST_TEST(SC::is_umbilic(curvatures(scale, scale)));
    BOOST_TEST(SC::is_umbilic(curvatures(-scale, -scale), 0));
    BOOST_TEST(!SC::is_umbilic(curvatures(-scale, scale)));
    BOOST_TEST(!SC::is_umbilic(curvatures(0, scale)));
    BOOST_TEST(SC::is_umbilic(curvatures(0.95 * scale, scale), 0.1));
    BOOST_TEST(!SC::is_umbilic(curvatures(0.85 * scale, scale), 0.1));
    BOOST_TEST(SC::is_umbilic(curvatures(-scale, -0.95 * scale), 0.1));
    BOOST_TEST(!SC::is_umbilic(curvatures(-scale, -0.85 * scale), 0.1));
  }
  BOOST_TEST(SC::is_umbilic(curvatures(1, 1 + 0.5e-6)));
  BOOST_TEST(!SC::is_umbilic(curvatures(1, 1 + 2e-6)));
  BOOST_TEST(SC::is_umbilic(curvatures(0, 0), 0));
  BOOST_TEST(!SC::is_umbilic(curvatures(-largest, largest)));
  BOOST_CHECK_THROW(SC::is_umbilic(curvatures(0, 0), -1e-9), std::invalid_argument);
  BOOST_CHECK_THROW(SC::is_umbilic(curvatures(0, 0), quiet_nan), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(sharpness)
{
  for(double scale : {1e-300, 1e-150, 1., 1e150, 1e300})
  {
    BOOST_TEST(SC::is_sharp(curvatures(-.1 / scale, .6 / scale), scale));
    BOOST_TEST(SC::is_sharp(curvatures(-.6 / scale, .1 / scale), scale));
    BOOST_TEST(!SC::is_sharp(curvatures(-.4 / scale, .4 / scale), scale));
    BOOST_TEST(SC::is_sharp(curvatures(-.4 / scale, .4 / scale), scale, .3));
    BOOST_TEST(!SC::is_sharp(curvatures(-.6 / scale, .6 / scale), scale, .7));
  }
  BOOST_TEST(!SC::is_sharp(curvatures(0, .5), 1)); // at most
  BOOST_TEST(!SC::is_sharp(curvatures(-largest, largest), 0));
  BOOST_TEST(SC::is_sharp(curvatures(0, largest), largest));
  BOOST_TEST(SC::is_sharp(curvatures(0, smallest), 1, 0));
  BOOST_TEST(!SC::is_sharp(curvatures(0, 0), largest, 0));
  BOOST_CHECK_THROW(SC::is_sharp(curvatures(0, 0), -1e-9), std::invalid_argument);
  BOOST_CHECK_THROW(SC::is_sharp(curvatures(0, 0), quiet_nan), std::invalid_argument);
  BOOST_CHECK_THROW(SC::is_sharp(curvatures(0, 0), 1, -1e-9), std::invalid_argument);
  BOOST_CHECK_THROW(SC::is_sharp(curvatures(0, 0), 1, quiet_nan), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(planes)
{
  BOOST_TEST(SC::is_planar(curvatures(0, 0)));
  BOOST_TEST(!SC::is_planar(curvatures(0, smallest)));
  BOOST_TEST(SC::is_planar(curvatures(-1e-3, 1e-3), 1e-3));
  BOOST_TEST(!SC::is_planar(curvatures(-1.1e-3, 1e-3), 1e-3));
  BOOST_TEST(!SC::is_planar(curvatures(-1e-3, 1.1e-3), 1e-3));
  BOOST_CHECK_THROW(SC::is_planar(curvatures(0, 0), -1), std::invalid_argument);
  BOOST_CHECK_THROW(SC::is_planar(curvatures(0, 0), quiet_nan), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(any_type_with_the_two_members)
{
  const Foreign c = {1, 3};
  static_assert(std::is_same_v<decltype(SC::mean_curvature(c)), float>);
  BOOST_TEST(SC::mean_curvature(c) == 2);
  BOOST_TEST(SC::Gaussian_curvature(c) == 3);
  BOOST_TEST(SC::Willmore_energy(c) == 1);
  BOOST_TEST(std::abs(SC::curvedness(c) - std::sqrt(5.f)) < 1e-6f);
  BOOST_TEST(std::abs(SC::shape_index(c) - 0.7048328f) < 1e-6f);
  BOOST_TEST(!SC::is_umbilic(c));
  BOOST_TEST(!SC::is_planar(c));
}

BOOST_AUTO_TEST_SUITE_END()
