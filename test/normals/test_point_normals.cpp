#include <boost/test/unit_test.hpp>

#include <Shape_characteristics/normals/point_normals.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/jet_estimate_normals.h>
#include <CGAL/pca_estimate_normals.h>

#include "analytic_surfaces.h"
#include "raise_to.h"
#include "says.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(point_normals)

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Status = SC::Estimation_status;

namespace {

const double quiet_nan = std::numeric_limits<double>::quiet_NaN();

// an element of a range: nothing of it tells where in the range it is
struct Oriented_point
{
  Point_3 point;
  Vector_3 normal = Vector_3(7, 7, 7);
  Status status = Status::CANCELLED;
};

template <typename T>
struct Member_map
{
  using key_type = Oriented_point;
  using value_type = T;
  using reference = const T&;
  using category = boost::read_write_property_map_tag;
  T Oriented_point::*member;
  friend const T& get(const Member_map& map, const Oriented_point& p) { return p.*map.member; }
  friend void put(const Member_map& map, Oriented_point& p, const T& value) { p.*map.member = value; }
};

using Cloud = std::vector<Oriented_point>;
const Member_map<Point_3> point_map{&Oriented_point::point};
const Member_map<Vector_3> normal_map{&Oriented_point::normal};
const Member_map<Status> status_map{&Oriented_point::status};

Cloud cloud_of(const std::vector<test_support::Vector>& points)
{
  Cloud cloud;
  for(const auto& p : points)
    cloud.push_back({Point_3(p[0], p[1], p[2])});
  return cloud;
}

auto parameters()
{
  return SC::parameters::point_map(point_map).status_map(status_map);
}

template <typename NamedParameters>
std::size_t run(Cloud& cloud, const NamedParameters& np)
{
  const std::size_t failures = SC::point_normals(cloud, normal_map, np);
  std::size_t counted = 0;
  for(const Oriented_point& p : cloud)
  {
    const double length = std::sqrt(p.normal.squared_length());
    if(SC::is_estimated(p.status))
      BOOST_TEST(std::abs(length - 1) < 1e-12);
    else
    {
      ++counted;
      BOOST_TEST((std::isnan(p.normal.x()) && std::isnan(p.normal.y()) && std::isnan(p.normal.z())));
    }
  }
  BOOST_TEST(failures == counted);
  return failures;
}

// greatest angle to the exact, outward normals
double largest_angle(const Cloud& cloud, const test_support::Analytic_surface& surface)
{
  double largest = 0;
  for(std::size_t i = 0; i < cloud.size(); ++i)
  {
    const auto& n = surface.exact[i].normal;
    const double cosine = cloud[i].normal * Vector_3(n[0], n[1], n[2]);
    test_support::raise_to(largest, std::acos(std::min(1., std::max(-1., cosine))));
  }
  return largest;
}

bool same(const Vector_3& a, const Vector_3& b)
{
  return a == b || (std::isnan(a.x()) && std::isnan(b.x()));
}

} // namespace

// on closed surfaces every normal is outward and near the exact one; the fit of quadrics is nearer than that of planes
BOOST_AUTO_TEST_CASE(closed_surfaces)
{
  using SC::Point_normal_method;
  const auto check = [](const test_support::Analytic_surface& surface, double pca_bound, double jet_bound)
  {
    BOOST_TEST_CONTEXT(surface.name)
    {
      Cloud cloud = cloud_of(surface.points);
      BOOST_TEST(run(cloud, parameters()) == 0u);
      const double pca = largest_angle(cloud, surface);
      BOOST_TEST(pca < pca_bound);
      BOOST_TEST(run(cloud, parameters().point_normal_method(Point_normal_method::JET)) == 0u);
      const double jet = largest_angle(cloud, surface);
      BOOST_TEST(jet < jet_bound);
      BOOST_TEST_MESSAGE(surface.name << ": largest angle of PCA " << pca << ", of jets " << jet);

      const double radius = 2.5 * surface.mean_edge_length();
      BOOST_TEST(run(cloud, parameters().neighbor_radius(radius)) == 0u);
      BOOST_TEST(largest_angle(cloud, surface) < 1.5 * pca_bound);
      BOOST_TEST(run(cloud, parameters().neighbor_radius(radius).point_normal_method(
                                Point_normal_method::JET)) == 0u);
      BOOST_TEST(largest_angle(cloud, surface) < 2 * jet_bound);
    }
  };
  for(double jitter : {0., .2})
  {
    check(test_support::sphere(2., 4, jitter), .04, .0004);
    check(test_support::torus(1., .4, 96, 48, jitter), .1, .01);
    check(test_support::ellipsoid(1., .8, .6, 4, jitter), .06, .012);
  }
}

