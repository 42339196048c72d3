// Vertex normals as weighted sums of the normals of the faces, and how far they are from the normals of the surface.
#include "../support/data_file.h"

#include <Shape_characteristics/normals/vertex_normals.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <tuple>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main()
{
  // the vertices lie on the unit sphere: a normal should be equal to its point
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(support::data_file("meshes/larger_sphere.off"), mesh))
    return EXIT_FAILURE;

  auto normals = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
  double best = 1, of_default = 1;
  for(const auto& [name, weighting] : {std::make_tuple("average", SC::Normal_weighting::AVERAGE),
                                       std::make_tuple("area", SC::Normal_weighting::AREA),
                                       std::make_tuple("angle", SC::Normal_weighting::ANGLE),
                                       std::make_tuple("Max", SC::Normal_weighting::MAX)})
  {
    const std::size_t failed = SC::vertex_normals(mesh, normals, SC::parameters::normal_weighting(weighting));
    double error = 0; // the sine of the angle
    for(auto v : mesh.vertices())
      error = std::max(
          error, std::sqrt(CGAL::cross_product(normals[v], mesh.point(v) - CGAL::ORIGIN).squared_length()));
    std::cout << name << ": at most " << error * 180 / CGAL_PI << " degrees off, " << failed
              << " vertices without a normal\n";
    best = std::min(best, error);
    of_default = error; // Max is the default
  }
  return of_default == best && best < 1e-6 ? EXIT_SUCCESS : EXIT_FAILURE;
}
