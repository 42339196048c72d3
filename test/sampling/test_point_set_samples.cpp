#include <boost/test/unit_test.hpp>

#include <CGAL/Simple_cartesian.h>

#include <Shape_characteristics/sampling/Point_set_samples.h>

#include "analytic_surfaces.h"
#include "check_traversal.h"
#include "neighbor_key.h"

#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(point_set_samples)

namespace SC = Shape_characteristics;
using test_support::Random;
using S = SC::Estimation_status;
using SC::Neighborhood;
using SC::Point_set_samples;
using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Indices = std::vector<Point_set_samples::Index>;

namespace {

Point_set_samples samples_of(const std::vector<Point_3>& points, const Neighborhood& neighborhood)
{
  return Point_set_samples(points, CGAL::Identity_property_map<Point_3>(), neighborhood);
}

std::vector<Point_3> random_points(std::size_t n, std::uint64_t seed)
{
  Random random(seed);
  std::vector<Point_3> points;
  for(std::size_t i = 0; i < n; ++i)
  {
    const double x = random.uniform(), y = random.uniform();
    points.emplace_back(x, y, random.uniform());
  }
  return points;
}

// where many points are equally far from each other
std::vector<Point_3> grid(int n)
{
  std::vector<Point_3> points;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
      for(int k = 0; k < 3; ++k)
        points.emplace_back(i, j, k);
  return points;
}

// all other finite points elsewhere, nearest first, those that are equally far to seven digits in lexicographic order, to
// six digits
Indices plain_order(const std::vector<Point_3>& points, std::size_t i)
{
  const auto is_finite = [](const Point_3& p)
  { return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()); };
  Indices others;
  if(is_finite(points[i]))
    for(std::size_t j = 0; j < points.size(); ++j)
      if(is_finite(points[j]) && points[j] != points[i])
        others.push_back(Point_set_samples::Index(j));
  const auto key = [&](const std::size_t j)
  {
    const Point_3 &p = points[i], &q = points[j];
    return test_support::neighbor_key({p.x(), p.y(), p.z()}, {q.x(), q.y(), q.z()});
  };
  std::sort(others.begin(), others.end(),
            [&](const std::size_t a, const std::size_t b) { return key(a) < key(b); });
  return others;
}

std::vector<Point_3> coordinates(const std::vector<Point_3>& points, const Indices& indices)
{
  std::vector<Point_3> result;
  for(const auto i : indices)
    result.push_back(points[i]);
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(nearest)
{
  for(const std::vector<Point_3>& points : {random_points(300, 1), grid(8), random_points(10, 2)})
    for(const std::size_t k : {1u, 6u, 18u, 70u, 140u, 1000u})
    {
      const Point_set_samples samples = samples_of(points, Neighborhood::nearest(k));
      BOOST_REQUIRE(samples.size() == points.size());
      Point_set_samples::Workspace workspace;
      for(std::size_t i = 0; i < points.size(); ++i)
      {
        Indices expected = plain_order(points, i);
        expected.resize(std::min(k, expected.size()));
        BOOST_TEST((samples.neighbors(i, 0, workspace) == expected),
                   points.size() << " points, k " << k << ", point " << i);
      }
    }
}

BOOST_AUTO_TEST_CASE(ball)
{
  for(const std::vector<Point_3>& points : {random_points(300, 3), grid(8)})
    for(const double radius : {1e-9, .2, 1., 2., 100.})
    {
      const Point_set_samples samples = samples_of(points, Neighborhood::ball(radius));
      Point_set_samples::Workspace workspace;
      for(std::size_t i = 0; i < points.size(); ++i)
      {
        Indices expected = plain_order(points, i);
        expected.erase(std::remove_if(expected.begin(), expected.end(),
                                      [&](const std::size_t j) {
                                        return CGAL::squared_distance(points[i], points[j]) > radius * radius;
                                      }),
                       expected.end());
        BOOST_TEST((samples.neighbors(i, 0, workspace) == expected), "radius " << radius << ", point " << i);
      }
    }
}

// the same neighbors, whatever the order of the points
BOOST_AUTO_TEST_CASE(order_is_canonical)
{
  const std::vector<Point_3> points = grid(7);
  std::vector<std::size_t> place(points.size());
  std::iota(place.begin(), place.end(), std::size_t(0));
  Random random(4);
  for(std::size_t i = place.size(); i > 1; --i)
    std::swap(place[i - 1], place[std::size_t(random.uniform() * double(i))]);
  std::vector<Point_3> shuffled(points.size());
  for(std::size_t i = 0; i < place.size(); ++i)
    shuffled[place[i]] = points[i];
  for(const Neighborhood& neighborhood : {Neighborhood::nearest(10), Neighborhood::ball(1.5)})
  {
    const Point_set_samples a = samples_of(points, neighborhood), b = samples_of(shuffled, neighborhood);
    Point_set_samples::Workspace of_a, of_b;
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      BOOST_TEST((coordinates(points, a.neighbors(i, 0, of_a)) ==
                  coordinates(shuffled, b.neighbors(place[i], 0, of_b))));
      BOOST_TEST(a.spacing(i) == b.spacing(place[i]));
    }
    BOOST_TEST(a.mean_spacing() == b.mean_spacing());
  }
}

