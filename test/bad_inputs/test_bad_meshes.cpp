#include <boost/test/unit_test.hpp>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "analytic_surfaces.h"
#include "bad_meshes.h"
#include "build_mesh.h"
#include "estimators.h"
#include "known_shapes.h"
#include "raise_to.h"

#include <Shape_characteristics/sampling/Face_graph_samples.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/boost/graph/helpers.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <tuple>
#include <vector>

BOOST_AUTO_TEST_SUITE(bad_meshes)

using namespace test_support;
using namespace bad_inputs;
using S = Estimation_status;
using Mesh_estimator = Estimator<Mesh>;

namespace {

const std::vector<Mesh_estimator> all_estimators = estimators<Mesh>();
const double nan_value = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

Polygon_arrays arrays(const Analytic_surface& s)
{
  return test_support::polygons_of(s.name, s);
}

Mesh mesh_of(const Polygon_arrays& a)
{
  return build_mesh<Mesh>(a);
}

template <typename Map>
Polygon_arrays transformed(Polygon_arrays a, const Map& map)
{
  for(Vector& p : a.points)
    p = map(p);
  return a;
}

Polygon_arrays flipped(Polygon_arrays a)
{
  for(auto& face : a.faces)
    std::reverse(face.begin(), face.end());
  return a;
}

// rows of edges to the nearest of some vertices
std::vector<std::size_t> rings_from(const Polygon_arrays& a, const std::vector<std::size_t>& sources)
{
  std::vector<std::size_t> rings(a.points.size(), std::size_t(-1));
  for(const std::size_t v : sources)
    rings[v] = 0;
  for(std::size_t ring = 1, changed = 1; changed > 0; ++ring)
  {
    changed = 0;
    std::vector<std::size_t> next = rings;
    for(const auto& face : a.faces)
      for(std::size_t k = 0; k < face.size(); ++k)
        for(const auto& [u, v] : {std::pair(face[k], face[(k + 1) % face.size()]),
                                  std::pair(face[(k + 1) % face.size()], face[k])})
          if(rings[u] == ring - 1 && next[v] == std::size_t(-1))
          {
            next[v] = ring;
            ++changed;
          }
    rings = next;
  }
  return rings;
}

bool is_one_of(S status, const std::vector<S>& allowed)
{
  return std::find(allowed.begin(), allowed.end(), status) != allowed.end();
}

// whether `b` is `a` as far as `tolerance` (absolute, of the curvatures) can tell; directions aren't compared
bool close(const Estimate& a, const Estimate& b, double tolerance)
{
  if(a.status != b.status)
    return false;
  return !SC::is_estimated(a.status) || (std::abs(a.values[0] - b.values[0]) <= tolerance &&
                                         std::abs(a.values[1] - b.values[1]) <= tolerance);
}

// k_min and k_max change their places and signs
void check_flipped(const Mesh_estimator& estimator, const Estimate& a, const Estimate& b)
{
  const double tolerance = estimator.flips_exactly ? 0. : 1e-12 * largest(a);
  BOOST_TEST(std::abs(b.k_min() + a.k_max()) <= tolerance);
  BOOST_TEST(std::abs(b.k_max() + a.k_min()) <= tolerance);
  BOOST_TEST(std::abs(b.Gaussian() - a.Gaussian()) <= 4. * tolerance * largest(a));
}

using Expectation = std::function<void(const Mesh_estimator&, const Mesh&, const Results&)>;

// every vertex has one of these statuses
Expectation only(const std::vector<S>& allowed)
{
  return [=](const Mesh_estimator&, const Mesh&, const Results& results)
  {
    for(std::size_t i = 0; i < results.samples.size(); ++i)
      BOOST_TEST(is_one_of(results.samples[i].status, allowed),
                 "vertex " << i << ": " << SC::to_string(results.samples[i].status));
  };
}

Expectation only(S status)
{
  return only(std::vector<S>{status});
}

// vertices of the first index on have one of these statuses, the others another of their own
Expectation last_ones(std::size_t first, const std::vector<S>& of_last, const std::vector<S>& of_others)
{
  return [=](const Mesh_estimator&, const Mesh&, const Results& results)
  {
    for(std::size_t i = 0; i < results.samples.size(); ++i)
      BOOST_TEST(is_one_of(results.samples[i].status, i < first ? of_others : of_last),
                 "vertex " << i << ": " << SC::to_string(results.samples[i].status));
  };
}

// curvature times `size` is at most `bound` for estimators that promise a bound
Expectation bounded(double size, double bound)
{
  return [=](const Mesh_estimator& estimator, const Mesh&, const Results& results)
  {
    if(!estimator.gives_curvatures || !estimator.is_bounded)
      return;
    for(std::size_t i = 0; i < results.samples.size(); ++i)
      if(SC::is_estimated(results.samples[i].status))
        BOOST_TEST(largest(results.samples[i]) * size <= bound,
                   "vertex " << i << ": " << largest(results.samples[i]));
  };
}

Expectation both(const Expectation& a, const Expectation& b)
{
  return [=](const Mesh_estimator& estimator, const Mesh& mesh, const Results& results)
  {
    a(estimator, mesh, results);
    b(estimator, mesh, results);
  };
}

const Expectation anything = [](const Mesh_estimator&, const Mesh&, const Results&) {};

// Meshes of this file alone -------------------------------------------------------------------------------

Polygon_arrays named(const std::string& name, Polygon_arrays a)
{
  a.name = name;
  return a;
}

// a triangle of two sides, which share their vertices
Polygon_arrays pillow()
{
  return {"pillow", {{.1, .2, .3}, {1.3, .7, .1}, {.4, 1.9, .8}}, {{0, 1, 2}, {0, 2, 1}}};
}

// a grid, all its vertices on one line
Polygon_arrays collinear_mesh()
{
  return named("collinear", transformed(arrays(plane(1., 6, .2)),
                                        [](const Vector& p) {
                                          return (p[0] + .3 * p[1]) * Vector{.31, -.77, .55};
                                        }));
}

Polygon_arrays identical_points()
{
  return named("identical points", transformed(arrays(plane(1., 4)),
                                               [](const Vector&) {
                                                 return Vector{.1, .2, .3};
                                               }));
}

Polygon_arrays with_point(Polygon_arrays a, std::size_t i, const Vector& p, const std::string& name)
{
  a.name = name;
  a.points[i] = p;
  return a;
}

// a cube of n x n x n cells: faces, edges and corners of a CAD part
Polygon_arrays fine_cube(std::size_t n = 4)
{
  Polygon_arrays m{"fine cube", {}, {}};
  std::map<std::array<std::size_t, 3>, std::size_t> index;
  const auto vertex = [&](const std::array<std::size_t, 3>& c)
  {
    const auto inserted = index.emplace(c, m.points.size());
    if(inserted.second)
      m.points.push_back({double(c[0]) / double(n), double(c[1]) / double(n), double(c[2]) / double(n)});
    return inserted.first->second;
  };
  for(std::size_t axis = 0; axis < 3; ++axis)
    for(const std::size_t side : {std::size_t(0), n})
      for(std::size_t i = 0; i < n; ++i)
        for(std::size_t j = 0; j < n; ++j)
        {
          const auto corner = [&](const std::size_t u, const std::size_t v)
          {
            std::array<std::size_t, 3> c{};
            c[axis] = side;
            c[(axis + 1) % 3] = u;
            c[(axis + 2) % 3] = v;
            return vertex(c);
          };
          std::vector<std::size_t> q = {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1),
                                        corner(i, j + 1)};
          if(side == 0)
            std::reverse(q.begin(), q.end());
          m.faces.push_back({q[0], q[1], q[2]});
          m.faces.push_back({q[0], q[2], q[3]});
        }
  return m;
}

