// The neighborhoods of the vertices of a mesh (rings of edges, a ball) and of the points of a set (the nearest ones).
#include "../support/data_file.h"

#include <Shape_characteristics/sampling/Face_graph_samples.h>
#include <Shape_characteristics/sampling/Neighborhood.h>
#include <Shape_characteristics/sampling/Point_set_samples.h>
#include <Shape_characteristics/sampling/for_each_sample.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/property_map.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// Prints how many neighbors the samples have on average, and returns how many sample 0 has. Asking for neighbors
// needs scratch memory: a Workspace for each thread.
template <typename Samples>
std::size_t count_neighbors(const std::string& name, const Samples& samples)
{
  std::vector<std::size_t> count(samples.size());
  SC::for_each_sample<CGAL::Parallel_if_available_tag, typename Samples::Workspace>(
      samples.size(), [&](std::size_t i, typename Samples::Workspace& workspace)
      { count[i] = samples.neighbors(i, 0, workspace).size(); });
  double sum = 0;
  for(std::size_t n : count)
    sum += double(n);
  std::cout << name << ": " << sum / double(count.size()) << " neighbors on average, " << count[0]
            << " of sample 0\n";
  return count[0];
}

int main()
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(support::data_file("meshes/elephant.off"), mesh))
    return EXIT_FAILURE;

  const SC::Face_graph_samples one_ring(mesh, mesh.points(), SC::Neighborhood::rings(1));
  const SC::Face_graph_samples two_rings(mesh, mesh.points(), SC::Neighborhood::rings(2));
  const double radius = 2.5 * one_ring.mean_spacing();
  const SC::Face_graph_samples ball(mesh, mesh.points(), SC::Neighborhood::ball(radius));
  const std::size_t in_one_ring = count_neighbors("1 ring", one_ring);
  const std::size_t in_two_rings = count_neighbors("2 rings", two_rings);
  const std::size_t in_ball = count_neighbors("ball of 2.5 edges", ball);

  std::vector<Kernel::Point_3> points(mesh.points().begin(), mesh.points().end());
  const SC::Point_set_samples nearest(points, CGAL::Identity_property_map<Kernel::Point_3>(),
                                      SC::Neighborhood::nearest(18));
  const std::size_t in_nearest = count_neighbors("18 nearest points", nearest);

  return in_one_ring == mesh.degree(Mesh::Vertex_index(0)) && in_two_rings > in_one_ring && in_ball > 0 &&
                 in_nearest == 18
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
}
