#define BOOST_TEST_MODULE ambient_occlusion
#include <boost/test/unit_test.hpp>

#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/screen_space/Griffin_ambient_occlusion.h>
#include <Shape_characteristics/screen_space/Hattori_ambient_occlusion.h>
#include <Shape_characteristics/screen_space/Two_part_ambient_occlusion.h>

#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Curvatures = SC::Principal_curvatures_and_directions<Kernel>;

namespace {

const double quiet_nan = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

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

BOOST_AUTO_TEST_CASE(two_parts_by_the_formula_of_the_thesis)
{
  const SC::Two_part_ambient_occlusion light(2.);
  BOOST_TEST(light(curvatures(0, 0)) == 0.9);
  BOOST_TEST(light(curvatures(-1, 1)) == 0.9);                                          // a saddle
  BOOST_TEST(std::abs(light(curvatures(2, 2)) - 1) < 1e-15);                            // the brightest bump
  BOOST_TEST(std::abs(light(curvatures(0, 2)) - 0.95) < 1e-15);                         // half of it
  BOOST_TEST(std::abs(light(curvatures(-2, -2)) - 0.9 * std::exp(-2.5)) < 1e-15);       // the darkest hollow
  BOOST_TEST(std::abs(light(curvatures(-2, 0)) - 0.9 * std::exp(-0.25 / 0.4)) < 1e-15); // half of it
  BOOST_TEST(light(curvatures(5, 7)) == light(curvatures(2, 2)));                       // beyond the extreme
  BOOST_TEST(light(curvatures(-infinity, -3)) == light(curvatures(-2, -2)));
  BOOST_TEST(light(Foreign{0.f, 2.f}) == light(curvatures(0, 2)));
}

BOOST_AUTO_TEST_CASE(two_parts_grow_and_join)
{
  const SC::Two_part_ambient_occlusion light(1., 0.7, 0.1);
  double before = -1;
  for(int i = -1000; i <= 1000; ++i)
  {
    const double value = light(curvatures(i / 1000., i / 1000.));
    BOOST_TEST(value > before);
    BOOST_TEST((i == -1000 || value - before < 0.007)); // no step
    before = value;
  }
  BOOST_TEST(before == 1);
}

// the mean over all directions of the squared sine under which the quadric leaves the sphere, by quadrature
BOOST_AUTO_TEST_CASE(Hattori_is_the_quadric_in_a_sphere)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> curvature(-2, 2), size(0.1, 0.6);
  for(int trial = 0; trial < 100; ++trial)
  {
    const double k1 = curvature(random), k2 = curvature(random), r = size(random);
    double hidden = 0;
    const int steps = 64; // exact for a trigonometric polynomial of degree 4
    for(int i = 0; i < steps; ++i)
    {
      const double angle = 2 * 3.14159265358979323846 * i / steps, c = std::cos(angle), s = std::sin(angle);
      const double sine = r * (k1 * c * c + k2 * s * s) / 2;
      hidden += sine * sine / steps;
    }
    const SC::Hattori_ambient_occlusion light(r);
    BOOST_TEST(std::abs(light(curvatures(k1, k2)) - (1 - hidden)) < 1e-14);
    BOOST_TEST(light(curvatures(-k1, -k2)) == light(curvatures(k1, k2))); // no sign
  }
  BOOST_TEST(SC::Hattori_ambient_occlusion(1.)(curvatures(0, 0)) == 1);
  BOOST_TEST(SC::Hattori_ambient_occlusion(1.)(curvatures(-100, 100)) == 0);
}

BOOST_AUTO_TEST_CASE(Griffin_is_a_polynomial)
{
  const SC::Griffin_ambient_occlusion light(5.);
  BOOST_TEST(light(curvatures(0, 0)) == 0.7369);
  BOOST_TEST(std::abs(light(curvatures(0.1, 0.2)) - (0.7369 + 0.0776 * 1.5 - 0.0022 * 1.25)) < 1e-15);
  BOOST_TEST(std::abs(light(curvatures(-0.3, 0.1)) - (0.7369 - 0.0776 - 0.0022 * 2.5)) < 1e-15);
  BOOST_TEST(light(curvatures(2, 2)) == 1);
  BOOST_TEST(light(curvatures(-9, -9)) == 0);
}

BOOST_AUTO_TEST_CASE(every_mapping_stays_within_bounds_and_passes_nan_on)
{
  const auto check = [](const auto& light)
  {
    for(const double a : {-infinity, -1e300, -3., -0., 1e-300, 4., 1e300, infinity})
      for(const double b : {-infinity, -1e300, -3., -0., 1e-300, 4., 1e300, infinity})
        if(!(std::isinf(a) && a == -b)) // their mean is not defined
        {
          const double value = light(curvatures(a, b));
          BOOST_TEST(value >= 0);
          BOOST_TEST(value <= 1);
        }
    for(const double other : {0., infinity, quiet_nan})
    {
      BOOST_TEST(std::isnan(light(curvatures(quiet_nan, other))));
      BOOST_TEST(std::isnan(light(curvatures(other, quiet_nan))));
    }
  };
  check(SC::Two_part_ambient_occlusion(1.));
  check(SC::Hattori_ambient_occlusion(1.));
  check(SC::Griffin_ambient_occlusion(1.));
}

// a surface of another size with parameters in its unit looks the same
BOOST_AUTO_TEST_CASE(mappings_do_not_depend_on_the_unit)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> curvature(-2, 2);
  for(const double unit : {0x1p-20, 0x1p20})
    for(int trial = 0; trial < 50; ++trial)
    {
      const double a = curvature(random), b = curvature(random);
      const Curvatures c = curvatures(a, b), scaled = curvatures(a / unit, b / unit);
      BOOST_TEST(SC::Two_part_ambient_occlusion(3. / unit)(scaled) == SC::Two_part_ambient_occlusion(3.)(c));
      BOOST_TEST(SC::Hattori_ambient_occlusion(.25 * unit)(scaled) == SC::Hattori_ambient_occlusion(.25)(c));
      BOOST_TEST(SC::Griffin_ambient_occlusion(5. * unit)(scaled) == SC::Griffin_ambient_occlusion(5.)(c));
    }
}

BOOST_AUTO_TEST_CASE(wrong_arguments)
{
  for(const double wrong : {0., -1., infinity, quiet_nan})
  {
    BOOST_CHECK_THROW(SC::Two_part_ambient_occlusion{wrong}, std::invalid_argument);
    BOOST_CHECK_THROW(SC::Two_part_ambient_occlusion(1., 0.9, wrong), std::invalid_argument);
    BOOST_CHECK_THROW(SC::Hattori_ambient_occlusion{wrong}, std::invalid_argument);
    BOOST_CHECK_THROW(SC::Griffin_ambient_occlusion{wrong}, std::invalid_argument);
  }
  for(const double wrong : {-0.1, 1.1, quiet_nan})
    BOOST_CHECK_THROW(SC::Two_part_ambient_occlusion(1., wrong), std::invalid_argument);
  BOOST_CHECK_THROW(SC::Two_part_ambient_occlusion(1., .9, .2, infinity), std::invalid_argument);
  BOOST_CHECK_THROW(SC::Griffin_ambient_occlusion(1., quiet_nan), std::invalid_argument);
}