// half of the sheet's cells are 1000 times as small as the others
Polygon_arrays uneven_density()
{
  return named("density 1 : 1000", transformed(arrays(plane(1., 12, .1)),
                                               [](const Vector& p)
                                               {
                                                 const double x = p[0] < 0. ? 1e-3 * p[0] : p[0];
                                                 return Vector{x, p[1], .2 * x * x - .3 * p[1] * p[1]};
                                               }));
}

struct Row
{
  int number; // of the list of bad inputs
  Polygon_arrays input;
  Expectation expectation;
};

// Statuses that are no failure, or the usual ones.
const std::vector<S> estimated = {S::ESTIMATED, S::BORDER};
const std::vector<S> border_or_less = {S::BORDER, S::FEW_NEIGHBOURS, S::DEGENERATE};
const std::vector<S> no_surface = {S::DEGENERATE, S::FEW_NEIGHBOURS};

std::vector<Row> rows()
{
  const Polygon_arrays ball = arrays(sphere(1., 2, .15));
  const Polygon_arrays sheet = arrays(waves(.1, 4., 1., 12, .15));
  const std::size_t middle = 6 * 13 + 6;
  const auto at_middle = [&](const Vector& p, const std::string& name)
  { return with_point(sheet, middle, p, name); };
  const auto not_finite_at = [](const std::size_t v) -> Expectation
  {
    return [=](const Mesh_estimator&, const Mesh&, const Results& results)
    {
      for(std::size_t i = 0; i < results.samples.size(); ++i)
        BOOST_TEST((results.samples[i].status == S::NON_FINITE_INPUT) == (i == v), "vertex " << i);
    };
  };
  const Expectation soup = [](const Mesh_estimator& estimator, const Mesh&, const Results& results)
  {
    for(const Estimate& e : results.samples) // normals don't say DUPLICATE
      BOOST_TEST(
          (e.status == S::DUPLICATE || (!estimator.gives_curvatures && e.status == S::FEW_NEIGHBOURS)));
  };
  const Expectation edges = [](const Mesh_estimator& estimator, const Mesh& mesh, const Results& results)
  {
    const Expectation expectation =
        estimator.needs_smoothness ? only({S::ESTIMATED, S::DEGENERATE}) : only(S::ESTIMATED);
    expectation(estimator, mesh, results);
  };
  return {
      {1, empty_mesh(), only(S::UNREFERENCED)},
      {2, single_vertex(), only(S::UNREFERENCED)},
      {3, single_triangle(), only(no_surface)},
      {3, open_fan(), only(border_or_less)},
      {4, tetrahedron(), bounded(2., 200.)},
      {4, cube(), both(only({S::ESTIMATED, S::FEW_NEIGHBOURS}), bounded(2., 200.))},
      {4, fan_of_three(), bounded(1., 200.)},
      {5, isolated_vertices(), last_ones(162, {S::UNREFERENCED}, estimated)},
      {6, triangle_soup(), soup},
      {7, pillow(), only(no_surface)},
      {8, zero_area_triangles(), anything},
      {8, needle_triangles(), anything},
      {8, cap_triangle(), anything},
      {10, collinear_mesh(), only(no_surface)},
      {10, identical_points(), only({S::DEGENERATE, S::FEW_NEIGHBOURS, S::DUPLICATE})},
      {12, at_middle({nan_value, 0., 0.}, "NaN in x"), not_finite_at(middle)},
      {12, at_middle({0., infinity, 0.}, "infinity in y"), not_finite_at(middle)},
      {12, at_middle({-infinity, nan_value, infinity}, "no number"), not_finite_at(middle)},
      {12, at_middle({1e308, -1e308, 1e308}, "huge"), anything},
      {12, at_middle({5e-324, 5e-324, 5e-324}, "denormal"), bounded(.1, 1e4)},
      {12,
       named("all NaN", transformed(ball,
                                    [](const Vector&) {
                                      return Vector{nan_value, 0., 0.};
                                    })),
       only(S::NON_FINITE_INPUT)},
      {12, named("all huge", transformed(ball, [](const Vector& p) { return 1e308 * p; })), anything},
      {12, named("all denormal", transformed(ball, [](const Vector& p) { return 1e-310 * p; })), anything},
      {15, bow_tie(), only(border_or_less)},
      {16, moebius_strip(24, 4), anything},
      {17, border_ear(), last_ones(81, border_or_less, estimated)},
      {17, thin_strip(30), only(border_or_less)},
      {18, mixed_valences(), bounded(.02, 200.)},
      {21, fine_cube(), both(edges, bounded(.25, 60.))},
      {22, named("scale 1e-100", transformed(ball, [](const Vector& p) { return 1e-100 * p; })),
       only(S::ESTIMATED)},
      {22, named("scale 1e+100", transformed(ball, [](const Vector& p) { return 1e100 * p; })),
       only(S::ESTIMATED)},
      {24, uneven_density(), anything},
      {25, schwarz_lantern(8, 40), anything},
      {26, two_sheets(.01, 8), only(estimated)},
      {27, cube_of_quads(), bounded(2., 200.)},
      {27, prism_of_polygons(), bounded(1., 200.)},
      {27, several_components(), last_ones(450, no_surface, estimated)},
  };
}

} // namespace

