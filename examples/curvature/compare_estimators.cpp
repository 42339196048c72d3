// The estimators side by side: a picture of the mean curvature of one mesh by each, with the same colours.
#include "../support/Contact_sheet.h"
#include "../support/Mesh_renderer.h"
#include "../support/camera_for.h"
#include "../support/data_file.h"
#include "../support/drawable_mesh.h"

#include <Shape_characteristics/curvature/hrbf_curvatures.h>
#include <Shape_characteristics/curvature/jet_fitting_curvatures.h>
#include <Shape_characteristics/curvature/rusinkiewicz_curvatures.h>
#include <Shape_characteristics/curvature/tangent_space_curvatures.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace SC = Shape_characteristics;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// argument: the folder to write compare_estimators.png to
int main(int argc, char* argv[])
{
  const std::string file_name = support::data_file("meshes/lion-head.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file_name, mesh))
    return EXIT_FAILURE;
  auto H = mesh.add_property_map<Mesh::Vertex_index, double>("v:mean_curvature").first;
  const auto np = SC::parameters::vertex_mean_curvature_map(H);

  support::Drawable shape = support::drawable_mesh(mesh);
  support::Mesh_renderer renderer;
  support::Render_options options;
  options.width = 300;
  options.height = 330;
  options.camera = support::camera_for(file_name);
  support::Contact_sheet sheet;
  bool is_right = true;

  const auto add_picture = [&](const std::string& estimator, std::size_t failed)
  {
    shape.scalars.assign(H.begin(), H.end());
    if(estimator == "HRBF") // the first one: the others shall have the same range
      options.range = support::percentile_range(shape.scalars, 0.06, true);
    sheet.add(renderer.render(shape, options), estimator);
    std::cout << estimator << ": " << failed << " of " << shape.points.size()
              << " vertices could not be estimated\n";
    is_right = is_right && failed < shape.points.size() / 100;
  };
  add_picture("HRBF", SC::hrbf_curvatures(mesh, np));
  add_picture("Rusinkiewicz", SC::rusinkiewicz_curvatures(mesh, np));
  add_picture("tangent space", SC::tangent_space_curvatures(mesh, np));
  add_picture("jet of degree 2", SC::jet_fitting_curvatures(mesh, np.degree_fitting(2)));

  support::Legend legend;
  legend.title = "mean curvature";
  legend.range = options.range;
  sheet.set_legend(legend);
  support::write_png(std::string(argc > 1 ? argv[1] : ".") + "/compare_estimators.png", sheet.image(4));
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
