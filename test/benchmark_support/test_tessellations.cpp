#include <boost/test/unit_test.hpp>

#include "dual_contouring.h"
#include "raise_to.h"
#include "tessellations.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(tessellations)

using namespace benchmark_support;

namespace {

// What the triangles alone say. `manifold`: every halfedge once, every vertex with one fan.
struct Topology
{
  bool manifold = true;
  bool degenerate = false;
  long euler = 0;
  std::size_t border_edges = 0;
  std::size_t unreferenced = 0;
};

Topology topology(const Triangle_arrays& mesh)
{
  Topology result;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> halfedges;
  std::vector<std::vector<std::pair<std::size_t, std::size_t>>> links(mesh.points.size()); // opposite edges
  for(const Triangle& t : mesh.triangles)
    for(int i = 0; i < 3; ++i)
    {
      const std::size_t a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
      result.degenerate = result.degenerate || a == b;
      result.manifold = result.manifold && ++halfedges[{a, b}] == 1;
      links[a].emplace_back(b, c);
    }
  long edges = 0;
  for(const auto& [e, count] : halfedges)
  {
    const bool border = halfedges.count({e.second, e.first}) == 0;
    result.border_edges += border;
    edges += border || e.first < e.second;
  }
  for(auto& link : links)
  {
    if(link.empty())
    {
      ++result.unreferenced;
      continue;
    }
    // a fan: starting from an edge without predecessor, or anywhere, all edges are reached
    std::map<std::size_t, std::size_t> next(link.begin(), link.end());
    std::set<std::size_t> targets;
    for(const auto& e : link)
      targets.insert(e.second);
    std::size_t at = link[0].first;
    for(const auto& e : link)
      if(targets.count(e.first) == 0)
        at = e.first;
    std::size_t steps = 0;
    while(next.count(at) != 0 && steps <= link.size())
    {
      const std::size_t to = next[at];
      next.erase(at);
      at = to;
      ++steps;
    }
    result.manifold = result.manifold && steps == link.size();
  }
  result.euler = long(mesh.points.size() - result.unreferenced) - edges + long(mesh.triangles.size());
  return result;
}

double volume(const Triangle_arrays& mesh)
{
  double sum = 0.;
  for(const Triangle& t : mesh.triangles)
    sum += dot(mesh.points[t[0]], cross(mesh.points[t[1]], mesh.points[t[2]])) / 6.;
  return sum;
}

} // namespace

BOOST_AUTO_TEST_CASE(marching_cubes_makes_a_sphere_and_a_torus)
{
  const auto sphere = [](const Vector& p) { return dot(p, p) - 1.; };
  const auto torus = [](const Vector& p)
  {
    const double d = std::hypot(p.x, p.y) - 1.;
    return d * d + p.z * p.z - .16;
  };
  for(Edge_crossing crossing : {Edge_crossing::LINEAR, Edge_crossing::EXACT})
  {
    const Triangle_arrays s = marching_cubes(sphere, {-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5}, 40, crossing);
    const Topology ts = topology(s);
    BOOST_TEST((ts.manifold && !ts.degenerate && ts.border_edges == 0 && ts.unreferenced == 0));
    BOOST_TEST(ts.euler == 2);
    BOOST_TEST(std::abs(volume(s) - 4. / 3. * CGAL_PI) < .01 * 4. / 3. * CGAL_PI); // outward: positive

    const Triangle_arrays t = marching_cubes(torus, {-1.5, -1.5, -.5}, {1.5, 1.5, .5}, 40, crossing);
    const Topology tt = topology(t);
    BOOST_TEST((tt.manifold && !tt.degenerate && tt.border_edges == 0 && tt.unreferenced == 0));
    BOOST_TEST(tt.euler == 0);
    BOOST_TEST(std::abs(volume(t) - 2. * CGAL_PI * CGAL_PI * .16) < .02 * 2. * CGAL_PI * CGAL_PI * .16);
  }
}

