#ifndef SHAPE_CHARACTERISTICS_TEST_SUPPORT_BAD_MESHES_H
#define SHAPE_CHARACTERISTICS_TEST_SUPPORT_BAD_MESHES_H

#include "analytic_surfaces.h"

#include <cstddef>
#include <string>
#include <vector>

// Meshes on which estimators have nothing, or little, to stand on. All can be held by a halfedge data structure
// (`build_mesh.h`); `bow_tie()` by those that allow two fans at a vertex, such as `Surface_mesh`.
namespace test_support {

/// A mesh of polygons, counterclockwise seen from outside.
struct Polygon_arrays
{
  std::string name;
  std::vector<Vector> points;
  std::vector<std::vector<std::size_t>> faces;
};

/// The triangles of a surface as polygons.
Polygon_arrays polygons_of(const std::string& name, const Analytic_surface& s);

/// Appends `part`, moved by `offset`.
void append(Polygon_arrays& m, const Polygon_arrays& part, const Vector& offset = {});

/// No vertex, no face.
Polygon_arrays empty_mesh();

/// A vertex, no face.
Polygon_arrays single_vertex();

Polygon_arrays single_triangle();

/// Three triangles around vertex 0, open between the last and the first.
Polygon_arrays open_fan();

/// Three triangles all around vertex 0, which has valence 3; the others have two faces each.
Polygon_arrays fan_of_three();

Polygon_arrays tetrahedron();

/// Cube [-1, 1]^3 of six quadrilaterals; vertex 4 z + 2 y + x.
Polygon_arrays cube_of_quads();

/// The same cube of twelve triangles.
Polygon_arrays cube();

/// Prism: two hexagons and six quadrilaterals.
Polygon_arrays prism_of_polygons();

/// A sphere with `count` vertices more, of no face: the last ones.
Polygon_arrays isolated_vertices(std::size_t count = 3);

/// What an STL file holds: a sphere of which every triangle has its own three vertices.
Polygon_arrays triangle_soup();

/// A wavy sheet of which one vertex lies exactly upon a neighbor: two triangles have no area.
Polygon_arrays zero_area_triangles(std::size_t* vertex = nullptr);

/// A wavy sheet with needles: a vertex at 1e-8 from its neighbor.
Polygon_arrays needle_triangles(std::size_t* vertex = nullptr);

/// A saddle with a cap: an angle of nearly pi at `vertex`, which lies at 1e-8 of the height of a triangle above
/// the middle of its edge, inside of it.
Polygon_arrays cap_triangle(std::size_t* vertex = nullptr);

/// A saddle with an ear: the last vertex hangs on the border by a single triangle.
Polygon_arrays border_ear();

/// A strip one triangle wide and `length` long: every vertex is on the border.
Polygon_arrays thin_strip(std::size_t length = 100);

/// A closed double cone with two poles (vertices 0 and 1) of valence 40, and on each triangle of the upper side
/// a vertex of valence 3.
Polygon_arrays mixed_valences();

/// A sphere, a torus, and a part of one triangle, far from each other. The triangle's vertices are the last three.
Polygon_arrays several_components();

/// A Moebius strip cut across: a halfedge data structure is orientable, so the vertices of the cut are there
/// twice, at the same places, with opposite normals. The cut joins vertices 0 ... width with the last width + 1,
/// in opposite order.
Polygon_arrays moebius_strip(std::size_t length = 60, std::size_t width = 6);

/// Two fans that share nothing but vertex 0.
Polygon_arrays bow_tie();

/// Two flat sheets facing away from each other, `distance` apart; the first half of the vertices is the upper one.
Polygon_arrays two_sheets(double distance = .01, std::size_t n = 20);

/// Schwarz's lantern in the unit cylinder of height 2: `rings` rings of `around` vertices, turned by half a
/// step from one to the next. With many rings (against around^2) the triangles' normals turn away from the
/// cylinder's, though the vertices lie on it.
Polygon_arrays schwarz_lantern(std::size_t around = 12, std::size_t rings = 100);

/// All of triangles but the bow tie: what every estimator must survive.
std::vector<Polygon_arrays> all_bad_triangle_meshes();

/// All of polygons with more than three corners.
std::vector<Polygon_arrays> all_polygon_meshes();

} // namespace test_support

#endif // SHAPE_CHARACTERISTICS_TEST_SUPPORT_BAD_MESHES_H
