#include <boost/test/unit_test.hpp>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Shape_characteristics/normals/vertex_normals.h>

#include "analytic_surfaces.h"
#include "bad_meshes.h"
#include "build_mesh.h"
#include "raise_to.h"

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(vertex_normals)

namespace SC = Shape_characteristics;
using namespace test_support;
using SC::Normal_weighting;
using S = SC::Estimation_status;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Polyhedron_with_ids = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;

namespace {

const std::vector<Normal_weighting> all_weightings = {Normal_weighting::AVERAGE, Normal_weighting::MAX,
                                                      Normal_weighting::AREA, Normal_weighting::ANGLE};

struct Answer
{
  std::vector<Vector> normals;
  std::vector<S> status;
  std::size_t failures = 0;
};

template <typename FaceGraph>
Answer normals_of(const FaceGraph& mesh, Normal_weighting weighting)
{
  const auto normals = get(CGAL::dynamic_vertex_property_t<Kernel::Vector_3>(), mesh);
  const auto status = get(CGAL::dynamic_vertex_property_t<S>(), mesh);
  Answer answer;
  answer.failures = SC::vertex_normals(mesh, normals,
                                       SC::parameters::normal_weighting(weighting).vertex_status_map(status));
  for(const auto v : vertices(mesh))
  {
    const Kernel::Vector_3 n = get(normals, v);
    answer.normals.push_back({n.x(), n.y(), n.z()});
    answer.status.push_back(get(status, v));
  }
  return answer;
}

Polygon_arrays arrays(const Analytic_surface& s)
{
  return test_support::polygons_of(s.name, s);
}

Polygon_arrays scaled(Polygon_arrays a, double factor)
{
  for(Vector& p : a.points)
    p = factor * p;
  return a;
}

// The formulas as they are printed: of each triangle at the vertex the unit normal, times 1, sin(angle) / (|e1| |e2|), area
// or angle, all from Heron's formula and the law of cosines.
Vector plain_normal(const Polygon_arrays& a, std::size_t vertex, Normal_weighting weighting)
{
  Vector sum;
  for(const auto& f : a.faces)
    for(std::size_t k = 0; k < 3; ++k)
      if(f[k] == vertex)
      {
        const Vector &p = a.points[f[0]], &q = a.points[f[1]], &r = a.points[f[2]];
        const Vector normal = normalized(cross(q - p, r - q));
        const double e1 = length(a.points[f[(k + 1) % 3]] - a.points[vertex]);
        const double e2 = length(a.points[f[(k + 2) % 3]] - a.points[vertex]);
        const double opposite = length(a.points[f[(k + 1) % 3]] - a.points[f[(k + 2) % 3]]);
        const double s = (e1 + e2 + opposite) / 2.;
        const double area = std::sqrt(s * (s - e1) * (s - e2) * (s - opposite));
        const double angle = std::acos((e1 * e1 + e2 * e2 - opposite * opposite) / (2. * e1 * e2));
        double weight = 1.;
        if(weighting == Normal_weighting::MAX)
          weight = std::sin(angle) / (e1 * e2);
        else if(weighting == Normal_weighting::AREA)
          weight = area;
        else if(weighting == Normal_weighting::ANGLE)
          weight = angle;
        sum = sum + weight * normal;
      }
  return normalized(sum);
}

} // namespace

BOOST_AUTO_TEST_CASE(plain_formulas)
{
  for(const Analytic_surface& surface : {waves(.1, 4., 1., 10, .2), torus(1., .4, 20, 12, .2)})
  {
    const Polygon_arrays a = arrays(surface);
    const Mesh mesh = build_mesh<Mesh>(a);
    for(const Normal_weighting weighting : all_weightings)
      BOOST_TEST_CONTEXT(surface.name << ", weighting " << int(weighting))
      {
        const Answer answer = normals_of(mesh, weighting);
        BOOST_TEST(answer.failures == 0u);
        for(std::size_t i = 0; i < a.points.size(); ++i)
        {
          BOOST_TEST(length(answer.normals[i] - plain_normal(a, i, weighting)) < 1e-12, "vertex " << i);
          BOOST_TEST((answer.status[i] == (surface.exact[i].border ? S::BORDER : S::ESTIMATED)));
        }
      }
  }
}

