// The same header as main.cpp: a program may have several sources that include the library.
#include <Shape_characteristics/curvature/rusinkiewicz_curvatures.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <cmath>
#include <limits>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// The average over the vertices of a ball's mesh, NaN if one of them could not be estimated.
double curvature_of_a_ball(double radius)
{
  Mesh mesh;
  CGAL::make_icosahedron<Mesh, Kernel::Point_3>(mesh);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(2));
  auto normals = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
  for(const Mesh::Vertex_index v : mesh.vertices())
  {
    const Kernel::Vector_3 d = mesh.point(v) - CGAL::ORIGIN;
    normals[v] = d / std::sqrt(d.squared_length());
    mesh.point(v) = CGAL::ORIGIN + radius * normals[v];
  }

  auto curvatures = mesh.add_property_map<Mesh::Vertex_index, double>("v:curvature").first;
  if(SC::rusinkiewicz_curvatures(
         mesh, SC::parameters::vertex_mean_curvature_map(curvatures).vertex_normal_map(normals)) != 0)
    return std::numeric_limits<double>::quiet_NaN();
  double sum = 0;
  for(const double curvature : curvatures)
    sum += curvature;
  return sum / double(mesh.number_of_vertices());
}
