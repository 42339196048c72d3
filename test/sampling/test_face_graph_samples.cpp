#include <boost/test/unit_test.hpp>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#ifdef CGAL_USE_OPENMESH
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#endif

#include <Shape_characteristics/normals/vertex_normals.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>

#include "analytic_surfaces.h"
#include "bad_meshes.h"
#include "build_mesh.h"
#include "build_openmesh.h"
#include "check_traversal.h"
#include "neighbor_key.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <set>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(face_graph_samples)

namespace SC = Shape_characteristics;
using namespace test_support;
using S = SC::Estimation_status;
using SC::Face_graph_samples;
using SC::Neighborhood;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Polyhedron_with_ids = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;
using Indices = std::vector<Face_graph_samples::Index>;

namespace {

Polygon_arrays arrays(const Analytic_surface& s)
{
  return test_support::polygons_of(s.name, s);
}

template <typename FaceGraph>
Face_graph_samples samples_of(const FaceGraph& mesh, const Neighborhood& neighborhood)
{
  return Face_graph_samples(mesh, get(CGAL::vertex_point, mesh), neighborhood);
}

std::vector<std::set<std::size_t>> adjacency(const Polygon_arrays& a)
{
  std::vector<std::set<std::size_t>> neighbors(a.points.size());
  for(const auto& f : a.faces)
    for(std::size_t k = 0; k < f.size(); ++k)
    {
      neighbors[f[k]].insert(f[(k + 1) % f.size()]);
      neighbors[f[(k + 1) % f.size()]].insert(f[k]);
    }
  return neighbors;
}

// the vertices that are reached from `v` by at most `rings` edges between accepted vertices, nearest first, those that are
// equally far to seven digits in the lexicographic order of the points, to six digits
template <typename Accept>
Indices plain_search(const Polygon_arrays& a, std::size_t v, std::size_t rings, const Accept& accept)
{
  const auto neighbors = adjacency(a);
  std::set<std::size_t> reached = {v};
  for(std::size_t ring = 0; ring < rings; ++ring)
  {
    std::set<std::size_t> next = reached;
    for(const std::size_t i : reached)
      for(const std::size_t j : neighbors[i])
        if(accept(j))
          next.insert(j);
    if(next == reached)
      break;
    reached = next;
  }
  reached.erase(v);
  Indices result(reached.begin(), reached.end());
  const auto key = [&](const std::size_t i)
  {
    const Vector &p = a.points[v], &q = a.points[i];
    return test_support::neighbor_key({p.x, p.y, p.z}, {q.x, q.y, q.z});
  };
  std::sort(result.begin(), result.end(),
            [&](const std::size_t i, const std::size_t j) { return key(i) < key(j); });
  return result;
}

const auto all = [](std::size_t) { return true; };

// two pyramids on one polygon: apexes with many neighbors, which lie in several blocks of vertices
Polygon_arrays bipyramid(std::size_t n)
{
  Polygon_arrays a;
  a.name = "bipyramid";
  a.points = {{0., 0., 1.}, {0., 0., -1.}};
  for(std::size_t i = 0; i < n; ++i)
  {
    const double angle = 2. * 3.141592653589793 * double(i) / double(n);
    a.points.push_back({std::cos(angle), std::sin(angle), .1 * std::sin(3. * angle)});
    const std::size_t j = 2 + i, k = 2 + (i + 1) % n;
    a.faces.push_back({0, j, k});
    a.faces.push_back({1, k, j});
  }
  return a;
}

std::vector<Polygon_arrays> some_meshes()
{
  return {arrays(waves(.1, 4., 1., 8, .15)),
          arrays(torus(1., .4, 16, 8, .1)),
          cube_of_quads(),
          prism_of_polygons(),
          bow_tie(),
          isolated_vertices(),
          bipyramid(40),
          thin_strip(20)};
}

} // namespace

