#include <boost/test/unit_test.hpp>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "analytic_surfaces.h"
#include "estimators.h"
#include "known_shapes.h"
#include "raise_to.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(bad_point_sets)

using namespace test_support;
using namespace bad_inputs;
using S = Estimation_status;
using Point_estimator = Estimator<Point_set>;

namespace {

const std::vector<Point_estimator> all_estimators = estimators<Point_set>();
const double nan_value = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

Point_set points_of(const Analytic_surface& s)
{
  Point_set points;
  for(std::size_t i = 0; i < s.points.size(); ++i)
  {
    const Vector &p = s.points[i], &n = s.exact[i].normal;
    points.push_back({Point_3(p.x, p.y, p.z), Vector_3(n.x, n.y, n.z)});
  }
  return points;
}

template <typename Map>
Point_set moved(Point_set points, const Map& map)
{
  for(Oriented_point& p : points)
    p.point = map(p.point);
  return points;
}

Point_set flipped(Point_set points)
{
  for(Oriented_point& p : points)
    p.normal = -p.normal;
  return points;
}

Point_set with(Point_set points, std::size_t i, const Point_3& p, const Vector_3& n)
{
  points[i] = {p, n};
  return points;
}

// Of a wavy sheet; the spacing is 1/8.
Point_set sheet()
{
  return points_of(waves(.1, 4., 1., 16, .15));
}
constexpr std::size_t middle = 8 * 17 + 8;

double distance(const Point_set& points, std::size_t i, std::size_t j)
{
  return std::sqrt(CGAL::squared_distance(points[i].point, points[j].point));
}

struct Row
{
  int number; // of the list of bad inputs
  std::string name;
  Point_set points;
  std::vector<S> allowed; // what a status may be; empty: anything
};

Point_set copies(const Oriented_point& p, std::size_t n)
{
  return Point_set(n, p);
}

std::vector<Row> rows()
{
  const Point_set ball = points_of(sphere(1., 2, .15)), waves_points = sheet();
  const Oriented_point origin{Point_3(.1, .2, .3), Vector_3(0., 0., 1.)};
  const std::vector<S> none = {S::FEW_NEIGHBOURS, S::DEGENERATE};

  Point_set line, coincident = waves_points, stack = waves_points, without_normals = ball,
                  half_flipped = ball, two_sheets, crossing = points_of(plane(1., 8, .1));
  for(int i = 0; i < 50; ++i)
    line.push_back({Point_3(.31 * i, -.77 * i, .55 * i), Vector_3(1., 2., 0.)});
  coincident.insert(coincident.end(), 30, coincident[middle]);
  stack.insert(stack.end(), 1000, {stack[middle].point, Vector_3(1., 0., 1.)});
  for(Oriented_point& p : without_normals)
    p.normal = Vector_3(0., 0., 0.);
  for(std::size_t i = 0; i < half_flipped.size(); i += 2)
    half_flipped[i].normal = -half_flipped[i].normal;
  for(const double z : {0., -.01})
    for(const Oriented_point& p : points_of(plane(1., 10, .1)))
      two_sheets.push_back({p.point + Vector_3(0., 0., z), z == 0. ? p.normal : -p.normal});
  for(const Oriented_point& p : points_of(plane(1., 8, .1)))
    crossing.push_back({Point_3(p.point.z(), p.point.y(), p.point.x()), Vector_3(1., 0., 0.)});

  return {
      {1, "empty", {}, {}},
      {2, "one point", copies(origin, 1), {S::FEW_NEIGHBOURS}},
      {2, "two points", {waves_points[0], waves_points[1]}, {S::FEW_NEIGHBOURS}},
      {2, "three points", {waves_points[0], waves_points[1], waves_points[20]}, none},
      {2,
       "four points",
       {waves_points[0], waves_points[1], waves_points[20], waves_points[40]},
       {S::ESTIMATED, S::FEW_NEIGHBOURS, S::DEGENERATE}},
      {9, "coincident points", coincident, {}},
      {9, "a stack of points", stack, {}},
      {10, "collinear", line, {S::DEGENERATE}},
      {10, "identical", copies(origin, 500), {S::DEGENERATE}},
      {11, "coplanar", points_of(plane(1., 10, .2)), {S::ESTIMATED}},
      {12,
       "all NaN",
       moved(ball, [](const Point_3&) { return Point_3(nan_value, 0., 0.); }),
       {S::NON_FINITE_INPUT}},
      {12,
       "all huge",
       moved(ball, [](const Point_3& p) { return Point_3(1e308 * p.x(), 1e308 * p.y(), p.z()); }),
       {}},
      {12,
       "all denormal",
       moved(ball, [](const Point_3& p) { return Point_3(1e-310 * p.x(), 1e-310 * p.y(), 1e-310 * p.z()); }),
       {}},
      {12, "one huge", with(waves_points, middle, Point_3(1e308, -1e308, 1e308), Vector_3(0., 0., 1.)), {}},
      {13, "no normals", without_normals, {S::NON_FINITE_INPUT}},
      {14, "half of the normals flipped", half_flipped, {}},
      {19, "sphere", ball, {S::ESTIMATED}},
      {22,
       "scale 1e-100",
       moved(ball, [](const Point_3& p) { return Point_3(1e-100 * p.x(), 1e-100 * p.y(), 1e-100 * p.z()); }),
       {S::ESTIMATED}},
      {22,
       "scale 1e+100",
       moved(ball, [](const Point_3& p) { return Point_3(1e100 * p.x(), 1e100 * p.y(), 1e100 * p.z()); }),
       {S::ESTIMATED}},
      {24,
       "density 1 : 1000",
       moved(waves_points,
             [](const Point_3& p) { return p.x() < 0. ? Point_3(1e-3 * p.x(), p.y(), p.z()) : p; }),
       {}},
      {26, "two sheets", two_sheets, {S::DEGENERATE}},
      {26, "planes that cross", crossing, {}},
  };
}

} // namespace

