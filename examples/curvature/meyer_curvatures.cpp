// Curvatures of a closed triangle mesh by its angle defects and cotangents, and its total Gaussian curvature.
#include <Shape_characteristics/curvature/meyer_curvatures.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// the part of the area of a triangle that belongs to its corner `p`
double mixed_area(const Kernel::Point_3& p, const Kernel::Point_3& q, const Kernel::Point_3& r)
{
  const double at_p = (q - p) * (r - p), at_q = (p - q) * (r - q), at_r = (p - r) * (q - r);
  const double area = std::sqrt(CGAL::squared_area(p, q, r));
  if(at_p < 0.)
    return area / 2.;
  if(at_q < 0. || at_r < 0.)
    return area / 4.;
  return ((q - p).squared_length() * at_r + (r - p).squared_length() * at_q) / (16. * area);
}

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
  auto Gaussian = mesh.add_property_map<Mesh::Vertex_index, double>("v:Gaussian").first;
  const std::size_t failures = SC::meyer_curvatures(
      mesh, SC::parameters::vertex_mean_curvature_map(mean).vertex_Gaussian_curvature_map(Gaussian));

  // integrals over the surface: each vertex stands for its mixed area
  double area = 0., of_mean = 0., of_Gaussian = 0.;
  for(const auto h : mesh.halfedges())
    if(!mesh.is_border(h))
    {
      const auto v = mesh.target(h);
      const double a =
          mixed_area(mesh.point(v), mesh.point(mesh.source(h)), mesh.point(mesh.target(mesh.next(h))));
      area += a;
      of_mean += a * mean[v];
      of_Gaussian += a * Gaussian[v];
    }
  const double characteristic =
      double(mesh.number_of_vertices()) - double(mesh.number_of_edges()) + double(mesh.number_of_faces());
  std::cout << mesh.number_of_vertices() << " vertices, " << failures << " without an estimate\n"
            << "mean curvature on average " << of_mean / area << '\n'
            << "total Gaussian curvature " << of_Gaussian << ", 2 pi times the Euler characteristic "
            << 2. * CGAL_PI * characteristic << '\n';
  if(failures > 0 || !CGAL::is_closed(mesh))
    return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
  return std::abs(of_Gaussian - 2. * CGAL_PI * characteristic) < 1e-6 ? EXIT_SUCCESS : EXIT_FAILURE;
}
