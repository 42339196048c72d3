// The same places on two point sets of one surface, found by their fast point feature histograms.
#include "../support/data_file.h"

#include <Shape_characteristics/descriptors/fpfh_descriptors.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <utility>
#include <vector>

namespace SC = Shape_characteristics;
namespace params = SC::parameters;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Oriented_point = std::pair<Kernel::Point_3, Kernel::Vector_3>;

int main()
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(support::data_file("meshes/elephant.off"), mesh))
    return EXIT_FAILURE;
  const auto normals = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
  const SC::Face_graph_samples surface = SC::sampled_surface(mesh, SC::Neighborhood::rings(1));
  for(const auto v : mesh.vertices())
  {
    const Eigen::Vector3d& n = surface.normal(v);
    normals[v] = Kernel::Vector_3(n.x(), n.y(), n.z());
  }

  // every other vertex, turned by a quarter, as a point set; its every tenth point is looked for among the vertices
  std::vector<Oriented_point> points;
  std::vector<std::size_t> sought;
  for(std::size_t i = 0; i < mesh.number_of_vertices(); i += 2)
  {
    const Mesh::Vertex_index v{Mesh::size_type(i)};
    const auto turned = [](const auto& p) { return std::make_pair(-p.y(), p.x()); };
    const auto [x, y] = turned(mesh.point(v));
    const auto [u, w] = turned(normals[v]);
    if(points.size() % 10 == 0)
      sought.push_back(points.size());
    points.emplace_back(Kernel::Point_3(x, y, mesh.point(v).z()), Kernel::Vector_3(u, w, normals[v].z()));
  }

  const double radius = 0.08;
  const SC::Descriptor_matrix of_mesh =
      SC::fpfh_descriptors(mesh, params::vertex_normal_map(normals).neighbor_radius(radius));
  const SC::Descriptor_matrix of_points =
      SC::fpfh_descriptors(points, params::point_map(CGAL::First_of_pair_property_map<Oriented_point>())
                                       .normal_map(CGAL::Second_of_pair_property_map<Oriented_point>())
                                       .neighbor_radius(radius)
                                       .descriptor_samples(sought));

  std::size_t compared = 0, found = 0;
  for(std::size_t k = 0; k < sought.size(); ++k)
  {
    if(!SC::is_estimated(of_points.status[k]))
      continue;
    ++compared;
    std::size_t nearest = 0;
    float smallest = 1e30f;
    for(std::size_t i = 0; i < mesh.number_of_vertices(); ++i)
      if(SC::is_estimated(of_mesh.status[i]))
      {
        const float distance =
            (of_mesh.values.row(Eigen::Index(i)) - of_points.values.row(Eigen::Index(k))).squaredNorm();
        if(distance < smallest)
        {
          smallest = distance;
          nearest = i;
        }
      }
    const Mesh::Vertex_index of_point{Mesh::size_type(2 * sought[k])};
    const auto d = mesh.point(Mesh::Vertex_index{Mesh::size_type(nearest)}) - mesh.point(of_point);
    found += std::sqrt(d.squared_length()) < radius;
  }
  std::cout << found << " of " << compared
            << " points are next to the vertex whose descriptor is the nearest\n";
  return found > compared / 2 ? EXIT_SUCCESS : EXIT_FAILURE;
}
