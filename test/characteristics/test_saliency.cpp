#include <boost/test/unit_test.hpp>

#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/characteristics/saliency.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include "analytic_surfaces.h"
#include "build_mesh.h"
#include "raise_to.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <stdexcept>
#include <tuple>
#include <vector>

BOOST_AUTO_TEST_SUITE(saliency)

namespace SC = Shape_characteristics;
namespace np = SC::parameters;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Curvatures = SC::Principal_curvatures_and_directions<Kernel>;
using Real = long double;
using S = SC::Estimation_status;

namespace {

const double quiet_nan = std::numeric_limits<double>::quiet_NaN();

Curvatures of_mean(double h)
{
  Curvatures result;
  result.min_curvature = h - .5;
  result.max_curvature = h + .5;
  return result;
}

struct Result
{
  std::size_t failures = 0;
  std::vector<double> values;
  std::vector<S> status;
};

bool same_bits(const Result& a, const Result& b)
{
  return a.failures == b.failures && a.status == b.status &&
         std::equal(a.values.begin(), a.values.end(), b.values.begin(), b.values.end(),
                    [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

double difference(const Result& a, const Result& b)
{
  BOOST_TEST((a.status == b.status));
  double largest = 0.;
  for(std::size_t i = 0; i < a.values.size(); ++i)
    if(SC::is_estimated(a.status[i]))
      test_support::raise_to(largest, std::abs(a.values[i] - b.values[i]));
  return largest;
}

void check(const Result& r)
{
  BOOST_TEST(r.failures == std::size_t(std::count_if(r.status.begin(), r.status.end(),
                                                     [](S s) { return !SC::is_estimated(s); })));
  for(std::size_t i = 0; i < r.values.size(); ++i)
    BOOST_TEST(
        (SC::is_estimated(r.status[i]) ? r.values[i] >= 0. && r.values[i] <= 5. : std::isnan(r.values[i])));
}

// a point set whose curvatures are given
struct Cloud
{
  std::vector<Point> points;
  std::vector<double> mean_curvatures;
};

template <typename Tag = CGAL::Parallel_if_available_tag, typename NamedParameters>
Result saliency(const Cloud& cloud, const NamedParameters& parameters)
{
  using Item = std::tuple<Point, Kernel::Vector_3, Curvatures, double, S>;
  std::vector<Item> items;
  for(std::size_t i = 0; i < cloud.points.size(); ++i)
    items.emplace_back(cloud.points[i], Kernel::Vector_3(0., 0., 1.), of_mean(cloud.mean_curvatures[i]), 0.,
                       S::ESTIMATED);
  Result r;
  r.failures = SC::saliency<Tag>(
      items, parameters.point_map(CGAL::Nth_of_tuple_property_map<0, Item>())
                 .normal_map(CGAL::Nth_of_tuple_property_map<1, Item>())
                 .principal_curvatures_and_directions_map(CGAL::Nth_of_tuple_property_map<2, Item>())
                 .saliency_map(CGAL::Nth_of_tuple_property_map<3, Item>())
                 .status_map(CGAL::Nth_of_tuple_property_map<4, Item>()));
  for(const Item& item : items)
  {
    r.values.push_back(std::get<3>(item));
    r.status.push_back(std::get<4>(item));
  }
  return r;
}

Cloud random_cloud(std::size_t count, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  Cloud cloud;
  for(std::size_t i = 0; i < count; ++i)
  {
    const double x = uniform(random), y = uniform(random);
    cloud.points.emplace_back(x, y, .3 * x * y);
    cloud.mean_curvatures.push_back(3. * std::exp(-8. * (x * x + y * y)) + .3 * uniform(random));
  }
  return cloud;
}

Real distance(const Point& p, const Point& q)
{
  return std::sqrt(Real(CGAL::squared_distance(p, q)));
}

// by the words of the paper; `ignored`: a sample that has no saliency
std::vector<Real>
plain_saliency(const Cloud& cloud, Real scale, std::size_t ignored = std::numeric_limits<std::size_t>::max())
{
  const std::size_t n = cloud.points.size();
  std::vector<Real> result(n, 0);
  const auto average = [&](std::size_t i, Real sigma)
  {
    Real sum = 0, weight = 0;
    for(std::size_t j = 0; j < n; ++j)
      if(const Real d = distance(cloud.points[i], cloud.points[j]); d <= 2 * sigma)
      {
        const Real w = std::exp(-d * d / (2 * sigma * sigma));
        sum += w * Real(cloud.mean_curvatures[j]);
        weight += w;
      }
    return sum / weight;
  };
  for(int k = 2; k <= 6; ++k)
  {
    std::vector<Real> s(n);
    for(std::size_t i = 0; i < n; ++i)
      s[i] = i == ignored ? 0 : std::abs(average(i, k * scale) - average(i, 2 * k * scale));
    const Real largest = *std::max_element(s.begin(), s.end());
    for(Real& x : s)
      x /= largest;
    Real sum = 0;
    std::size_t others = 0;
    for(std::size_t i = 0; i < n; ++i)
    {
      bool is_maximum = s[i] > 0 && s[i] < 1;
      for(std::size_t j = 0; is_maximum && j < n; ++j)
        is_maximum = s[j] <= (1 + 1e-9L) * s[i] || distance(cloud.points[i], cloud.points[j]) > 2 * k * scale;
      if(is_maximum)
      {
        sum += s[i];
        ++others;
      }
    }
    const Real mean = others > 0 ? sum / Real(others) : 0;
    for(std::size_t i = 0; i < n; ++i)
      result[i] += (1 - mean) * (1 - mean) * s[i];
  }
  return result;
}

template <typename MeshType, typename NamedParameters>
Result of_mesh(const MeshType& mesh, const NamedParameters& parameters)
{
  auto values = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
  auto status = get(CGAL::dynamic_vertex_property_t<S>(), mesh);
  Result r;
  r.failures = SC::saliency(mesh, parameters.vertex_saliency_map(values).vertex_status_map(status));
  for(const auto v : vertices(mesh))
  {
    r.values.push_back(get(values, v));
    r.status.push_back(get(status, v));
  }
  return r;
}

} // namespace

BOOST_AUTO_TEST_CASE(agrees_with_plain_loops)
{
  for(const double scale : {.01, .03, .1})
  {
    const Cloud cloud = random_cloud(600, 3);
    const Result r = saliency(cloud, np::saliency_scale(scale));
    check(r);
    const std::vector<Real> expected = plain_saliency(cloud, scale);
    double worst = 0.;
    for(std::size_t i = 0; i < 600; ++i)
      if(SC::is_estimated(r.status[i]))
        test_support::raise_to(worst, double(std::abs(Real(r.values[i]) - expected[i])));
    BOOST_TEST(worst < 1e-12);
    BOOST_TEST(r.failures < 10u);
  }
}

BOOST_AUTO_TEST_CASE(moved_scaled_flipped_permuted_and_in_parallel)
{
  const Cloud cloud = random_cloud(600, 4);
  const Result r = saliency(cloud, np::callback([](double) { return true; }));
  check(r);
  BOOST_TEST(r.failures == 0u); // the scale is chosen by the distance of neighbors
  BOOST_TEST(same_bits(saliency<CGAL::Sequential_tag>(cloud, np::callback([](double) { return true; })), r));
  for(const double scale : {1e-6, -1e6}) // turned inside out, too
  {
    Cloud other = cloud;
    for(Point& p : other.points)
      p = Point(scale * p.z() + scale, scale * p.x() - scale, scale * p.y());
    for(double& h : other.mean_curvatures)
      h /= scale;
    BOOST_TEST(difference(saliency(other, np::callback([](double) { return true; })), r) < 1e-9);
  }
  Cloud reversed = cloud;
  std::reverse(reversed.points.begin(), reversed.points.end());
  std::reverse(reversed.mean_curvatures.begin(), reversed.mean_curvatures.end());
  Result of_reversed = saliency(reversed, np::callback([](double) { return true; }));
  std::reverse(of_reversed.values.begin(), of_reversed.values.end());
  BOOST_TEST(same_bits(of_reversed, r));
}

// a bump on a torus stands out, with curvatures that are estimated; a sphere has nothing that does
BOOST_AUTO_TEST_CASE(bump)
{
  test_support::Analytic_surface torus = test_support::torus(1., .4, 96, 48);
  Mesh mesh = test_support::build_mesh<Mesh>(torus);
  const Point center(1.4, 0., 0.);
  for(const auto v : mesh.vertices())
  {
    const double d = std::sqrt(CGAL::squared_distance(mesh.point(v), center));
    mesh.point(v) = mesh.point(v) + .06 * std::exp(-d * d / .01) * Kernel::Vector_3(1., 0., 0.);
  }
  const Result r = of_mesh(mesh, np::saliency_scale(.02));
  check(r);
  BOOST_TEST(r.failures == 0u);
  double inside = 0., outside = 0.;
  for(const auto v : mesh.vertices())
  {
    const double d = std::sqrt(CGAL::squared_distance(mesh.point(v), center));
    double& largest = d < .1 ? inside : outside;
    if(d < .1 || d > .4)
      test_support::raise_to(largest, r.values[v]);
  }
  BOOST_TEST(inside > 2.);
  BOOST_TEST(outside < .2 * inside);

  const test_support::Analytic_surface ball = test_support::sphere(2.);
  const Mesh sphere = test_support::build_mesh<Mesh>(ball);
  auto curvatures = get(CGAL::dynamic_vertex_property_t<Curvatures>(), sphere);
  for(const auto v : sphere.vertices())
    put(curvatures, v, of_mean(.5 * (1. + 1e-15 * double(v % 3))));
  const Result of_sphere = of_mesh(sphere, np::vertex_principal_curvatures_and_directions_map(curvatures));
  BOOST_TEST(of_sphere.failures == 0u);
  BOOST_TEST(*std::max_element(of_sphere.values.begin(), of_sphere.values.end()) == 0.);
}

BOOST_AUTO_TEST_CASE(surface_mesh_and_polyhedron)
{
  const test_support::Analytic_surface torus = test_support::torus(1., .4, 48, 24, .2, 6);
  const auto parameters = np::saliency_scale(.05);
  const Result r = of_mesh(test_support::build_mesh<Mesh>(torus), parameters);
  check(r);
  BOOST_TEST(r.failures == 0u);
  BOOST_TEST(*std::max_element(r.values.begin(), r.values.end()) > .01);
  BOOST_TEST(same_bits(of_mesh(test_support::build_mesh<CGAL::Polyhedron_3<Kernel> >(torus), parameters), r));
}

// where much is equal but for rounding
BOOST_AUTO_TEST_CASE(regular_torus_of_other_sizes)
{
  test_support::Analytic_surface torus = test_support::torus(1., .4, 48, 24);
  const Result r = of_mesh(test_support::build_mesh<Mesh>(torus), np::saliency_scale(.05));
  BOOST_TEST(*std::max_element(r.values.begin(), r.values.end()) > .01);
  double largest_change = 0.;
  for(const double scale : {1e-6, 3e5})
  {
    test_support::Analytic_surface scaled = torus;
    for(auto& p : scaled.points)
      for(std::size_t k = 0; k < 3; ++k)
        p[k] *= scale;
    test_support::raise_to(
        largest_change,
        difference(of_mesh(test_support::build_mesh<Mesh>(scaled), np::saliency_scale(.05 * scale)), r));
  }
  BOOST_TEST(largest_change < 1e-9);
}

BOOST_AUTO_TEST_CASE(bad_input)
{
  BOOST_TEST(saliency(Cloud(), np::saliency_scale(1.)).failures == 0u);
  Mesh mesh;
  BOOST_TEST(of_mesh(mesh, np::saliency_scale(1.)).failures == 0u);
  for(int i = 0; i < 3; ++i)
  {
    mesh.add_vertex(Point(1., 1., 1.)); // without a face
    Result r = of_mesh(mesh, np::callback([](double) { return true; }));
    check(r);
    BOOST_TEST(r.failures == std::size_t(i + 1));
    BOOST_TEST((r.status[0] == S::UNREFERENCED));
    Cloud at_one_place;
    at_one_place.points.assign(std::size_t(i) + 1, Point(1., 1., 1.));
    at_one_place.mean_curvatures.assign(std::size_t(i) + 1, 1.);
    r = saliency(at_one_place, np::callback([](double) { return true; }));
    check(r);
    BOOST_TEST(std::count(r.status.begin(), r.status.end(), S::FEW_NEIGHBOURS) == i + 1);
  }

  for(const double unit : {1e-200, 1e-155, 1e155, 1e200}) // whose square is no number any more
  {
    Mesh large;
    CGAL::make_icosahedron(large, Point(0., 0., 0.), unit);
    BOOST_CHECK_NO_THROW(of_mesh(large, np::callback([](double) { return true; })));
  }

  Cloud cloud = random_cloud(300, 5);
  const auto parameters = np::saliency_scale(.03);
  const Result good = saliency(cloud, parameters);
  cloud.points.emplace_back(0., 0., 0.);
  cloud.mean_curvatures.push_back(quiet_nan); // nobody's neighbor
  cloud.points.emplace_back(quiet_nan, 0., 0.);
  cloud.mean_curvatures.push_back(100.);
  cloud.points.emplace_back(50., 0., 0.);
  cloud.mean_curvatures.push_back(100.);
  Result r = saliency(cloud, parameters);
  check(r);
  BOOST_TEST((r.status[300] == S::DEGENERATE));
  BOOST_TEST((r.status[301] == S::NON_FINITE_INPUT));
  BOOST_TEST((r.status[302] == S::FEW_NEIGHBOURS));
  r.values.resize(300);
  r.status.resize(300);
  BOOST_TEST(difference(good, r) == 0.);

  cloud = random_cloud(300, 5);
  cloud.mean_curvatures[7] = std::numeric_limits<double>::max(); // minus that of a neighbor, it is infinite
  for(std::size_t i = 0; i < 300; ++i)
    if(i != 7)
      cloud.mean_curvatures[i] *= -1e308;
  r = saliency(cloud, parameters);
  check(r);
  BOOST_TEST((r.status[7] == S::DEGENERATE));

  // The sums of one scale alone overflow, at the origin, whose differences would be the largest ones of the others.
  cloud = Cloud();
  cloud.points = {Point(0., 0., 0.), Point(-3., 1., 0.), Point(-3., -2., 0.)};
  cloud.mean_curvatures = {1e306, 0., 0.};
  for(int i = 0; i < 12; ++i)
  {
    cloud.points.emplace_back(22., .1 * i, 0.); // within the last scale
    cloud.mean_curvatures.push_back(1.7e308);
  }
  r = saliency(cloud, np::saliency_scale(1.));
  check(r);
  BOOST_TEST(r.failures == 1u);
  BOOST_TEST((r.status[0] == S::DEGENERATE));
  const std::vector<Real> expected = plain_saliency(cloud, 1, 0);
  for(std::size_t i = 1; i < cloud.points.size(); ++i)
    BOOST_TEST(std::abs(r.values[i] - double(expected[i])) < 1e-9);

  for(const double scale : {0., -1., quiet_nan, std::numeric_limits<double>::infinity(), 1e308})
    BOOST_CHECK_THROW(saliency(cloud, np::saliency_scale(scale)), std::invalid_argument);
  for(int calls = 0; calls < 4; ++calls)
  {
    int left = calls;
    r = saliency<CGAL::Sequential_tag>(random_cloud(300, 5),
                                       parameters.callback([&](double) { return left-- > 0; }));
    check(r);
    BOOST_TEST(std::count(r.status.begin(), r.status.end(), S::CANCELLED) == 300);
  }
}

BOOST_AUTO_TEST_SUITE_END()
