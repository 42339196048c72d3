// Vertex normals re-estimated by Hermite radial basis functions.
#include "../support/data_file.h"

#include <Shape_characteristics/normals/hrbf_normals.h>
#include <Shape_characteristics/normals/vertex_normals.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Normals = Mesh::Property_map<Mesh::Vertex_index, Kernel::Vector_3>;

int main()
{
  // a sphere that is stretched to the ellipsoid (x/3)^2 + (y/2)^2 + (z/2)^2 = 1
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(support::data_file("meshes/larger_sphere.off"), mesh))
    return EXIT_FAILURE;
  for(auto v : mesh.vertices())
  {
    Kernel::Point_3& p = mesh.point(v);
    p = Kernel::Point_3(3 * p.x(), 2 * p.y(), 2 * p.z());
  }

  Normals normals = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
  const auto mean_angle = [&]
  {
    double sum = 0;
    for(auto v : mesh.vertices())
    {
      const Kernel::Point_3& p = mesh.point(v);
      Kernel::Vector_3 truth(p.x() / 9, p.y() / 4, p.z() / 4);
      truth = truth / std::sqrt(truth.squared_length());
      sum += std::asin(std::min(1., std::sqrt(CGAL::cross_product(normals[v], truth).squared_length())));
    }
    return sum / double(mesh.number_of_vertices()) * 180 / CGAL_PI;
  };

  // weighted sums of the normals of the faces, then better ones, which start from them
  std::size_t failed = SC::vertex_normals(mesh, normals);
  const double before = mean_angle();
  failed += SC::hrbf_normals(mesh, normals, SC::parameters::vertex_normal_map(normals));
  const double after = mean_angle();
  std::cout << "mean angle between the normals and those of the ellipsoid, in degrees: " << before
            << " before, " << after << " after\n";
  return failed == 0 && after < before / 2 ? EXIT_SUCCESS : EXIT_FAILURE;
}