BOOST_AUTO_TEST_CASE(rings_are_those_of_a_breadth_first_search)
{
  for(const Polygon_arrays& a : some_meshes())
    for(const unsigned rings : {1u, 2u, 3u})
      BOOST_TEST_CONTEXT(a.name << ", " << rings << " rings")
      {
        const Mesh mesh = build_mesh<Mesh>(a);
        const Face_graph_samples samples = samples_of(mesh, Neighborhood::rings(rings));
        BOOST_REQUIRE(samples.size() == a.points.size());
        Face_graph_samples::Workspace workspace;
        for(std::size_t v = 0; v < a.points.size(); ++v)
          BOOST_TEST((samples.neighbors(v, 0, workspace) == plain_search(a, v, rings, all)), "vertex " << v);
      }
}

// Vertices are looked at in blocks, by several threads.
BOOST_AUTO_TEST_CASE(edges_are_those_of_the_faces)
{
  for(const Polygon_arrays& a :
      {bipyramid(3000), arrays(torus(1., .4, 80, 40, .1)), arrays(waves(.1, 4., 1., 50, .15))})
    BOOST_TEST_CONTEXT(a.name)
    {
      const Mesh mesh = build_mesh<Mesh>(a);
      const auto vpm = get(CGAL::vertex_point, mesh);
      const Face_graph_samples samples(mesh, vpm, Neighborhood::rings(1)),
          by_threads(mesh, vpm, Neighborhood::rings(1), Face_graph_samples::Connectivity::NEIGHBORS,
                     CGAL::Parallel_if_available_tag());
      BOOST_TEST(samples.size() > 2048u);
      const auto expected = adjacency(a);
      Face_graph_samples::Workspace workspace;
      std::size_t failures = 0;
      for(std::size_t i = 0; i < samples.size(); ++i)
        for(const Face_graph_samples* s : {&samples, &by_threads})
        {
          const Indices& neighbors = s->neighbors(i, 0, workspace);
          failures += neighbors.size() != expected[i].size() ||
                      std::set<std::size_t>(neighbors.begin(), neighbors.end()) != expected[i];
        }
      BOOST_TEST(failures == 0u);
      BOOST_TEST((samples.traversal_order() == by_threads.traversal_order()));
      BOOST_TEST(samples.mean_spacing() == by_threads.mean_spacing());
    }
}

// As long as there are less than the minimum, one ring more, but not more than two.
BOOST_AUTO_TEST_CASE(rings_grow)
{
  for(const Polygon_arrays& a : {arrays(waves(.1, 4., 1., 8, .15)), thin_strip(20)})
    for(const std::size_t minimum : {3u, 6u, 9u, 1000u})
    {
      const Mesh mesh = build_mesh<Mesh>(a);
      const Face_graph_samples samples = samples_of(mesh, Neighborhood::rings(1));
      Face_graph_samples::Workspace workspace;
      std::size_t grown = 0;
      for(std::size_t v = 0; v < a.points.size(); ++v)
      {
        std::size_t rings = 1;
        while(rings < 3 && plain_search(a, v, rings, all).size() < minimum)
          ++rings;
        grown += rings > 1;
        BOOST_TEST((samples.neighbors(v, minimum, workspace) == plain_search(a, v, rings, all)),
                   a.name << ", vertex " << v);
      }
      BOOST_TEST(grown > 0);
    }
}

BOOST_AUTO_TEST_CASE(balls_are_searched_along_edges)
{
  std::vector<Polygon_arrays> meshes = some_meshes();
  meshes.push_back(two_sheets(.01, 8)); // the other sheet is in the ball, but not along edges
  for(const Polygon_arrays& a : meshes)
    for(const double radius : {.2, .5, 1.1, 100.})
      BOOST_TEST_CONTEXT(a.name << ", radius " << radius)
      {
        const Mesh mesh = build_mesh<Mesh>(a);
        const Face_graph_samples samples = samples_of(mesh, Neighborhood::ball(radius));
        Face_graph_samples::Workspace workspace;
        for(std::size_t v = 0; v < a.points.size(); ++v)
        {
          const auto in_ball = [&](const std::size_t j)
          { return dot(a.points[j] - a.points[v], a.points[j] - a.points[v]) <= radius * radius; };
          BOOST_TEST((samples.neighbors(v, 0, workspace) == plain_search(a, v, a.points.size(), in_ball)),
                     "vertex " << v);
        }
      }
}