// Corners of concave faces turn the other way; what they count doesn't.
BOOST_AUTO_TEST_CASE(concave_faces)
{
  // an L, flat and as the top and the bottom of a prism
  const std::vector<Vector> corners = {{0., 0., 0.}, {2., 0., 0.}, {2., 1., 0.},
                                       {1., 1., 0.}, {1., 2., 0.}, {0., 2., 0.}};
  const std::size_t n = corners.size(), reflex = 3;
  Polygon_arrays flat, prism;
  flat.points = prism.points = corners;
  flat.faces = {{0, 1, 2, 3, 4, 5}};
  prism.faces = {{5, 4, 3, 2, 1, 0}, {6, 7, 8, 9, 10, 11}};
  for(std::size_t k = 0; k < n; ++k)
  {
    prism.points.push_back(corners[k] + Vector{0., 0., 1.});
    prism.faces.push_back({k, (k + 1) % n, (k + 1) % n + n, k + n});
  }
  for(const double scale : {1., 1e-80}) // there is a shorter way for usual lengths
    for(const Normal_weighting weighting : all_weightings)
      BOOST_TEST_CONTEXT("scale " << scale << ", weighting " << int(weighting))
      {
        const Answer of_flat = normals_of(build_mesh<Mesh>(scaled(flat, scale)), weighting);
        for(const Vector& normal : of_flat.normals)
          BOOST_TEST(length(normal - Vector{0., 0., 1.}) < 1e-15);
        const Answer of_prism = normals_of(build_mesh<Mesh>(scaled(prism, scale)), weighting);
        Vector expected = {1., 1., 1.}; // the edges there have the length 1
        if(weighting == Normal_weighting::ANGLE)
          expected = {1., 1., 3.};
        else if(weighting == Normal_weighting::AREA)
          expected = {1., 1., 3.};
        BOOST_TEST(length(of_prism.normals[reflex + n] - normalized(expected)) < 1e-14);
      }
}

// Max's weights are exact where a vertex and its neighbors lie on a sphere, however irregularly; the others aren't.
BOOST_AUTO_TEST_CASE(max_is_exact_on_spheres)
{
  const Analytic_surface surface = sphere(3., 2, .2);
  const Mesh mesh = build_mesh<Mesh>(surface);
  for(const Normal_weighting weighting : all_weightings)
  {
    const Answer answer = normals_of(mesh, weighting);
    double worst = 0.;
    for(std::size_t i = 0; i < surface.points.size(); ++i)
      test_support::raise_to(worst, length(answer.normals[i] - surface.exact[i].normal));
    if(weighting == Normal_weighting::MAX)
      BOOST_TEST(worst < 1e-14);
    else
      BOOST_TEST(worst > 1e-4);
  }
}

BOOST_AUTO_TEST_CASE(all_are_exact_on_planes)
{
  Polygon_arrays a = arrays(plane(1., 8, .2));
  for(Vector& p : a.points)
    p = Vector{p.x + 2., .6 * p.y, .8 * p.y - 1.};
  const Mesh mesh = build_mesh<Mesh>(a);
  for(const Normal_weighting weighting : all_weightings)
    for(const Vector& n : normals_of(mesh, weighting).normals)
      BOOST_TEST(length(n - Vector{0., -.8, .6}) < 1e-14);
}

// Of a cube of quadrilaterals all weights of a corner are equal, and of a prism with n-gons those of a wall are.
BOOST_AUTO_TEST_CASE(polygons)
{
  const Polygon_arrays cube = cube_of_quads(), prism = prism_of_polygons();
  const Mesh cube_mesh = build_mesh<Mesh>(cube), prism_mesh = build_mesh<Mesh>(prism);
  for(const Normal_weighting weighting : all_weightings)
  {
    const Answer of_cube = normals_of(cube_mesh, weighting), of_prism = normals_of(prism_mesh, weighting);
    for(std::size_t i = 0; i < cube.points.size(); ++i)
      BOOST_TEST(length(of_cube.normals[i] - normalized(cube.points[i])) < 1e-15);
    for(std::size_t i = 0; i < prism.points.size(); ++i)
    {
      const Vector &p = prism.points[i], &n = of_prism.normals[i];
      // of the two walls at an edge, with angle pi / 6 to the edge's direction, and the hexagon
      double wall = 1., hexagon = 1.;
      if(weighting == Normal_weighting::MAX)
      {
        wall = 1. / 2.; // sin(pi / 2) / (1 2)
        hexagon = std::sin(2. * CGAL_PI / 3.);
      }
      else if(weighting == Normal_weighting::AREA)
      {
        wall = 2.;
        hexagon = 1.5 * std::sqrt(3.);
      }
      else if(weighting == Normal_weighting::ANGLE)
      {
        wall = CGAL_PI / 2.;
        hexagon = 2. * CGAL_PI / 3.;
      }
      const double out = 2. * wall * std::cos(CGAL_PI / 6.);
      BOOST_TEST(length(n - normalized(Vector{out * p.x, out * p.y, hexagon * p.z})) < 1e-14);
    }
  }
}

