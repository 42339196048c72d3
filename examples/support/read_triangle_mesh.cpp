#include "read_triangle_mesh.h"

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <stdexcept>

namespace support {

CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> read_triangle_mesh(const std::string& filename)
{
  CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || mesh.is_empty())
    throw std::runtime_error(filename + " can't be read as a mesh");
  if(!CGAL::is_triangle_mesh(mesh))
    CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
  return mesh;
}

} // namespace support