namespace {

void check_same(const Face_graph_samples& a, const Face_graph_samples& b, std::size_t minimum)
{
  BOOST_REQUIRE(a.size() == b.size());
  BOOST_REQUIRE(a.number_of_faces() == b.number_of_faces());
  BOOST_TEST(a.is_triangle_mesh() == b.is_triangle_mesh());
  BOOST_TEST(a.mean_spacing() == b.mean_spacing());
  for(std::size_t f = 0; f < a.number_of_faces(); ++f)
  {
    BOOST_REQUIRE(a.degree(f) == b.degree(f));
    for(std::size_t k = 0; k < a.degree(f); ++k)
      BOOST_TEST(a.vertex(f, k) == b.vertex(f, k));
  }
  Face_graph_samples::Workspace of_a, of_b;
  for(std::size_t i = 0; i < a.size(); ++i)
  {
    BOOST_TEST((a.point(i) == b.point(i)));
    BOOST_TEST((a.status(i) == b.status(i)));
    BOOST_TEST(a.spacing(i) == b.spacing(i));
    const auto faces_a = a.incident_faces(i), faces_b = b.incident_faces(i);
    BOOST_TEST(std::equal(faces_a.first, faces_a.second, faces_b.first, faces_b.second));
    BOOST_TEST((a.neighbors(i, minimum, of_a) == b.neighbors(i, minimum, of_b)));
  }
}

} // namespace

// What isn't kept is found in another way, or is gone; the rest is the same.
BOOST_AUTO_TEST_CASE(connectivity)
{
  using Connectivity = Face_graph_samples::Connectivity;
  for(const Polygon_arrays& a : some_meshes())
    for(const Neighborhood& neighborhood : {Neighborhood::rings(2), Neighborhood::ball(.4)})
      BOOST_TEST_CONTEXT(a.name)
      {
        const Mesh mesh = build_mesh<Mesh>(a);
        const auto vpm = get(CGAL::vertex_point, mesh);
        const Face_graph_samples both(mesh, vpm, neighborhood);
        const Face_graph_samples faces(mesh, vpm, neighborhood, Connectivity::FACES);
        const Face_graph_samples neighbors(mesh, vpm, neighborhood, Connectivity::NEIGHBORS);
        BOOST_TEST(faces.number_of_faces() == both.number_of_faces());
        BOOST_TEST(neighbors.number_of_faces() == 0u);
        BOOST_TEST(neighbors.is_triangle_mesh() == both.is_triangle_mesh());
        BOOST_TEST(neighbors.mean_spacing() == both.mean_spacing());
        BOOST_TEST(faces.mean_spacing() == both.mean_spacing());
        Face_graph_samples::Workspace of_both, of_faces, of_neighbors;
        for(std::size_t i = 0; i < both.size(); ++i)
        {
          const Indices& expected = both.neighbors(i, 9, of_both);
          BOOST_TEST((faces.neighbors(i, 9, of_faces) == expected));
          BOOST_TEST((neighbors.neighbors(i, 9, of_neighbors) == expected));
          BOOST_TEST(faces.spacing(i) == both.spacing(i));
          BOOST_TEST((faces.status(i) == both.status(i) && neighbors.status(i) == both.status(i)));
          const auto [begin, end] = both.incident_faces(i);
          const auto of_i = faces.incident_faces(i);
          BOOST_TEST(std::equal(begin, end, of_i.first, of_i.second));
          for(const auto* f = begin; f != end; ++f)
            BOOST_TEST(both.vertex(*f, both.corner(*f, i)) == i);
        }
      }
}

// The mesh's own numbers are used where they are in order, and only there.
BOOST_AUTO_TEST_CASE(numbers_of_the_mesh)
{
  const Analytic_surface surface = torus(1., .4, 16, 8, .1);
  Polyhedron_with_ids mesh = build_mesh<Polyhedron_with_ids>(surface);
  const Face_graph_samples expected = samples_of(mesh, Neighborhood::rings(2));
  for(auto v = mesh.vertices_begin(); v != mesh.vertices_end(); ++v)
    v->id() = std::size_t(-1);
  check_same(expected, samples_of(mesh, Neighborhood::rings(2)), 5);
  std::size_t id = surface.points.size();
  for(auto v = mesh.vertices_begin(); v != mesh.vertices_end(); ++v)
    v->id() = --id;
  check_same(expected, samples_of(mesh, Neighborhood::rings(2)), 5);
}