// What holds for every input and estimator: nothing is thrown, every value is written, and is finite where the status
// says that it was estimated and NaN elsewhere; failures are counted; and the statuses of the row.
BOOST_AUTO_TEST_CASE(every_row_and_estimator)
{
  for(const Row& row : rows())
    for(const Point_estimator& estimator : all_estimators)
      BOOST_TEST_CONTEXT("row " << row.number << ", " << row.name << ", " << estimator.name)
      {
        Results results;
        BOOST_REQUIRE_NO_THROW(results = estimator.all(row.points));
        BOOST_TEST(complaint(results, row.points) == "");
        for(std::size_t i = 0; i < results.samples.size() && !row.allowed.empty(); ++i)
        {
          const S status = results.samples[i].status;
          BOOST_TEST((std::find(row.allowed.begin(), row.allowed.end(), status) != row.allowed.end()),
                     "point " << i << ": " << SC::to_string(status));
        }
      }
}

// Rows that are much farther apart than their points: the nearest points are on one of them, and tell nothing of the curvature across.
// It is said so, or farther ones are taken.
BOOST_AUTO_TEST_CASE(rows_far_apart)
{
  Point_set points;
  std::vector<double> across; // exact curvature
  for(int row = -5; row <= 5; ++row)
    for(int k = -100; k <= 100; ++k)
    {
      const double angle = .2 * row, z = .01 * k, wave = 1. + .1 * std::cos(2. * z),
                   slope = -.2 * std::sin(2. * z);
      Vector_3 normal(std::cos(angle), std::sin(angle), -slope);
      normal = normal / std::sqrt(normal.squared_length());
      points.push_back({Point_3(wave * std::cos(angle), wave * std::sin(angle), z), normal});
      across.push_back(1. / (wave * std::sqrt(1. + slope * slope)));
    }
  for(const Point_estimator& estimator : all_estimators)
    if(estimator.gives_curvatures)
      BOOST_TEST_CONTEXT(estimator.name)
      {
        const Results results = estimator.all(points);
        BOOST_TEST(complaint(results, points) == "");
        for(std::size_t i = 0; i < points.size(); ++i)
          if(std::abs(points[i].point.z()) < .8 &&
             std::abs(std::atan2(points[i].point.y(), points[i].point.x())) < .7 &&
             SC::is_estimated(results.samples[i].status))
            BOOST_TEST(std::abs(results.samples[i].k_max() - across[i]) < .25, "point " << i);
      }
}

// The tip of a cone, among points around it.
BOOST_AUTO_TEST_CASE(cone_with_apex)
{
  const Analytic_surface surface = cone(1., 1.5, 12, 12);
  const Point_set points = points_of(surface);
  for(const Point_estimator& estimator : all_estimators)
    BOOST_TEST_CONTEXT(estimator.name)
    {
      const Results results = estimator.all(points);
      for(std::size_t i = 0; i < points.size(); ++i)
        if(surface.exact[i].singular)
          BOOST_TEST((results.samples[i].status == S::DEGENERATE));
    }
}

