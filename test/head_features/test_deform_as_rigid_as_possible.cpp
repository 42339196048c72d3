#include <boost/test/unit_test.hpp>

#include "bad_meshes.h"
#include "handles_on_surfaces.h"
#include "raise_to.h"

#include <Shape_characteristics/head_features/deform_as_rigid_as_possible.h>

#include <CGAL/Polygon_mesh_processing/transform.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(deform_as_rigid_as_possible)

using namespace handles_on_surfaces;
using SC::deform_as_rigid_as_possible;
using test_support::build_mesh;

namespace {

Points deformed(const Mesh& mesh, const std::vector<Handle>& handles, unsigned int iterations = 20)
{
  Mesh copy = mesh;
  deform_as_rigid_as_possible(copy, handles, SC::parameters::number_of_iterations(iterations));
  return points_of(copy);
}

} // namespace

BOOST_AUTO_TEST_CASE(what_handles_hold_goes_with_them_and_what_is_far_stays)
{
  const Mesh mesh = build_mesh<Mesh>(test_support::plane(1., 40, .2, 3));
  const Vertex source = vertex_at(mesh, .1, -.1, 0.);
  const double radius = .2;
  const Vector_3 d(0, .1, .3);
  const Points after = deformed(mesh, {Handle::displacing({source}, radius, d)});
  double previous = std::numeric_limits<double>::infinity();
  for(const double s : {.1, .25, .4, .55})
  {
    // rises towards the handle
    const Vertex v = vertex_at(mesh, .1 + s, -.1, 0.);
    BOOST_TEST(after[v].z() < previous + 1e-12);
    BOOST_TEST(after[v].z() >= -1e-3);
    previous = after[v].z();
  }
  for(const Vertex v : mesh.vertices())
  {
    const double s = length(mesh.point(v) - mesh.point(source));
    if(s <= .499 * radius)
      BOOST_TEST(length(after[v] - mesh.point(v) - d) < 1e-12);
    else if(s > 3.001 * radius)
      BOOST_TEST(after[v] == mesh.point(v));
  }
}

// Handles with points far inside of faces take the vertices of those faces along, each its own.
BOOST_AUTO_TEST_CASE(coarse_meshes)
{
  const Mesh mesh = build_mesh<Mesh>(test_support::plane(10., 10));
  std::vector<Handle> handles;
  std::vector<Vertex> held;
  for(const double x : {-6., 6.})
  {
    const Vertex v = vertex_at(mesh, x, 0., 0.);
    held.push_back(v);
    const Vector_3 d(0, 0, x / 2.);
    handles.push_back(
        Handle::displacing({Handle::Surface_point(v, mesh.point(v) + Vector_3(.5, .2, 0))}, .05, d));
  }
  const Points after = deformed(mesh, handles);
  for(const Vertex v : held)
    BOOST_TEST(length(after[v] - mesh.point(v) - Vector_3(0, 0, mesh.point(v).x() / 2.)) < 1e-12);
}

BOOST_AUTO_TEST_CASE(a_rigid_motion_of_all_is_found)
{
  // three handles turn a surface that they don't hold elsewhere: everything turns, nothing is strained
  const Mesh mesh = build_mesh<Mesh>(test_support::waves(.1, 4., .5, 16, .1));
  const Vector_3 axis(1, 2, 3);
  const double angle = .5;
  const Point_3 center(.1, .2, .3);
  std::vector<Handle> handles;
  for(const auto& [x, y] : {std::pair<double, double>(-.4, -.4), {.4, -.3}, {0., .4}})
    handles.push_back(Handle::rotating({vertex_at(mesh, x, y, 0.)}, .5, center, axis, angle));
  const Points after = deformed(mesh, handles, 200);
  // the rotation, by the formula of Rodrigues
  const Vector_3 u = axis / std::sqrt(axis.squared_length());
  double largest = 0.;
  for(const Vertex v : mesh.vertices())
  {
    const Vector_3 a = mesh.point(v) - center;
    const Vector_3 turned = std::cos(angle) * a + std::sin(angle) * CGAL::cross_product(u, a) +
                            (1. - std::cos(angle)) * CGAL::scalar_product(u, a) * u;
    test_support::raise_to(largest, length(after[v] - (center + turned)));
  }
  BOOST_TEST(largest < 1e-3);
}

