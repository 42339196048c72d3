#ifndef SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_READ_TRIANGLE_MESH_H
#define SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_READ_TRIANGLE_MESH_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <string>

namespace support {

/// The mesh in a file of a format that CGAL reads, its faces cut into triangles. Throws `std::runtime_error` if there is none,
/// or one without vertices.
CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> read_triangle_mesh(const std::string& filename);

} // namespace support

#endif