namespace {

// as far as an estimator sees on the sheet, whose points are at some 0.16
double distance_of_sight(const Point_estimator& estimator)
{
  return .16 * double(estimator.sight);
}

} // namespace

// A bad point or normal is flagged, is nobody's neighbor, and isn't seen from afar. (A point more or less among the 18
// nearest reaches two rings; the normal of a point reaches those that have it among theirs.)
BOOST_AUTO_TEST_CASE(bad_points_and_normals_stay_where_they_are)
{
  const Point_set clean = sheet();
  const Oriented_point p = clean[middle];
  const auto bad_normal = [&](const Vector_3& n) { return with(clean, middle, p.point, n); };
  const std::vector<std::pair<S, Point_set>> inputs = {
      {S::NON_FINITE_INPUT, with(clean, middle, Point_3(nan_value, 0., 0.), p.normal)},
      {S::NON_FINITE_INPUT, with(clean, middle, Point_3(0., infinity, 0.), p.normal)},
      {S::NON_FINITE_INPUT, with(clean, middle, Point_3(-infinity, nan_value, infinity), p.normal)},
      {S::NON_FINITE_INPUT, bad_normal(Vector_3(nan_value, 0., 1.))},
      {S::NON_FINITE_INPUT, bad_normal(Vector_3(0., 0., infinity))},
      {S::NON_FINITE_INPUT, bad_normal(Vector_3(0., 0., 0.))},
      {S::ESTIMATED, bad_normal(-p.normal)},
      {S::ESTIMATED, with(clean, middle, Point_3(p.point.x(), p.point.y(), .6), p.normal)}};
  for(const Point_estimator& estimator : all_estimators)
  {
    const Results without = estimator.all(clean);
    for(std::size_t k = 0; k < inputs.size(); ++k)
      BOOST_TEST_CONTEXT(estimator.name << ", input " << k)
      {
        const Results results = estimator.all(inputs[k].second);
        BOOST_TEST(complaint(results, inputs[k].second) == "");
        for(std::size_t i = 0; i < clean.size(); ++i)
        {
          const S status = results.samples[i].status;
          if(inputs[k].first == S::NON_FINITE_INPUT)
            BOOST_TEST((status == S::NON_FINITE_INPUT) == (i == middle));
          if(distance(clean, i, middle) > distance_of_sight(estimator) && !estimator.has_pattern)
            BOOST_TEST(same_but_for_fits(estimator, results.samples[i], without.samples[i]), "point " << i);
        }
      }
  }
}

// Copies of a point, with its normal, leave the others' results as they are, but for the room that they take among the
// nearest points.
BOOST_AUTO_TEST_CASE(coincident_points)
{
  Point_set points = sheet();
  const std::size_t n = points.size();
  points.insert(points.end(), 5, points[middle]);
  for(const Point_estimator& estimator : all_estimators)
    BOOST_TEST_CONTEXT(estimator.name)
    {
      const Results once = estimator.all(sheet()), six_times = estimator.all(points);
      BOOST_TEST(complaint(six_times, points) == "");
      for(std::size_t i = n; i < points.size(); ++i) // all copies get the same
        BOOST_TEST(same_but_for_fits(estimator, six_times.samples[i], six_times.samples[middle]));
      if(!estimator.has_pattern)
      {
        // not if its parameter is the neighbors' spacing, or if it sees what the neighbors make of the copies
        if(estimator.name.find("Exponential") == std::string::npos &&
           estimator.name.rfind("kalogerakis", 0) != 0)
          BOOST_TEST(same_but_for_fits(estimator, six_times.samples[middle], once.samples[middle]));
        for(std::size_t i = 0; i < n; ++i)
          if(distance(points, i, middle) > distance_of_sight(estimator))
            BOOST_TEST(same_but_for_fits(estimator, six_times.samples[i], once.samples[i]));
      }
    }
}

BOOST_AUTO_TEST_CASE(plane_is_flat)
{
  const Point_set points =
      moved(points_of(plane(1., 10, .2)), [](const Point_3& p) { return p + Vector_3(3., -2., 1.); });
  for(const Point_estimator& estimator : all_estimators)
    if(estimator.gives_curvatures)
      BOOST_TEST_CONTEXT(estimator.name)
      {
        for(const Estimate& e : estimator.all(points).samples)
        {
          BOOST_TEST((e.status == S::ESTIMATED));
          BOOST_TEST(largest(e) <= 1e-11);
        }
      }
}