// nearer to the surface than the cells are large, with the surface's shape and its edges
BOOST_AUTO_TEST_CASE(dual_contouring_makes_a_sphere_a_torus_and_a_box)
{
  const auto sphere = [](const Vector& p) { return dot(p, p) - 1.; };
  const Triangle_arrays s = dual_contouring(
      sphere, [](const Vector& p) { return 2. * p; }, {-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5}, 40);
  const Topology ts = topology(s);
  BOOST_TEST((ts.manifold && !ts.degenerate && ts.border_edges == 0 && ts.unreferenced == 0));
  BOOST_TEST(ts.euler == 2);
  BOOST_TEST(std::abs(volume(s) - 4. / 3. * CGAL_PI) < .01 * 4. / 3. * CGAL_PI); // outward: positive
  for(const Vector& p : s.points)
    BOOST_TEST(std::abs(length(p) - 1.) < .1 * 3. / 39.);

  const auto torus = [](const Vector& p)
  {
    const double d = std::hypot(p.x, p.y) - 1.;
    return d * d + p.z * p.z - .16;
  };
  const auto gradient = [](const Vector& p)
  {
    const double r = std::hypot(p.x, p.y), d = 2. * (r - 1.) / r;
    return Vector{d * p.x, d * p.y, 2. * p.z};
  };
  const Triangle_arrays t = dual_contouring(torus, gradient, {-1.5, -1.5, -.5}, {1.5, 1.5, .5}, 40);
  const Topology tt = topology(t);
  BOOST_TEST((tt.manifold && !tt.degenerate && tt.border_edges == 0 && tt.unreferenced == 0));
  BOOST_TEST(tt.euler == 0);

  // the corners of a box, which marching cubes cuts off
  const Vector half = {.51, .62, .73};
  const auto depths = [&](const Vector& p) {
    return Vector{std::abs(p.x) - half.x, std::abs(p.y) - half.y, std::abs(p.z) - half.z};
  };
  const auto box = [&](const Vector& p)
  {
    const Vector d = depths(p);
    return std::max({d.x, d.y, d.z});
  };
  const auto normal = [&](const Vector& p)
  {
    const Vector d = depths(p);
    Vector n;
    for(std::size_t i = 0; i < 3; ++i)
      n[i] = d[i] == box(p) ? (p[i] < 0. ? -1. : 1.) : 0.;
    return n;
  };
  const Triangle_arrays b = dual_contouring(box, normal, {-1, -1, -1}, {1, 1, 1}, 20);
  BOOST_TEST((topology(b).manifold && topology(b).euler == 2));
  BOOST_TEST(std::abs(volume(b) - 8. * half.x * half.y * half.z) < 1e-9);
}

// random signs meet every case with every neighbor: ambiguous faces on both sides, loops that cross a face twice
BOOST_AUTO_TEST_CASE(marching_cubes_is_manifold_for_any_values)
{
  for(std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    Random random(seed);
    const std::size_t n = 16;
    std::map<std::tuple<double, double, double>, double> values;
    const auto noise = [&](const Vector& p)
    {
      const auto inserted = values.insert({std::make_tuple(p.x, p.y, p.z), 0.});
      if(inserted.second)
      {
        const bool border = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > .999;
        inserted.first->second = border ? 1. : random.uniform(-1., 1.);
      }
      return inserted.first->second;
    };
    const Triangle_arrays mesh = marching_cubes(noise, {-1, -1, -1}, {1, 1, 1}, n, Edge_crossing::LINEAR);
    const Topology t = topology(mesh);
    BOOST_TEST(mesh.triangles.size() > 1000u);
    BOOST_TEST((t.manifold && !t.degenerate && t.unreferenced == 0));
    BOOST_TEST(t.border_edges == 0u);
    BOOST_TEST(t.euler % 2 == 0);
    BOOST_TEST(volume(mesh) > 0.);
  }
}

BOOST_AUTO_TEST_CASE(all_cases_but_two_have_triangles)
{
  const auto& cases = internal::Marching_cubes_cases::instance();
  for(unsigned int inside = 0; inside < 256; ++inside)
    BOOST_TEST(cases.triangles(inside).empty() == (inside == 0 || inside == 255));
  BOOST_TEST(cases.triangles(1).size() == 1u);
  BOOST_TEST(cases.triangles(0x0f).size() == 2u);
  BOOST_TEST(cases.triangles(0x69).size() == 4u); // four corners, none adjacent: each cut off
}

BOOST_AUTO_TEST_CASE(exact_crossings_lie_on_the_surface_and_linear_ones_on_the_chord)
{
  const auto shifted = [](const Vector& p) { return p.x * p.x * p.x + p.y + .3 * p.z - .05; };
  const Triangle_arrays exact = marching_cubes(shifted, {-1, -1, -1}, {1, 1, 1}, 12, Edge_crossing::EXACT);
  for(const Vector& p : exact.points)
    BOOST_TEST(std::abs(shifted(p)) < 1e-7);
  const Triangle_arrays linear = marching_cubes(shifted, {-1, -1, -1}, {1, 1, 1}, 12, Edge_crossing::LINEAR);
  BOOST_TEST((exact.triangles == linear.triangles));
  double farthest = 0.;
  for(std::size_t i = 0; i < linear.points.size(); ++i)
    test_support::raise_to(farthest, std::abs(shifted(linear.points[i])));
  BOOST_TEST(farthest > 1e-4);
  BOOST_TEST(farthest < .1);
}

