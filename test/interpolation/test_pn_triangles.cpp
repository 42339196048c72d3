#include <boost/test/unit_test.hpp>

#include "raise_to.h"
#include "says.h"

#include <Shape_characteristics/curvature/parametric_surface_curvatures.h>
#include <Shape_characteristics/interpolation/Pn_triangle.h>
#include <Shape_characteristics/interpolation/Png1_triangle.h>

#include <CGAL/Simple_cartesian.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(pn_triangles)

namespace {

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Pn = SC::Pn_triangle<Kernel>;
using Png1 = SC::Png1_triangle<Kernel>;
using Derivatives = SC::Surface_derivatives<Kernel>;
using Barycentric = std::array<double, 3>;
using E3 = Eigen::Vector3d;

E3 eigen(const Vector& v)
{
  return {v.x(), v.y(), v.z()};
}
E3 eigen(const Point& p)
{
  return {p.x(), p.y(), p.z()};
}
E3 normal_of(const Derivatives& d)
{
  return eigen(d.u).cross(eigen(d.v)).normalized();
}

// four corners of two triangles at an edge: (0, 1, 2) and (2, 1, 3), with normals
struct Pair
{
  std::array<Point, 4> points;
  std::array<Vector, 4> normals;

  Png1 first() const
  {
    Png1 patch({points[0], points[1], points[2]}, {normals[0], normals[1], normals[2]});
    patch.set_neighbor(0, points[3], normals[3]);
    return patch;
  }
  Png1 second() const
  {
    Png1 patch({points[2], points[1], points[3]}, {normals[2], normals[1], normals[3]});
    patch.set_neighbor(2, points[0], normals[0]);
    return patch;
  }
  Pn plain_first() const
  {
    return Pn({points[0], points[1], points[2]}, {normals[0], normals[1], normals[2]});
  }
  Pn plain_second() const
  {
    return Pn({points[2], points[1], points[3]}, {normals[2], normals[1], normals[3]});
  }
};

Pair random_pair(unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> d(-.25, .25);
  Pair pair;
  const double plan[4][2] = {{-1., 0.}, {0., -.7}, {0., .7}, {.9, .1}};
  for(std::size_t i = 0; i < 4; ++i)
  {
    pair.points[i] = Point(plan[i][0] + d(random), plan[i][1] + d(random), d(random));
    const double length = 1. + 2. * std::abs(d(random));
    pair.normals[i] = length * Vector(d(random), d(random), 1.);
  }
  return pair;
}

// all barycentric coordinates with denominator n
std::vector<Barycentric> grid(int n)
{
  std::vector<Barycentric> result;
  for(int i = 0; i <= n; ++i)
    for(int j = 0; i + j <= n; ++j)
      result.push_back({double(i) / n, double(j) / n, double(n - i - j) / n});
  return result;
}

template <typename T>
using Three = Eigen::Matrix<T, 3, 1>;

// the surface of the classes, in any type of numbers
template <typename T>
SC::internal::Blended_triangle<T> blended(unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> d(-.25, .25);
  std::array<Three<T>, 6> p, n;
  const double plan[6][2] = {{-.9, -.5}, {.9, -.5}, {0., 1.}, {1.4, 1.1}, {-1.3, 1.}, {0., -1.6}};
  for(std::size_t i = 0; i < 6; ++i)
  {
    p[i] = Three<T>(T(plan[i][0] + d(random)), T(plan[i][1] + d(random)), T(d(random)));
    n[i] = Three<T>(T(d(random)), T(d(random)), T(1)).normalized();
  }
  using Cubic = SC::internal::Cubic_triangle<T>;
  SC::internal::Blended_triangle<T> patch(Cubic({p[0], p[1], p[2]}, {n[0], n[1], n[2]}));
  for(int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    patch.set_neighbor(i, Cubic({p[3 + i], p[k], p[j]}, {n[3 + i], n[k], n[j]}));
  }
  return patch;
}

// first and second derivatives by differences of points alone, of order h^4
template <typename Patch, typename T>
SC::internal::Patch_jet<T> differences(const Patch& patch, const std::array<T, 3>& c, T h)
{
  const auto at = [&](int i, int j) {
    return Three<T>(patch({c[0] - (i + j) * h, c[1] + i * h, c[2] + j * h}).point);
  };
  const auto first = [&](const auto& f)
  { return Three<T>((8 * (f(1) - f(-1)) - (f(2) - f(-2))) / (12 * h)); };
  const auto second = [&](const auto& f)
  { return Three<T>((16 * (f(1) + f(-1)) - (f(2) + f(-2)) - 30 * f(0)) / (12 * h * h)); };
  SC::internal::Patch_jet<T> jet;
  jet.point = at(0, 0);
  jet.u = first([&](int i) { return at(i, 0); });
  jet.v = first([&](int i) { return at(0, i); });
  jet.uu = second([&](int i) { return at(i, 0); });
  jet.vv = second([&](int i) { return at(0, i); });
  jet.uv = first([&](int i) { return first([&](int j) { return at(i, j); }); });
  return jet;
}

// a triangle of a sphere of radius 1, with edges of about the length h
struct Spherical
{
  std::array<Point, 6> points;
  std::array<Vector, 6> normals;