namespace {

// The overload for one vertex answers the same to the last bit: six of those that were estimated, and of the others. It
// doesn't search the mesh for duplicates.
void check_single_vertices(const Mesh_estimator& estimator, const Mesh& mesh, const Results& results)
{
  constexpr std::size_t most = 6;
  const std::size_t step = mesh.number_of_vertices() / most + 1;
  std::size_t not_estimated = 0;
  for(std::size_t i = 0; i < mesh.number_of_vertices(); ++i)
  {
    if(i % step != 0 && (SC::is_estimated(results.samples[i].status) || not_estimated++ >= most))
      continue;
    Estimate one;
    BOOST_REQUIRE_NO_THROW(one = estimator.one(Mesh::Vertex_index(unsigned(i)), mesh));
    if(results.samples[i].status == S::DUPLICATE)
      BOOST_TEST((one.status == S::FEW_NEIGHBOURS || one.status == S::DUPLICATE));
    else
      BOOST_TEST(same(one, results.samples[i]), "vertex " << i);
  }
}

} // namespace

// What holds for every input and estimator: nothing is thrown, every value is written, and is finite where the status
// says that it was estimated and NaN elsewhere; failures are counted; what the row says; and one vertex is told the same
// where nothing but the neighborhood has a say (of a bow tie, it sees one fan alone).
BOOST_AUTO_TEST_CASE(every_row_and_estimator)
{
  for(const Row& row : rows())
  {
    const Mesh mesh = mesh_of(row.input);
    for(const Mesh_estimator& estimator : all_estimators)
      BOOST_TEST_CONTEXT("row " << row.number << ", " << row.input.name << ", " << estimator.name)
      {
        if(estimator.needs_triangles && !CGAL::is_triangle_mesh(mesh))
        {
          BOOST_CHECK_THROW(estimator.all(mesh), std::invalid_argument);
          continue;
        }
        Results results;
        BOOST_REQUIRE_NO_THROW(results = estimator.all(mesh));
        BOOST_TEST(complaint(results, mesh) == "");
        row.expectation(estimator, mesh, results);
        if(estimator.one && estimator.is_local && row.input.name != "bow tie")
          check_single_vertices(estimator, mesh, results);
      }
  }
}

