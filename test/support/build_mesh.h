#ifndef SHAPE_CHARACTERISTICS_TEST_SUPPORT_BUILD_MESH_H
#define SHAPE_CHARACTERISTICS_TEST_SUPPORT_BUILD_MESH_H

#include "../../benchmark/support/build_face_graph.h"

#include <cstddef>

// Meshes of any type from the arrays of `analytic_surfaces.h` and `bad_meshes.h`, with vertices and faces in the
// order of the arrays. Include CGAL's header of the mesh type before this one.
namespace test_support {

namespace internal {

// ids of polyhedra that have them
template <typename Mesh>
auto set_ids(Mesh& mesh, int) -> decltype(mesh.vertices_begin()->id() = std::size_t(0), void())
{
  std::size_t i = 0;
  for(auto v = mesh.vertices_begin(); v != mesh.vertices_end(); ++v)
    v->id() = i++;
  i = 0;
  for(auto h = mesh.halfedges_begin(); h != mesh.halfedges_end(); ++h)
    h->id() = i++;
  i = 0;
  for(auto f = mesh.facets_begin(); f != mesh.facets_end(); ++f)
    f->id() = i++;
}

template <typename Mesh>
void set_ids(Mesh&, long)
{}

} // namespace internal

/// A `Surface_mesh`, a `Polyhedron_3` (its ids set if its items have them), or another `MutableFaceGraph`, from
/// anything with `points` and `triangles`.
template <typename Mesh, typename Surface>
auto build_mesh(const Surface& surface) -> decltype(surface.triangles, Mesh())
{
  Mesh mesh = benchmark_support::build_face_graph<Mesh>(surface.points, surface.triangles);
  internal::set_ids(mesh, 0);
  return mesh;
}

/// The same from anything with `points` and `faces`.
template <typename Mesh, typename Surface>
auto build_mesh(const Surface& surface) -> decltype(surface.faces, Mesh())
{
  Mesh mesh = benchmark_support::build_face_graph<Mesh>(surface.points, surface.faces);
  internal::set_ids(mesh, 0);
  return mesh;
}

} // namespace test_support

#endif // SHAPE_CHARACTERISTICS_TEST_SUPPORT_BUILD_MESH_H