  explicit Spherical(double h)
  {
    const double plan[6][2] = {{-.5, -.3}, {.5, -.25}, {.05, .6}, {1.1, .7}, {-.9, .8}, {0., -1.2}};
    for(std::size_t i = 0; i < 6; ++i)
    {
      const E3 p = E3(h * plan[i][0], h * plan[i][1], 1.).normalized();
      points[i] = Point(p.x(), p.y(), p.z());
      normals[i] = Vector(p.x(), p.y(), p.z());
    }
  }
  Pn plain() const { return Pn({points[0], points[1], points[2]}, {normals[0], normals[1], normals[2]}); }
  Png1 blend() const
  {
    Png1 patch({points[0], points[1], points[2]}, {normals[0], normals[1], normals[2]});
    for(unsigned int i = 0; i < 3; ++i)
      patch.set_neighbor(i, points[3 + i], normals[3 + i]);
    return patch;
  }
};

bool same(const Derivatives& a, const Derivatives& b)
{
  return a.point == b.point && a.u == b.u && a.v == b.v && a.uu == b.uu && a.uv == b.uv && a.vv == b.vv;
}

} // namespace

// The formulas of the paper, with the thesis's sum of Bernstein polynomials (3.3)
BOOST_AUTO_TEST_CASE(control_points_of_the_paper)
{
  for(unsigned int seed = 0; seed < 20; ++seed)
  {
    const Pair pair = random_pair(seed);
    std::array<E3, 3> p, n;
    for(std::size_t i = 0; i < 3; ++i)
    {
      p[i] = eigen(pair.points[i]);
      n[i] = eigen(pair.normals[i]).normalized();
    }
    const auto w = [&](int i, int j) { return (p[j] - p[i]).dot(n[i]); };
    const auto b = [&](int i, int j) { return E3((2. * p[i] + p[j] - w(i, j) * n[i]) / 3.); };
    const E3 E = (b(0, 1) + b(0, 2) + b(1, 0) + b(1, 2) + b(2, 0) + b(2, 1)) / 6.,
             V = (p[0] + p[1] + p[2]) / 3.;
    const E3 b111 = E + (E - V) / 2.;
    const Pn patch = pair.plain_first();
    BOOST_TEST((eigen(patch.control_point(2, 1, 0)) - b(0, 1)).norm() < 1e-14);
    BOOST_TEST((eigen(patch.control_point(1, 0, 2)) - b(2, 0)).norm() < 1e-14);
    BOOST_TEST((eigen(patch.control_point(0, 3, 0)) - p[1]).norm() < 1e-14);
    BOOST_TEST((eigen(patch.control_point(1, 1, 1)) - b111).norm() < 1e-14);

    const double factorial[4] = {1., 1., 2., 6.};
    for(const Barycentric& c : grid(5))
    {
      E3 x = E3::Zero();
      for(unsigned int i = 0; i < 4; ++i)
        for(unsigned int j = 0; i + j < 4; ++j)
        {
          const unsigned int k = 3 - i - j;
          x += 6. / (factorial[i] * factorial[j] * factorial[k]) * std::pow(c[0], i) * std::pow(c[1], j) *
               std::pow(c[2], k) * eigen(patch.control_point(i, j, k));
        }
      BOOST_TEST((eigen(patch.point(c)) - x).norm() < 1e-14);
      BOOST_TEST((patch.point(c) == patch.derivatives(c).point));
    }
  }
}