BOOST_AUTO_TEST_CASE(units_and_places_do_not_matter)
{
  const Mesh mesh = build_mesh<Mesh>(test_support::waves(.1, 4., 1., 20, .2));
  const Vertex a = vertex_at(mesh, -.3, .1, 0.), b = vertex_at(mesh, .3, 0., 0.);
  const auto handles = [&](double scale)
  {
    return std::vector<Handle>{Handle::displacing({a}, .2 * scale, scale * Vector_3(.1, .2, .3)),
                               Handle::holding({b}, .15 * scale)};
  };
  const Points reference = deformed(mesh, handles(1.));
  for(const double scale : {1e-6, 1e6})
  {
    const CGAL::Aff_transformation_3<Kernel> m(scale, 0, 0, 10. * scale, 0, scale, 0, -20. * scale, 0, 0,
                                               scale, 0);
    Mesh moved = mesh;
    CGAL::Polygon_mesh_processing::transform(m, moved);
    const Points after = deformed(moved, handles(scale));
    double largest = 0.;
    for(const Vertex v : mesh.vertices())
      test_support::raise_to(largest, length(after[v] - m.transform(reference[v])) / scale);
    BOOST_TEST(largest < 1e-7);
  }
}

BOOST_AUTO_TEST_CASE(other_meshes_and_maps)
{
  const auto surface = test_support::waves(.1, 4., 1., 16, .2);
  Mesh mesh = build_mesh<Mesh>(surface);
  const auto handles = std::vector<Handle>{Handle::displacing({Vertex(120)}, .3, Vector_3(.1, .2, .3))};
  const Points expected = deformed(mesh, handles), before = points_of(mesh);

  auto out = mesh.add_property_map<Vertex, Point_3>("v:out").first;
  const Mesh& constant = mesh;
  const std::size_t moved =
      deform_as_rigid_as_possible(constant, handles, SC::parameters::deformed_vertex_point_map(out));
  BOOST_TEST(moved > 20U);
  BOOST_TEST(largest_difference(points_of(mesh), before) == 0.);
  for(const Vertex v : mesh.vertices())
    BOOST_TEST(out[v] == expected[v]);

  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  using Polyhedron_handle = SC::Surface_handle<Polyhedron>;
  Polyhedron polyhedron = build_mesh<Polyhedron>(surface);
  const auto source = std::next(polyhedron.vertices_begin(), 120);
  deform_as_rigid_as_possible(polyhedron, std::vector<Polyhedron_handle>{Polyhedron_handle::displacing(
                                              {source}, .3, Vector_3(.1, .2, .3))});
  std::size_t i = 0;
  for(auto v = polyhedron.vertices_begin(); v != polyhedron.vertices_end(); ++v)
    BOOST_TEST(length(v->point() - expected[i++]) < 1e-9); // the order of the edges differs, and sums with it
}

BOOST_AUTO_TEST_CASE(bad_inputs)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Mesh mesh = build_mesh<Mesh>(test_support::plane(1., 12));
  const Points before = points_of(mesh);
  const auto refused = [&](Mesh& m, const Handle& handle)
  { BOOST_CHECK_THROW(deform_as_rigid_as_possible(m, std::vector<Handle>{handle}), std::invalid_argument); };
  refused(mesh, Handle::displacing({Vertex(10)}, nan, Vector_3(0, 0, 1)));
  refused(mesh, Handle::displacing({}, 1., Vector_3(0, 0, 1)));
  BOOST_CHECK_THROW(
      deform_as_rigid_as_possible(mesh, std::vector<Handle>(), SC::parameters::number_of_iterations(0)),
      std::invalid_argument);
  BOOST_TEST(deform_as_rigid_as_possible(mesh, std::vector<Handle>()) == 0U);
  BOOST_TEST(largest_difference(points_of(mesh), before) == 0.);

  Mesh quads = build_mesh<Mesh>(test_support::cube_of_quads());
  refused(quads, Handle::displacing({Vertex(0)}, 1., Vector_3(0, 0, 1)));
  std::size_t flat = 0;
  Mesh degenerate = build_mesh<Mesh>(test_support::zero_area_triangles(&flat));
  refused(degenerate, Handle::displacing({Vertex(std::uint32_t(flat))}, .5, Vector_3(0, 0, 1)));

  // vertices without faces, and points that aren't finite, far away do no harm
  const Vertex alone = mesh.add_vertex(Point_3(0, 0, .01));
  mesh.point(Vertex(0)) = Point_3(nan, 0, 0);
  const Vertex source = vertex_at(mesh, .4, .4, 0.);
  deform_as_rigid_as_possible(mesh,
                              std::vector<Handle>{Handle::displacing({source}, .15, Vector_3(0, 0, .2))});
  BOOST_TEST(mesh.point(alone) == Point_3(0, 0, .01));
  for(const Vertex v : mesh.vertices())
    if(v != Vertex(0))
      BOOST_TEST(std::isfinite(mesh.point(v).z()));
  BOOST_TEST(std::abs(mesh.point(source).z() - .2) < 1e-12);
}

BOOST_AUTO_TEST_SUITE_END()
