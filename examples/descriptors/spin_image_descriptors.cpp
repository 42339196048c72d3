// Where a bust looks like an ear, by its spin images. They don't tell left from right: the other ear does.
#include "../support/Contact_sheet.h"
#include "../support/Painter.h"
#include "../support/camera_for.h"
#include "../support/data_file.h"
#include "../support/drawable_mesh.h"
#include "../support/picture.h"

#include <Shape_characteristics/descriptors/spin_image_descriptors.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace {

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

constexpr unsigned int width = 16; // of a spin image, in cells

// the correlation of each spin image with that of a vertex: 1 of equal ones; NaN where there is none
std::vector<double> correlations(const SC::Descriptor_matrix& spin_images, Mesh::Vertex_index v)
{
  const auto centered = [&](Eigen::Index i)
  {
    const Eigen::RowVectorXf row = spin_images.values.row(i);
    return Eigen::RowVectorXf((row.array() - row.mean()).matrix().normalized());
  };
  const Eigen::RowVectorXf of_v = centered(Eigen::Index(v));
  std::vector<double> result;
  for(Eigen::Index i = 0; i < spin_images.values.rows(); ++i)
    result.push_back(double(centered(i).dot(of_v)));
  return result;
}

// The spin images of some vertices, side by side: the normal's line is at the left of each, the tangent plane halfway up. What is dark
// has more neighbors.
support::Image draw(const SC::Descriptor_matrix& spin_images, const std::vector<Mesh::Vertex_index>& some)
{
  constexpr int cell = 10, columns = int(width) + 1, rows = 2 * int(width) + 1, gap = 40;
  const support::Color_gradient gradient({{1, 1, 1}, {.35, .6, .85}, {.05, .1, .3}});
  support::Image image(int(some.size()) * (cell * columns + gap) - gap, cell * rows);
  support::Painter painter(image);
  double left = 0;
  for(const auto v : some)
  {
    const Eigen::RowVectorXf values = spin_images.values.row(Eigen::Index(v));
    const float largest = values.maxCoeff();
    for(int a = 0; a < columns; ++a)
      for(int b = 0; b < rows; ++b)
      {
        const double share = double(values[a * rows + b] / largest);
        painter.fill({left + cell * a, double(cell * (rows - 1 - b)), cell, cell},
                     gradient.pixel(std::sqrt(share)));
      }
    painter.frame({left, 0, cell * columns, cell * rows}, 1, {150, 154, 160, 255});
    left += cell * columns + gap;
  }
  return image;
}

} // namespace

// argument: the folder to write spin_images.png to
int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(support::data_file("meshes/mannequin-devil.off"), mesh))
    return EXIT_FAILURE;
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double size = std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());

  const SC::Descriptor_matrix spin_images =
      SC::spin_image_descriptors(mesh, SC::parameters::neighbor_radius(.15 * size).image_width(width));

  // what is farthest to one side, above the shoulders; what is most like it on the other half; what is least like it
  const Kernel::Point_3 center = CGAL::midpoint(Kernel::Point_3(box.xmin(), box.ymin(), box.zmin()),
                                                Kernel::Point_3(box.xmax(), box.ymax(), box.zmax()));
  Mesh::Vertex_index ear = *mesh.vertices().begin();
  for(const auto v : mesh.vertices())
    if(mesh.point(v).z() > center.z() && mesh.point(v).x() > mesh.point(ear).x())
      ear = v;
  const std::vector<double> similarities = correlations(spin_images, ear);
  Mesh::Vertex_index other = Mesh::null_vertex(), least = ear;
  for(const auto v : mesh.vertices())
  {
    if(mesh.point(v).x() < center.x() &&
       (other == Mesh::null_vertex() || similarities[v] > similarities[other]))
      other = v;
    if(similarities[v] < similarities[least])
      least = v;
  }
  const Kernel::Point_3 p = mesh.point(ear), q = mesh.point(other);
  const double distance = std::hypot(2 * center.x() - p.x() - q.x(), p.y() - q.y(), p.z() - q.z()) / size;
  std::cout << "On the other half, what is most like the ear is " << distance
            << " sizes of the bust off the mirror image; their spin images have the correlation "
            << similarities[other] << ".\n";

  support::Drawable shape = support::drawable_mesh(mesh);
  shape.scalars = similarities;
  support::Mesh_renderer renderer;
  support::Picture_options options;
  options.width = 600;
  options.height = 480;
  options.render.camera = support::camera_for("mannequin-devil");
  options.render.range = support::percentile_range(shape.scalars, 0, false);
  support::Contact_sheet sheet;
  sheet.add(support::picture(renderer, shape, options), "correlation with an ear");
  sheet.add(draw(spin_images, {ear, other, least}), "of the ear, most and least like it");
  support::write_png(std::string(argc > 1 ? argv[1] : ".") + "/spin_images.png", sheet.image(2));
  return distance < .05 ? EXIT_SUCCESS : EXIT_FAILURE;
}
