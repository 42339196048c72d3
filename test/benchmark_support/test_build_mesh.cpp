#include <boost/test/unit_test.hpp>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include "analytic_surfaces.h"
#include "bad_meshes.h"
#include "build_mesh.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(build_mesh)

using namespace test_support;
using test_support::build_mesh; // not the suite
using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Polyhedron_with_ids = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;

namespace {

// vertices, faces and the corners of faces are those of the arrays, in their order
template <typename Mesh, typename Faces>
void check(const std::string& name, const Mesh& mesh, const std::vector<Vector>& points, const Faces& input)
{
  BOOST_TEST_CONTEXT(name)
  {
    std::vector<bool> isolated(points.size(), true);
    for(const auto& f : input)
      for(std::size_t i : f)
        isolated[i] = false;
    if(std::find(isolated.begin(), isolated.end(), true) == isolated.end()) // CGAL calls those invalid
      BOOST_TEST(CGAL::is_valid_face_graph(mesh));
    const auto map = get(CGAL::vertex_point, mesh);
    std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, std::size_t> index;
    std::size_t i = 0;
    for(auto v : vertices(mesh))
    {
      BOOST_TEST_REQUIRE(i < points.size());
      const auto& p = get(map, v);
      BOOST_TEST((p[0] == points[i][0] && p[1] == points[i][1] && p[2] == points[i][2]));
      index[v] = i++;
    }
    BOOST_TEST(i == points.size());
    auto face = input.begin();
    for(auto f : faces(mesh))
    {
      BOOST_TEST_REQUIRE((face != input.end()));
      std::vector<std::size_t> corners;
      for(auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
        corners.push_back(index[v]);
      std::vector<std::size_t> expected(face->begin(), face->end());
      const auto first = std::find(corners.begin(), corners.end(), expected[0]);
      BOOST_TEST_REQUIRE((first != corners.end()));
      std::rotate(corners.begin(), first, corners.end());
      BOOST_TEST(corners == expected, boost::test_tools::per_element());
      ++face;
    }
    BOOST_TEST((face == input.end()));
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(analytic_surfaces_become_meshes_of_every_type)
{
  for(const Analytic_surface& s : all_analytic_surfaces(.2))
  {
    check(s.name, build_mesh<Surface_mesh>(s), s.points, s.triangles);
    check(s.name, build_mesh<Polyhedron>(s), s.points, s.triangles);
    const auto p = build_mesh<Polyhedron_with_ids>(s);
    check(s.name, p, s.points, s.triangles);
    std::size_t i = 0;
    for(auto v : vertices(p))
      BOOST_TEST(v->id() == i++);
  }
}

BOOST_AUTO_TEST_CASE(bad_meshes_can_be_built)
{
  std::vector<Polygon_arrays> all = all_bad_triangle_meshes();
  for(const Polygon_arrays& m : all_polygon_meshes())
    all.push_back(m);
  for(const Polygon_arrays& m : all)
  {
    check(m.name, build_mesh<Surface_mesh>(m), m.points, m.faces);
    check(m.name, build_mesh<Polyhedron>(m), m.points, m.faces);
  }
  check("bow tie", build_mesh<Surface_mesh>(bow_tie()), bow_tie().points, bow_tie().faces);
}

BOOST_AUTO_TEST_CASE(bad_meshes_are_as_bad_as_they_say)
{
  BOOST_TEST(CGAL::is_closed(build_mesh<Surface_mesh>(tetrahedron())));
  BOOST_TEST(CGAL::is_closed(build_mesh<Surface_mesh>(cube())));
  BOOST_TEST(CGAL::is_closed(build_mesh<Surface_mesh>(cube_of_quads())));
  BOOST_TEST(CGAL::is_closed(build_mesh<Surface_mesh>(prism_of_polygons())));

  const Surface_mesh valences = build_mesh<Surface_mesh>(mixed_valences());
  BOOST_TEST(CGAL::is_closed(valences));
  BOOST_TEST(valences.degree(Surface_mesh::Vertex_index(1)) == 40u);
  BOOST_TEST(valences.degree(Surface_mesh::Vertex_index(valences.number_of_vertices() - 1)) == 3u);

  const Polygon_arrays soup = triangle_soup();
  BOOST_TEST(soup.points.size() == 3 * soup.faces.size());

  for(const Polygon_arrays& m : {tetrahedron(), cube(), schwarz_lantern(12, 10)})
    BOOST_TEST_CONTEXT(m.name)
  for(const auto& f : m.faces)
  {
    using benchmark_support::cross;
    const Vector a = m.points[f[0]], b = m.points[f[1]], c = m.points[f[2]];
    Vector outward = (1. / 3.) * (a + b + c);
    if(m.name == "Schwarz lantern")
      outward.z = 0.;
    BOOST_TEST(dot(cross(b - a, c - a), outward) > 0.);
  }

  std::size_t v;
  const Polygon_arrays caps = cap_triangle(&v), needles = needle_triangles(), flat = zero_area_triangles();
  std::size_t thin = 0;
  for(const Polygon_arrays* m : {&caps, &needles, &flat})
  {
    bool found = false;
    for(const auto& f : m->faces)
    {
      const Vector a = m->points[f[0]], b = m->points[f[1]], c = m->points[f[2]];
      found = found || length(benchmark_support::cross(b - a, c - a)) < 1e-7;
    }
    thin += found;
  }
  BOOST_TEST(thin == 3u);
}

BOOST_AUTO_TEST_CASE(what_no_halfedge_structure_holds_is_refused)
{
  Polygon_arrays m{"three faces at an edge",
                   {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                   {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};
  BOOST_CHECK_THROW(build_mesh<Surface_mesh>(m), std::runtime_error);
}

BOOST_AUTO_TEST_SUITE_END()
