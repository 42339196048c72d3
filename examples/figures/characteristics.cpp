// The figure of the manual that shows what the characteristics tell of a shape.
#include "../support/Contact_sheet.h"
#include "../support/camera_for.h"
#include "../support/data_file.h"
#include "../support/drawable_point_set.h"
#include "../support/picture.h"

#include <Shape_characteristics/characteristics/Gaussian_curvature.h>
#include <Shape_characteristics/characteristics/curvedness.h>
#include <Shape_characteristics/characteristics/mean_curvature.h>
#include <Shape_characteristics/characteristics/shape_index.h>
#include <Shape_characteristics/curvature/hrbf_curvatures.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO/XYZ.h>
#include <CGAL/Simple_cartesian.h>

#include <cstdlib>
#include <fstream>
#include <string>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Point_set = CGAL::Point_set_3<Kernel::Point_3>;
using Curvatures = SC::Principal_curvatures_and_directions<Kernel>;

// argument: the folder to write characteristics.png to
int main(int argc, char* argv[])
{
  Point_set points;
  std::ifstream file(support::data_file("points_3/kitten.xyz"));
  if(!CGAL::IO::read_XYZ(file, points) || !points.has_normal_map())
    return EXIT_FAILURE;
  auto curvatures = points.add_property_map<Curvatures>("curvatures").first;
  const std::size_t failed =
      SC::hrbf_curvatures(points, SC::parameters::principal_curvatures_and_directions_map(curvatures));

  support::Drawable shape = support::drawable_point_set(points);
  support::Mesh_renderer renderer;
  support::Contact_sheet sheet;
  support::Picture_options options;
  options.width = 390;
  options.height = 340;
  options.render.camera = support::camera_for("kitten");
  const auto add = [&](const std::string& name, auto characteristic, bool is_symmetric)
  {
    shape.scalars.clear();
    for(const Point_set::Index& i : points)
      shape.scalars.push_back(characteristic(curvatures[i]));
    options.render.range = support::percentile_range(shape.scalars, 0.04, is_symmetric);
    if(name == "shape index")
    {
      options.render.range = support::Value_range();
      options.render.range.low = -1;
    }
    sheet.add(support::picture(renderer, shape, options), name);
  };
  add(
      "mean curvature", [](const Curvatures& c) { return SC::mean_curvature(c); }, true);
  add(
      "Gaussian curvature", [](const Curvatures& c) { return SC::Gaussian_curvature(c); }, true);
  add(
      "shape index", [](const Curvatures& c) { return SC::shape_index(c); }, true);
  add(
      "curvedness", [](const Curvatures& c) { return SC::curvedness(c); }, false);
  support::write_png(std::string(argc > 1 ? argv[1] : ".") + "/characteristics.png", sheet.image(2));
  return failed < points.size() / 100 ? EXIT_SUCCESS : EXIT_FAILURE;
}
