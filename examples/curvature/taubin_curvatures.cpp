// Taubin's curvatures of a mesh beside Rusinkiewicz's: the same where edges leave a vertex in all directions alike.
#include <Shape_characteristics/curvature/rusinkiewicz_curvatures.h>
#include <Shape_characteristics/curvature/taubin_curvatures.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

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

  auto mean = mesh.add_property_map<Mesh::Vertex_index, double>("v:mean").first;
  auto other_mean = mesh.add_property_map<Mesh::Vertex_index, double>("v:other_mean").first;
  auto statuses = mesh.add_property_map<Mesh::Vertex_index, SC::Estimation_status>("v:status").first;
  const std::size_t failures = SC::taubin_curvatures(
      mesh, SC::parameters::vertex_mean_curvature_map(mean).vertex_status_map(statuses));
  SC::rusinkiewicz_curvatures(mesh, SC::parameters::vertex_mean_curvature_map(other_mean));

  std::vector<double> differences;
  for(const auto v : mesh.vertices())
    if(SC::is_estimated(statuses[v]))
      differences.push_back(std::abs(mean[v] - other_mean[v]) /
                            (std::max)({std::abs(mean[v]), std::abs(other_mean[v]), 1e-300}));
  std::cout << mesh.number_of_vertices() << " vertices, " << failures << " without an estimate\n";
  if(differences.empty())
    return EXIT_FAILURE;
  const auto middle = differences.begin() + std::ptrdiff_t(differences.size() / 2);
  std::nth_element(differences.begin(), middle, differences.end());
  std::cout << "mean curvatures differ from Rusinkiewicz's by " << 100. * *middle << " % (median)\n";
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
