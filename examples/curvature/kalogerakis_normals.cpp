// Noisy normals of a column with flat sides: averages with the neighbors' bend at its edges, those of robust statistics don't.
#include <Shape_characteristics/curvature/kalogerakis_normals.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Vector_3 = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main()
{
  // eight flat sides, with eight squares across each side
  const unsigned int sides = 8, across = 8, around = sides * across, rows = 24;
  Mesh mesh;
  auto exact = mesh.add_property_map<Mesh::Vertex_index, Vector_3>("v:exact_normal").first;
  auto noisy = mesh.add_property_map<Mesh::Vertex_index, Vector_3>("v:noisy_normal").first;
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0., .01);
  for(unsigned int row = 0; row <= rows; ++row)
    for(unsigned int i = 0; i < around; ++i)
    {
      const double a = 2. * CGAL_PI * (i / across) / sides, b = 2. * CGAL_PI * (i / across + 1) / sides;
      const double t = double(i % across) / across;
      const auto v = mesh.add_vertex(Kernel::Point_3((1. - t) * std::cos(a) + t * std::cos(b),
                                                     (1. - t) * std::sin(a) + t * std::sin(b), .1 * row));
      const double middle = .5 * (a + b);
      exact[v] = Vector_3(std::cos(middle), std::sin(middle), 0.);
      const Vector_3 n = exact[v] + Vector_3(noise(random), noise(random), noise(random));
      noisy[v] = n / std::sqrt(n.squared_length());
    }
  for(unsigned int row = 0; row < rows; ++row)
    for(unsigned int i = 0; i < around; ++i)
    {
      const auto vertex = [=](unsigned int r, unsigned int k)
      { return Mesh::Vertex_index(r * around + k % around); };
      mesh.add_face(vertex(row, i), vertex(row, i + 1), vertex(row + 1, i + 1));
      mesh.add_face(vertex(row, i), vertex(row + 1, i + 1), vertex(row + 1, i));
    }

  auto normals = mesh.add_property_map<Mesh::Vertex_index, Vector_3>("v:normal").first;
  // root mean square angle to the exact normals in degrees, of the vertices beside an edge and away from the rims, where most
  // neighbors can be those beyond the edge
  const auto error = [&](const auto& map)
  {
    double sum = 0.;
    unsigned int count = 0;
    for(const auto v : mesh.vertices())
      if((v.idx() % across == 1 || v.idx() % across == across - 1) && v.idx() / around > 1 &&
         v.idx() / around < rows - 1)
      {
        const double angle = CGAL::approximate_angle(map[v], exact[v]);
        sum += angle * angle;
        ++count;
      }
    return std::sqrt(sum / count);
  };

  for(const auto v : mesh.vertices())
  {
    Vector_3 sum = noisy[v];
    for(const auto w : mesh.vertices_around_target(mesh.halfedge(v)))
      sum += noisy[w];
    normals[v] = sum / std::sqrt(sum.squared_length());
  }
  const double of_averages = error(normals);
  const std::size_t failures =
      SC::kalogerakis_normals(mesh, normals, SC::parameters::vertex_normal_map(noisy));
  const double robust = error(normals);
  std::cout << "beside an edge, normals are off by " << error(noisy) << " degrees before, " << of_averages
            << " after averaging, " << robust << " by robust statistics; " << failures << " failures\n";
  return failures == 0 && robust < .7 * error(noisy) && robust < of_averages ? EXIT_SUCCESS : EXIT_FAILURE;
}
