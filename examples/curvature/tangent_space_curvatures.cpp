// Curvatures of a torus from the shape operators of its triangles, with their two choices.
#include <Shape_characteristics/curvature/tangent_space_curvatures.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main()
{
  // a tube of radius 1 around a circle of radius 3
  const int n = 60, m = 20;
  Mesh mesh;
  std::vector<double> exact;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < m; ++j)
    {
      const double u = 2 * CGAL_PI * i / n, v = 2 * CGAL_PI * j / m, r = 3 + std::cos(v);
      mesh.add_vertex(Kernel::Point_3(r * std::cos(u), r * std::sin(u), std::sin(v)));
      exact.push_back((1 + std::cos(v) / r) / 2); // mean of 1 across and cos(v) / r along the circle
    }
  const auto vertex = [&](int i, int j) { return Mesh::Vertex_index(unsigned((i % n) * m + j % m)); };
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < m; ++j)
    {
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }

  auto mean_curvature = mesh.add_property_map<Mesh::Vertex_index, double>("v:mean_curvature").first;
  bool is_right = true;
  for(const int edges : {2, 3})
    for(const auto weighting : {SC::Face_weighting::UNIFORM, SC::Face_weighting::AREA})
    {
      SC::tangent_space_curvatures(mesh, SC::parameters::vertex_mean_curvature_map(mean_curvature)
                                             .number_of_edges(edges)
                                             .face_weighting(weighting));
      double error = 0;
      for(const auto v : mesh.vertices())
        error += std::abs(mean_curvature[v] - exact[v]) / double(mesh.number_of_vertices());
      std::cout << edges << " edges, " << (weighting == SC::Face_weighting::AREA ? "areas" : "equal weights")
                << ": mean error " << error << '\n';
      is_right = is_right && error < 0.01;
    }
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
