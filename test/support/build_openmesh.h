#ifndef SHAPE_CHARACTERISTICS_TEST_SUPPORT_BUILD_OPENMESH_H
#define SHAPE_CHARACTERISTICS_TEST_SUPPORT_BUILD_OPENMESH_H

#include <stdexcept>
#include <vector>

namespace test_support {

/// An OpenMesh mesh, by OpenMesh's own functions, from anything with `points` and `triangles`.
template <typename Mesh, typename Surface>
Mesh build_openmesh(const Surface& surface)
{
  Mesh mesh;
  std::vector<typename Mesh::VertexHandle> vertices, corners;
  for(const auto& p : surface.points)
    vertices.push_back(mesh.add_vertex(typename Mesh::Point(p[0], p[1], p[2])));
  for(const auto& t : surface.triangles)
  {
    corners.clear();
    for(std::size_t i : t)
      corners.push_back(vertices[i]);
    if(!mesh.add_face(corners).is_valid())
      throw std::runtime_error("build_openmesh: a face can't be added");
  }
  return mesh;
}

} // namespace test_support

#endif // SHAPE_CHARACTERISTICS_TEST_SUPPORT_BUILD_OPENMESH_H
