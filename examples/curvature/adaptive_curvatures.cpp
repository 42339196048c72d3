// Curvatures by the estimators that suit the data, without saying what kind of data it is: a mesh with exact normals,
// with none, and with noise on its points; and which of them had the largest weight. The mesh is a barrel, whose
// curvatures are known; and once more, an ellipsoid.
#include "../support/Progress_bar.h"
#include "../support/data_file.h"

#include <Shape_characteristics/characteristics/mean_curvature.h>
#include <Shape_characteristics/curvature/adaptive_curvatures.h>
#include <Shape_characteristics/curvature/implicit_surface_curvatures.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <random>
#include <string>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Choice = SC::Adaptive_estimator_choice;

int main()
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(support::data_file("meshes/larger_sphere.off"), mesh))
    return EXIT_FAILURE;
  auto exact_normal = mesh.add_property_map<Vertex, Kernel::Vector_3>("v:exact_normal").first;
  auto exact_H = mesh.add_property_map<Vertex, double>("v:exact_mean_curvature").first;

  // moves the vertices along rays from the origin onto (x/3)^power + (y/2)^2 + (z/2)^2 = 1, power 2 or 4
  const auto make_surface = [&](const int power)
  {
    for(Vertex v : mesh.vertices())
    {
      Kernel::Point_3& p = mesh.point(v);
      const double a = std::pow(p.x() / 3, power), b = (p.y() * p.y() + p.z() * p.z()) / 4;
      const double square = power == 2 ? 1 / (a + b) : 2 / (b + std::sqrt(b * b + 4 * a)); // of the factor
      p = CGAL::ORIGIN + std::sqrt(square) * (p - CGAL::ORIGIN);
      exact_normal[v] = Kernel::Vector_3(power * std::pow(p.x() / 3, power - 1) / 3, p.y() / 2, p.z() / 2);
      const Eigen::Vector3d second(power * (power - 1) * std::pow(p.x() / 3, power - 2) / 9, .5, .5);
      const Eigen::Matrix3d hessian = second.asDiagonal();
      exact_H[v] = SC::mean_curvature(SC::implicit_surface_curvatures(exact_normal[v], hessian));
    }
  };

  // What gets a property map is computed; nothing is said of how good points and normals are.
  auto H = mesh.add_property_map<Vertex, double>("v:mean_curvature").first;
  auto choice = mesh.add_property_map<Vertex, Choice>("v:estimator").first;
  const auto outputs = SC::parameters::vertex_mean_curvature_map(H).vertex_estimator_map(choice);
  const auto report = [&](const std::string& what)
  {
    double error = 0;
    std::array<std::size_t, std::size_t(Choice::NONE) + 1> counts{};
    for(Vertex v : mesh.vertices())
    {
      error += std::abs(H[v] - exact_H[v]) / double(mesh.number_of_vertices());
      ++counts[std::size_t(choice[v])];
    }
    std::cout << what << ": mean error of H " << error << ", by";
    for(std::size_t c = 0; c < counts.size(); ++c)
      if(counts[c] > 0)
        std::cout << ' ' << SC::to_string(Choice(c)) << " (" << counts[c] << ")";
    std::cout << '\n';
    return error;
  };

  make_surface(2);
  SC::adaptive_curvatures(mesh, outputs);
  const double of_quadric = report("ellipsoid, no normals");

  make_surface(4);
  SC::adaptive_curvatures(mesh, outputs.vertex_normal_map(exact_normal));
  const double of_exact_normals = report("exact normals");
  SC::adaptive_curvatures(mesh, outputs.callback(support::Progress_bar("no normals"))); // the longer steps
  const double of_points = report("no normals");

  // one vertex alone: the results are written to variables
  const Vertex v(0);
  double H_at_v;
  const SC::Estimation_status status =
      SC::adaptive_curvatures(v, mesh, SC::parameters::vertex_mean_curvature(std::ref(H_at_v)));
  std::cout << v << ": " << SC::to_string(status) << ", H " << H_at_v << '\n';

  std::mt19937 random(1);
  std::normal_distribution<double> noise(0., .003);
  for(Vertex w : mesh.vertices())
    mesh.point(w) = mesh.point(w) + Kernel::Vector_3(noise(random), noise(random), noise(random));
  SC::adaptive_curvatures(mesh, outputs.callback(support::Progress_bar("noise")));
  const double of_noise = report("no normals, noisy points");

  return SC::is_estimated(status) && of_quadric < 1e-12 && of_exact_normals < 1e-4 && of_points < 1e-4 &&
                 of_noise < .02
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
}