BOOST_AUTO_TEST_CASE(isolated_vertices_change_nothing)
{
  Polygon_arrays clean = isolated_vertices(3);
  clean.points.resize(clean.points.size() - 3);
  const Mesh with = mesh_of(isolated_vertices(3)), without = mesh_of(clean);
  for(const Mesh_estimator& estimator : all_estimators)
    BOOST_TEST_CONTEXT(estimator.name)
    {
      const Results a = estimator.all(with), b = estimator.all(without);
      BOOST_TEST(a.failures == b.failures + 3);
      for(std::size_t i = 0; i < b.samples.size(); ++i)
        BOOST_TEST(same(a.samples[i], b.samples[i]), "vertex " << i);
    }
}

// Vertices that were removed from a Surface_mesh leave holes in its indices.
BOOST_AUTO_TEST_CASE(removed_vertices_change_nothing)
{
  Polygon_arrays a = arrays(waves(.1, 4., 1., 8, .15));
  const Mesh clean = mesh_of(a);
  a.points.insert(a.points.begin(), 5, Vector{7., 7., 7.});
  for(auto& face : a.faces)
    for(std::size_t& i : face)
      i += 5;
  Mesh holes = mesh_of(a);
  for(unsigned i = 0; i < 5; ++i)
    holes.remove_vertex(Mesh::Vertex_index(i));
  for(const Mesh_estimator& estimator : all_estimators)
    BOOST_TEST_CONTEXT(estimator.name)
    {
      const Results with = estimator.all(holes), without = estimator.all(clean);
      BOOST_TEST(complaint(with, holes) == "");
      for(std::size_t i = 0; i < without.samples.size(); ++i)
        BOOST_TEST(same(with.samples[i + 5], without.samples[i]), "vertex " << i);
    }
}

// A soup is told what to do; after that it is the mesh it was made of.
BOOST_AUTO_TEST_CASE(merged_soup)
{
  const Mesh clean = mesh_of(arrays(sphere(1., 2)));
  Mesh soup = mesh_of(triangle_soup());
  CGAL::Polygon_mesh_processing::stitch_borders(soup);
  soup.collect_garbage();
  BOOST_REQUIRE(soup.number_of_vertices() == clean.number_of_vertices());
  std::map<Point_3, Mesh::Vertex_index> at;
  for(const auto v : clean.vertices())
    at[clean.point(v)] = v;
  for(const Mesh_estimator& estimator : all_estimators)
    BOOST_TEST_CONTEXT(estimator.name)
    {
      const Results a = estimator.all(soup), b = estimator.all(clean);
      for(const auto v : soup.vertices())
        BOOST_TEST(same_but_for_fits(estimator, a.samples[v], b.samples[at.at(soup.point(v))]),
                   "vertex " << v);
    }
}

