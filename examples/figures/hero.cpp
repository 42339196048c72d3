// The picture at the head of the README: the mean curvature of a mesh, of another one, and of a point set.
#include "../support/Mesh_renderer.h"
#include "../support/Painter.h"
#include "../support/camera_for.h"
#include "../support/data_file.h"
#include "../support/drawable_mesh.h"
#include "../support/drawable_point_set.h"

#include <Shape_characteristics/curvature/hrbf_curvatures.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO/XYZ.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>

namespace {

namespace SC = Shape_characteristics;
using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Point_set = CGAL::Point_set_3<Point_3>;

support::Drawable mesh_with_curvature(const std::string& file_name)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file_name, mesh))
    throw std::runtime_error("cannot read " + file_name);
  auto H = mesh.add_property_map<Mesh::Vertex_index, double>("v:mean_curvature").first;
  SC::hrbf_curvatures(mesh, SC::parameters::vertex_mean_curvature_map(H));
  support::Drawable shape = support::drawable_mesh(mesh);
  shape.scalars.assign(H.begin(), H.end());
  return shape;
}

support::Drawable point_set_with_curvature(const std::string& file_name)
{
  Point_set points;
  std::ifstream file(file_name);
  if(!CGAL::IO::read_XYZ(file, points) || !points.has_normal_map())
    throw std::runtime_error("cannot read " + file_name);
  auto H = points.add_property_map<double>("mean_curvature").first;
  SC::hrbf_curvatures(points, SC::parameters::mean_curvature_map(H));
  support::Drawable shape = support::drawable_point_set(points);
  for(const Point_set::Index& i : points)
    shape.scalars.push_back(H[i]);
  return shape;
}

} // namespace

// argument: the folder to write hero.png to
int main(int argc, char* argv[])
{
  constexpr int width = 1040, height = 424, shape_height = 370;
  support::Image image(width, height);
  support::Mesh_renderer renderer;
  support::Render_options options;
  options.height = shape_height;
  int left = 0;
  const auto add = [&](const support::Drawable& shape, const std::string& file_name, int shape_width)
  {
    options.width = shape_width;
    options.camera = support::camera_for(file_name);
    options.range = support::percentile_range(shape.scalars, 0.05, true);
    image.paste(renderer.render(shape, options), left, 0);
    left += shape_width;
  };
  add(mesh_with_curvature(support::data_file("meshes/bunny00.off")), "bunny00", 390);
  add(mesh_with_curvature(support::data_file("meshes/lion-head.off")), "lion-head", 340);
  add(point_set_with_curvature(support::data_file("points_3/kitten.xyz")), "kitten", width - left);

  // each shape has its own range, so that the colours are named by what they mean
  support::Painter painter(image);
  const support::Rectangle bar = {(width - 420) / 2., height - 38., 420, 16};
  for(int x = 0; x < int(bar.width); ++x)
    painter.fill({bar.left + x, bar.top, 1, bar.height}, options.gradient.pixel(x / (bar.width - 1)));
  support::Text_style style;
  style.size = 22;
  style.vertical = support::Vertical_alignment::MIDDLE;
  painter.text("convex", {bar.right() + 14, bar.top + bar.height / 2}, style);
  style.horizontal = support::Horizontal_alignment::RIGHT;
  painter.text("concave", {bar.left - 14, bar.top + bar.height / 2}, style);
  support::write_png(std::string(argc > 1 ? argv[1] : ".") + "/hero.png", image);
  return EXIT_SUCCESS;
}