// a level set through the points of the grid: vertices fall together, indices don't
BOOST_AUTO_TEST_CASE(zeros_at_grid_points_are_kept)
{
  for(Edge_crossing crossing : {Edge_crossing::LINEAR, Edge_crossing::EXACT})
  {
    const Triangle_arrays mesh =
        marching_cubes([](const Vector& p) { return p.x + p.y + p.z; }, {-1, -1, -1}, {1, 1, 1}, 9, crossing);
    const Topology t = topology(mesh);
    BOOST_TEST((t.manifold && !t.degenerate && t.unreferenced == 0));
    BOOST_TEST(t.euler == 1);
    std::set<std::tuple<double, double, double>> places;
    for(const Vector& p : mesh.points)
    {
      BOOST_TEST(std::abs(p.x + p.y + p.z) < 1e-7);
      places.insert({p.x, p.y, p.z});
    }
    if(crossing == Edge_crossing::LINEAR)
      BOOST_TEST(places.size() < mesh.points.size());
  }
}

BOOST_AUTO_TEST_CASE(surfaces_of_the_experiments_have_their_shapes)
{
  // f1i: a cube-like shell, with an inner surface; f2i: a sphere-like one; f4i: a rounded cube
  for(const Implicit_function& f : implicit_functions())
    BOOST_TEST_CONTEXT(f.name)
    {
      const Triangle_arrays mesh = marching_cubes_tessellation(f, 64, Edge_crossing::EXACT);
      const Topology t = topology(mesh);
      BOOST_TEST((t.manifold && !t.degenerate && t.unreferenced == 0));
      BOOST_TEST((t.border_edges == 0) == (f.name != "f3i" && f.name != "f5i"));
      std::size_t inward = 0;
      for(const Triangle& i : mesh.triangles)
      {
        const Vector& a = mesh.points[i[0]];
        const Vector n = cross(mesh.points[i[1]] - a, mesh.points[i[2]] - a);
        inward += dot(n, f.gradient(a)) < -.1 * length(n) * length(f.gradient(a));
      }
      BOOST_TEST(inward == 0u);
      if(f.name == "f4i")
        BOOST_TEST(t.euler == 2);
    }
}

BOOST_AUTO_TEST_CASE(delaunay_triangles_have_empty_circles)
{
  const Explicit_function& f = explicit_function("f2e");
  const Triangle_arrays mesh = random_tessellation(f, 300, 5);
  BOOST_TEST(mesh.points.size() == 300u);
  const Topology t = topology(mesh);
  BOOST_TEST((t.manifold && !t.degenerate && t.unreferenced == 0));
  BOOST_TEST(t.euler == 1);
  double area = 0.;
  for(const Triangle& i : mesh.triangles)
  {
    const Vector &a = mesh.points[i[0]], &b = mesh.points[i[1]], &c = mesh.points[i[2]];
    const double twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    BOOST_TEST(twice > 0.);
    area += .5 * twice;
    for(const Vector& p : mesh.points)
    {
      // the determinant of the lifted points is positive inside the circle
      const auto row = [&p](const Vector& v) {
        return Vector{v.x - p.x, v.y - p.y, (v.x - p.x) * (v.x - p.x) + (v.y - p.y) * (v.y - p.y)};
      };
      BOOST_TEST(dot(row(a), cross(row(b), row(c))) < 1e-9);
    }
  }
  BOOST_TEST((area < 400. && area > 340.)); // the hull of 300 points in a square of 400
  BOOST_TEST((random_tessellation(f, 300, 5).triangles == mesh.triangles));
  BOOST_TEST((random_tessellation(f, 300, 6).points != mesh.points));
  for(const Vector& p : mesh.points)
    BOOST_TEST((std::abs(p.x) <= f.half && std::abs(p.y) <= f.half && p.z == f.value(p.x, p.y)));
}