// up to their signs and the last digits, CGAL's normals
BOOST_AUTO_TEST_CASE(estimates_are_those_of_CGAL)
{
  using Pair = std::pair<Point_3, Vector_3>;
  const auto surface = test_support::torus(1., .4, 48, 24, .2);
  std::vector<Pair> pairs;
  for(const auto& p : surface.points)
    pairs.emplace_back(Point_3(p[0], p[1], p[2]), Vector_3(0, 0, 0));
  const auto np = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Pair>())
                      .normal_map(CGAL::Second_of_pair_property_map<Pair>());
  for(const auto method : {SC::Point_normal_method::PCA, SC::Point_normal_method::JET})
  {
    Cloud cloud = cloud_of(surface.points);
    run(cloud, parameters().point_normal_method(method).number_of_neighbors(13));
    if(method == SC::Point_normal_method::PCA)
      CGAL::pca_estimate_normals<CGAL::Sequential_tag>(pairs, 13, np);
    else
      CGAL::jet_estimate_normals<CGAL::Sequential_tag>(pairs, 13, np);
    double largest = 0;
    for(std::size_t i = 0; i < cloud.size(); ++i)
      test_support::raise_to(largest, 1 - std::abs(pairs[i].second * cloud[i].normal));
    BOOST_TEST(largest < 1e-12);
  }
}

// Where a surface ends, the normals still point to one side.
BOOST_AUTO_TEST_CASE(open_surfaces)
{
  for(const auto& surface : {test_support::cylinder(1., 2., 60, 20, .1), test_support::plane(1., 24, .1),
                             test_support::waves(.1, 4., 1., 48, .1)})
    BOOST_TEST_CONTEXT(surface.name)
    {
      Cloud cloud = cloud_of(surface.points);
      BOOST_TEST(run(cloud, parameters()) == 0u);
      BOOST_TEST(largest_angle(cloud, surface) < .2);
    }
}

BOOST_AUTO_TEST_CASE(parts_that_do_not_touch)
{
  test_support::Analytic_surface both = test_support::sphere(1., 3);
  const test_support::Analytic_surface torus = test_support::torus(1., .4, 48, 24);
  for(std::size_t i = 0; i < torus.points.size(); ++i)
  {
    both.points.push_back(torus.points[i] + test_support::Vector{10., 0., -5.});
    both.exact.push_back(torus.exact[i]);
  }
  Cloud cloud = cloud_of(both.points);
  BOOST_TEST(run(cloud, parameters()) == 0u);
  BOOST_TEST(largest_angle(cloud, both) < .15);
}

// On tori, many points are equally far from another but for rounding: it doesn't decide which are neighbors.
BOOST_AUTO_TEST_CASE(regular_points_of_other_sizes)
{
  for(const auto& surface : {test_support::torus(), test_support::torus(1., .4, 24, 12)})
    for(const auto method : {SC::Point_normal_method::PCA, SC::Point_normal_method::JET})
    {
      const auto np = parameters().point_normal_method(method);
      Cloud cloud = cloud_of(surface.points);
      run(cloud, np);
      for(const double factor : {1e6, 3e5, 1e3, 1. / 3., 1e-6})
      {
        Cloud other;
        for(const auto& p : surface.points)
          other.push_back({Point_3(factor * p[0], factor * p[1], factor * p[2])});
        run(other, np);
        double change = 0.;
        for(std::size_t i = 0; i < cloud.size(); ++i)
          test_support::raise_to(change, std::sqrt((cloud[i].normal - other[i].normal).squared_length()));
        BOOST_TEST(change < 1e-12, surface.points.size() << " points times " << factor);
      }
    }
}