// Copies of a point are no neighbors of each other, and don't take the room of others.
BOOST_AUTO_TEST_CASE(coincident_points)
{
  std::vector<Point_3> points = random_points(100, 5);
  const std::size_t copies = 40;
  points.insert(points.end(), copies, points[7]);
  const Point_set_samples samples = samples_of(points, Neighborhood::nearest(12));
  Point_set_samples::Workspace workspace;
  for(const std::size_t i : {std::size_t(7), points.size() - 1})
  {
    Indices expected = plain_order(points, i);
    expected.resize(12);
    BOOST_TEST((samples.neighbors(i, 0, workspace) == expected));
    BOOST_TEST(samples.has_coincident_points(i));
    BOOST_TEST(samples.spacing(i) > 0.);
  }
  BOOST_TEST(!samples.has_coincident_points(8));

  // nothing but copies, in numbers that a kd-tree can't divide
  const Point_set_samples same =
      samples_of(std::vector<Point_3>(5000, Point_3(1., 2., 3.)), Neighborhood::nearest(5));
  BOOST_TEST(same.neighbors(0, 0, workspace).empty());
  BOOST_TEST(same.has_coincident_points(4999));
  BOOST_TEST(same.spacing(17) == 0.);
  BOOST_TEST(same.mean_spacing() == 0.);
}

BOOST_AUTO_TEST_CASE(not_finite)
{
  const double nan_value = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  std::vector<Point_3> points = random_points(60, 6);
  points[10] = Point_3(nan_value, 0., 0.);
  points[20] = Point_3(0., infinity, .5);
  points[30] = Point_3(-infinity, nan_value, 0.);
  for(const Neighborhood& neighborhood : {Neighborhood::nearest(8), Neighborhood::ball(.4)})
  {
    const Point_set_samples samples = samples_of(points, neighborhood);
    Point_set_samples::Workspace workspace;
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      const bool is_bad = i == 10 || i == 20 || i == 30;
      BOOST_TEST((samples.status(i) == (is_bad ? S::NON_FINITE_INPUT : S::ESTIMATED)));
      Indices expected = plain_order(points, i);
      if(neighborhood.kind() == Neighborhood::Kind::NEAREST)
        expected.resize(std::min<std::size_t>(8, expected.size()));
      else
        expected.erase(std::remove_if(expected.begin(), expected.end(),
                                      [&](const std::size_t j)
                                      { return CGAL::squared_distance(points[i], points[j]) > .4 * .4; }),
                       expected.end());
      BOOST_TEST((samples.neighbors(i, 0, workspace) == expected), "point " << i);
      BOOST_TEST(!samples.has_coincident_points(i));
      BOOST_TEST((samples.spacing(i) > 0.) == !is_bad);
    }
    BOOST_TEST(std::isfinite(samples.mean_spacing()));
  }

  // no finite point, no point
  for(const std::vector<Point_3>& none : {std::vector<Point_3>(5, points[10]), std::vector<Point_3>()})
  {
    const Point_set_samples samples = samples_of(none, Neighborhood::nearest(8));
    Point_set_samples::Workspace workspace;
    for(std::size_t i = 0; i < none.size(); ++i)
      BOOST_TEST(samples.neighbors(i, 0, workspace).empty());
    BOOST_TEST(samples.mean_spacing() == 0.);
  }
}

