// The mean curvature at every vertex of a mesh, in ten lines.
#include "../support/data_file.h"

#include <Shape_characteristics/curvature/hrbf_curvatures.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>

namespace SC = Shape_characteristics;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : support::data_file("meshes/elephant.off"), mesh))
    return 1;
  auto H = mesh.add_property_map<Mesh::Vertex_index, double>("v:mean_curvature").first;
  const std::size_t failed = SC::hrbf_curvatures(mesh, SC::parameters::vertex_mean_curvature_map(H));
  for(auto v : mesh.vertices())
    std::cout << mesh.point(v) << " " << H[v] << "\n";
  std::cerr << failed << " of " << mesh.number_of_vertices() << " vertices could not be estimated\n";
  return failed == mesh.number_of_vertices();
}