BOOST_AUTO_TEST_CASE(grids_cover_the_square)
{
  const Triangle_arrays mesh = grid_tessellation(explicit_function("f3e"), 11);
  const Topology t = topology(mesh);
  BOOST_TEST((t.manifold && t.euler == 1 && t.border_edges == 40));
  BOOST_TEST((mesh.points.front().x == -1. && mesh.points.back().x == 1. && mesh.points.back().y == 1.));
  const std::vector<std::size_t> rings = rings_from_border(mesh);
  for(std::size_t i = 0; i < 11; ++i)
    for(std::size_t j = 0; j < 11; ++j)
      BOOST_TEST(rings[i * 11 + j] == std::min({i, j, 10 - i, 10 - j}));
}

BOOST_AUTO_TEST_CASE(closed_surfaces_have_no_rings_from_a_border)
{
  const Triangle_arrays mesh = marching_cubes([](const Vector& p) { return dot(p, p) - 1.; }, {-2, -2, -2},
                                              {2, 2, 2}, 8, Edge_crossing::EXACT);
  for(std::size_t r : rings_from_border(mesh))
    BOOST_TEST(r == mesh.points.size());
}

BOOST_AUTO_TEST_CASE(noise_has_the_deviation_asked_for)
{
  const Triangle_arrays clean = grid_tessellation(explicit_function("f1e"), 60);
  const double edge = mean_edge_length(clean);
  for(Noise noise : {Noise::GAUSSIAN, Noise::UNIFORM})
  {
    Triangle_arrays noisy = clean, again = clean, other = clean;
    add_noise(noisy, noise, .1, 1);
    add_noise(again, noise, .1, 1);
    add_noise(other, noise, .1, 2);
    BOOST_TEST((noisy.points == again.points));
    BOOST_TEST((noisy.points != other.points));
    double square = 0., sum = 0., greatest = 0.;
    for(std::size_t i = 0; i < clean.points.size(); ++i)
      for(int c = 0; c < 3; ++c)
      {
        const double d = noisy.points[i][c] - clean.points[i][c];
        sum += d;
        square += d * d;
        test_support::raise_to(greatest, std::abs(d));
      }
    const double n = 3. * double(clean.points.size());
    BOOST_TEST(std::abs(std::sqrt(square / n) - .1 * edge) < .02 * .1 * edge);
    BOOST_TEST(std::abs(sum / n) < .05 * .1 * edge);
    if(noise == Noise::UNIFORM)
      BOOST_TEST(greatest <= std::sqrt(3.) * .1 * edge);
    else
      BOOST_TEST(greatest > 3. * .1 * edge);
  }
}

// the values are part of what a seed means
BOOST_AUTO_TEST_CASE(random_numbers_are_the_same_everywhere)
{
  std::mt19937_64 engine(5489u);
  engine.discard(9999);
  BOOST_TEST(engine() == 9981545732273789042u); // the standard's check of the engine
  Random a(5489u);
  std::mt19937_64 b(5489u);
  for(int i = 0; i < 100; ++i)
  {
    const double u = a.uniform();
    BOOST_TEST(u == std::ldexp(double(b() >> 11), -53));
    BOOST_TEST((u >= 0. && u < 1.));
  }
}

BOOST_AUTO_TEST_CASE(incremental_triangulation_leaves_out_flat_triangles_of_the_border)
{
  const Explicit_function& f = explicit_function("f1e");
  const Triangle_arrays whole = random_tessellation(f, 2000, 3),
                        mesh = random_tessellation(f, 2000, 3, Hull::OF_INCREMENTAL_TRIANGULATION);
  BOOST_TEST((mesh.points == whole.points));
  BOOST_TEST(mesh.triangles.size() < whole.triangles.size());
  const Topology t = topology(mesh);
  BOOST_TEST((t.manifold && !t.degenerate && t.unreferenced == 0));
  BOOST_TEST(t.euler == 1);
  const std::set<Triangle> left(mesh.triangles.begin(), mesh.triangles.end());
  std::size_t found = 0;
  for(const Triangle& i : whole.triangles)
  {
    if(left.count(i) > 0)
    {
      ++found;
      continue;
    }
    // a corner of the large triangle is in the circle
    const Vector &a = whole.points[i[0]], &b = whole.points[i[1]], &c = whole.points[i[2]];
    const double twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    const double radius = std::hypot(a.x - b.x, a.y - b.y) * std::hypot(b.x - c.x, b.y - c.y) *
                          std::hypot(c.x - a.x, c.y - a.y) / (2. * twice);
    BOOST_TEST(radius > 4. * f.half);
  }
  BOOST_TEST(found == mesh.triangles.size());
}

BOOST_AUTO_TEST_SUITE_END()