// The second sheet of a double cover, whose vertices lie on those of the first, changes nothing on the first: a mesh's
// neighbors are found along its edges.
BOOST_AUTO_TEST_CASE(opposite_duplicate_faces)
{
  const Polygon_arrays sheet = arrays(waves(.1, 4., 1., 8, .15));
  Polygon_arrays twice = sheet;
  test_support::append(twice, flipped(sheet));
  const Mesh one = mesh_of(sheet), two = mesh_of(twice);
  const std::size_t n = sheet.points.size();
  for(const Mesh_estimator& estimator : all_estimators)
    BOOST_TEST_CONTEXT(estimator.name)
    {
      const Results a = estimator.all(one), b = estimator.all(two);
      BOOST_TEST(complaint(b, two) == "");
      if(estimator.has_pattern)
        continue;
      for(std::size_t i = 0; i < n; ++i)
      {
        BOOST_TEST(same(a.samples[i], b.samples[i]), "vertex " << i);
        if(estimator.gives_curvatures && SC::is_estimated(b.samples[i].status))
          check_flipped(estimator, b.samples[i], b.samples[n + i]);
      }
    }
}

// What is wrong somewhere stays there.
BOOST_AUTO_TEST_CASE(far_vertices_are_unaffected)
{
  const Polygon_arrays clean = arrays(waves(.1, 4., 1., 20, .15));
  const std::size_t middle = 10 * 21 + 10;
  const std::vector<std::size_t> rings = rings_from(clean, {middle});
  std::vector<Results> of_clean;
  for(const Mesh_estimator& estimator : all_estimators)
    of_clean.push_back(estimator.all(mesh_of(clean)));
  for(const Polygon_arrays& bad :
      {with_point(clean, middle, {nan_value, 0., 0.}, "NaN"),
       with_point(clean, middle, {0., -infinity, 0.}, "infinity"),
       with_point(clean, middle, clean.points[middle + 1], "coincident"),
       with_point(clean, middle, clean.points[middle] + Vector{0., 0., .5}, "outlier")})
  {
    const Mesh mesh = mesh_of(bad);
    for(std::size_t e = 0; e < all_estimators.size(); ++e)
      BOOST_TEST_CONTEXT(bad.name << ", " << all_estimators[e].name)
      {
        const Mesh_estimator& estimator = all_estimators[e];
        const Results &a = of_clean[e], b = estimator.all(mesh);
        BOOST_TEST(complaint(b, mesh) == "");
        std::size_t far = 0;
        for(std::size_t i = 0; i < a.samples.size(); ++i)
          if(rings[i] > estimator.sight)
          {
            ++far;
            if(estimator.has_pattern) // 1 of 800 edges changes the mean length of all
              BOOST_TEST(close(a.samples[i], b.samples[i], .05), "vertex " << i);
            else
              BOOST_TEST(same_but_for_fits(estimator, a.samples[i], b.samples[i]), "vertex " << i);
          }
        BOOST_TEST(far > 100);
      }
  }
}

BOOST_AUTO_TEST_CASE(components_are_independent)
{
  const Polygon_arrays a = arrays(sphere(1., 2, .15)), b = arrays(waves(.1, 4., 1., 8, .15));
  Polygon_arrays together = a;
  test_support::append(together, b);
  const Mesh mesh_a = mesh_of(a), mesh_b = mesh_of(b), mesh = mesh_of(together);
  for(const Mesh_estimator& estimator : all_estimators)
    if(estimator.is_local)
      BOOST_TEST_CONTEXT(estimator.name)
      {
        const Results of_a = estimator.all(mesh_a), of_b = estimator.all(mesh_b), all = estimator.all(mesh);
        for(std::size_t i = 0; i < a.points.size(); ++i)
          BOOST_TEST(same(all.samples[i], of_a.samples[i]), "vertex " << i);
        for(std::size_t i = 0; i < b.points.size(); ++i)
          BOOST_TEST(same(all.samples[a.points.size() + i], of_b.samples[i]), "vertex " << i);
      }
}

// Figures ---------------------------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(plane_is_flat)
{
  const Mesh mesh = mesh_of(transformed(arrays(plane(1., 10, .2)),
                                        [](const Vector& p) {
                                          return Vector{p[0], .6 * p[1] + 1., .8 * p[1] - 2.};
                                        }));
  for(const Mesh_estimator& estimator : all_estimators)
    if(estimator.gives_curvatures)
      BOOST_TEST_CONTEXT(estimator.name)
      {
        for(const Estimate& e : estimator.all(mesh).samples)
        {
          BOOST_TEST(SC::is_estimated(e.status));
          BOOST_TEST(largest(e) <= 1e-11); // of a square of size 2, with spacing 0.2
        }
      }
}

BOOST_AUTO_TEST_CASE(sphere_is_umbilic)
{
  const double radius = 2.5;
  const Mesh mesh = mesh_of(arrays(sphere(radius, 3, .15)));
  for(const Mesh_estimator& estimator : all_estimators)
    if(estimator.gives_curvatures)
      BOOST_TEST_CONTEXT(estimator.name)
      {
        check_sphere(estimator, estimator.all(mesh), radius);
      }
}