// A face without area has no normal and no weight.
BOOST_AUTO_TEST_CASE(degenerate_faces_are_ignored)
{
  // three triangles of a corner; the fourth, of vertices 0, 3, 4, lies on a line
  Polygon_arrays a{"corner", {{.1, .2, .3}, {1.1, .2, .3}, {.1, 1.3, .3}, {.1, .2, 1.5}, {.1, .2, 1.1}}, {}};
  a.faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
  Polygon_arrays without = a;
  without.faces = {{0, 1, 2}, {0, 2, 3}, {0, 4, 1}};
  const Mesh mesh = build_mesh<Mesh>(a), clean = build_mesh<Mesh>(without);
  for(const Normal_weighting weighting : all_weightings)
  {
    const Answer with = normals_of(mesh, weighting), expected = normals_of(clean, weighting);
    BOOST_TEST(with.failures == 0u);
    for(std::size_t i = 0; i < a.points.size(); ++i)
      BOOST_TEST(length(with.normals[i] - expected.normals[i]) < 1e-14, "vertex " << i);
  }
  // a vertex on its neighbor
  std::size_t vertex = 0;
  const Polygon_arrays zero = zero_area_triangles(&vertex);
  const Mesh zero_mesh = build_mesh<Mesh>(zero);
  for(const Normal_weighting weighting : all_weightings)
  {
    const Answer answer = normals_of(zero_mesh, weighting);
    BOOST_TEST(answer.failures == 0u);
    BOOST_TEST(answer.normals[vertex].z > .5);
  }
}