// corners and their tangent planes are met; the normals for shading are those of the paper
BOOST_AUTO_TEST_CASE(corners_and_normals)
{
  for(unsigned int seed = 0; seed < 20; ++seed)
  {
    const Pair pair = random_pair(seed);
    const Pn patch = pair.plain_first();
    const Png1 blend = pair.first();
    for(std::size_t i = 0; i < 3; ++i)
    {
      Barycentric c = {0., 0., 0.};
      c[i] = 1.;
      const E3 n = eigen(pair.normals[i]).normalized();
      BOOST_TEST((eigen(patch.point(c)) - eigen(pair.points[i])).norm() < 1e-14);
      BOOST_TEST((eigen(blend.point(c)) - eigen(pair.points[i])).norm() < 1e-14);
      BOOST_TEST((normal_of(patch.derivatives(c)) - n).norm() < 1e-13);
      BOOST_TEST((normal_of(blend.derivatives(c)) - n).norm() < 1e-13);
      BOOST_TEST((eigen(patch.normal(c)) - n).norm() < 1e-14);
      const Derivatives at_corner = blend.derivatives(c);
      BOOST_TEST(
          (eigen(at_corner.uu).hasNaN() && eigen(at_corner.uv).hasNaN() && eigen(at_corner.vv).hasNaN()));
      BOOST_TEST((eigen(patch.derivatives(c).uv).allFinite()));

      // in the middle of an edge: the sum of three unit vectors, one of them mirrored
      const std::size_t j = (i + 1) % 3;
      Barycentric middle = {0., 0., 0.};
      middle[i] = middle[j] = .5;
      const E3 m = eigen(pair.normals[j]).normalized(),
               e = eigen(pair.points[j] - pair.points[i]).normalized();
      const E3 mirrored = (n + m - 2. * e * e.dot(n + m)).normalized();
      BOOST_TEST((eigen(patch.normal(middle)) - (n + m + mirrored).normalized()).norm() < 1e-14);
    }
  }
}

BOOST_AUTO_TEST_CASE(derivatives_are_those_of_the_points)
{
  using Real = long double;
  const Real h = 1e-3L;
  double largest_first = 0., largest_second = 0.;
  for(unsigned int seed = 0; seed < 10; ++seed)
  {
    const auto patch = blended<Real>(seed);
    for(const Barycentric& b : grid(6))
    {
      if(*std::min_element(b.begin(), b.end()) < .1)
        continue;
      const std::array<Real, 3> c = {1 - Real(b[1]) - Real(b[2]), Real(b[1]), Real(b[2])};
      const auto check = [&](const auto& surface)
      {
        const auto exact = surface(c), estimated = differences(surface, c, h);
        test_support::raise_to(largest_first, double((exact.u - estimated.u).norm()),
                               double((exact.v - estimated.v).norm()));
        test_support::raise_to(largest_second, double((exact.uu - estimated.uu).norm()),
                               double((exact.uv - estimated.uv).norm()),
                               double((exact.vv - estimated.vv).norm()));
      };
      check(patch.triangle());
      check(patch);
    }
  }
  BOOST_TEST_MESSAGE("  difference from finite differences: first " << largest_first << ", second "
                                                                    << largest_second);
  BOOST_TEST(largest_first < 1e-9);
  BOOST_TEST(largest_second < 1e-8);
}