BOOST_AUTO_TEST_CASE(cylinder_has_a_direction)
{
  const Analytic_surface surface = cylinder(1., 2., 40, 12, .15);
  std::vector<std::size_t> inner;
  for(std::size_t i = 0; i < surface.points.size(); ++i)
    if(!surface.exact[i].border && std::abs(surface.points[i].z) < .6)
      inner.push_back(i);
  const Mesh mesh = mesh_of(arrays(surface));
  for(const Mesh_estimator& estimator : all_estimators)
    if(estimator.gives_curvatures)
      BOOST_TEST_CONTEXT(estimator.name)
      {
        check_cylinder(estimator, estimator.all(mesh), inner);
      }
}

namespace {

SC::Face_graph_samples samples_of(const Mesh& mesh)
{
  return SC::Face_graph_samples(mesh, mesh.points(), SC::Neighborhood::rings(1));
}

} // namespace

// Edges of a cube are found by what is said of their curvature, and neither its faces nor a ball.
BOOST_AUTO_TEST_CASE(sharp_edges)
{
  const Polygon_arrays cube = fine_cube(6);
  std::vector<std::size_t> planes(cube.points.size()); // of those of the faces, through each vertex
  std::vector<std::size_t> on_edges;
  for(std::size_t i = 0; i < cube.points.size(); ++i)
  {
    for(std::size_t axis = 0; axis < 3; ++axis)
      planes[i] += cube.points[i][axis] == 0. || cube.points[i][axis] == 1.;
    if(planes[i] >= 2)
      on_edges.push_back(i);
  }
  const std::vector<std::size_t> rings = rings_from(cube, on_edges);
  BOOST_REQUIRE(*std::max_element(rings.begin(), rings.end()) == 3);
  const Mesh mesh = mesh_of(cube), ball = mesh_of(arrays(sphere(1., 3)));
  const SC::Face_graph_samples samples = samples_of(mesh), samples_of_ball = samples_of(ball);
  for(const Mesh_estimator& estimator : all_estimators)
    if(estimator.gives_curvatures)
      BOOST_TEST_CONTEXT(estimator.name)
      {
        const Results of_cube = estimator.all(mesh), of_ball = estimator.all(ball);
        for(std::size_t i = 0; i < planes.size(); ++i)
        {
          const bool is_found = is_sharp(estimator, of_cube.samples[i], samples.spacing(i));
          if(planes[i] == 2 && SC::is_estimated(of_cube.samples[i].status))
            BOOST_TEST(is_found, "edge, vertex " << i);
          if(rings[i] == 3)
            BOOST_TEST(!is_found, "face, vertex " << i);
        }
        for(std::size_t i = 0; i < samples_of_ball.size(); ++i)
          BOOST_TEST(!is_sharp(estimator, of_ball.samples[i], samples_of_ball.spacing(i)),
                     "ball, vertex " << i);
      }
}

// The tip of a cone has no curvature: it is flagged but by those that measure over an area, what these say of it is bounded, and its
// sides are those of a cone. So it is with a fine cone and a flat one.
BOOST_AUTO_TEST_CASE(cone_with_apex)
{
  for(const Analytic_surface& surface : {cone(1., 1.5, 24, 12), cone(1., 1.5, 48, 24), cone(1., .5, 24, 12)})
  {
    const Mesh mesh = mesh_of(arrays(surface));
    std::vector<std::size_t> singular;
    for(std::size_t i = 0; i < surface.points.size(); ++i)
      if(surface.exact[i].singular)
        singular.push_back(i);
    BOOST_REQUIRE(!singular.empty());
    const SC::Face_graph_samples samples = samples_of(mesh);
    const std::vector<std::size_t> rings = rings_from(arrays(surface), singular);
    for(const Mesh_estimator& estimator : all_estimators)
      BOOST_TEST_CONTEXT(surface.name << ", " << surface.points.size() << " vertices, " << estimator.name)
      {
        const Results results = estimator.all(mesh);
        BOOST_TEST(complaint(results, mesh) == "");
        bounded(surface.mean_edge_length(), 100.)(estimator, mesh, results);
        for(const std::size_t i : singular)
        {
          BOOST_TEST(
              (results.samples[i].status == (estimator.measures_areas ? S::ESTIMATED : S::DEGENERATE)));
          if(estimator.measures_areas && estimator.resolution == 1.) // it isn't averaged with the sides
            BOOST_TEST(is_sharp(estimator, results.samples[i], samples.spacing(i)));
        }
        if(estimator.gives_curvatures && estimator.accuracy < 1.)
          for(std::size_t i = 0; i < surface.points.size(); ++i)
            if(rings[i] > estimator.sight && !surface.exact[i].border)
              BOOST_TEST(std::abs(results.samples[i].k_min()) <=
                             4. * estimator.accuracy * (1. + surface.exact[i].k_max),
                         "vertex " << i << ": " << results.samples[i].k_min());
      }
  }
}