// Points whose normals are no directions are nobody's neighbors.
BOOST_AUTO_TEST_CASE(normals)
{
  const std::vector<Point_3> points = random_points(40, 8);
  Point_set_samples samples = samples_of(points, Neighborhood::nearest(39));
  std::vector<Eigen::Vector3d> normals(points.size(), Eigen::Vector3d(0., 3e200, 4e200));
  normals[5].setZero();
  normals[6] = Eigen::Vector3d(0., 0., std::numeric_limits<double>::infinity());
  BOOST_TEST(!samples.has_normals());
  samples.set_normals(normals);
  BOOST_TEST(samples.has_normals());
  BOOST_TEST((samples.normal(0) - Eigen::Vector3d(0., .6, .8)).norm() < 1e-15);
  Point_set_samples::Workspace workspace;
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    const bool is_bad = i == 5 || i == 6;
    BOOST_TEST((samples.status(i) == (is_bad ? S::NON_FINITE_INPUT : S::ESTIMATED)));
    Indices expected = plain_order(points, i);
    expected.erase(
        std::remove_if(expected.begin(), expected.end(), [](const auto j) { return j == 5 || j == 6; }),
        expected.end());
    BOOST_TEST((samples.neighbors(i, 0, workspace) == expected));
  }
}

// Points without normals don't take the place of others: the neighbors are those that there would be without them.
BOOST_AUTO_TEST_CASE(as_many_as_are_wanted_with_normals)
{
  std::vector<Point_3> points = random_points(300, 11);
  points.push_back(points[4]); // a copy, without a normal
  for(const std::size_t k : {4u, 18u, 100u})
  {
    Point_set_samples samples = samples_of(points, Neighborhood::nearest(k));
    const auto has_normal = [](const std::size_t i) { return i % 3 == 1; };
    std::vector<Eigen::Vector3d> normals;
    for(std::size_t i = 0; i < points.size(); ++i)
      normals.push_back(has_normal(i) ? Eigen::Vector3d(0., 0., 1.) : Eigen::Vector3d(0., 0., 0.));
    samples.set_normals(normals);
    Point_set_samples::Workspace workspace;
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      Indices expected;
      for(const auto j : plain_order(points, i))
        if(has_normal(j))
          expected.push_back(j);
      expected.resize((std::min)(k, expected.size()));
      BOOST_TEST((samples.neighbors(i, 0, workspace) == expected), "k " << k << ", point " << i);
    }
    BOOST_TEST(!samples.has_coincident_points(4));
    BOOST_TEST(samples.has_coincident_points(300));
  }
}

// Neighbors are looked for where the points were; they are sorted as they are.
BOOST_AUTO_TEST_CASE(moved_points)
{
  const std::vector<Point_3> points = random_points(200, 12);
  Point_set_samples samples = samples_of(points, Neighborhood::nearest(10));
  std::vector<Point_3> moved = points;
  Random random(13);
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    const double x = .2 * random.uniform(), y = .2 * random.uniform();
    moved[i] = points[i] + Kernel::Vector_3(x, y, 0.);
    samples.set_point(i, Eigen::Vector3d(moved[i].x(), moved[i].y(), moved[i].z()));
  }
  Point_set_samples::Workspace workspace;
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    Indices expected = plain_order(points, i);
    expected.resize(10);
    std::sort(
        expected.begin(), expected.end(),
        [&](const std::size_t a, const std::size_t b)
        { return CGAL::squared_distance(moved[i], moved[a]) < CGAL::squared_distance(moved[i], moved[b]); });
    BOOST_TEST((samples.neighbors(i, 0, workspace) == expected));
  }
}