// one-sided limits on edges, where the points have no derivatives in all directions to compare with
BOOST_AUTO_TEST_CASE(derivatives_on_edges_are_limits)
{
  for(unsigned int seed = 0; seed < 10; ++seed)
  {
    const auto patch = blended<long double>(seed);
    for(int edge = 0; edge < 3; ++edge)
      for(const long double t : {.1L, .37L, .5L, .9L})
      {
        std::array<long double, 3> on, near;
        const long double step = 1e-9L;
        on[edge] = 0;
        on[(edge + 1) % 3] = 1 - t;
        on[(edge + 2) % 3] = t;
        near = on;
        near[edge] += step;
        near[(edge + 1) % 3] -= step;
        const auto a = patch(on), b = patch(near);
        long double largest = 0.;
        test_support::raise_to(largest, (a.point - b.point).norm(), (a.u - b.u).norm(), (a.v - b.v).norm(),
                               (a.uu - b.uu).norm(), (a.uv - b.uv).norm(), (a.vv - b.vv).norm());
        BOOST_TEST(double(largest) < 1e-6);
      }
  }
}

BOOST_AUTO_TEST_CASE(single_and_double_precision_agree)
{
  for(unsigned int seed = 0; seed < 10; ++seed)
  {
    const auto a = blended<double>(seed);
    const auto b = blended<long double>(seed);
    for(const Barycentric& c : grid(7))
    {
      if(std::count(c.begin(), c.end(), 0.) == 2)
        continue;
      const auto x = a(c);
      const auto y = b({(long double)(c[0]), (long double)(c[1]), (long double)(c[2])});
      for(const auto& [p, q] : {std::pair(x.point, y.point), std::pair(x.u, y.u), std::pair(x.uu, y.uu),
                                std::pair(x.uv, y.uv), std::pair(x.vv, y.vv)})
        BOOST_TEST((p - q.template cast<double>()).norm() < 1e-11);
    }
  }
}

// The blend has one tangent plane on both sides of an edge, and one curve. PN triangles have the curve alone.
BOOST_AUTO_TEST_CASE(tangent_planes_across_edges)
{
  double plain = 0., blend = 0., gap = 0.;
  for(unsigned int seed = 0; seed < 50; ++seed)
  {
    const Pair pair = random_pair(seed);
    const Png1 a = pair.first(), b = pair.second();
    const Pn plain_a = pair.plain_first(), plain_b = pair.plain_second();
    for(int k = 0; k <= 32; ++k)
    {
      const double t = k / 32.;
      const Barycentric in_a = {0., 1. - t, t}, in_b = {t, 1. - t, 0.};
      test_support::raise_to(gap, (eigen(a.point(in_a)) - eigen(b.point(in_b))).norm());
      const E3 n = normal_of(a.derivatives(in_a)), m = normal_of(b.derivatives(in_b));
      test_support::raise_to(blend, (n - m).norm());
      const E3 p = normal_of(plain_a.derivatives(in_a)), q = normal_of(plain_b.derivatives(in_b));
      test_support::raise_to(plain, (p - q).norm());
      // it is between those of the PN triangles
      BOOST_TEST(n.dot(p + q) > .999 * (p + q).norm());
    }
  }
  BOOST_TEST_MESSAGE("  largest difference of normals: PN " << plain << ", PNG1 " << blend);
  BOOST_TEST(gap < 1e-14);
  BOOST_TEST(blend < 1e-12);
  BOOST_TEST(plain > .1);
}

// The other two edges are those of the PN triangle, with its tangent planes: an edge's blend ends before them.
BOOST_AUTO_TEST_CASE(without_a_neighbor_it_is_a_pn_triangle)
{
  for(unsigned int seed = 0; seed < 10; ++seed)
  {
    const Pair pair = random_pair(seed);
    const Pn plain = pair.plain_first();
    const Png1 alone({pair.points[0], pair.points[1], pair.points[2]},
                     {pair.normals[0], pair.normals[1], pair.normals[2]});
    for(const Barycentric& c : grid(6))
      BOOST_TEST(same(alone.derivatives(c), plain.derivatives(c)));
    const Png1 one = pair.first();
    for(const double t : {.2, .5, .7})
      for(const Barycentric& c : {Barycentric{t, 0., 1. - t}, Barycentric{t, 1. - t, 0.}})
      {
        const Derivatives a = one.derivatives(c), b = plain.derivatives(c);
        BOOST_TEST((eigen(a.point) - eigen(b.point)).norm() < 1e-15);
        BOOST_TEST((normal_of(a) - normal_of(b)).norm() < 1e-14);
      }
  }
}