// of directions that come from elsewhere, rounded as they may be
BOOST_AUTO_TEST_CASE(unit_normals_keep_their_bits)
{
  const Mesh mesh = build_mesh<Mesh>(torus(1., .4, 16, 8, .1));
  Face_graph_samples samples = samples_of(mesh, Neighborhood::rings(1));
  const std::vector<Eigen::Vector3d> normals = SC::vertex_normals<CGAL::Sequential_tag>(samples);
  samples.set_normals(normals);
  for(std::size_t i = 0; i < samples.size(); ++i)
  {
    BOOST_TEST(std::abs(samples.normal(i).norm() - 1.) < 1e-15);
    BOOST_TEST((samples.normal(i) == normals[i]));
  }
}

BOOST_AUTO_TEST_CASE(mesh_types_give_the_same_arrays)
{
  for(const Analytic_surface& surface : {waves(.1, 4., 1., 8, .15), torus(1., .4, 16, 8, .1)})
    for(const Neighborhood& neighborhood : {Neighborhood::rings(2), Neighborhood::ball(.4)})
    {
      const Mesh mesh = build_mesh<Mesh>(surface);
      const Face_graph_samples expected = samples_of(mesh, neighborhood);
      const Polyhedron polyhedron = build_mesh<Polyhedron>(surface);
      check_same(expected, samples_of(polyhedron, neighborhood), 5);
      const Polyhedron_with_ids with_ids = build_mesh<Polyhedron_with_ids>(surface);
      check_same(expected, samples_of(with_ids, neighborhood), 5);
#ifdef CGAL_USE_OPENMESH
      struct Traits : OpenMesh::DefaultTraits
      {
        using Point = OpenMesh::Vec3d;
        using Normal = OpenMesh::Vec3d;
      };
      using Open_mesh = OpenMesh::PolyMesh_ArrayKernelT<Traits>;
      const Open_mesh open_mesh = build_openmesh<Open_mesh>(surface);
      check_same(expected, samples_of(open_mesh, neighborhood), 5);
#endif
    }
}

// Vertices and faces that were removed, but not yet collected as garbage.
BOOST_AUTO_TEST_CASE(removed_elements)
{
  Polygon_arrays a = arrays(waves(.1, 4., 1., 6, .15));
  const Mesh clean = build_mesh<Mesh>(a);
  test_support::append(a, tetrahedron(), {5., 0., 0.});
  Mesh mesh = build_mesh<Mesh>(a);
  const std::size_t n = clean.number_of_vertices();
  CGAL::Euler::remove_center_vertex(mesh.halfedge(Mesh::Vertex_index(unsigned(n))), mesh);
  while(mesh.number_of_faces() > clean.number_of_faces())
    for(const auto f : faces(mesh))
      if(std::size_t(target(halfedge(f, mesh), mesh)) >= n)
      {
        CGAL::Euler::remove_face(halfedge(f, mesh), mesh);
        break;
      }
  BOOST_TEST(mesh.has_garbage());
  check_same(samples_of(clean, Neighborhood::rings(2)), samples_of(mesh, Neighborhood::rings(2)), 5);
}