namespace {

// the origin, and points about as far from it as sqrt(1.3)
std::vector<Point_3> points_on_a_ring(std::size_t count, double width)
{
  std::vector<Point_3> points = {Point_3(0., 0., 0.)};
  Random random(14);
  for(std::size_t i = 0; i < count; ++i)
  {
    const double angle = 6. * random.uniform(), radius = std::sqrt(1.3) * (1. + width * random.uniform());
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.);
  }
  return points;
}

} // namespace

// Many neighbors, of which the leading bits of the distances don't tell which is nearer.
BOOST_AUTO_TEST_CASE(nearly_equal_distances)
{
  // so that no two are the same to seven digits
  std::vector<Point_3> points = points_on_a_ring(40, 0.);
  for(std::size_t i = 1; i < points.size(); ++i)
    points[i] = CGAL::ORIGIN + (1. + 1e-7 * double(17 * i % 41)) * (points[i] - CGAL::ORIGIN);
  for(const Neighborhood& neighborhood : {Neighborhood::nearest(25), Neighborhood::ball(1.5)})
  {
    Indices expected = plain_order(points, 0);
    if(neighborhood.kind() == Neighborhood::Kind::NEAREST)
      expected.resize(25);
    const Point_set_samples samples = samples_of(points, neighborhood);
    Point_set_samples::Workspace workspace;
    BOOST_TEST((samples.neighbors(0, 0, workspace) == expected));
  }
}

// Those that are equally far but for rounding come in the order of their coordinates, and so are chosen.
BOOST_AUTO_TEST_CASE(equal_distances_but_for_rounding)
{
  const std::vector<Point_3> points = points_on_a_ring(40, 1e-12);
  Indices in_order(points.size() - 1);
  std::iota(in_order.begin(), in_order.end(), Point_set_samples::Index(1));
  std::sort(in_order.begin(), in_order.end(),
            [&](const std::size_t a, const std::size_t b) { return points[a] < points[b]; });
  for(const Neighborhood& neighborhood : {Neighborhood::nearest(25), Neighborhood::ball(1.5)})
  {
    Indices expected = in_order;
    if(neighborhood.kind() == Neighborhood::Kind::NEAREST)
      expected.resize(25);
    const Point_set_samples samples = samples_of(points, neighborhood);
    Point_set_samples::Workspace workspace;
    BOOST_TEST((samples.neighbors(0, 0, workspace) == expected));
  }
}