// Toward a corner, the second derivatives have limits, which depend on the direction.
BOOST_AUTO_TEST_CASE(second_derivatives_near_a_corner)
{
  const auto patch = blended<long double>(3);
  const auto along = [&](long double s, long double r) { return patch({1 - r, r * s, r * (1 - s)}); };
  double variation = 0., distance = 0.;
  const auto reference = along(.5L, 1e-9L);
  for(const long double s : {.05L, .3L, .5L, .8L, .95L})
  {
    const auto near = along(s, 1e-6L), nearer = along(s, 1e-9L);
    test_support::raise_to(distance, double((near.uu - nearer.uu).norm()),
                           double((near.uv - nearer.uv).norm()), double((near.vv - nearer.vv).norm()));
    test_support::raise_to(variation, double((nearer.uv - reference.uv).norm()));
    const auto plain = patch.triangle()({1, 0, 0});
    BOOST_TEST(double((nearer.u - plain.u).norm() + (nearer.v - plain.v).norm()) < 1e-6);
  }
  BOOST_TEST(distance < 1e-3);
  BOOST_TEST(variation > 1e-2);
}

// To a sphere the distance falls with the fourth power of the edges, and the curvature in the middle with the second.
BOOST_AUTO_TEST_CASE(convergence_on_a_sphere)
{
  const auto largest_errors = [](const auto& patch)
  {
    double of_points = 0., of_curvatures = 0.;
    for(const Barycentric& c : grid(8))
    {
      test_support::raise_to(of_points, std::abs(eigen(patch.point(c)).norm() - 1.));
      if(*std::min_element(c.begin(), c.end()) < .2)
        continue;
      const Derivatives d = patch.derivatives(c);
      const auto k = SC::parametric_surface_curvatures(d.u, d.v, d.uu, d.uv, d.vv);
      test_support::raise_to(of_curvatures, std::abs(k.min_curvature - 1.), std::abs(k.max_curvature - 1.));
    }
    return std::pair(of_points, of_curvatures);
  };
  const auto check = [&](const char* name, const auto& coarse, const auto& fine)
  {
    const auto [p, k] = largest_errors(coarse);
    const auto [q, l] = largest_errors(fine);
    BOOST_TEST_MESSAGE("  " << name << ": distance " << p << " -> " << q << ", curvature " << k << " -> "
                            << l);
    BOOST_TEST(std::log2(p / q) / 2. > 3.8);
    BOOST_TEST(std::log2(k / l) / 2. > 1.8);
  };
  const Spherical coarse(.4), fine(.1);
  check("PN", coarse.plain(), fine.plain());
  check("PNG1", coarse.blend(), fine.blend());
}