// What the samples say doesn't depend on the order of vertices and faces, nor on where faces start.
BOOST_AUTO_TEST_CASE(order_is_canonical)
{
  Random random(3);
  for(const Polygon_arrays& a :
      {arrays(plane(1., 8)), arrays(sphere(1., 2)), arrays(waves(.1, 4., 1., 8, .15))})
  {
    std::vector<std::size_t> place(a.points.size());
    std::iota(place.begin(), place.end(), std::size_t(0));
    for(std::size_t i = place.size(); i > 1; --i)
      std::swap(place[i - 1], place[std::size_t(random.uniform() * double(i))]);
    Polygon_arrays b = a;
    for(std::size_t i = 0; i < place.size(); ++i)
      b.points[place[i]] = a.points[i];
    for(auto& f : b.faces)
    {
      for(std::size_t& i : f)
        i = place[i];
      std::rotate(f.begin(), f.begin() + 1 + std::ptrdiff_t(2. * random.uniform()), f.end());
    }
    std::reverse(b.faces.begin(), b.faces.end());

    const Mesh mesh_a = build_mesh<Mesh>(a), mesh_b = build_mesh<Mesh>(b);
    for(const Neighborhood& neighborhood : {Neighborhood::rings(2), Neighborhood::ball(.5)})
    {
      const Face_graph_samples of_a = samples_of(mesh_a, neighborhood),
                               of_b = samples_of(mesh_b, neighborhood);
      BOOST_TEST(of_a.mean_spacing() == of_b.mean_spacing());
      Face_graph_samples::Workspace workspace_a, workspace_b;
      for(std::size_t i = 0; i < place.size(); ++i)
      {
        BOOST_TEST(of_a.spacing(i) == of_b.spacing(place[i]));
        Indices expected = of_a.neighbors(i, 5, workspace_a);
        for(auto& j : expected)
          j = Face_graph_samples::Index(place[j]);
        BOOST_TEST((expected == of_b.neighbors(place[i], 5, workspace_b)));
        const auto [begin_a, end_a] = of_a.incident_faces(i);
        const auto [begin_b, end_b] = of_b.incident_faces(place[i]);
        BOOST_REQUIRE(end_a - begin_a == end_b - begin_b);
        for(const auto *f = begin_a, *g = begin_b; f != end_a; ++f, ++g)
          for(std::size_t k = 0; k < 3; ++k)
            BOOST_TEST(place[of_a.vertex(*f, k)] == of_b.vertex(*g, k));
      }
    }
  }
}

namespace {

// the part of the edges that join different blocks of 2000 of the order
double part_across_blocks(const Face_graph_samples& samples, const Indices& order)
{
  std::vector<std::size_t> block(samples.size());
  for(std::size_t k = 0; k < order.size(); ++k)
    block[order[k]] = k / 2000;
  std::size_t edges = 0, across = 0;
  for(std::size_t f = 0; f < samples.number_of_faces(); ++f)
    for(std::size_t k = 0; k < 3; ++k)
    {
      ++edges;
      across += block[samples.vertex(f, k)] != block[samples.vertex(f, (k + 1) % 3)];
    }
  return double(across) / double(edges);
}

void check_permutation(Indices order, std::size_t size)
{
  std::sort(order.begin(), order.end());
  BOOST_REQUIRE(order.size() == size);
  for(std::size_t i = 0; i < size; ++i)
    BOOST_REQUIRE(order[i] == i);
}

} // namespace

BOOST_AUTO_TEST_CASE(traversal_goes_by_compact_patches)
{
  for(Polygon_arrays a : {arrays(plane(1., 150)), arrays(sphere(1., 5)), arrays(torus(1., .1, 400, 30))})
  {
    Random random(11);
    for(std::size_t shuffled = 0; shuffled < 2; ++shuffled)
      BOOST_TEST_CONTEXT(a.name << (shuffled == 0 ? "" : ", shuffled"))
      {
        const Face_graph_samples samples = samples_of(build_mesh<Mesh>(a), Neighborhood::rings(2));
        const Indices order = samples.traversal_order();
        check_permutation(order, samples.size());
        BOOST_TEST(order.front() == 0u);
        BOOST_TEST(part_across_blocks(samples, order) < .06);
        test_support::check_traversal(samples, 512);

        // The connectivity alone determines it.
        Polygon_arrays moved = a;
        for(auto& p : moved.points)
          p = {3. * p.y + 1., -.7 * p.x, 100. * p.z};
        const Polyhedron polyhedron = build_mesh<Polyhedron>(moved);
        BOOST_TEST((samples_of(polyhedron, Neighborhood::ball(.1)).traversal_order() == order));

        std::vector<std::size_t> place(a.points.size());
        std::iota(place.begin(), place.end(), std::size_t(0));
        for(std::size_t i = place.size(); i > 1; --i)
          std::swap(place[i - 1], place[std::size_t(random.uniform() * double(i))]);
        const Polygon_arrays before = a;
        for(std::size_t i = 0; i < place.size(); ++i)
          a.points[place[i]] = before.points[i];
        for(auto& f : a.faces)
          for(std::size_t& i : f)
            i = place[i];
      }
  }
  for(const Polygon_arrays& a : some_meshes())
  {
    const Face_graph_samples samples = samples_of(build_mesh<Mesh>(a), Neighborhood::rings(2));
    check_permutation(samples.traversal_order(), a.points.size());
    test_support::check_traversal(samples, 3);
  }
  BOOST_TEST(samples_of(Mesh(), Neighborhood::rings(2)).traversal_order().empty());
}