BOOST_AUTO_TEST_CASE(sphere_is_umbilic)
{
  const double radius = 2.5;
  const Point_set points = points_of(sphere(radius, 3, .15));
  for(const Point_estimator& estimator : all_estimators)
    if(estimator.gives_curvatures)
      BOOST_TEST_CONTEXT(estimator.name)
      {
        check_sphere(estimator, estimator.all(points), radius);
      }
}

BOOST_AUTO_TEST_CASE(cylinder_has_a_direction)
{
  const Point_set points = points_of(cylinder(1., 2., 40, 12, .15));
  std::vector<std::size_t> inner;
  for(std::size_t i = 0; i < points.size(); ++i)
    if(std::abs(points[i].point.z() - 1.) < .6)
      inner.push_back(i);
  for(const Point_estimator& estimator : all_estimators)
    if(estimator.gives_curvatures)
      BOOST_TEST_CONTEXT(estimator.name)
      {
        check_cylinder(estimator, estimator.all(points), inner);
      }
}

// Of two half planes that meet at a right angle, on a grid: the edge is found by what is said of its curvature, and not the planes.
BOOST_AUTO_TEST_CASE(sharp_edge)
{
  constexpr int n = 10;
  const double spacing = 1. / n;
  Point_set points;
  for(int i = -n; i <= n; ++i)
    for(int j = -n; j <= n; ++j)
    {
      const double x = spacing * (std::max)(i, 0), z = spacing * (std::min)(i, 0);
      const double s = i == 0 ? std::sqrt(.5) : 1.;
      points.push_back({Point_3(x, spacing * j, z), Vector_3(i <= 0 ? -s : 0., 0., i >= 0 ? s : 0.)});
    }
  for(const Point_estimator& estimator : all_estimators)
    if(estimator.gives_curvatures)
      BOOST_TEST_CONTEXT(estimator.name)
      {
        const Results results = estimator.all(points);
        BOOST_TEST(complaint(results, points) == "");
        for(std::size_t i = 0; i < points.size(); ++i)
        {
          const double from_edge = points[i].point.x() - points[i].point.z();
          // at the border of a grid, 18 points can be too few for polynomials
          const bool is_inner = from_edge < .6 && std::abs(points[i].point.y()) < .6;
          if(is_inner && !estimator.needs_smoothness)
            BOOST_TEST((results.samples[i].status == S::ESTIMATED), "point " << i);
          const bool is_found = is_sharp(estimator, results.samples[i], spacing);
          if(from_edge == 0. && SC::is_estimated(results.samples[i].status))
            BOOST_TEST(is_found, "edge, point " << i);
          if(from_edge > 5.5 * spacing)
            BOOST_TEST(!is_found, "plane, point " << i);
        }
      }
}

// On tori, which are regular, much is equal but for rounding: distances, coordinates, angles. The coarse one looks noisy. The fine one,
// the largest of all, is there for what rounds: powers of two don't.
BOOST_AUTO_TEST_CASE(scaling)
{
  const std::vector<Point_set> surfaces = {sheet(), points_of(torus(1., .4, 24, 12)), points_of(torus())};
  const std::vector<double> rounding = {1e-6, 1e6}, all_scales = {1e-6, 1e6, 0x1p-200, 0x1p200};
  for(const Point_set& points : surfaces)
  {
    const bool is_fine = &points == &surfaces.back();
    for(const Point_estimator& estimator : all_estimators)
    {
      if(!estimator.gives_curvatures)
        continue;
      const Results a = estimator.all(points);
      for(const double scale : is_fine ? rounding : all_scales)
        BOOST_TEST_CONTEXT(points.size() << " points times " << scale << ", " << estimator.name)
        {
          const Results b =
              estimator.all(moved(points, [&](const Point_3& p)
                                  { return Point_3(scale * p.x(), scale * p.y(), scale * p.z()); }));
          BOOST_TEST_MESSAGE(points.size() << " points, " << estimator.name << " times " << scale
                                           << ": changed by " << change_by_scaling(a, b, scale));
          BOOST_TEST(complaint_of_scaled(estimator, a, b, scale) == "");
        }
    }
  }
}

