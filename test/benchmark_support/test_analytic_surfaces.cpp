#include <boost/test/unit_test.hpp>

#include "analytic_surfaces.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>

// The surfaces that other tests take for the truth are checked against the equations of the surfaces, of which
// everything is derived here by finite differences.

BOOST_AUTO_TEST_SUITE(analytic_surfaces)

using namespace test_support;
using benchmark_support::cross;
using benchmark_support::dot;
using benchmark_support::length;
using benchmark_support::normalized;

namespace {

using Function = std::function<double(const Vector&)>;

// zero on the surface, growing outwards
const std::map<std::string, Function> equations = {
    {"sphere", [](const Vector& p) { return dot(p, p) - 4.; }},
    {"ellipsoid", [](const Vector& p) { return p[0] * p[0] + p[1] * p[1] / .64 + p[2] * p[2] / .36 - 1.; }},
    {"cylinder", [](const Vector& p) { return std::hypot(p[0], p[1]) - 1.; }},
    {"cone", [](const Vector& p) { return 1.5 * std::hypot(p[0], p[1]) + p[2]; }},
    {"torus", [](const Vector& p) { return std::hypot(std::hypot(p[0], p[1]) - 1., p[2]) - .4; }},
    {"plane", [](const Vector& p) { return p[2]; }},
    {"paraboloid", [](const Vector& p) { return p[2] - .5 * (p[0] * p[0] + .5 * p[1] * p[1]); }},
    {"saddle", [](const Vector& p) { return p[2] - .5 * (p[0] * p[0] - p[1] * p[1]); }},
    {"monkey saddle", [](const Vector& p) { return p[2] - p[0] * p[0] * p[0] + 3. * p[0] * p[1] * p[1]; }},
    {"waves", [](const Vector& p) { return p[2] - .1 * (std::sin(4. * p[0]) + std::cos(4. * p[1])); }}};

Vector numeric_normal(const Function& f, const Vector& p)
{
  const double h = 1e-5;
  Vector g;
  for(int i = 0; i < 3; ++i)
  {
    Vector lower = p, upper = p;
    lower[i] -= h;
    upper[i] += h;
    g[i] = f(upper) - f(lower);
  }
  return normalized(g);
}

void check(const Analytic_surface& s)
{
  BOOST_TEST_CONTEXT(s.name)
  {
    const Function& f = equations.at(s.name);
    BOOST_TEST_REQUIRE(s.points.size() == s.exact.size());
    for(std::size_t i = 0; i < s.points.size(); ++i)
    {
      const Exact_vertex& e = s.exact[i];
      BOOST_TEST(std::abs(f(s.points[i])) < 1e-12);
      BOOST_TEST(std::abs(length(e.normal) - 1.) < 1e-12);
      BOOST_TEST(std::abs(length(e.d_min) - 1.) < 1e-12);
      BOOST_TEST(std::abs(length(e.d_max) - 1.) < 1e-12);
      BOOST_TEST(std::abs(dot(e.d_min, e.normal)) < 1e-12);
      BOOST_TEST(std::abs(dot(e.d_max, e.normal)) < 1e-12);
      BOOST_TEST(std::abs(dot(e.d_max, e.d_min)) < 1e-12);
      if(e.singular)
        continue;
      BOOST_TEST(length(numeric_normal(f, s.points[i]) - e.normal) < 1e-8);
      BOOST_TEST(e.k_min <= e.k_max);

      // Rodrigues: along a principal direction the normal turns by k d
      const double h = 1e-4;
      for(const auto& [k, d] : {std::make_pair(e.k_min, e.d_min), std::make_pair(e.k_max, e.d_max)})
      {
        const Vector turn =
            (.5 / h) * (numeric_normal(f, s.points[i] + h * d) - numeric_normal(f, s.points[i] - h * d));
        BOOST_TEST(length(turn - k * d) < 2e-5 * (1. + std::abs(k) * std::abs(k) * std::abs(k)));
      }
    }
  }
}

// orientation, Euler characteristic and number of border edges from the triangles alone
void check_topology(const Analytic_surface& s, long euler, bool closed)
{
  BOOST_TEST_CONTEXT(s.name)
  {
    std::map<std::pair<std::size_t, std::size_t>, int> halfedges;
    for(const Triangle& t : s.triangles)
    {
      for(int i = 0; i < 3; ++i)
        BOOST_TEST((++halfedges[{t[i], t[(i + 1) % 3]}]) == 1);
      const Vector n = cross(s.points[t[1]] - s.points[t[0]], s.points[t[2]] - s.points[t[0]]);
      for(std::size_t v : t)
        if(!s.exact[v].singular)
          BOOST_TEST(dot(normalized(n), s.exact[v].normal) > .5);
    }
    long edges = 0;
    std::vector<bool> border(s.points.size(), false);
    for(const auto& [e, count] : halfedges)
    {
      const bool is_border = halfedges.count({e.second, e.first}) == 0;
      if(is_border)
        border[e.first] = border[e.second] = true;
      if(is_border || e.first < e.second)
        ++edges;
    }
    BOOST_TEST(long(s.points.size()) - edges + long(s.triangles.size()) == euler);
    bool any = false;
    for(std::size_t i = 0; i < border.size(); ++i)
    {
      BOOST_TEST(border[i] == s.exact[i].border);
      any = any || border[i];
    }
    BOOST_TEST(any == !closed);
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(truth_agrees_with_the_equations)
{
  for(double jitter : {0., .2})
    for(const Analytic_surface& s : all_analytic_surfaces(jitter))
      check(s);
}

BOOST_AUTO_TEST_CASE(known_curvatures)
{
  for(const Exact_vertex& e : sphere(2.).exact)
  {
    BOOST_TEST(e.k_min == .5);
    BOOST_TEST(e.k_max == .5);
    BOOST_TEST(e.umbilic);
  }
  for(const Exact_vertex& e : plane().exact)
    BOOST_TEST((e.k_min == 0. && e.k_max == 0. && e.umbilic));
  const Analytic_surface s = saddle();
  for(std::size_t i = 0; i < s.points.size(); ++i)
    if(s.points[i][0] == 0. && s.points[i][1] == 0.)
    {
      BOOST_TEST(s.exact[i].k_min == -1.);
      BOOST_TEST(s.exact[i].k_max == 1.);
      BOOST_TEST(std::abs(s.exact[i].d_min[0]) == 1.);
    }
}

BOOST_AUTO_TEST_CASE(meshes_are_oriented_outwards)
{
  for(double jitter : {0., .2})
  {
    const std::vector<Analytic_surface> all = all_analytic_surfaces(jitter, 7);
    const long euler[] = {2, 2, 0, 1, 0, 1, 1, 1, 1, 1};
    for(std::size_t i = 0; i < all.size(); ++i)
      check_topology(all[i], euler[i], i == 0 || i == 1 || i == 4);
  }
}

BOOST_AUTO_TEST_CASE(jitter_moves_vertices_and_depends_on_the_seed_alone)
{
  const Analytic_surface regular = torus(), a = torus(1., .4, 48, 24, .2, 5),
                         b = torus(1., .4, 48, 24, .2, 5), c = torus(1., .4, 48, 24, .2, 6);
  BOOST_TEST((a.points == b.points && a.triangles == b.triangles));
  BOOST_TEST((a.points != c.points));
  BOOST_TEST((a.points != regular.points));
  std::vector<int> valence(a.points.size(), 0);
  for(const Triangle& t : a.triangles)
    for(std::size_t v : t)
      ++valence[v];
  BOOST_TEST(*std::max_element(valence.begin(), valence.end()) > 6);
}

BOOST_AUTO_TEST_SUITE_END()
