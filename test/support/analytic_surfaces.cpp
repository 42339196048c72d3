#include "analytic_surfaces.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace test_support {

namespace {

// smaller differences of the principal curvatures than this share of them are an umbilic
constexpr double umbilic_tolerance = 1e-9;

Exact_vertex make_exact(const Exact_curvature& c)
{
  Exact_vertex e;
  static_cast<Exact_curvature&>(e) = c;
  const double size = std::max(std::abs(c.k_min), std::abs(c.k_max));
  e.umbilic = c.k_max - c.k_min <= umbilic_tolerance * size || size == 0.;
  return e;
}

// truth from a unit normal and the two curvatures with unit directions, in any order
Exact_vertex make_exact(const Vector& n, double k1, const Vector& d1, double k2, const Vector& d2)
{
  Exact_curvature c;
  c.normal = n;
  const bool ordered = k1 <= k2;
  c.k_min = ordered ? k1 : k2;
  c.k_max = ordered ? k2 : k1;
  c.d_min = ordered ? d1 : d2;
  c.d_max = ordered ? d2 : d1;
  return make_exact(c);
}

// a grid of parameters: nu x nv quadrilaterals, each direction closed (wraps around) or open. Vertex (i, j)
// has index i * columns + j and parameters (u, v) in units of the spacing.
struct Parameter_grid
{
  std::size_t rows, columns;
  std::vector<std::pair<double, double>> parameters;
  std::vector<bool> border;
  std::vector<Triangle> triangles;
};

Parameter_grid parameter_grid(std::size_t nu,
                              std::size_t nv,
                              bool closed_u,
                              bool closed_v,
                              double jitter,
                              std::uint64_t seed)
{
  Random random(seed);
  Parameter_grid g;
  g.rows = closed_u ? nu : nu + 1;
  g.columns = closed_v ? nv : nv + 1;
  for(std::size_t i = 0; i < g.rows; ++i)
    for(std::size_t j = 0; j < g.columns; ++j)
    {
      const bool end_u = !closed_u && (i == 0 || i == nu), end_v = !closed_v && (j == 0 || j == nv);
      // vertices of the border move along it only, corners not at all
      const double du = end_u ? 0. : jitter * random.uniform(-1., 1.);
      const double dv = end_v ? 0. : jitter * random.uniform(-1., 1.);
      g.parameters.emplace_back(double(i) + du, double(j) + dv);
      g.border.push_back(end_u || end_v);
    }
  for(std::size_t i = 0; i < nu; ++i)
    for(std::size_t j = 0; j < nv; ++j)
    {
      const std::size_t i1 = (i + 1) % g.rows, j1 = (j + 1) % g.columns;
      const std::size_t a = i * g.columns + j, b = i1 * g.columns + j, c = i1 * g.columns + j1,
                        d = i * g.columns + j1;
      if(jitter > 0. && random.uniform() < .5)
      {
        g.triangles.push_back({a, b, d});
        g.triangles.push_back({b, c, d});
      }
      else
      {
        g.triangles.push_back({a, b, c});
        g.triangles.push_back({a, c, d});
      }
    }
  return g;
}

void jitter_on_unit_sphere(std::vector<Vector>& points,
                           const std::vector<Triangle>& triangles,
                           double jitter,
                           std::uint64_t seed)
{
  if(jitter == 0.)
    return;
  Random random(seed);
  const double step = jitter * benchmark_support::length(points[triangles[0][0]] - points[triangles[0][1]]);
  for(Vector& p : points)
  {
    const auto [s, t] = benchmark_support::tangents(p);
    const double a = step * random.uniform(-1., 1.), b = step * random.uniform(-1., 1.);
    p = benchmark_support::normalized(p + a * s + b * t);
  }
}

// moves the points of the unit sphere to the ellipsoid with these half axes, and says its curvatures there
void stretch_to_ellipsoid(Analytic_surface& s, double a, double b, double c)
{
  const Symmetric_matrix hessian{Vector{2. / (a * a), 0, 0}, Vector{0, 2. / (b * b), 0},
                                 Vector{0, 0, 2. / (c * c)}};
  for(Vector& p : s.points)
  {
    p = {a * p[0], b * p[1], c * p[2]};
    s.exact.push_back(
        make_exact(benchmark_support::exact_curvature(benchmark_support::multiply(hessian, p), hessian)));
  }
}

} // namespace

