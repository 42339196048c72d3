#include "Mesh.h"

namespace registration {

Mesh to_mesh(const Scan& scan)
{
  Mesh mesh;
  for(const Eigen::Vector3d& p : scan.points)
    mesh.add_vertex({p.x(), p.y(), p.z()});
  for(const auto& t : scan.triangles)
    mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
  return mesh;
}

} // namespace registration
