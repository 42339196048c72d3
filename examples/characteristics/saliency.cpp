// What stands out on a mesh: its mean curvature shows each wrinkle, its saliency what people look at.
#include "../support/Contact_sheet.h"
#include "../support/camera_for.h"
#include "../support/data_file.h"
#include "../support/drawable_mesh.h"
#include "../support/picture.h"

#include <Shape_characteristics/characteristics/saliency.h>
#include <Shape_characteristics/curvature/hrbf_curvatures.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Curvatures = SC::Principal_curvatures_and_directions<Kernel>;

// argument: the folder to write saliency.png to
int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(support::data_file("meshes/armadillo.off"), mesh))
    return EXIT_FAILURE;
  auto curvatures = mesh.add_property_map<Mesh::Vertex_index, Curvatures>("v:curvatures").first;
  auto mean_curvature = mesh.add_property_map<Mesh::Vertex_index, double>("v:mean_curvature").first;
  auto saliency = mesh.add_property_map<Mesh::Vertex_index, double>("v:saliency").first;
  SC::hrbf_curvatures(mesh, SC::parameters::vertex_principal_curvatures_and_directions_map(curvatures)
                                .vertex_mean_curvature_map(mean_curvature));
  const std::size_t failed =
      SC::saliency(mesh, SC::parameters::vertex_principal_curvatures_and_directions_map(curvatures)
                             .vertex_saliency_map(saliency));
  const auto most = *std::max_element(mesh.vertices().begin(), mesh.vertices().end(),
                                      [&](auto v, auto w) { return saliency[v] < saliency[w]; });
  std::cout << failed << " of " << mesh.number_of_vertices()
            << " vertices have no saliency; the largest one, " << saliency[most] << ", is at "
            << mesh.point(most) << ".\n";

  support::Drawable shape = support::drawable_mesh(mesh);
  support::Mesh_renderer renderer;
  support::Contact_sheet sheet;
  support::Picture_options options;
  options.width = 560;
  options.height = 520;
  options.render.camera = support::camera_for("armadillo");
  const auto add = [&](const std::string& name, const auto& map, bool is_symmetric)
  {
    shape.scalars.clear();
    for(const auto v : mesh.vertices())
      shape.scalars.push_back(map[v]);
    options.render.range = support::percentile_range(shape.scalars, 0.02, is_symmetric);
    sheet.add(support::picture(renderer, shape, options), name);
  };
  add("mean curvature", mean_curvature, true);
  add("saliency", saliency, false);
  support::write_png(std::string(argc > 1 ? argv[1] : ".") + "/saliency.png", sheet.image(2));
  return failed < mesh.number_of_vertices() / 100 ? EXIT_SUCCESS : EXIT_FAILURE;
}