// The points were rounded when they were moved away; moving them back is exact.
BOOST_AUTO_TEST_CASE(large_offset)
{
  const Vector_3 offset(5e6, 1e7, -3e6);
  const Point_set far = moved(sheet(), [&](const Point_3& p) { return p + offset; });
  const Point_set near = moved(far, [&](const Point_3& p) { return p - offset; });
  for(const Point_estimator& estimator : all_estimators)
    if(estimator.gives_curvatures)
      BOOST_TEST_CONTEXT(estimator.name)
      {
        const Results a = estimator.all(near), b = estimator.all(far);
        for(std::size_t i = 0; i < near.size(); ++i)
        {
          BOOST_REQUIRE((a.samples[i].status == b.samples[i].status));
          if(SC::is_estimated(a.samples[i].status))
            BOOST_TEST(std::abs(a.samples[i].k_max() - b.samples[i].k_max()) <=
                       1e-6 * (1. + largest(a.samples[i])));
        }
      }
}

// to the last bit, on a grid as well, where many points are equally far
BOOST_AUTO_TEST_CASE(permutation)
{
  Random random(5);
  for(const Analytic_surface& surface :
      {waves(.1, 4., 1., 12, .15), waves(.1, 4., 1., 12), sphere(1., 2), plane(1., 8)})
  {
    const Point_set points = points_of(surface);
    std::vector<std::size_t> place(points.size());
    std::iota(place.begin(), place.end(), std::size_t(0));
    for(std::size_t i = place.size(); i > 1; --i)
      std::swap(place[i - 1], place[std::size_t(random.uniform() * double(i))]);
    Point_set shuffled(points.size());
    for(std::size_t i = 0; i < place.size(); ++i)
      shuffled[place[i]] = points[i];
    for(const Point_estimator& estimator : all_estimators)
      BOOST_TEST_CONTEXT(surface.name << ", " << estimator.name)
      {
        const Results a = estimator.all(points), b = estimator.all(shuffled);
        for(std::size_t i = 0; i < place.size(); ++i)
          BOOST_TEST(same_but_for_fits(estimator, a.samples[i], b.samples[place[i]]), "point " << i);
      }
  }
}

BOOST_AUTO_TEST_CASE(flipped_normals)
{
  const Point_set points = sheet();
  for(const Point_estimator& estimator : all_estimators)
    if(estimator.gives_curvatures)
      BOOST_TEST_CONTEXT(estimator.name)
      {
        const Results a = estimator.all(points), b = estimator.all(flipped(points));
        for(std::size_t i = 0; i < points.size(); ++i)
        {
          BOOST_REQUIRE((a.samples[i].status == b.samples[i].status));
          if(!SC::is_estimated(a.samples[i].status))
            continue;
          const double tolerance = estimator.flips_exactly ? 0. : 1e-12 * largest(a.samples[i]);
          BOOST_TEST(std::abs(b.samples[i].k_min() + a.samples[i].k_max()) <= tolerance);
          BOOST_TEST(std::abs(b.samples[i].k_max() + a.samples[i].k_min()) <= tolerance);
        }
      }
}

// Lengths of normals don't matter.
BOOST_AUTO_TEST_CASE(length_of_normals)
{
  const Point_set points = sheet();
  for(const Point_estimator& estimator : all_estimators)
  {
    const Results a = estimator.all(points);
    for(const double factor : {0x1p-1000, 0x1p1000})
      BOOST_TEST_CONTEXT("normals times " << factor << ", " << estimator.name)
      {
        Point_set scaled = points;
        for(Oriented_point& p : scaled)
          p.normal = factor * p.normal;
        const Results b = estimator.all(scaled);
        for(std::size_t i = 0; i < points.size(); ++i)
          BOOST_TEST(same(a.samples[i], b.samples[i]), "point " << i);
      }
  }
}

#ifdef CGAL_LINKED_WITH_TBB
BOOST_AUTO_TEST_CASE(number_of_threads)
{
  const Point_set points = sheet();
  for(const Point_estimator& estimator : all_estimators)
    BOOST_TEST_CONTEXT(estimator.name)
    {
      Results of_one, of_two;
      tbb::task_arena(1).execute([&] { of_one = estimator.all(points); });
      tbb::task_arena(2).execute([&] { of_two = estimator.all(points); });
      for(std::size_t i = 0; i < points.size(); ++i)
        BOOST_TEST(same(of_one.samples[i], of_two.samples[i]), "point " << i);
    }
}
#endif

BOOST_AUTO_TEST_SUITE_END()
