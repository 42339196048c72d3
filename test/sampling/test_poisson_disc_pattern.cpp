#include <boost/test/unit_test.hpp>

#include <Shape_characteristics/sampling/poisson_disc_pattern.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(poisson_disc_pattern)

namespace SC = Shape_characteristics;

BOOST_AUTO_TEST_CASE(points_keep_their_distance)
{
  for(const double distance : {.1, .3, .7, 1.})
    for(std::uint64_t seed = 0; seed < 20; ++seed)
    {
      const auto points = SC::poisson_disc_pattern(distance, seed);
      BOOST_TEST(!points.empty());
      for(std::size_t i = 0; i < points.size(); ++i)
      {
        BOOST_TEST(points[i].norm() <= 1.);
        for(std::size_t j = 0; j < i; ++j)
          BOOST_TEST((points[i] - points[j]).norm() >= distance * (1. - 1e-15));
      }
    }
}

// On a fine grid of candidates there is next to no room for another point, well inside of the disc: each place that isn't
// covered would have been missed by 30 candidates around all of the points near it.
BOOST_AUTO_TEST_CASE(patterns_are_packed)
{
  std::size_t candidates = 0, free = 0;
  for(std::uint64_t seed = 0; seed < 20; ++seed)
  {
    const auto points = SC::poisson_disc_pattern(.3, seed);
    for(int i = -100; i <= 100; ++i)
      for(int j = -100; j <= 100; ++j)
      {
        const Eigen::Vector2d c(i / 100., j / 100.);
        if(c.norm() > .7) // points beyond the rim were cut off
          continue;
        ++candidates;
        free += std::all_of(points.begin(), points.end(),
                            [&](const Eigen::Vector2d& p) { return (p - c).norm() >= .3; });
      }
  }
  BOOST_TEST_MESSAGE(free << " of " << candidates << " candidates are free");
  BOOST_TEST(double(free) < .005 * double(candidates));
}

BOOST_AUTO_TEST_CASE(about_thirty_points)
{
  double sum = 0.;
  for(std::uint64_t seed = 0; seed < 50; ++seed)
  {
    const std::size_t n = SC::poisson_disc_pattern(.3, seed).size();
    BOOST_TEST(n >= 18u);
    BOOST_TEST(n <= 38u);
    sum += double(n);
  }
  BOOST_TEST_MESSAGE("mean number of points: " << sum / 50.);
  BOOST_TEST(SC::poisson_disc_pattern(.3).size() == SC::poisson_disc_pattern().size());
}

BOOST_AUTO_TEST_CASE(deterministic)
{
  BOOST_TEST((SC::poisson_disc_pattern(.3, 5) == SC::poisson_disc_pattern(.3, 5)));
  BOOST_TEST((SC::poisson_disc_pattern(.3, 5) != SC::poisson_disc_pattern(.3, 6)));
}

BOOST_AUTO_TEST_CASE(distances_without_meaning)
{
  for(const double distance :
      {0., -.3, 1.1, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    BOOST_CHECK_THROW(SC::poisson_disc_pattern(distance), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