// On regular surfaces, distances, coordinates, and edges of boxes are equal but for rounding. It doesn't decide.
BOOST_AUTO_TEST_CASE(regular_points_of_other_sizes)
{
  for(const test_support::Analytic_surface& surface :
      {test_support::torus(), test_support::torus(1., .4, 24, 12), test_support::waves(.1, 4., 1., 40)})
  {
    const auto points_times = [&](const double factor)
    {
      std::vector<Point_3> points;
      for(const auto& p : surface.points)
        points.emplace_back(factor * p[0], factor * p[1], factor * p[2]);
      return points;
    };
    // On the coarse torus, some are .4 away from each other, but for rounding.
    const auto neighborhoods_times = [](const double factor) {
      return std::array<Neighborhood, 2>{Neighborhood::nearest(18), Neighborhood::ball(.4 * factor)};
    };
    for(std::size_t k = 0; k < 2; ++k)
    {
      const Point_set_samples samples = samples_of(points_times(1.), neighborhoods_times(1.)[k]);
      for(const double factor : {1e6, 3e5, 1e3, 1. / 3., 1e-6})
      {
        const Point_set_samples others = samples_of(points_times(factor), neighborhoods_times(factor)[k]);
        BOOST_TEST((samples.traversal_order() == others.traversal_order()),
                   surface.name << " times " << factor);
        Point_set_samples::Workspace workspace;
        std::size_t different = 0;
        for(std::size_t i = 0; i < samples.size(); ++i)
        {
          const Indices neighbors = samples.neighbors(i, 0, workspace);
          different += neighbors != others.neighbors(i, 0, workspace);
        }
        BOOST_TEST(different == 0u,
                   surface.name << " times " << factor << ": " << different << " neighborhoods");
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(spacing)
{
  const std::vector<Point_3> points = random_points(80, 9);
  const Point_set_samples samples = samples_of(points, Neighborhood::nearest(3));
  double sum_of_all = 0.;
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    const Indices order = plain_order(points, i);
    double sum = 0.;
    for(std::size_t k = 0; k < 6; ++k)
      sum += std::sqrt(CGAL::squared_distance(points[i], points[order[k]]));
    BOOST_TEST(std::abs(samples.spacing(i) - sum / 6.) < 1e-14);
    sum_of_all += sum / 6.;
  }
  BOOST_TEST(std::abs(samples.mean_spacing() - sum_of_all / double(points.size())) < 1e-14);
}

// of many points as well
BOOST_AUTO_TEST_CASE(mean_spacing_has_no_order)
{
  std::vector<Point_3> points = random_points(2500, 12);
  const double spacing = samples_of(points, Neighborhood::nearest(3)).mean_spacing();
  std::sort(points.begin(), points.end());
  BOOST_TEST(samples_of(points, Neighborhood::nearest(3)).mean_spacing() == spacing);
}

BOOST_AUTO_TEST_CASE(traversal_goes_by_compact_patches)
{
  std::vector<Point_3> points = random_points(20000, 10);
  for(Point_3& p : points)
    p = Point_3(p.x(), p.y(), std::sin(p.x()));
  const std::size_t bad = 77;
  points[bad] = Point_3(0., std::numeric_limits<double>::quiet_NaN(), 0.);
  const Point_set_samples samples = samples_of(points, Neighborhood::nearest(6));
  const Indices order = samples.traversal_order();
  BOOST_REQUIRE(order.size() == points.size());
  BOOST_TEST(order.back() == bad);
  BOOST_TEST((samples_of(points, Neighborhood::ball(.1)).traversal_order() == order));
  test_support::check_traversal(samples, 512);

  std::vector<std::size_t> block(points.size(), points.size());
  for(std::size_t k = 0; k < order.size(); ++k)
  {
    BOOST_REQUIRE(block[order[k]] == points.size()); // not yet seen
    block[order[k]] = k / 2000;
  }
  Point_set_samples::Workspace workspace;
  std::size_t neighbors = 0, across = 0;
  for(std::size_t i = 0; i < points.size(); ++i)
    for(const auto j : samples.neighbors(i, 0, workspace))
    {
      ++neighbors;
      across += block[i] != block[j];
    }
  BOOST_TEST(double(across) / double(neighbors) < .08);

  const std::vector<Point_3> none(3, points[bad]);
  BOOST_TEST((samples_of(none, Neighborhood::nearest(6)).traversal_order() == Indices{0, 1, 2}));
}

BOOST_AUTO_TEST_CASE(rings_need_a_mesh)
{
  BOOST_CHECK_THROW(samples_of(random_points(5, 1), Neighborhood::rings(1)), std::invalid_argument);
}

// In units in which squares of lengths are out of the range of numbers, neighbors are the same as in others.
BOOST_AUTO_TEST_CASE(extraordinary_units)
{
  for(const std::vector<Point_3>& points : {random_points(300, 11), grid(8)})
    for(const Neighborhood& neighborhood : {Neighborhood::nearest(12), Neighborhood::ball(1.2)})
      for(const double unit : {0x1p-1000, 0x1p-560, 0x1p-500, 0x1p500, 0x1p560, 0x1p1000})
      {
        const Point_set_samples expected = samples_of(points, neighborhood);
        std::vector<Point_3> scaled;
        for(const Point_3& p : points)
          scaled.emplace_back(unit * p.x(), unit * p.y(), unit * p.z());
        const bool is_ball = neighborhood.kind() == Neighborhood::Kind::BALL;
        const Point_set_samples samples =
            samples_of(scaled, is_ball ? Neighborhood::ball(1.2 * unit) : neighborhood);
        Point_set_samples::Workspace a, b;
        std::size_t differences = 0;
        for(std::size_t i = 0; i < points.size(); ++i)
          differences += samples.neighbors(i, 0, a) != expected.neighbors(i, 0, b) ||
                         samples.spacing(i) != unit * expected.spacing(i) || samples.has_coincident_points(i);
        BOOST_TEST(differences == 0u);
        BOOST_TEST((samples.traversal_order() == expected.traversal_order()));
      }

  // One point that is far away doesn't make the unit extraordinary for all, ...
  std::vector<Point_3> points = random_points(300, 12);
  const Point_set_samples expected = samples_of(points, Neighborhood::nearest(12));
  points.emplace_back(1e308, -1e308, 1e308);
  const Point_set_samples samples = samples_of(points, Neighborhood::nearest(12));
  Point_set_samples::Workspace a, b;
  for(std::size_t i = 0; i + 1 < points.size(); ++i)
    BOOST_TEST((samples.neighbors(i, 0, a) == expected.neighbors(i, 0, b)));
  // ... nor do lengths count for nothing beside it, whatever their unit, ...
  for(const double unit : {1e-60, 1e-70})
  {
    std::vector<Point_3> small = random_points(300, 12);
    for(Point_3& p : small)
      p = Point_3(unit * p.x(), unit * p.y(), unit * p.z());
    const Point_set_samples without = samples_of(small, Neighborhood::nearest(12));
    small.emplace_back(1e110, -1e110, 1e110);
    const Point_set_samples with = samples_of(small, Neighborhood::nearest(12));
    for(std::size_t i = 0; i + 1 < small.size(); ++i)
      BOOST_TEST((with.neighbors(i, 0, a) == without.neighbors(i, 0, b)));
  }
  // ... but it is a neighbor where there is no other, unless it is beyond all numbers in the unit of the others, ...
  std::vector<Point_3> few(12, Point_3(1e-160, 0., 0.));
  few.resize(20, Point_3(-1e-160, 0., 0.));
  few.emplace_back(0., 1e-20, 0.);
  few.emplace_back(0., 0., 1.);
  few.emplace_back(1e110, 0., 0.);
  const Point_set_samples distant = samples_of(few, Neighborhood::nearest(20));
  for(const std::size_t i : {0u, 5u})
  {
    BOOST_TEST(distant.neighbors(i, 0, a).size() == 9u);
    BOOST_TEST(distant.neighbors(i, 0, a).back() == 20u);
  }
  BOOST_TEST(distant.neighbors(20, 0, a).size() == 20u);
  for(const std::size_t i : {21u, 22u})
    BOOST_TEST(distant.neighbors(i, 0, a).empty());
  // ... and a few that are so close that nothing tells their distances apart are one.
  points = random_points(300, 12);
  for(int k = 0; k < 5; ++k)
    points.emplace_back(1e-170 * double(k), 0., 0.);
  const Point_set_samples crowded = samples_of(points, Neighborhood::nearest(4));
  for(std::size_t i = 300; i < points.size(); ++i)
    for(const auto j : crowded.neighbors(i, 0, a))
      BOOST_TEST(j < 300u);
}

BOOST_AUTO_TEST_SUITE_END()