// The patch of a vertex is the whole mesh, as far as one sees from it.
template <typename FaceGraph>
void check_patches(const Polygon_arrays& a, const Neighborhood& neighborhood, unsigned reach)
{
  const FaceGraph mesh = build_mesh<FaceGraph>(a);
  const auto vpm = get(CGAL::vertex_point, mesh);
  using vertex_descriptor = typename boost::graph_traits<FaceGraph>::vertex_descriptor;
  const std::vector<vertex_descriptor> all_vertices(vertices(mesh).begin(), vertices(mesh).end());
  Face_graph_samples whole(mesh, vpm, neighborhood);
  whole.set_normals(SC::vertex_normals<CGAL::Sequential_tag>(whole), S::DEGENERATE);
  Face_graph_samples::Workspace workspace, workspace_of_patch;
  for(std::size_t v = 0; v < all_vertices.size(); ++v)
    BOOST_TEST_CONTEXT(a.name << ", vertex " << v << ", reach " << reach)
    {
      std::vector<vertex_descriptor> copied;
      Face_graph_samples patch(all_vertices[v], mesh, vpm, neighborhood, reach, copied);
      patch.set_normals(SC::vertex_normals<CGAL::Sequential_tag>(patch), S::DEGENERATE);
      BOOST_REQUIRE(patch.size() == copied.size());
      std::vector<std::size_t> index; // in the whole mesh
      for(const vertex_descriptor w : copied)
        index.push_back(
            std::size_t(std::find(all_vertices.begin(), all_vertices.end(), w) - all_vertices.begin()));
      BOOST_REQUIRE(index[0] == v);

      // those that are reached in less than `reach` steps from neighbors to neighbors
      std::set<std::size_t> inner = {0};
      for(unsigned step = 1; step < reach; ++step)
        for(const std::size_t i : std::set<std::size_t>(inner))
          for(const auto j : patch.neighbors(i, 5, workspace_of_patch))
            inner.insert(j);
      for(const std::size_t i : inner)
      {
        BOOST_TEST((patch.status(i) == whole.status(index[i])));
        BOOST_TEST((patch.point(i) == whole.point(index[i])));
        BOOST_TEST((patch.normal(i) == whole.normal(index[i])));
        BOOST_TEST(patch.spacing(i) == whole.spacing(index[i]));
        Indices neighbors = patch.neighbors(i, 5, workspace_of_patch);
        for(auto& j : neighbors)
        {
          BOOST_TEST((patch.normal(j) == whole.normal(index[j])));
          j = Face_graph_samples::Index(index[j]);
        }
        BOOST_TEST((neighbors == whole.neighbors(index[i], 5, workspace)));

        const auto [begin, end] = patch.incident_faces(i);
        const auto [whole_begin, whole_end] = whole.incident_faces(index[i]);
        BOOST_REQUIRE(end - begin == whole_end - whole_begin);
        for(const auto *f = begin, *g = whole_begin; f != end; ++f, ++g)
        {
          BOOST_REQUIRE(patch.degree(*f) == whole.degree(*g));
          for(std::size_t k = 0; k < patch.degree(*f); ++k)
            BOOST_TEST(index[patch.vertex(*f, k)] == whole.vertex(*g, k));
        }
      }
    }
}

