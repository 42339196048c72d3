#include <boost/test/unit_test.hpp>

#include <Shape_characteristics/sampling/Nearest_point_search.h>

#include "../../benchmark/support/Random.h"

#include <Eigen/Core>

#include <cstddef>
#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(nearest_point_search)

namespace SC = Shape_characteristics;
using benchmark_support::Random;
using Points = std::vector<Eigen::Vector3d>;
constexpr auto none = SC::Nearest_point_search::none;

namespace {

Eigen::Vector3d random_point(Random& random)
{
  const double x = random.uniform(), y = random.uniform();
  return {x, y, random.uniform()};
}

// the first of the nearest ones within `maximum_distance`
std::uint32_t
plain_nearest(const Points& points, const Eigen::Vector3d& place, double maximum_distance, bool elsewhere)
{
  std::uint32_t found = none;
  double least = maximum_distance * maximum_distance;
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    const double d = (points[i] - place).squaredNorm();
    if(points[i].allFinite() && (found == none ? d <= least : d < least) &&
       !(elsewhere && points[i] == place))
    {
      found = std::uint32_t(i);
      least = d;
    }
  }
  return found;
}

void check(const Points& points, const Points& places)
{
  const SC::Nearest_point_search search(points);
  const double infinity = std::numeric_limits<double>::infinity();
  for(const Eigen::Vector3d& place : places)
    for(const double distance : {infinity, 1., .1, .01, 0.})
      BOOST_TEST(search.nearest(place, distance) == plain_nearest(points, place, distance, false));
  for(std::size_t i = 0; i < points.size(); ++i)
    BOOST_TEST(search.nearest_elsewhere(i) ==
               (points[i].allFinite() ? plain_nearest(points, points[i], infinity, true) : none));
}

} // namespace

BOOST_AUTO_TEST_CASE(agrees_with_the_plain_search)
{
  Random random(1);
  Points places(50);
  for(auto& p : places)
    p = random_point(random) * 2.;
  for(const std::size_t n : {0u, 1u, 2u, 13u, 500u})
  {
    Points points(n);
    for(auto& p : points)
      p = random_point(random);
    check(points, places);
  }
}

BOOST_AUTO_TEST_CASE(of_equally_near_points_the_first_is_found)
{
  Points points;
  for(int copy = 0; copy < 2; ++copy)
    for(int i = 0; i < 4; ++i)
      for(int j = 0; j < 4; ++j)
        for(int k = 0; k < 4; ++k)
          points.emplace_back(.5 * i, .5 * j, .5 * k);
  Points places = points;
  for(const auto& p : points)
    places.push_back(p + Eigen::Vector3d(.25, .25, 0.));
  check(points, places);
  check(Points(40, Eigen::Vector3d(1., 2., 3.)), places);
}

BOOST_AUTO_TEST_CASE(points_and_places_that_are_not_finite)
{
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const Points points{{nan, 0., 0.}, {1., 0., 0.}, {0., inf, 0.}, {0., 0., 0.}};
  check(points, {{.2, 0., 0.}, {.8, 0., 0.}});
  BOOST_TEST(SC::Nearest_point_search(points).nearest({nan, 0., 0.}) == none);
  BOOST_TEST(SC::Nearest_point_search(points).nearest({inf, 0., 0.}) == none);
  BOOST_TEST(SC::Nearest_point_search({{nan, nan, nan}}).nearest({0., 0., 0.}) == none);
}

// Squares of the lengths are out of the range of numbers.
BOOST_AUTO_TEST_CASE(extraordinary_units)
{
  Random random(8);
  Points points, places;
  for(int i = 0; i < 200; ++i)
  {
    points.push_back(random_point(random));
    places.push_back(random_point(random));
  }
  const SC::Nearest_point_search expected(points);
  for(const double unit : {0x1p-1000, 0x1p-560, 0x1p560, 0x1p1000})
  {
    Points scaled = points;
    for(Eigen::Vector3d& p : scaled)
      p *= unit;
    const SC::Nearest_point_search search(scaled);
    for(std::size_t i = 0; i < places.size(); ++i)
    {
      for(const double distance : {std::numeric_limits<double>::infinity(), .1})
        BOOST_TEST(search.nearest(unit * places[i], unit * distance) ==
                   expected.nearest(places[i], distance));
      BOOST_TEST(search.nearest_elsewhere(i) == expected.nearest_elsewhere(i));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