// Invariances -----------------------------------------------------------------------------------------------

namespace {

std::vector<Polygon_arrays> smooth_meshes()
{
  return {arrays(ellipsoid(1., .8, .6, 2, .15)), arrays(waves(.1, 4., 1., 8, .15))};
}

} // namespace

// On tori, which are regular, much is equal but for rounding: distances, coordinates, angles. The coarse one looks noisy. The fine one,
// the largest of all, is there for what rounds: powers of two don't.
BOOST_AUTO_TEST_CASE(scaling)
{
  std::vector<Polygon_arrays> surfaces = smooth_meshes();
  surfaces.push_back(arrays(torus(1., .4, 24, 12)));
  surfaces.push_back(arrays(torus()));
  const std::vector<double> rounding = {1e-6, 1e6}, all_scales = {1e-6, 1e6, 0x1p-200, 0x1p200};
  for(const Polygon_arrays& surface : surfaces)
  {
    const Mesh mesh = mesh_of(surface);
    const bool is_fine = &surface == &surfaces.back();
    for(const Mesh_estimator& estimator : all_estimators)
    {
      if(!estimator.gives_curvatures)
        continue;
      const Results a = estimator.all(mesh);
      for(const double scale : is_fine ? rounding : all_scales)
        BOOST_TEST_CONTEXT(surface.name << " times " << scale << ", " << estimator.name)
        {
          const Results b =
              estimator.all(mesh_of(transformed(surface, [&](const Vector& p) { return scale * p; })));
          BOOST_TEST_MESSAGE(surface.name << ", " << estimator.name << " times " << scale << ": changed by "
                                          << change_by_scaling(a, b, scale));
          BOOST_TEST(complaint_of_scaled(estimator, a, b, scale) == "");
        }
    }
  }
}

// Coordinates as those of maps: the result is that of the same points around the origin. (The points were rounded when
// they were moved away; moving them back is exact.)
BOOST_AUTO_TEST_CASE(large_offset)
{
  const Vector offset{5e6, 1e7, -3e6};
  for(const Polygon_arrays& surface : smooth_meshes())
  {
    const Polygon_arrays far = transformed(surface, [&](const Vector& p) { return p + offset; });
    const Mesh far_mesh = mesh_of(far),
               mesh = mesh_of(transformed(far, [&](const Vector&p) { return p - offset; }));
    for(const Mesh_estimator& estimator : all_estimators)
      if(estimator.gives_curvatures)
        BOOST_TEST_CONTEXT(surface.name << ", " << estimator.name)
        {
          const Results a = estimator.all(mesh), b = estimator.all(far_mesh);
          for(std::size_t i = 0; i < a.samples.size(); ++i)
            BOOST_TEST(close(a.samples[i], b.samples[i], 1e-6 * (1. + largest(a.samples[i]))),
                       "vertex " << i);
        }
  }
}

BOOST_AUTO_TEST_CASE(rigid_motion)
{
  const double c = std::cos(.7), s = std::sin(.7);
  for(const Polygon_arrays& surface : smooth_meshes())
  {
    const Mesh mesh = mesh_of(surface),
               moved = mesh_of(
                   transformed(surface,
                               [&](const Vector&p)
                               {
                                 const Vector q{c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]};
                                 return Vector{q[0] + .3, c * q[1] - s * q[2] - .7, s * q[1] + c * q[2] + .2};
                               }));
    for(const Mesh_estimator& estimator : all_estimators)
      if(estimator.gives_curvatures && !estimator.has_pattern && !estimator.has_box)
        BOOST_TEST_CONTEXT(surface.name << ", " << estimator.name)
        {
          const Results a = estimator.all(mesh), b = estimator.all(moved);
          BOOST_TEST_MESSAGE(surface.name << " moved, " << estimator.name << ": changed by "
                                          << change_by_scaling(a, b, 1.));
          for(std::size_t i = 0; i < a.samples.size(); ++i)
            BOOST_TEST(close(a.samples[i], b.samples[i],
                             10. * estimator.reproducibility * (1. + largest(a.samples[i]))),
                       "vertex " << i);
        }
  }
}