BOOST_AUTO_TEST_CASE(patches)
{
  for(const Polygon_arrays& a : {arrays(waves(.1, 4., 1., 8, .15)), cube_of_quads(), prism_of_polygons(),
                                 isolated_vertices(), border_ear(), thin_strip(30)})
  {
    check_patches<Mesh>(a, Neighborhood::rings(1), 1);
    check_patches<Mesh>(a, Neighborhood::rings(2), 1);
    check_patches<Mesh>(a, Neighborhood::ball(.4), 1);
  }
  const Polygon_arrays grid = arrays(plane(1., 16, .1));
  check_patches<Mesh>(grid, Neighborhood::rings(1), 2);
  check_patches<Mesh>(grid, Neighborhood::ball(.3), 3);
  check_patches<Polyhedron>(arrays(waves(.1, 4., 1., 8, .15)), Neighborhood::rings(2), 1);
}

BOOST_AUTO_TEST_CASE(statuses)
{
  Polygon_arrays a = isolated_vertices(2);
  test_support::append(a, arrays(plane(1., 4)), {4., 0., 0.});
  const std::size_t first = a.points.size() - 25, bad = first + 12;
  a.points[bad] = {4., std::numeric_limits<double>::infinity(), 0.};
  const Mesh mesh = build_mesh<Mesh>(a);
  Face_graph_samples samples = samples_of(mesh, Neighborhood::rings(2));
  for(std::size_t i = 0; i < a.points.size(); ++i)
  {
    const std::size_t row = (i - first) / 5, column = (i - first) % 5;
    const S expected = i < 162                           ? S::ESTIMATED
                       : i < 164                         ? S::UNREFERENCED
                       : i == bad                        ? S::NON_FINITE_INPUT
                       : row % 4 == 0 || column % 4 == 0 ? S::BORDER
                                                         : S::ESTIMATED;
    BOOST_TEST((samples.status(i) == expected), "vertex " << i);
    BOOST_TEST(samples.is_usable(i) == SC::is_estimated(expected));
  }
  // an edge with an infinite end has no length
  BOOST_TEST(std::isfinite(samples.mean_spacing()));
  BOOST_TEST(std::isfinite(samples.spacing(bad - 1)));
  BOOST_TEST(samples.spacing(162) == 0.);

  Face_graph_samples::Workspace workspace;
  const auto has = [&](const std::size_t i, const std::size_t j)
  {
    const Indices& n = samples.neighbors(i, 0, workspace);
    return std::find(n.begin(), n.end(), j) != n.end();
  };
  BOOST_TEST(!has(bad - 1, bad));
  BOOST_TEST(has(bad - 1, bad + 1)); // the way through it is a way
  BOOST_TEST(samples.neighbors(162, 5, workspace).empty());

  // normals of any length; those that are no directions make samples unusable
  std::vector<Eigen::Vector3d> normals(samples.size(), Eigen::Vector3d(0., 3e-200, 4e-200));
  normals[5].setZero();
  normals[6].setConstant(std::numeric_limits<double>::quiet_NaN());
  normals[7] = Eigen::Vector3d(1e300, 0., 1e300);
  BOOST_TEST(!samples.has_normals());
  samples.set_normals(normals, S::DEGENERATE);
  BOOST_TEST(samples.has_normals());
  BOOST_TEST((samples.normal(0) - Eigen::Vector3d(0., .6, .8)).norm() < 1e-15);
  BOOST_TEST((samples.normal(7) - Eigen::Vector3d(1., 0., 1.) / std::sqrt(2.)).norm() < 1e-15);
  BOOST_TEST((samples.status(5) == S::DEGENERATE && samples.status(6) == S::DEGENERATE));
  BOOST_TEST((samples.status(162) == S::UNREFERENCED && samples.status(bad) == S::NON_FINITE_INPUT));
}

