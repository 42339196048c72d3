// Mean curvature of a mesh over balls of several radii: details fade as the ball grows.
#include <Shape_characteristics/curvature/normal_cycle_curvatures.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << filename << " can't be read\n";
    return EXIT_FAILURE;
  }
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double size = std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());

  auto mean = mesh.add_property_map<Mesh::Vertex_index, double>("v:mean").first;
  double before = 0.;
  for(const double share : {.02, .03, .04})
  {
    const std::size_t failures = SC::normal_cycle_curvatures(
        mesh, SC::parameters::vertex_mean_curvature_map(mean).neighbor_radius(share * size));
    double sum = 0.;
    for(const auto v : mesh.vertices())
      if(std::isfinite(mean[v]))
        sum += std::abs(mean[v]);
    sum /= double(mesh.number_of_vertices() - failures);
    std::cout << "radius " << share * size << ": mean curvature of " << sum << " in magnitude, " << failures
              << " vertices without an estimate\n";
    if(before > 0. && !(sum < before))
      return EXIT_FAILURE;
    before = sum;
  }
  return EXIT_SUCCESS;
}