// to the last bit: vertices, faces, and the corners that faces start with, in another order
BOOST_AUTO_TEST_CASE(permutation)
{
  std::vector<Polygon_arrays> inputs = smooth_meshes();
  inputs.push_back(arrays(plane(1., 8))); // many neighbors are equally far
  inputs.push_back(arrays(sphere(1., 2)));
  inputs.push_back(zero_area_triangles());
  inputs.push_back(moebius_strip(24, 4));
  Random random(7);
  for(const Polygon_arrays& surface : inputs)
  {
    std::vector<std::size_t> place(surface.points.size());
    std::iota(place.begin(), place.end(), std::size_t(0));
    for(std::size_t i = place.size(); i > 1; --i)
      std::swap(place[i - 1], place[std::size_t(random.uniform() * double(i))]);
    Polygon_arrays shuffled = surface;
    for(std::size_t i = 0; i < place.size(); ++i)
      shuffled.points[place[i]] = surface.points[i];
    for(auto& face : shuffled.faces)
    {
      for(std::size_t& i : face)
        i = place[i];
      std::rotate(face.begin(), face.begin() + std::ptrdiff_t(random.uniform() * double(face.size())),
                  face.end());
    }
    for(std::size_t i = shuffled.faces.size(); i > 1; --i)
      std::swap(shuffled.faces[i - 1], shuffled.faces[std::size_t(random.uniform() * double(i))]);

    const Mesh a = mesh_of(surface), b = mesh_of(shuffled);
    for(const Mesh_estimator& estimator : all_estimators)
      BOOST_TEST_CONTEXT(surface.name << ", " << estimator.name)
      {
        const Results of_a = estimator.all(a), of_b = estimator.all(b);
        for(std::size_t i = 0; i < place.size(); ++i)
          BOOST_TEST(same_but_for_fits(estimator, of_a.samples[i], of_b.samples[place[i]]), "vertex " << i);
      }
  }
}

// Faces turned over: the curvatures change their signs and places, to the last bit, and statuses stay.
BOOST_AUTO_TEST_CASE(flipped_normals)
{
  std::vector<Polygon_arrays> surfaces = smooth_meshes();
  surfaces.push_back(arrays(sphere(1., 2)));
  surfaces.push_back(fine_cube());
  for(const Polygon_arrays& surface : surfaces)
  {
    const Mesh out = mesh_of(surface), in = mesh_of(flipped(surface));
    for(const Mesh_estimator& estimator : all_estimators)
      if(estimator.gives_curvatures)
        BOOST_TEST_CONTEXT(surface.name << ", " << estimator.name)
        {
          const Results a = estimator.all(out), b = estimator.all(in);
          for(std::size_t i = 0; i < a.samples.size(); ++i)
          {
            BOOST_REQUIRE((a.samples[i].status == b.samples[i].status));
            if(!SC::is_estimated(a.samples[i].status))
              continue;
            check_flipped(estimator, a.samples[i], b.samples[i]);
          }
        }
  }
}

#ifdef CGAL_LINKED_WITH_TBB
BOOST_AUTO_TEST_CASE(number_of_threads)
{
  std::vector<Polygon_arrays> inputs = smooth_meshes();
  inputs.push_back(several_components());
  for(const Polygon_arrays& surface : inputs)
  {
    const Mesh mesh = mesh_of(surface);
    for(const Mesh_estimator& estimator : all_estimators)
      BOOST_TEST_CONTEXT(surface.name << ", " << estimator.name)
      {
        Results of_one, of_two;
        tbb::task_arena(1).execute([&] { of_one = estimator.all(mesh); });
        tbb::task_arena(2).execute([&] { of_two = estimator.all(mesh); });
        BOOST_TEST(of_one.failures == of_two.failures);
        for(std::size_t i = 0; i < of_one.samples.size(); ++i)
          BOOST_TEST(same(of_one.samples[i], of_two.samples[i]), "vertex " << i);
      }
  }
}
#endif

// On a soup, on meshes with borders ... nothing is written into the mesh, and a second call answers the same.
BOOST_AUTO_TEST_CASE(calls_leave_no_trace)
{
  const Mesh mesh = mesh_of(border_ear());
  for(const Mesh_estimator& estimator : all_estimators)
  {
    const Results a = estimator.all(mesh), b = estimator.all(mesh);
    for(std::size_t i = 0; i < a.samples.size(); ++i)
      BOOST_TEST(same(a.samples[i], b.samples[i]));
  }
  BOOST_TEST(mesh.properties<Mesh::Vertex_index>().size() == 3); // points, connectivity, removal
}

BOOST_AUTO_TEST_SUITE_END()