// Rounding errors are no normals: faces on a line that isn't an axis, and faces that cancel, wherever they lie.
BOOST_AUTO_TEST_CASE(no_normal)
{
  Polygon_arrays line = arrays(plane(1., 5, .2));
  for(Vector& p : line.points)
    p = (p.x + .3 * p.y) * Vector{.31, -.77, .55} + Vector{.1, .7, .3};
  Polygon_arrays pillow{"pillow", {{.1, .2, .3}, {1.3, .7, .1}, {.4, 1.9, .8}}, {{0, 1, 2}, {0, 2, 1}}};
  // two sides with different diagonals, far from the origin
  Polygon_arrays envelope{"envelope",
                          {{1000.1, .2, .3}, {1001.3, .7, .3}, {1001.7, 1.9, .3}, {1000.3, 1.1, .3}},
                          {{0, 1, 2}, {0, 2, 3}, {1, 0, 3}, {1, 3, 2}}};
  for(const Polygon_arrays& a : {line, pillow})
  {
    const Mesh mesh = build_mesh<Mesh>(a);
    for(const Normal_weighting weighting : all_weightings)
      BOOST_TEST_CONTEXT(a.name << ", weighting " << int(weighting))
      {
        const Answer answer = normals_of(mesh, weighting);
        BOOST_TEST(answer.failures == a.points.size());
        for(std::size_t i = 0; i < a.points.size(); ++i)
        {
          BOOST_TEST((answer.status[i] == S::DEGENERATE));
          BOOST_TEST((std::isnan(answer.normals[i].x) && std::isnan(answer.normals[i].y) &&
                      std::isnan(answer.normals[i].z)));
        }
      }
  }
  // area and angle of both sides are the same; the number of faces and Max's weights aren't
  const Mesh mesh = build_mesh<Mesh>(envelope);
  for(const Normal_weighting weighting :
      {Normal_weighting::ANGLE, Normal_weighting::MAX, Normal_weighting::AREA})
  {
    const Answer answer = normals_of(mesh, weighting);
    for(std::size_t i = 0; i < envelope.points.size(); ++i)
      if(weighting == Normal_weighting::ANGLE)
        BOOST_TEST((answer.status[i] == S::DEGENERATE), "vertex " << i);
      else if(answer.status[i] == S::ESTIMATED)
        BOOST_TEST(std::abs(std::abs(answer.normals[i].z) - 1.) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(statuses)
{
  const double nan_value = std::numeric_limits<double>::quiet_NaN();
  Polygon_arrays a = arrays(plane(1., 4));
  const std::size_t bad = 2 * 5 + 2;
  a.points[bad] = {nan_value, 0., 0.};
  a.points.push_back({0., 0., 1.});
  const Mesh mesh = build_mesh<Mesh>(a);
  for(const Normal_weighting weighting : all_weightings)
  {
    const Answer answer = normals_of(mesh, weighting);
    BOOST_TEST(answer.failures == 2u);
    for(std::size_t i = 0; i < a.points.size(); ++i)
    {
      const bool border = i < 25 && (i % 5 == 0 || i % 5 == 4 || i / 5 == 0 || i / 5 == 4);
      const S expected = i == 25    ? S::UNREFERENCED
                         : i == bad ? S::NON_FINITE_INPUT
                         : border   ? S::BORDER
                                    : S::ESTIMATED;
      BOOST_TEST((answer.status[i] == expected), "vertex " << i);
      if(SC::is_estimated(expected))
        BOOST_TEST(length(answer.normals[i] - Vector{0., 0., 1.}) < 1e-15);
      else
        BOOST_TEST((std::isnan(answer.normals[i].x) && std::isnan(answer.normals[i].y) &&
                    std::isnan(answer.normals[i].z)));
    }
  }
  const Mesh empty;
  BOOST_TEST(normals_of(empty, Normal_weighting::MAX).failures == 0u);
}

BOOST_AUTO_TEST_CASE(scales)
{
  const Polygon_arrays a = arrays(waves(.1, 4., 1., 6, .2));
  const Mesh mesh = build_mesh<Mesh>(a);
  for(const double factor : {1e-100, 1e100, 1e-9, 1e9})
  {
    const Mesh scaled_mesh = build_mesh<Mesh>(scaled(a, factor));
    for(const Normal_weighting weighting : all_weightings)
      BOOST_TEST_CONTEXT("times " << factor << ", weighting " << int(weighting))
      {
        const Answer expected = normals_of(mesh, weighting), answer = normals_of(scaled_mesh, weighting);
        BOOST_TEST(answer.failures == 0u);
        for(std::size_t i = 0; i < a.points.size(); ++i)
          BOOST_TEST(length(answer.normals[i] - expected.normals[i]) < 1e-14);
      }
  }
}

BOOST_AUTO_TEST_CASE(flipped_faces_negate_to_the_last_bit)
{
  const Polygon_arrays a = arrays(torus(1., .4, 20, 12, .2));
  Polygon_arrays b = a;
  for(auto& f : b.faces)
    std::reverse(f.begin(), f.end());
  const Mesh out = build_mesh<Mesh>(a), in = build_mesh<Mesh>(b);
  for(const Normal_weighting weighting : all_weightings)
  {
    const Answer x = normals_of(out, weighting), y = normals_of(in, weighting);
    for(std::size_t i = 0; i < a.points.size(); ++i)
      BOOST_TEST((x.normals[i] == -1. * y.normals[i]), "weighting " << int(weighting) << ", vertex " << i);
  }
}

BOOST_AUTO_TEST_CASE(mesh_types_agree_to_the_last_bit)
{
  const Polygon_arrays a = arrays(torus(1., .4, 20, 12, .2));
  const Mesh mesh = build_mesh<Mesh>(a);
  const Polyhedron polyhedron = build_mesh<Polyhedron>(a);
  const Polyhedron_with_ids with_ids = build_mesh<Polyhedron_with_ids>(a);
  for(const Normal_weighting weighting : all_weightings)
  {
    const Answer x = normals_of(mesh, weighting), y = normals_of(polyhedron, weighting),
                 z = normals_of(with_ids, weighting);
    BOOST_TEST((x.normals == y.normals));
    BOOST_TEST((x.normals == z.normals));
    BOOST_TEST((x.status == y.status));
  }
}

// On irregular meshes of smooth surfaces, the error falls with the spacing; Max's is the smallest.
BOOST_AUTO_TEST_CASE(convergence)
{
  std::vector<std::vector<double>> errors(all_weightings.size());
  for(const std::size_t n : {12u, 24u, 48u})
  {
    const Analytic_surface surface = torus(1., .4, 2 * n, n, .15);
    const Mesh mesh = build_mesh<Mesh>(surface);
    for(std::size_t w = 0; w < all_weightings.size(); ++w)
    {
      const Answer answer = normals_of(mesh, all_weightings[w]);
      double sum = 0.;
      for(std::size_t i = 0; i < surface.points.size(); ++i)
        sum += length(answer.normals[i] - surface.exact[i].normal);
      errors[w].push_back(sum / double(surface.points.size()));
    }
  }
  for(std::size_t w = 0; w < all_weightings.size(); ++w)
  {
    const double order = std::log2(errors[w][1] / errors[w][2]);
    BOOST_TEST_MESSAGE("weighting " << int(all_weightings[w]) << ": errors " << errors[w][0] << ", "
                                    << errors[w][1] << ", " << errors[w][2] << ", order " << order);
    BOOST_TEST(order > .85);
    BOOST_TEST(order < 2.5);
    BOOST_TEST(errors[1][2] <= errors[w][2]);
  }
}

BOOST_AUTO_TEST_SUITE_END()
