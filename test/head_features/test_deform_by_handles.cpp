#include <boost/test/unit_test.hpp>

#include "bad_meshes.h"
#include "handles_on_surfaces.h"
#include "raise_to.h"

#include <Shape_characteristics/head_features/deform_by_handles.h>

#include <CGAL/Polygon_mesh_processing/transform.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(deform_by_handles)

using namespace handles_on_surfaces;
using SC::deform_by_handles;
using test_support::build_mesh;

namespace {

// where the vertices are after the deformation, which leaves the mesh as it is
Points deformed(const Mesh& mesh, const std::vector<Handle>& handles)
{
  Mesh copy = mesh;
  deform_by_handles(copy, handles);
  return points_of(copy);
}

// the distances that the parts of a displacement by (0, 0, 1) tell
std::vector<double> distances_of(const Mesh& mesh, const Handle::Surface_point& source, double radius)
{
  const Points after = deformed(mesh, {Handle::displacing({source}, radius, Vector_3(0, 0, 1))});
  std::vector<double> result;
  for(const Vertex v : mesh.vertices())
    result.push_back(radius * std::sqrt(-2. * std::log((after[v] - mesh.point(v)).z())));
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(one_point_on_a_plane_has_a_Gaussian_neighborhood)
{
  for(const double jitter : {0., .2})
  {
    const Mesh mesh = build_mesh<Mesh>(test_support::plane(1., 40, jitter, 3));
    const Vertex source = vertex_at(mesh, .1, -.2, 0.);
    const double radius = .25;
    const Vector_3 d(.3, -.1, .7);
    const Points after = deformed(mesh, {Handle::displacing({source}, radius, d)});
    double largest = 0.;
    for(const Vertex v : mesh.vertices())
    {
      const double s = length(mesh.point(v) - mesh.point(source));
      const Vector_3 expected = (s <= 6. * radius ? gaussian(s, radius) : 0.) * d;
      test_support::raise_to(largest, length(after[v] - mesh.point(v) - expected));
    }
    BOOST_TEST(largest < 1e-12);
    BOOST_TEST(length(after[source] - mesh.point(source) - d) < 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(a_point_may_lie_inside_of_a_face)
{
  const Mesh mesh = build_mesh<Mesh>(test_support::plane(1., 40, .2, 4));
  const Mesh::Face_index f(1500);
  Point_3 p = CGAL::ORIGIN;
  std::vector<Vertex> corners;
  for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
    corners.push_back(v);
  p = CGAL::barycenter(mesh.point(corners[0]), .5, mesh.point(corners[1]), .3, mesh.point(corners[2]), .2);
  const double radius = .2;
  const Points after = deformed(mesh, {Handle::displacing({{corners[0], p}}, radius, Vector_3(0, 0, 1))});
  double largest = 0.;
  for(const Vertex v : mesh.vertices())
    if(const double s = length(mesh.point(v) - p); s < 6. * radius)
      test_support::raise_to(largest, std::abs(after[v].z() - gaussian(s, radius)));
  BOOST_TEST(largest < 1e-12);
}

BOOST_AUTO_TEST_CASE(scaling_and_rotation_are_felt_in_parts)
{
  const Mesh mesh = build_mesh<Mesh>(test_support::plane(1., 30, .2, 5));
  const Vertex source = vertex_at(mesh, 0., 0., 0.);
  const double radius = .3, factor = 1.7, angle = 1.1;
  const Point_3 center(.05, .02, -.1);
  const Points scaled = deformed(mesh, {Handle::scaling({source}, radius, center, factor)});
  const Points turned =
      deformed(mesh, {Handle::rotating({source}, radius, center, Vector_3(0, 0, 5), angle)});
  for(const Vertex v : mesh.vertices())
  {
    const Vector_3 arm = mesh.point(v) - center;
    const double s = length(mesh.point(v) - mesh.point(source));
    const double t = s <= 6. * radius ? gaussian(s, radius) : 0.;
    BOOST_TEST(length(scaled[v] - (center + (1. + t * (factor - 1.)) * arm)) < 1e-12);
    const double c = std::cos(t * angle), n = std::sin(t * angle);
    const Point_3 expected = center + Vector_3(c * arm.x() - n * arm.y(), n * arm.x() + c * arm.y(), arm.z());
    BOOST_TEST(length(turned[v] - expected) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(all_of_a_motion)
{
  // one handle of a single point with everything at once: scaled and turned about the center, then displaced
  const Mesh mesh = build_mesh<Mesh>(test_support::plane(1., 10));
  const Vertex source = vertex_at(mesh, .4, .2, 0.);
  Handle handle = Handle::scaling({source}, .3, Point_3(0, 0, 0), 2.);
  handle.axis = Vector_3(0, 0, 1);
  handle.angle = std::acos(0.); // a right angle
  handle.displacement = Vector_3(.1, 0., .5);
  const Points after = deformed(mesh, {handle});
  const Point_3 p = mesh.point(source);
  BOOST_TEST(length(after[source] - Point_3(-2. * p.y() + .1, 2. * p.x(), .5)) < 1e-12);
}

BOOST_AUTO_TEST_CASE(distances_are_exact_on_what_unfolds)
{
  // a plane folded by 70 degrees along x = 0, and wound up
  const double fold = 1.2;
  const auto flat = test_support::plane(1., 30);
  for(const bool is_folded : {true, false})
  {
    auto surface = flat;
    for(auto& p : surface.points)
      if(is_folded && p[0] > 0.)
        p = {p[0] * std::cos(fold), p[1], p[0] * std::sin(fold)};
      else if(!is_folded)
      {
        // one strip of quadrilaterals after the other, each turned against the last
        const double width = 2. / 30., turn = .15;
        const int strips = int(std::lround((p[0] + 1.) / width));
        double x = 0., z = 0.;
        for(int k = 0; k < strips; ++k)
        {
          x += width * std::cos(k * turn);
          z += width * std::sin(k * turn);
        }
        p = {x, p[1], z};
      }
    const Mesh mesh = build_mesh<Mesh>(surface);
    const Vertex source(std::uint32_t(flat.points.size() / 2 + 4));
    const std::vector<double> distances = distances_of(mesh, source, .4);
    for(const Vertex v : mesh.vertices())
    {
      const double expected =
          benchmark_support::length(flat.points[std::size_t(v)] - flat.points[std::size_t(source)]);
      if(v != source && expected < 1.6) // beyond, logarithms lose their digits
        BOOST_TEST(std::abs(distances[v] - expected) < 1e-6 * expected);
    }
  }
}

BOOST_AUTO_TEST_CASE(distances_are_near_those_of_shortest_paths)
{
  // CGAL's exact shortest paths as the oracle
  using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
  const auto surfaces = {test_support::ellipsoid(1., .7, .4, 3, .2, 2),
                         test_support::waves(.12, 5., 1., 24, .2)};
  for(const auto& surface : surfaces)
  {
    Mesh mesh = build_mesh<Mesh>(surface);
    const Vertex source(100);
    CGAL::Surface_mesh_shortest_path<Traits> paths(mesh);
    paths.add_source_point(source);
    const std::vector<double> distances = distances_of(mesh, source, .5);
    double sum = 0.;
    std::size_t count = 0;
    for(const Vertex v : mesh.vertices())
    {
      const double exact = paths.shortest_distance_to_source_points(v).first;
      if(v == source || exact > 2.)
        continue;
      BOOST_TEST(distances[v] < 1.02 * exact);
      BOOST_TEST(distances[v] > .98 * exact);
      sum += std::abs(distances[v] / exact - 1.);
      ++count;
    }
    BOOST_TEST(sum / double(count) < .006);
  }
}

BOOST_AUTO_TEST_CASE(gaps_are_gone_around)
{
  const Mesh mesh = plane_with_slit();
  const Vertex source = vertex_at(mesh, -.25, -.5, 0.);
  const std::vector<double> distances = distances_of(mesh, source, .4);
  const Point_3 end(0, 0, 0);
  std::size_t across = 0;
  for(const Vertex v : mesh.vertices())
  {
    const Point_3 p = mesh.point(v);
    const double straight = length(p - mesh.point(source));
    // the straight way meets x = 0 at this height
    const double crossing = p.x() > 0. ? -.5 + (p.y() + .5) * .25 / (p.x() + .25) : 0.;
    const bool is_twin = std::abs(p.x()) < 1e-9 && p.y() < -1e-9 && distances[v] > 1.2 * straight;
    if(v == source || distances[v] > 1.6)
      continue;
    if(crossing >= 0. && !is_twin)
      BOOST_TEST(std::abs(distances[v] - straight) <
                 .005 * straight); // within sight of the slit's end not exact
    else
    {
      const double around = length(end - mesh.point(source)) + length(p - end);
      BOOST_TEST(distances[v] > .999 * around);
      BOOST_TEST(distances[v] < 1.04 * around);
      ++across;
    }
  }
  BOOST_TEST(across > 100U);
}

BOOST_AUTO_TEST_CASE(other_components_stay)
{
  Mesh mesh = build_mesh<Mesh>(test_support::two_sheets(.01));
  const Points before = points_of(mesh);
  const Vertex source = vertex_at(mesh, 0., 0., 0.);
  deform_by_handles(mesh, std::vector<Handle>{Handle::displacing({source}, .3, Vector_3(0, 0, 1))});
  std::size_t moved = 0;
  for(const Vertex v : mesh.vertices())
    if(std::abs(before[v].z() - before[source].z()) > .005)
      BOOST_TEST(mesh.point(v) == before[v]);
    else
      moved += mesh.point(v) == before[v] ? 0 : 1;
  BOOST_TEST(moved > 100U);
}

BOOST_AUTO_TEST_CASE(several_handles)
{
  const Mesh mesh = build_mesh<Mesh>(test_support::waves(.1, 4., 1., 40, .1));
  const Vertex a = vertex_at(mesh, -.2, 0., 0.), b = vertex_at(mesh, .1, .1, 0.),
               c = vertex_at(mesh, .1, -.3, 0.);
  const Vector_3 da(0, .1, .3), db(.2, 0, -.2);
  const std::vector<Handle> handles = {Handle::displacing({a}, .3, da), Handle::displacing({b}, .2, db),
                                       Handle::holding({c}, .1)};
  const Points after = deformed(mesh, handles);
  // each goes where it is told to, however near the others
  BOOST_TEST(length(after[a] - mesh.point(a) - da) < 1e-15);
  BOOST_TEST(length(after[b] - mesh.point(b) - db) < 1e-15);
  BOOST_TEST(length(after[c] - mesh.point(c)) < 1e-15);

  // in any order
  const Points other = deformed(mesh, {handles[2], handles[1], handles[0]});
  BOOST_TEST(largest_difference(after, other) < 1e-14);

  // no vertex moves farther than the farthest handle
  for(const Vertex v : mesh.vertices())
    BOOST_TEST(length(after[v] - mesh.point(v)) <= length(da));

  // two handles of one motion are one with two points
  const Points two = deformed(mesh, {Handle::displacing({a}, .3, da), Handle::displacing({b}, .3, da)});
  const Points one = deformed(mesh, {Handle::displacing({a, b}, .3, da)});
  BOOST_TEST(largest_difference(one, two) < 1e-14);
  // whose parts of the motion are 1 - (1 - g)(1 - h)
  const Points only_a = deformed(mesh, {Handle::displacing({a}, .3, da)}),
               only_b = deformed(mesh, {Handle::displacing({b}, .3, da)});
  for(const Vertex v : mesh.vertices())
  {
    const double g = (only_a[v] - mesh.point(v)).z() / .3, h = (only_b[v] - mesh.point(v)).z() / .3;
    BOOST_TEST(std::abs((one[v] - mesh.point(v)).z() / .3 - (g + h - g * h)) < 1e-12);
  }

  // as many points as there are: what 1 - t is of them is too small for a number
  std::vector<Handle::Surface_point> all;
  for(const Vertex v : mesh.vertices())
    if(length(mesh.point(v) - mesh.point(a)) < .3)
      all.push_back(v);
  BOOST_REQUIRE(all.size() > 100u);
  const Points of_many = deformed(mesh, {Handle::displacing(all, .6, da)});
  for(const Vertex v : mesh.vertices())
  {
    const double s = length(mesh.point(v) - mesh.point(a));
    if(s < .32)
      BOOST_TEST(length(of_many[v] - mesh.point(v) - da) < 1e-9, "vertex " << v);
    else
      BOOST_TEST(length(of_many[v] - mesh.point(v)) <= length(da) * (1. + 1e-12), "vertex " << v);
  }

  // one vertex of two handles goes to the mean
  const Points torn = deformed(mesh, {Handle::displacing({a}, .3, da), Handle::displacing({a}, .1, db)});
  BOOST_TEST(length(torn[a] - mesh.point(a) - (da + db) / 2.) < 1e-15);
}

BOOST_AUTO_TEST_CASE(units_and_poses_do_not_matter)
{
  const Mesh mesh = build_mesh<Mesh>(test_support::waves(.1, 4., 1., 30, .2));
  const Vertex a = vertex_at(mesh, -.3, .1, 0.), b = vertex_at(mesh, .2, 0., 0.);
  const auto handles = [&](const CGAL::Aff_transformation_3<Kernel>& m, double scale)
  {
    return std::vector<Handle>{
        Handle::displacing({a}, .2 * scale, m.transform(Vector_3(.1, .2, .3))),
        Handle::rotating({b}, .15 * scale, m.transform(mesh.point(b)), m.transform(Vector_3(1, 1, 0)), .8)};
  };
  const Points reference = deformed(mesh, handles(CGAL::Aff_transformation_3<Kernel>(CGAL::IDENTITY), 1.));
  const double c = .6, s = .8;
  for(const double scale : {1e-6, 1., 1e6})
    for(const double offset : {0., 1e7})
    {
      const CGAL::Aff_transformation_3<Kernel> m(scale * c, -scale * s, 0, offset * scale, scale * s,
                                                 scale * c, 0, -offset * scale, 0, 0, scale, 0);
      Mesh moved = mesh;
      CGAL::Polygon_mesh_processing::transform(m, moved);
      const Points after = deformed(moved, handles(m, scale));
      double largest = 0.;
      for(const Vertex v : mesh.vertices())
        test_support::raise_to(largest, length(after[v] - m.transform(reference[v])) / scale);
      BOOST_TEST(largest < (offset == 0. ? 1e-10 : 1e-6));
    }
}

BOOST_AUTO_TEST_CASE(all_meshes_and_maps)
{
  const auto surface = test_support::waves(.1, 4., 1., 20, .2);
  Mesh mesh = build_mesh<Mesh>(surface);
  const Vertex a(200);
  const auto handles = std::vector<Handle>{Handle::displacing({a}, .2, Vector_3(.1, .2, .3))};
  const Points expected = deformed(mesh, handles);

  // out of place: the mesh may be const
  const Points before = points_of(mesh);
  auto out = mesh.add_property_map<Vertex, Point_3>("v:out").first;
  const Mesh& constant = mesh;
  const std::size_t moved =
      deform_by_handles(constant, handles, SC::parameters::deformed_vertex_point_map(out));
  BOOST_TEST(largest_difference(points_of(mesh), before) == 0.);
  std::size_t different = 0;
  for(const Vertex v : mesh.vertices())
  {
    BOOST_TEST(out[v] == expected[v]);
    different += out[v] == before[v] ? 0 : 1;
  }
  BOOST_TEST(moved == different);
  BOOST_TEST(moved > 100U);

  // another map to read from, and to write to
  auto other = mesh.add_property_map<Vertex, Point_3>("v:other").first;
  for(const Vertex v : mesh.vertices())
  {
    other[v] = before[v];
    mesh.point(v) = Point_3(0, 0, 0);
  }
  deform_by_handles(mesh, handles, CGAL::parameters::vertex_point_map(other));
  for(const Vertex v : mesh.vertices())
    BOOST_TEST(other[v] == expected[v]);

  // a polyhedron, whose vertices have no numbers: the same bits
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  using Polyhedron_handle = SC::Surface_handle<Polyhedron>;
  Polyhedron polyhedron = build_mesh<Polyhedron>(surface);
  const auto source = std::next(polyhedron.vertices_begin(), 200);
  deform_by_handles(polyhedron, std::vector<Polyhedron_handle>{
                                    Polyhedron_handle::displacing({source}, .2, Vector_3(.1, .2, .3))});
  std::size_t i = 0;
  for(auto v = polyhedron.vertices_begin(); v != polyhedron.vertices_end(); ++v)
    BOOST_TEST(v->point() == expected[i++]);
}

BOOST_AUTO_TEST_CASE(faces_of_many_corners)
{
  // a plane of quadrilaterals is as exact as one of triangles
  Mesh mesh;
  const int n = 20;
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j <= n; ++j)
      mesh.add_vertex(Point_3(i, j, 0));
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
    {
      const auto at = [&](int k, int l) { return Vertex(std::uint32_t(k * (n + 1) + l)); };
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    }
  const Vertex source = vertex_at(mesh, 9, 11, 0);
  const Points after = deformed(mesh, {Handle::displacing({source}, 3., Vector_3(0, 0, 1))});
  for(const Vertex v : mesh.vertices())
    BOOST_TEST(std::abs(after[v].z() - gaussian(length(mesh.point(v) - mesh.point(source)), 3.)) < 1e-12);
}

BOOST_AUTO_TEST_CASE(bad_handles_are_refused)
{
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  Mesh mesh = build_mesh<Mesh>(test_support::plane(1., 6));
  const Points before = points_of(mesh);
  const Vertex a(10);
  const Vector_3 d(0, 0, 1);
  const auto refused = [&](const Handle& handle)
  {
    BOOST_CHECK_THROW(deform_by_handles(mesh, std::vector<Handle>{handle}), std::invalid_argument);
    BOOST_TEST(largest_difference(points_of(mesh), before) == 0.);
  };
  refused(Handle::displacing({}, 1., d));
  refused(Handle::displacing({a}, 0., d));
  refused(Handle::displacing({a}, -1., d));
  refused(Handle::displacing({a}, nan, d));
  refused(Handle::displacing({a}, infinity, d));
  refused(Handle::displacing({a}, 1., Vector_3(0, nan, 0)));
  refused(Handle::displacing({{a, Point_3(0, infinity, 0)}}, 1., d));
  refused(Handle::displacing({Mesh::null_vertex()}, 1., d));
  refused(Handle::displacing({Vertex(1000)}, 1., d));
  refused(Handle::scaling({a}, 1., Point_3(0, 0, 0), 0.));
  refused(Handle::scaling({a}, 1., Point_3(0, 0, 0), nan));
  refused(Handle::scaling({a}, 1., Point_3(nan, 0, 0), 2.));
  refused(Handle::rotating({a}, 1., Point_3(0, 0, 0), Vector_3(0, 0, 0), 1.));
  refused(Handle::rotating({a}, 1., Point_3(0, 0, 0), Vector_3(0, 0, 1), nan));
  // no handles, no motion
  BOOST_TEST(deform_by_handles(mesh, std::vector<Handle>()) == 0U);
  BOOST_TEST(largest_difference(points_of(mesh), before) == 0.);
  // one that holds alone moves nothing
  BOOST_TEST(deform_by_handles(mesh, std::vector<Handle>{Handle::holding({a}, 1.)}) == 0U);
}

BOOST_AUTO_TEST_CASE(bad_meshes)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  {
    Mesh empty;
    BOOST_TEST(deform_by_handles(empty, std::vector<Handle>()) == 0U);
    BOOST_CHECK_THROW(
        deform_by_handles(empty, std::vector<Handle>{Handle::displacing({Vertex(0)}, 1., Vector_3(0, 0, 1))}),
        std::invalid_argument);
  }
  {
    // a point that isn't finite: it stays, is no handle, and the ways lead around it
    Mesh mesh = build_mesh<Mesh>(test_support::plane(1., 20));
    const Points before = points_of(mesh);
    const Vertex hole = vertex_at(mesh, .2, .2, 0.), source = vertex_at(mesh, 0., 0., 0.);
    mesh.point(hole) = Point_3(nan, 0, 0);
    BOOST_CHECK_THROW(
        deform_by_handles(mesh, std::vector<Handle>{Handle::displacing({hole}, 1., Vector_3(0, 0, 1))}),
        std::invalid_argument);
    deform_by_handles(mesh, std::vector<Handle>{Handle::displacing({source}, .3, Vector_3(0, 0, 1))});
    for(const Vertex v : mesh.vertices())
      if(v != hole)
      {
        const double g = gaussian(length(before[v] - before[source]), .3);
        BOOST_TEST(mesh.point(v).z() <= g + 1e-12);
        BOOST_TEST(mesh.point(v).z() >= .8 * g - .05);
      }
    BOOST_TEST(std::isnan(mesh.point(hole).x()));
  }
  {
    // vertices without faces
    Mesh mesh = build_mesh<Mesh>(test_support::plane(1., 6));
    const Vertex alone = mesh.add_vertex(Point_3(0, 0, .01));
    BOOST_CHECK_THROW(
        deform_by_handles(mesh, std::vector<Handle>{Handle::displacing({alone}, 1., Vector_3(0, 0, 1))}),
        std::invalid_argument);
    deform_by_handles(mesh, std::vector<Handle>{Handle::displacing({Vertex(24)}, 1., Vector_3(0, 0, 1))});
    BOOST_TEST(mesh.point(alone) == Point_3(0, 0, .01));
  }
  // whatever else meshes may be: all stays finite, and the handle goes where it is told to
  for(const auto& bad : test_support::all_bad_triangle_meshes())
  {
    Mesh mesh = build_mesh<Mesh>(bad);
    const Points before = points_of(mesh);
    const auto v = std::find_if(mesh.vertices().begin(), mesh.vertices().end(),
                                [&](Vertex w) { return mesh.halfedge(w) != Mesh::null_halfedge(); });
    if(v == mesh.vertices().end())
      continue;
    BOOST_TEST_CONTEXT(bad.name)
    {
      deform_by_handles(mesh, std::vector<Handle>{Handle::displacing({*v}, .5, Vector_3(0, 0, 1))});
      BOOST_TEST(length(mesh.point(*v) - before[*v] - Vector_3(0, 0, 1)) < 1e-12);
      for(const Vertex w : mesh.vertices())
      {
        const double g = (mesh.point(w) - before[w]).z();
        BOOST_TEST((g >= 0. && g <= 1. + 1e-12));
        // a way over the surface is not shorter than the straight one
        if(g > 1e-7)
          BOOST_TEST(g <= gaussian(length(before[w] - before[*v]), .5) + 1e-6);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
