// Curvatures of a triangle mesh by Rusinkiewicz's method.
#include <Shape_characteristics/curvature/rusinkiewicz_curvatures.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Curvatures = SC::Principal_curvatures_and_directions<Kernel>;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << filename << " can't be read\n";
    return EXIT_FAILURE;
  }

  auto curvatures = mesh.add_property_map<Mesh::Vertex_index, Curvatures>("v:curvatures").first;
  auto statuses = mesh.add_property_map<Mesh::Vertex_index, SC::Estimation_status>("v:status").first;
  const std::size_t failures = SC::rusinkiewicz_curvatures(
      mesh,
      SC::parameters::vertex_principal_curvatures_and_directions_map(curvatures).vertex_status_map(statuses));

  // the vertex that bends most
  Mesh::Vertex_index sharpest;
  double largest = -1;
  for(const auto v : mesh.vertices())
    if(SC::is_estimated(statuses[v]))
    {
      const double k =
          (std::max)(std::abs(curvatures[v].min_curvature), std::abs(curvatures[v].max_curvature));
      if(k > largest)
      {
        largest = k;
        sharpest = v;
      }
    }
  std::cout << mesh.number_of_vertices() << " vertices, " << failures << " without an estimate\n";
  if(largest < 0)
    return EXIT_FAILURE;
  std::cout << "curvatures of the sharpest one, " << mesh.point(sharpest) << ": "
            << curvatures[sharpest].min_curvature << " along " << curvatures[sharpest].min_direction << ", "
            << curvatures[sharpest].max_curvature << " along " << curvatures[sharpest].max_direction << '\n';
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
