// A part with sharp edges: the curvatures there tell how densely the mesh samples them, and are left out.
#include "../support/Contact_sheet.h"
#include "../support/camera_for.h"
#include "../support/data_file.h"
#include "../support/drawable_mesh.h"
#include "../support/picture.h"

#include <Shape_characteristics/characteristics/is_sharp.h>
#include <Shape_characteristics/characteristics/mean_curvature.h>
#include <Shape_characteristics/curvature/hrbf_curvatures.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Curvatures = SC::Principal_curvatures_and_directions<Kernel>;

// argument: the folder to write sharp_vertices.png to
int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(support::data_file("meshes/fandisk.off"), mesh))
    return EXIT_FAILURE;
  auto curvatures = mesh.add_property_map<Mesh::Vertex_index, Curvatures>("v:curvatures").first;
  SC::hrbf_curvatures(mesh, SC::parameters::vertex_principal_curvatures_and_directions_map(curvatures));

  const SC::Face_graph_samples samples(mesh, mesh.points(), SC::Neighborhood::rings(1));
  support::Drawable shape = support::drawable_mesh(mesh), smooth = shape;
  std::size_t sharp = 0;
  for(const auto v : mesh.vertices())
  {
    const bool is_sharp = SC::is_sharp(curvatures[v], samples.spacing(v));
    const double mean_curvature = SC::mean_curvature(curvatures[v]);
    shape.scalars.push_back(mean_curvature);
    smooth.scalars.push_back(is_sharp ? std::numeric_limits<double>::quiet_NaN() : mean_curvature);
    sharp += is_sharp;
  }
  std::cout << "The surface is sharp at " << sharp << " of " << mesh.number_of_vertices() << " vertices.\n";

  support::Mesh_renderer renderer;
  support::Contact_sheet sheet;
  support::Picture_options options;
  options.width = 560;
  options.height = 420;
  options.missing_label = "sharp";
  options.render.camera = support::camera_for("fandisk");
  const auto add = [&](const std::string& name, const support::Drawable& drawable)
  {
    options.render.range = support::percentile_range(drawable.scalars, 0.02, true);
    sheet.add(support::picture(renderer, drawable, options), name);
  };
  add("mean curvature", shape);
  add("mean curvature without sharp vertices", smooth);
  support::write_png(std::string(argc > 1 ? argv[1] : ".") + "/sharp_vertices.png", sheet.image(2));
  return sharp > 0 && sharp < mesh.number_of_vertices() / 4 ? EXIT_SUCCESS : EXIT_FAILURE;
}