BOOST_AUTO_TEST_CASE(order_unit_position_and_threads_do_not_matter)
{
  const auto surface = test_support::ellipsoid(1., .8, .6, 3, .2);
  for(const auto method : {SC::Point_normal_method::PCA, SC::Point_normal_method::JET})
  {
    const auto np = parameters().point_normal_method(method);
    Cloud cloud = cloud_of(surface.points);
    run(cloud, np);

    std::vector<std::size_t> order(cloud.size());
    for(std::size_t i = 0; i < order.size(); ++i)
      order[i] = i;
    std::mt19937 random(1);
    std::shuffle(order.begin(), order.end(), random);
    Cloud shuffled;
    for(std::size_t i : order)
      shuffled.push_back({cloud[i].point});
    run(shuffled, np);
    std::size_t different = 0;
    for(std::size_t i = 0; i < order.size(); ++i)
    {
      BOOST_TEST(shuffled[i].point == cloud[order[i]].point); // the range isn't reordered
      different += !same(shuffled[i].normal, cloud[order[i]].normal);
    }
    BOOST_TEST(different == 0u);

    Cloud sequential = cloud_of(surface.points);
    SC::point_normals<CGAL::Sequential_tag>(sequential, normal_map, np);
    Cloud parallel = cloud_of(surface.points);
    SC::point_normals<CGAL::Parallel_if_available_tag>(parallel, normal_map, np);
    for(std::size_t i = 0; i < cloud.size(); ++i)
      different += !same(sequential[i].normal, cloud[i].normal) || !same(parallel[i].normal, cloud[i].normal);
    BOOST_TEST(different == 0u);

    for(const double scale : {std::ldexp(1., -1000), std::ldexp(1., 20), std::ldexp(1., 1000)})
    {
      Cloud scaled = cloud;
      for(Oriented_point& p : scaled)
        p.point = Point_3(scale * p.point.x(), scale * p.point.y(), scale * p.point.z());
      run(scaled, np);
      for(std::size_t i = 0; i < cloud.size(); ++i)
        different += !same(scaled[i].normal, cloud[i].normal);
      BOOST_TEST(different == 0u);
    }
    double largest = 0;
    Cloud moved = cloud;
    for(Oriented_point& p : moved)
      p.point = p.point + Vector_3(1e7, -2e7, 3e6);
    run(moved, np);
    for(std::size_t i = 0; i < cloud.size(); ++i)
      test_support::raise_to(largest, std::sqrt((moved[i].normal - cloud[i].normal).squared_length()));
    BOOST_TEST(largest < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(ranges_and_maps)
{
  const auto surface = test_support::sphere(1., 3, .1);
  Cloud reference = cloud_of(surface.points);
  run(reference, parameters());

  using Pair = std::pair<Point_3, Vector_3>;
  std::vector<Pair> pairs;
  for(const Oriented_point& p : reference)
    pairs.emplace_back(p.point, Vector_3(0, 0, 0));
  BOOST_TEST(SC::point_normals(pairs, CGAL::Second_of_pair_property_map<Pair>(),
                               SC::parameters::point_map(CGAL::First_of_pair_property_map<Pair>())) == 0u);
  CGAL::Point_set_3<Point_3> set;
  set.add_normal_map();
  for(const Oriented_point& p : reference)
    set.insert(p.point);
  BOOST_TEST(SC::point_normals(set, set.normal_map()) == 0u);
  std::vector<Point_3> points;
  for(const Oriented_point& p : reference)
    points.push_back(p.point);
  std::map<Point_3, Vector_3> by_point;
  const std::vector<Point_3>& constant = points;
  BOOST_TEST(SC::point_normals(constant, boost::make_assoc_property_map(by_point)) == 0u);
  auto in_set = set.begin();
  for(std::size_t i = 0; i < reference.size(); ++i, ++in_set)
  {
    BOOST_TEST(pairs[i].second == reference[i].normal);
    BOOST_TEST(set.normal(*in_set) == reference[i].normal);
    BOOST_TEST(by_point[points[i]] == reference[i].normal);
  }
}

BOOST_AUTO_TEST_CASE(too_few_points)
{
  using SC::Point_normal_method;
  Cloud none;
  BOOST_TEST(run(none, parameters()) == 0u);
  const std::vector<test_support::Vector> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, .1}, {.5, .5, 0}};
  for(std::size_t n = 1; n <= points.size(); ++n)
  {
    const std::vector<test_support::Vector> some(points.begin(), points.begin() + std::ptrdiff_t(n));
    Cloud cloud = cloud_of(some);
    BOOST_TEST(run(cloud, parameters()) == (n < 3 ? n : 0u));
    BOOST_TEST((cloud[0].status == (n < 3 ? Status::FEW_NEIGHBOURS : Status::ESTIMATED)));
    if(n == 3)
      BOOST_TEST(cloud[0].normal == Vector_3(0, 0, 1));
    BOOST_TEST(run(cloud, parameters().point_normal_method(Point_normal_method::JET)) == n);
    BOOST_TEST((cloud[0].status == Status::FEW_NEIGHBOURS));
  }
  // a point alone in its ball, and a number of neighbors that is none
  Cloud cloud = cloud_of(test_support::sphere(1., 3).points);
  cloud.push_back({Point_3(5, 0, 0)});
  BOOST_TEST(run(cloud, parameters().neighbor_radius(.5)) == 1u);
  BOOST_TEST((cloud.back().status == Status::FEW_NEIGHBOURS));
  BOOST_TEST(run(cloud, parameters().neighbor_radius(1e-3)) == cloud.size());
  BOOST_TEST(run(cloud, parameters().number_of_neighbors(1)) == cloud.size());
}

BOOST_AUTO_TEST_CASE(neighborhoods_that_determine_nothing)
{
  for(const auto method : {SC::Point_normal_method::PCA, SC::Point_normal_method::JET})
  {
    const auto np = parameters().point_normal_method(method);
    std::vector<test_support::Vector> line;
    for(int i = 0; i < 50; ++i)
      line.push_back({1. + .1 * i, 2. - .3 * i, .7 * i});
    Cloud collinear = cloud_of(line);
    BOOST_TEST(run(collinear, np) == collinear.size());
    for(const Oriented_point& p : collinear)
      BOOST_TEST((p.status == Status::DEGENERATE));

    Cloud identical = cloud_of(std::vector<test_support::Vector>(20, {1, 2, 3}));
    BOOST_TEST(run(identical, np) == identical.size());
    for(const Oriented_point& p : identical)
      BOOST_TEST((p.status == Status::FEW_NEIGHBOURS));
  }
  // the corners of a tetrahedron spread alike in all directions
  Cloud tetrahedron = cloud_of({{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}});
  BOOST_TEST(run(tetrahedron, parameters()) == 4u);
  BOOST_TEST((tetrahedron[0].status == Status::DEGENERATE));
}

// what is wrong with some points isn't noticed by others
BOOST_AUTO_TEST_CASE(duplicates_and_coordinates_that_are_no_numbers)
{
  const auto surface = test_support::torus(1., .4, 48, 24, .1);
  Cloud clean = cloud_of(surface.points);
  run(clean, parameters());
  Cloud dirty = clean;
  for(int copy = 0; copy < 40; ++copy)
    dirty.push_back({clean[100].point});
  dirty.push_back({Point_3(quiet_nan, 0, 0)});
  dirty.push_back({Point_3(0, std::numeric_limits<double>::infinity(), 0)});
  BOOST_TEST(run(dirty, parameters()) == 2u);
  std::size_t different = 0;
  for(std::size_t i = 0; i < clean.size(); ++i)
    different += dirty[i].normal != clean[i].normal;
  for(std::size_t i = clean.size(); i < clean.size() + 40; ++i)
    different += dirty[i].normal != clean[100].normal;
  BOOST_TEST(different == 0u);
  BOOST_TEST((dirty[clean.size() + 40].status == Status::NON_FINITE_INPUT));
  BOOST_TEST((dirty.back().status == Status::NON_FINITE_INPUT));
}

BOOST_AUTO_TEST_CASE(wrong_arguments_throw)
{
  Cloud cloud = cloud_of(test_support::sphere(1., 1).points);
  using test_support::says;
  BOOST_CHECK_EXCEPTION(run(cloud, parameters().number_of_neighbors(0)), std::invalid_argument,
                        says("number_of_neighbors"));
  for(double radius : {0., -1., quiet_nan})
    BOOST_CHECK_EXCEPTION(run(cloud, parameters().neighbor_radius(radius)), std::invalid_argument,
                          says("neighbor_radius"));
}

BOOST_AUTO_TEST_SUITE_END()