BOOST_AUTO_TEST_CASE(planes_are_flat)
{
  std::array<Point, 3> points = {Point(0, 0, 2), Point(1, .2, 2), Point(.1, .8, 2)};
  const std::array<Vector, 3> normals = {Vector(0, 0, 5), Vector(0, 0, .1), Vector(0, 0, 1)};
  Png1 patch(points, normals);
  patch.set_neighbor(0, Point(2, 2, 2), Vector(0, 0, 1));
  patch.set_neighbor(1, Point(-1, 0, 2), Vector(0, 0, 1));
  for(const Barycentric& c : grid(6))
  {
    BOOST_TEST(patch.point(c).z() == 2.);
    const E3 affine = c[0] * eigen(points[0]) + c[1] * eigen(points[1]) + c[2] * eigen(points[2]);
    BOOST_TEST((eigen(patch.point(c)) - affine).norm() < 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(flip_scale_and_position)
{
  const Pair pair = random_pair(7);
  Pair flipped = pair, scaled = pair, moved = pair;
  for(std::size_t i = 0; i < 4; ++i)
    flipped.normals[i] = -flipped.normals[i];
  for(const Barycentric& c : grid(4))
  {
    const Derivatives d = pair.first().derivatives(c);
    if(std::count(c.begin(), c.end(), 0.) == 2)
      continue;
    BOOST_TEST(same(d, flipped.first().derivatives(c)));
    for(const double s : {std::ldexp(1., -900), 1e-6, 1e6, 1e100, std::ldexp(1., 1000)})
    {
      for(std::size_t i = 0; i < 4; ++i)
        scaled.points[i] = CGAL::ORIGIN + s * (pair.points[i] - CGAL::ORIGIN);
      const Derivatives e = scaled.first().derivatives(c);
      BOOST_TEST((eigen(e.point) / s - eigen(d.point)).norm() < 1e-14);
      BOOST_TEST((eigen(e.uv) / s - eigen(d.uv)).norm() < 1e-13);
      BOOST_TEST((eigen(e.vv) / s - eigen(d.vv)).norm() < 1e-13);
    }
    for(std::size_t i = 0; i < 4; ++i)
      moved.points[i] = pair.points[i] + Vector(1e7, -2e7, 3e6);
    BOOST_TEST((eigen(moved.first().derivatives(c).uv) - eigen(d.uv)).norm() < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(bad_inputs)
{
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  const std::array<Point, 3> points = {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)};
  const std::array<Vector, 3> normals = {Vector(0, 0, 1), Vector(0, 0, 1), Vector(0, 0, 1)};
  using test_support::says;
  for(const double x : {nan, infinity})
  {
    auto p = points;
    p[1] = Point(0, x, 0);
    BOOST_CHECK_EXCEPTION(Pn(p, normals), std::invalid_argument, says("coordinate"));
    BOOST_CHECK_EXCEPTION(Png1(p, normals), std::invalid_argument, says("coordinate"));
    auto n = normals;
    n[2] = Vector(x, 0, 0);
    BOOST_CHECK_EXCEPTION(Pn(points, n), std::invalid_argument, says("normal"));
    BOOST_CHECK_EXCEPTION(Png1(points, n), std::invalid_argument, says("normal"));
  }
  auto n = normals;
  n[0] = Vector(0, 0, 0);
  BOOST_CHECK_EXCEPTION(Pn(points, n), std::invalid_argument, says("normal is zero"));
  auto p = points;
  p[1] = Point(1e308, 0, 0);
  p[0] = Point(-1e308, 0, 0);
  BOOST_CHECK_EXCEPTION(Pn(p, normals), std::invalid_argument, says("longer"));
  Png1 patch(points, normals);
  BOOST_CHECK_EXCEPTION(patch.set_neighbor(3, Point(1, 1, 0), normals[0]), std::invalid_argument,
                        says("edge"));
  BOOST_CHECK_EXCEPTION(patch.set_neighbor(1, Point(1, nan, 0), normals[0]), std::invalid_argument,
                        says("coordinate"));
  BOOST_CHECK_EXCEPTION(patch.set_neighbor(1, Point(1, 1, 0), Vector(0, 0, 0)), std::invalid_argument,
                        says("normal"));
  BOOST_CHECK_EXCEPTION(patch.set_neighbor(1, Point(1, 1e100, 0), normals[0]), std::invalid_argument,
                        says("too large"));

  // an edge without length has nothing to blend
  Png1 needle({points[0], points[1], points[1]}, normals);
  for(unsigned int k = 0; k < 3; ++k)
    needle.set_neighbor(k, Point(1, 1, 1), normals[0]);
  for(const std::array<double, 3>& c : {std::array<double, 3>{.2, .3, .5}, std::array<double, 3>{0., .5, .5},
                                        std::array<double, 3>{1., 0., 0.}})
    BOOST_TEST(eigen(needle.point(c)).allFinite());

  // corners at one point, or on a line, make patches that are points or curves
  const Pn point({points[0], points[0], points[0]}, normals);
  BOOST_TEST((point.point({.2, .3, .5}) == points[0]));
  const Pn curve({points[0], points[1], points[0]}, normals);
  BOOST_TEST(curve.point({.2, .3, .5}).y() == 0.);
  BOOST_TEST(eigen(curve.normal({.2, .3, .5})).z() == 1.);
  // opposite normals at the ends of an edge leave the one in the middle undetermined
  const Pn opposite(points, {Vector(0, 0, 1), Vector(0, 0, -1), Vector(0, 0, 1)});
  BOOST_TEST(eigen(opposite.normal({.5, .5, 0.})).hasNaN());
  BOOST_TEST(eigen(opposite.point({.5, .5, 0.})).allFinite());
}

BOOST_AUTO_TEST_SUITE_END()