BOOST_AUTO_TEST_CASE(neighborhoods_without_meaning)
{
  const double nan_value = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(Neighborhood::rings(0), std::invalid_argument);
  BOOST_CHECK_THROW(Neighborhood::nearest(0), std::invalid_argument);
  for(const double radius : {0., -1., nan_value, std::numeric_limits<double>::infinity()})
    BOOST_CHECK_THROW(Neighborhood::ball(radius), std::invalid_argument);
  BOOST_CHECK_THROW(samples_of(build_mesh<Mesh>(tetrahedron()), Neighborhood::nearest(5)),
                    std::invalid_argument);

  namespace sp = SC::parameters;
  BOOST_TEST(SC::internal::mesh_neighborhood(sp::default_values()).count() == 2u);
  BOOST_TEST(SC::internal::mesh_neighborhood(sp::number_of_rings(3)).count() == 3u);
  BOOST_TEST(SC::internal::mesh_neighborhood(sp::neighbor_radius(.5)).radius() == .5);
  BOOST_TEST(SC::internal::point_set_neighborhood(sp::default_values()).count() == 18u);
  BOOST_TEST(SC::internal::point_set_neighborhood(sp::number_of_neighbors(7)).count() == 7u);
  for(const int rings : {0, -1, 1000000000})
    BOOST_CHECK_THROW(SC::internal::mesh_neighborhood(sp::number_of_rings(rings)), std::invalid_argument);
  for(const int k : {0, -1})
    BOOST_CHECK_THROW(SC::internal::point_set_neighborhood(sp::number_of_neighbors(k)),
                      std::invalid_argument);
  BOOST_CHECK_THROW(SC::internal::mesh_neighborhood(sp::neighbor_radius(nan_value)), std::invalid_argument);

  // numbers of any type, as long as they are whole
  BOOST_TEST(SC::internal::mesh_neighborhood(sp::number_of_rings(3.)).count() == 3u);
  BOOST_TEST(SC::internal::point_set_neighborhood(sp::number_of_neighbors(7.f)).count() == 7u);
  for(const double count : {nan_value, std::numeric_limits<double>::infinity(), 1.5, 1e300, -1e300})
  {
    BOOST_CHECK_THROW(SC::internal::mesh_neighborhood(sp::number_of_rings(count)), std::invalid_argument);
    BOOST_CHECK_THROW(SC::internal::point_set_neighborhood(sp::number_of_neighbors(count)),
                      std::invalid_argument);
    BOOST_CHECK_THROW(SC::internal::point_set_neighborhood(sp::number_of_neighbors(float(count))),
                      std::invalid_argument);
  }
}

// In units in which squares of lengths are out of the range of numbers, neighbors are the same as in others.
BOOST_AUTO_TEST_CASE(extraordinary_units)
{
  const Polygon_arrays a = arrays(ellipsoid_of_longitudes(1., .8, .6, 16));
  const Mesh mesh = build_mesh<Mesh>(a);
  for(const double unit : {0x1p-1000, 0x1p-560, 0x1p560, 0x1p1000})
  {
    Polygon_arrays scaled = a;
    for(auto& p : scaled.points)
      p = unit * p;
    const Mesh other = build_mesh<Mesh>(scaled);
    for(const bool is_ball : {false, true})
    {
      const Neighborhood neighborhood = is_ball ? Neighborhood::ball(.5) : Neighborhood::rings(2);
      const Neighborhood scaled_neighborhood = is_ball ? Neighborhood::ball(.5 * unit) : neighborhood;
      const Face_graph_samples expected = samples_of(mesh, neighborhood);
      const Face_graph_samples samples = samples_of(other, scaled_neighborhood);
      Face_graph_samples::Workspace v, w;
      std::size_t differences = 0;
      for(std::size_t i = 0; i < samples.size(); ++i)
        differences += samples.neighbors(i, 0, v) != expected.neighbors(i, 0, w);
      BOOST_TEST(differences == 0u);

      const Mesh::Vertex_index center(7);
      std::vector<Mesh::Vertex_index> copied, of_scaled;
      const Face_graph_samples around(center, mesh, get(CGAL::vertex_point, mesh), neighborhood, 1, copied);
      const Face_graph_samples scaled_around(center, other, get(CGAL::vertex_point, other),
                                             scaled_neighborhood, 1, of_scaled);
      BOOST_TEST((of_scaled == copied));
      BOOST_TEST((scaled_around.neighbors(0, 0, v) == around.neighbors(0, 0, w)));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
