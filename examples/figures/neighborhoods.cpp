// The figure of the manual that shows neighborhoods: a vertex with one ring, two rings, and a ball.
#include "../support/Contact_sheet.h"
#include "../support/Painter.h"
#include "../support/data_file.h"

#include <Shape_characteristics/sampling/Face_graph_samples.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

namespace SC = Shape_characteristics;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Index = SC::Face_graph_samples::Index;

// The mesh around a vertex, seen from above, with its neighbors.
support::Image draw(const Mesh& mesh, Index center, const SC::Neighborhood& neighborhood, double scale)
{
  SC::Face_graph_samples::Workspace workspace;
  const SC::Face_graph_samples samples(mesh, mesh.points(), neighborhood);
  const std::vector<Index>& neighbors = samples.neighbors(center, 0, workspace);

  // a view along the sum of the normals of the triangles there
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  const auto point = [&](Mesh::Vertex_index v) { return samples.point(std::size_t(v)); };
  for(auto h : mesh.halfedges_around_target(mesh.halfedge(Mesh::Vertex_index(center))))
    normal += (point(mesh.target(mesh.next(h))) - point(mesh.target(h)))
                  .cross(point(mesh.source(h)) - point(mesh.target(h)));
  normal.normalize();
  const Eigen::Vector3d right = normal.unitOrthogonal(), up = normal.cross(right);

  constexpr int size = 330;
  support::Image image(size, size);
  support::Painter painter(image);
  const auto to_pixel = [&](const Eigen::Vector3d& p)
  {
    const Eigen::Vector3d d = scale * (p - samples.point(center));
    return support::Pixel_point{size / 2. + d.dot(right), size / 2. - d.dot(up)};
  };
  const auto is_near = [&](Mesh::Vertex_index v)
  { return scale * (point(v) - samples.point(center)).norm() < size; };

  for(auto e : mesh.edges())
    if(is_near(mesh.vertex(e, 0)) && is_near(mesh.vertex(e, 1)))
      painter.polyline({to_pixel(point(mesh.vertex(e, 0))), to_pixel(point(mesh.vertex(e, 1)))}, 1.5,
                       {150, 154, 160, 255});
  if(neighborhood.kind() == SC::Neighborhood::Kind::BALL)
  {
    std::vector<support::Pixel_point> circle;
    for(int k = 0; k <= 90; ++k)
    {
      const double angle = k * 4 * CGAL_PI / 180, r = scale * neighborhood.radius();
      circle.push_back({size / 2. + r * std::cos(angle), size / 2. + r * std::sin(angle)});
    }
    painter.polyline(circle, 2, {60, 90, 200, 255}, 9);
  }
  for(Index i : neighbors)
    painter.marker(support::Marker::DISC, to_pixel(samples.point(i)), 13, {36, 150, 60, 255});
  painter.marker(support::Marker::DISC, to_pixel(samples.point(center)), 17, {206, 40, 32, 255});
  return image;
}

} // namespace

// argument: the folder to write neighborhoods.png to
int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(support::data_file("meshes/bunny00.off"), mesh))
    return EXIT_FAILURE;
  const Index center = 1000;
  SC::Face_graph_samples::Workspace workspace;
  const SC::Face_graph_samples samples(mesh, mesh.points(), SC::Neighborhood::rings(3));
  double width = 0; // of three rings
  for(Index i : samples.neighbors(center, 0, workspace))
    width = std::max(width, 2 * (samples.point(i) - samples.point(center)).norm());
  const double scale = 330 / width;

  support::Contact_sheet sheet;
  sheet.add(draw(mesh, center, SC::Neighborhood::rings(1), scale), "number_of_rings(1)");
  sheet.add(draw(mesh, center, SC::Neighborhood::rings(2), scale), "number_of_rings(2)");
  sheet.add(draw(mesh, center, SC::Neighborhood::ball(0.35 * width), scale), "neighbor_radius(r)");
  support::write_png(std::string(argc > 1 ? argv[1] : ".") + "/neighborhoods.png", sheet.image(3));
  return EXIT_SUCCESS;
}
