// Principal curvatures of an ellipsoid from PN triangles, cubic patches over its faces, and how far they are from the truth.
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/zhihong_curvatures.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Curvatures = SC::Principal_curvatures_and_directions<Kernel>;

int main()
{
  // x^2 + y^2 + 4 z^2 = 1, an icosahedron divided four times and pushed onto it, with the normals of the formula
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Kernel::Point_3(0., 0., 0.), 1.);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(4));
  auto normals = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
  for(const auto v : mesh.vertices())
  {
    const Kernel::Vector_3 n = mesh.point(v) - CGAL::ORIGIN;
    const double length = std::sqrt(n.squared_length());
    mesh.point(v) = Kernel::Point_3(n.x() / length, n.y() / length, .5 * n.z() / length);
    normals[v] = Kernel::Vector_3(n.x(), n.y(), 2. * n.z()); // of any length
  }

  auto curvatures = mesh.add_property_map<Mesh::Vertex_index, Curvatures>("v:curvatures").first;
  const std::size_t failures = SC::zhihong_curvatures(
      mesh,
      SC::parameters::vertex_normal_map(normals).vertex_principal_curvatures_and_directions_map(curvatures));

  // half of the gradient, (x, y, 4 z), has the length g: 1 / g along the circle of latitude, 4 / g^3 along the meridian
  double largest = 0.;
  for(const auto v : mesh.vertices())
  {
    const Kernel::Point_3& p = mesh.point(v);
    const double g = std::sqrt(p.x() * p.x() + p.y() * p.y() + 16. * p.z() * p.z());
    const double of_circle = 1. / g, of_meridian = 4. / (g * g * g);
    largest = std::max({largest, std::abs(curvatures[v].min_curvature - std::min(of_circle, of_meridian)),
                        std::abs(curvatures[v].max_curvature - std::max(of_circle, of_meridian))});
  }
  std::cout << mesh.number_of_vertices() << " vertices, " << failures << " failures, largest error "
            << largest << " (curvatures from 1/2 to 4)\n";
  return failures == 0 && largest < .1 ? EXIT_SUCCESS : EXIT_FAILURE;
}
