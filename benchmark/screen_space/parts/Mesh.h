#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_SCREEN_SPACE_PARTS_MESH_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_SCREEN_SPACE_PARTS_MESH_H

#include "surfaces.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>

namespace screen_space {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Normal_map = Mesh::Property_map<Mesh::Vertex_index, Kernel::Vector_3>;

/// The surface's mesh, with its exact normals.
inline Mesh mesh_of(const Surface& surface, Normal_map& normals)
{
  Mesh mesh;
  normals = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:exact_normal").first;
  for(std::size_t i = 0; i < surface.mesh.points.size(); ++i)
  {
    const Vector &p = surface.mesh.points[i], &n = surface.normals[i];
    put(normals, mesh.add_vertex({p.x, p.y, p.z}), Kernel::Vector_3(n.x, n.y, n.z));
  }
  for(const auto& t : surface.mesh.triangles)
    mesh.add_face(Mesh::Vertex_index(Mesh::size_type(t[0])), Mesh::Vertex_index(Mesh::size_type(t[1])),
                  Mesh::Vertex_index(Mesh::size_type(t[2])));
  return mesh;
}

inline double mean_edge(const Mesh& mesh)
{
  double sum = 0.;
  for(const auto e : mesh.edges())
    sum += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return mesh.number_of_edges() > 0 ? sum / double(mesh.number_of_edges()) : 0.;
}

} // namespace screen_space

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SCREEN_SPACE_PARTS_MESH_H
