// Curvatures of a mesh by Hermite radial basis functions: what can be asked for, the status of the vertices, one
// vertex alone, and what it helps to know the normals exactly. The mesh is an ellipsoid, whose curvatures are known.
#include "../support/data_file.h"

#include <Shape_characteristics/characteristics/mean_curvature.h>
#include <Shape_characteristics/curvature/hrbf_curvatures.h>
#include <Shape_characteristics/curvature/implicit_surface_curvatures.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <Eigen/Core>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Curvatures = SC::Principal_curvatures_and_directions<Kernel>;

int main()
{
  // a sphere that is stretched to the ellipsoid (x/3)^2 + (y/2)^2 + (z/2)^2 = 1; its gradients are its normals
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(support::data_file("meshes/larger_sphere.off"), mesh))
    return EXIT_FAILURE;
  const Eigen::Vector3d axes(3, 2, 2);
  const Eigen::Matrix3d hessian = (2 / axes.array().square()).matrix().asDiagonal();
  auto exact_normal = mesh.add_property_map<Vertex, Kernel::Vector_3>("v:exact_normal").first;
  for(Vertex v : mesh.vertices())
  {
    Kernel::Point_3& p = mesh.point(v);
    p = Kernel::Point_3(axes.x() * p.x(), axes.y() * p.y(), axes.z() * p.z());
    exact_normal[v] = Kernel::Vector_3(hessian(0, 0) * p.x(), hessian(1, 1) * p.y(), hessian(2, 2) * p.z());
  }

  // What gets a property map is computed. Normals that are not given are computed from the faces.
  auto curvatures = mesh.add_property_map<Vertex, Curvatures>("v:curvatures").first;
  auto H = mesh.add_property_map<Vertex, double>("v:mean_curvature").first;
  auto status = mesh.add_property_map<Vertex, SC::Estimation_status>("v:status").first;
  const std::size_t failed =
      SC::hrbf_curvatures(mesh, SC::parameters::vertex_principal_curvatures_and_directions_map(curvatures)
                                    .vertex_mean_curvature_map(H)
                                    .vertex_status_map(status)
                                    .number_of_rings(2));

  // the same with normals that are known exactly
  auto exact_H = mesh.add_property_map<Vertex, double>("v:mean_curvature_of_exact_normals").first;
  SC::hrbf_curvatures(mesh, SC::parameters::vertex_mean_curvature_map(exact_H)
                                .vertex_normal_map(exact_normal)
                                .normals_are_exact(true));

  double error = 0, exact_error = 0;
  for(Vertex v : mesh.vertices())
  {
    if(!SC::is_estimated(status[v])) // the values are NaN then
    {
      std::cout << v << ": " << SC::to_string(status[v]) << '\n';
      continue;
    }
    const double truth = SC::mean_curvature(SC::implicit_surface_curvatures(exact_normal[v], hessian));
    error += std::abs(H[v] - truth);
    exact_error += std::abs(exact_H[v] - truth);
  }
  error /= double(mesh.number_of_vertices());
  exact_error /= double(mesh.number_of_vertices());
  std::cout << failed << " vertices could not be estimated\n"
            << "mean error of H: " << error << ", with exact normals " << exact_error << '\n';

  // one vertex alone: the results are written to variables
  const Vertex v(0);
  Curvatures at_v;
  double H_at_v;
  const SC::Estimation_status status_of_v =
      SC::hrbf_curvatures(v, mesh,
                          SC::parameters::vertex_principal_curvatures_and_directions(std::ref(at_v))
                              .vertex_mean_curvature(std::ref(H_at_v)));
  std::cout << v << ": " << SC::to_string(status_of_v) << ", k_min " << at_v.min_curvature << " along "
            << at_v.min_direction << ", k_max " << at_v.max_curvature << " along " << at_v.max_direction
            << ", H " << H_at_v << '\n';

  return failed == 0 && error < 0.001 && exact_error < error / 2 && SC::is_estimated(status_of_v)
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
}