double Analytic_surface::mean_edge_length() const
{
  double sum = 0.;
  for(const Triangle& t : triangles)
    for(int i = 0; i < 3; ++i)
      sum += benchmark_support::length(points[t[i]] - points[t[(i + 1) % 3]]);
  return sum / (3. * double(triangles.size()));
}

void icosphere(unsigned int subdivisions, std::vector<Vector>& points, std::vector<Triangle>& triangles)
{
  const double p = .5 * (1. + std::sqrt(5.));
  points = {{-1, p, 0},  {1, p, 0},  {-1, -p, 0}, {1, -p, 0}, {0, -1, p},  {0, 1, p},
            {0, -1, -p}, {0, 1, -p}, {p, 0, -1},  {p, 0, 1},  {-p, 0, -1}, {-p, 0, 1}};
  for(Vector& q : points)
    q = benchmark_support::normalized(q);
  triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
               {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
               {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for(unsigned int level = 0; level < subdivisions; ++level)
  {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
    const auto middle = [&](std::size_t a, std::size_t b)
    {
      const auto inserted = middles.insert({std::minmax(a, b), points.size()});
      if(inserted.second)
        points.push_back(benchmark_support::normalized(points[a] + points[b]));
      return inserted.first->second;
    };
    std::vector<Triangle> finer;
    for(const Triangle& t : triangles)
    {
      const std::size_t a = middle(t[0], t[1]), b = middle(t[1], t[2]), c = middle(t[2], t[0]);
      finer.insert(finer.end(), {{t[0], a, c}, {t[1], b, a}, {t[2], c, b}, {a, b, c}});
    }
    triangles.swap(finer);
  }
}

Analytic_surface sphere(double radius, unsigned int subdivisions, double jitter, std::uint64_t seed)
{
  Analytic_surface s;
  s.name = "sphere";
  icosphere(subdivisions, s.points, s.triangles);
  jitter_on_unit_sphere(s.points, s.triangles, jitter, seed);
  for(Vector& p : s.points)
  {
    const auto [d1, d2] = benchmark_support::tangents(p);
    s.exact.push_back(make_exact(p, 1. / radius, d1, 1. / radius, d2));
    p = radius * p;
  }
  return s;
}

Analytic_surface
ellipsoid(double a, double b, double c, unsigned int subdivisions, double jitter, std::uint64_t seed)
{
  Analytic_surface s;
  s.name = "ellipsoid";
  icosphere(subdivisions, s.points, s.triangles);
  jitter_on_unit_sphere(s.points, s.triangles, jitter, seed);
  stretch_to_ellipsoid(s, a, b, c);
  return s;
}

Analytic_surface ellipsoid_of_longitudes(double a, double b, double c, std::size_t longitudes)
{
  Analytic_surface s;
  s.name = "ellipsoid of longitudes";
  const std::size_t n = longitudes, rows = n / 2;
  for(std::size_t i = 1; i < rows; ++i)
    for(std::size_t j = 0; j < n; ++j)
    {
      const double polar_angle = CGAL_PI * double(i) / double(rows),
                   longitude = 2. * CGAL_PI * double(j) / double(n);
      s.points.push_back({std::sin(polar_angle) * std::cos(longitude),
                          std::sin(polar_angle) * std::sin(longitude), std::cos(polar_angle)});
    }
  const std::size_t top = s.points.size(), bottom = top + 1, last = (rows - 2) * n;
  s.points.push_back({0., 0., 1.});
  s.points.push_back({0., 0., -1.});
  for(std::size_t j = 0; j < n; ++j)
  {
    const std::size_t next = (j + 1) % n;
    s.triangles.push_back({top, j, next});
    s.triangles.push_back({bottom, last + next, last + j});
    for(std::size_t i = 0; i < last; i += n)
    {
      s.triangles.push_back({i + j, i + n + j, i + next});
      s.triangles.push_back({i + next, i + n + j, i + n + next});
    }
  }
  stretch_to_ellipsoid(s, a, b, c);
  return s;
}

Analytic_surface cylinder(double radius,
                          double height,
                          std::size_t around,
                          std::size_t along,
                          double jitter,
                          std::uint64_t seed)
{
  Analytic_surface s;
  s.name = "cylinder";
  const Parameter_grid g = parameter_grid(around, along, true, false, jitter, seed);
  s.triangles = g.triangles;
  for(std::size_t i = 0; i < g.parameters.size(); ++i)
  {
    const double angle = 2. * CGAL_PI * g.parameters[i].first / double(around);
    const Vector n{std::cos(angle), std::sin(angle), 0.};
    s.points.push_back({radius * n[0], radius * n[1], height * g.parameters[i].second / double(along)});
    s.exact.push_back(make_exact(n, 0., {0, 0, 1}, 1. / radius, {-n[1], n[0], 0}));
    s.exact.back().border = g.border[i];
  }
  return s;
}

Analytic_surface
cone(double radius, double height, std::size_t around, std::size_t along, double jitter, std::uint64_t seed)
{
  Analytic_surface s;
  s.name = "cone";
  const double slant = std::hypot(radius, height);
  // rows: circles from the border (v = 0) to the last circle below the apex (v = along - 1)
  const Parameter_grid g = parameter_grid(around, along - 1, true, false, jitter, seed);
  s.triangles = g.triangles;
  for(std::size_t i = 0; i < g.parameters.size(); ++i)
  {
    const double angle = 2. * CGAL_PI * g.parameters[i].first / double(around);
    const double share =
        1. - g.parameters[i].second / double(along); // of the way from the apex to the border
    const double c = std::cos(angle), d = std::sin(angle);
    const Vector n{height / slant * c, height / slant * d, radius / slant};
    const Vector along_line{radius / slant * c, radius / slant * d, -height / slant};
    s.points.push_back({share * radius * c, share * radius * d, -share * height});
    // Meusnier: the circle's curvature 1/rho, of which the normal sees the share of its radial component
    s.exact.push_back(make_exact(n, 0., along_line, height / slant / (share * radius), Vector{-d, c, 0.}));
    s.exact.back().border = g.parameters[i].second == 0.;
  }
  const std::size_t apex = s.points.size();
  s.points.push_back({0., 0., 0.});
  Exact_vertex e;
  e.normal = {0., 0., 1.};
  e.d_min = {1., 0., 0.};
  e.d_max = {0., 1., 0.};
  e.k_min = e.k_max = std::nan("");
  e.singular = true;
  s.exact.push_back(e);
  for(std::size_t i = 0; i < around; ++i)
    s.triangles.push_back({i * along + along - 1, (i + 1) % around * along + along - 1, apex});
  return s;
}

Analytic_surface torus(double ring,
                       double tube,
                       std::size_t around_ring,
                       std::size_t around_tube,
                       double jitter,
                       std::uint64_t seed)
{
  Analytic_surface s;
  s.name = "torus";
  const Parameter_grid g = parameter_grid(around_ring, around_tube, true, true, jitter, seed);
  s.triangles = g.triangles;
  for(const auto& [u, v] : g.parameters)
  {
    const double a = 2. * CGAL_PI * u / double(around_ring), b = 2. * CGAL_PI * v / double(around_tube);
    const double distance = ring + tube * std::cos(b);
    s.points.push_back({distance * std::cos(a), distance * std::sin(a), tube * std::sin(b)});
    s.exact.push_back(make_exact({std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b)},
                                 std::cos(b) / distance, {-std::sin(a), std::cos(a), 0.}, 1. / tube,
                                 {-std::sin(b) * std::cos(a), -std::sin(b) * std::sin(a), std::cos(b)}));
  }
  return s;
}

Analytic_surface graph(const std::string& name,
                       const std::function<double(double, double)>& value,
                       const std::function<std::array<double, 2>(double, double)>& gradient,
                       const std::function<std::array<double, 3>(double, double)>& hessian,
                       double half,
                       std::size_t n,
                       double jitter,
                       std::uint64_t seed)
{
  Analytic_surface s;
  s.name = name;
  const Parameter_grid g = parameter_grid(n, n, false, false, jitter, seed);
  s.triangles = g.triangles;
  for(std::size_t i = 0; i < g.parameters.size(); ++i)
  {
    const double x = half * (2. * g.parameters[i].first / double(n) - 1.);
    const double y = half * (2. * g.parameters[i].second / double(n) - 1.);
    s.points.push_back({x, y, value(x, y)});
    const std::array<double, 2> d = gradient(x, y);
    const std::array<double, 3> h = hessian(x, y);
    // the level set z - f(x, y) = 0
    s.exact.push_back(make_exact(benchmark_support::exact_curvature(
        {-d[0], -d[1], 1.}, {Vector{-h[0], -h[1], 0.}, Vector{-h[1], -h[2], 0.}, Vector{0., 0., 0.}})));
    s.exact.back().border = g.border[i];
  }
  return s;
}

Analytic_surface plane(double half, std::size_t n, double jitter, std::uint64_t seed)
{
  return graph(
      "plane", [](double, double) { return 0.; },
      [](double, double) {
        return std::array<double, 2>{0., 0.};
      },
      [](double, double) {
        return std::array<double, 3>{0., 0., 0.};
      },
      half, n, jitter, seed);
}

Analytic_surface paraboloid(double a, double b, double half, std::size_t n, double jitter, std::uint64_t seed)
{
  return graph(
      a * b < 0. ? "saddle" : "paraboloid",
      [a, b](double x, double y) { return .5 * (a * x * x + b * y * y); },
      [a, b](double x, double y) {
        return std::array<double, 2>{a * x, b * y};
      },
      [a, b](double, double) {
        return std::array<double, 3>{a, 0., b};
      },
      half, n, jitter, seed);
}

Analytic_surface saddle(double half, std::size_t n, double jitter, std::uint64_t seed)
{
  return paraboloid(1., -1., half, n, jitter, seed);
}

Analytic_surface monkey_saddle(double half, std::size_t n, double jitter, std::uint64_t seed)
{
  return graph(
      "monkey saddle", [](double x, double y) { return x * x * x - 3. * x * y * y; },
      [](double x, double y) {
        return std::array<double, 2>{3. * x * x - 3. * y * y, -6. * x * y};
      },
      [](double x, double y) {
        return std::array<double, 3>{6. * x, -6. * y, -6. * x};
      },
      half, n, jitter, seed);
}

Analytic_surface
waves(double height, double frequency, double half, std::size_t n, double jitter, std::uint64_t seed)
{
  const double h = height, w = frequency;
  return graph(
      "waves", [h, w](double x, double y) { return h * (std::sin(w * x) + std::cos(w * y)); },
      [h, w](double x, double y) {
        return std::array<double, 2>{h * w * std::cos(w * x), -h * w * std::sin(w * y)};
      },
      [h, w](double x, double y) {
        return std::array<double, 3>{-h * w * w * std::sin(w * x), 0., -h * w * w * std::cos(w * y)};
      },
      half, n, jitter, seed);
}

Analytic_surface with_noise(Analytic_surface s, double level)
{
  Random random(11);
  const double sigma = level * s.mean_edge_length();
  for(auto& p : s.points)
    for(std::size_t c = 0; c < 3; ++c)
      p[c] += sigma * random.gaussian();
  return s;
}

std::vector<Analytic_surface> all_analytic_surfaces(double jitter, std::uint64_t seed)
{
  return {sphere(2., 3, jitter, seed),
          ellipsoid(1., .8, .6, 3, jitter, seed),
          cylinder(1., 2., 40, 12, jitter, seed),
          cone(1., 1.5, 40, 16, jitter, seed),
          torus(1., .4, 48, 24, jitter, seed),
          plane(1., 24, jitter, seed),
          paraboloid(1., .5, 1., 24, jitter, seed),
          saddle(1., 24, jitter, seed),
          monkey_saddle(.5, 24, jitter, seed),
          waves(.1, 4., 1., 32, jitter, seed)};
}

} // namespace test_support
