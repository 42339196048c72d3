// Curvature of what a picture shows, per pixel, on the GPU: mean curvature without and with level of detail and by spheres, Gaussian curvature and
// shape index.
//
//     screen_space_curvature mesh out.png [--size 400] [--lod 0.012] [--triangles 4] [--edges 2]
//
// Without a mesh, one that comes with CGAL is taken. `--lod` is how far away the pixels are from which curvature is estimated, in diagonals of the
// bounding box.
#include "../support/Color_gradient.h"
#include "../support/Contact_sheet.h"
#include "../support/Image.h"
#include "../support/Offscreen_context.h"
#include "../support/Orbit_camera.h"
#include "../support/Value_range.h"
#include "../support/camera_for.h"
#include "../support/data_file.h"

#include <Shape_characteristics/screen_space/OpenGL/G_buffer_renderer.h>
#include <Shape_characteristics/screen_space/OpenGL/Screen_space_curvature_pass.h>
#include <Shape_characteristics/screen_space/OpenGL/Sphere_fit_mean_curvature_pass.h>
#include <Shape_characteristics/screen_space/OpenGL/read_g_buffer.h>
#include <Shape_characteristics/screen_space/OpenGL/read_screen_space_curvatures.h>
#include <Shape_characteristics/screen_space/screen_space_curvatures.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace {

// the values' colors, lit a little so that the shape is seen; four pixels become one
support::Image
picture_of(const std::vector<float>& values, const SC::G_buffer& g, const support::Value_range& range)
{
  const auto gradient = support::Color_gradient::blue_green_red();
  const int size = g.width() / 2;
  support::Image image(size, size);
  for(int y = 0; y < size; ++y)
    for(int x = 0; x < size; ++x)
    {
      double color[3] = {0, 0, 0};
      for(int k = 0; k < 4; ++k)
      {
        const std::size_t pixel = g.index(2 * x + k % 2, 2 * y + k / 2);
        const bool is_surface = g.is_valid(pixel);
        const double light = is_surface ? 0.6 + 0.4 * std::max(0., g.view_normal(pixel).z()) : 1;
        const bool is_known = is_surface && !std::isnan(values[pixel]);
        support::Color_gradient::Rgb rgb = {1, 1, 1};
        if(is_known)
          rgb = gradient(range.position(double(values[pixel])));
        else if(is_surface)
          rgb = {0.62, 0.62, 0.63};
        for(std::size_t c = 0; c < 3; ++c)
          color[c] += light * rgb[c] / 4;
      }
      image.at(x, size - 1 - y) = {std::uint8_t(std::lround(255 * color[0])),
                                   std::uint8_t(std::lround(255 * color[1])),
                                   std::uint8_t(std::lround(255 * color[2])), 255};
    }
  return image;
}

support::Value_range range_of(const std::vector<float>& values)
{
  return support::percentile_range(std::vector<double>(values.begin(), values.end()), 0.03, true);
}

int run(const std::vector<std::string>& arguments)
{
  std::vector<std::string> files;
  int size = 400, triangles = 4, edges = 2;
  double lod = 0.012;
  for(std::size_t i = 0; i < arguments.size(); ++i)
  {
    const std::string& a = arguments[i];
    if(a.rfind("--", 0) != 0)
    {
      files.push_back(a);
      continue;
    }
    if(i + 1 == arguments.size())
      throw std::invalid_argument(a + " needs a value");
    std::istringstream value(arguments[++i]);
    if(!(a == "--size"        ? value >> size
         : a == "--lod"       ? value >> lod
         : a == "--triangles" ? value >> triangles
         : a == "--edges"     ? value >> edges
                              : throw std::invalid_argument("unknown argument " + a)))
      throw std::invalid_argument(a + " is no number: " + arguments[i]);
  }
  if(files.size() > 2 || size < 16 || size > 4000 || !(lod > 0))
    throw std::invalid_argument(
        "usage: screen_space_curvature mesh out.png [--size 400] [--lod 0.012] [--triangles 4] "
        "[--edges 2]");
  const std::string input = files.empty() ? support::data_file("meshes/elephant.off") : files[0];
  const std::string output = files.size() < 2 ? "screen_space_curvature.png" : files[1];

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(input, mesh) || mesh.is_empty())
    throw std::runtime_error(input + " is no mesh that can be read");
  CGAL::Bbox_3 box;
  for(const auto v : mesh.vertices())
    box += mesh.point(v).bbox();
  support::Orbit_camera view(box, support::camera_for(input));
  view.move(0.74);
  const SC::Level_of_detail level = SC::Level_of_detail::by_length(lod * 2 * view.radius());

  // depths and normals, twice as fine as the picture
  const support::Offscreen_context context;
  const int fine = 2 * size;
  SC::G_buffer_renderer renderer;
  renderer.set_mesh(mesh);
  const SC::G_buffer_textures textures = renderer.draw(view.camera(fine, fine), fine, fine);
  std::vector<float> depths, normals;
  const SC::G_buffer g = SC::read_g_buffer(textures, depths, normals);

  // their curvature
  SC::Screen_space_curvature_pass estimate;
  SC::Sphere_fit_mean_curvature_pass fit;
  std::vector<float> sharp(g.size()), mean(g.size()), spheres(g.size()), Gaussian(g.size()), index(g.size());
  const auto np = SC::parameters::number_of_triangles(triangles).number_of_edges(edges);
  SC::read_screen_space_curvatures(estimate(textures, np), fine, fine,
                                   SC::parameters::mean_curvature_map(CGAL::make_property_map(sharp)));
  const std::size_t failed =
      SC::read_screen_space_curvatures(estimate(textures, np.level_of_detail(level)), fine, fine,
                                       SC::parameters::mean_curvature_map(CGAL::make_property_map(mean))
                                           .Gaussian_curvature_map(CGAL::make_property_map(Gaussian))
                                           .shape_index_map(CGAL::make_property_map(index)));
  // the thesis's rule for depth discontinuities
  std::vector<float> far_plane(g.size());
  SC::read_screen_space_curvatures(
      estimate(textures,
               np.level_of_detail(level).depth_discontinuity_rule(SC::Depth_discontinuity_rule::FAR_PLANE)),
      fine, fine, SC::parameters::mean_curvature_map(CGAL::make_property_map(far_plane)));
  SC::read_screen_space_curvatures(fit(textures), fine, fine,
                                   SC::parameters::mean_curvature_map(CGAL::make_property_map(spheres)));

  // the same on the CPU
  std::vector<float> twin(g.size());
  const std::size_t failed_on_cpu = SC::screen_space_curvatures(
      g, np.level_of_detail(level).mean_curvature_map(CGAL::make_property_map(twin)));
  const support::Value_range range = range_of(mean);
  double largest = 0;
  std::size_t shown = 0;
  for(std::size_t i = 0; i < g.size(); ++i)
    if(!std::isnan(mean[i]) && !std::isnan(twin[i]))
    {
      largest = std::max(largest, std::abs(double(mean[i]) - double(twin[i])));
      ++shown;
    }
  std::cout << input << " on " << context.description() << ": " << shown << " pixels with curvature, "
            << failed << " without (on the CPU " << failed_on_cpu << "); CPU and GPU differ by at most "
            << largest / (range.high - range.low) << " of the range of mean curvatures\n";

  support::Value_range unit;
  unit.low = -1;
  support::Contact_sheet sheet;
  sheet.add(picture_of(sharp, g, range), "mean curvature, neighboring pixels");
  sheet.add(picture_of(mean, g, range), "mean curvature, level of detail");
  sheet.add(picture_of(far_plane, g, range), "mean curvature, the far plane's rule");
  sheet.add(picture_of(spheres, g, range), "mean curvature, spheres of 8 pixels");
  sheet.add(picture_of(Gaussian, g, range_of(Gaussian)), "Gaussian curvature, level of detail");
  sheet.add(picture_of(index, g, unit), "shape index, level of detail");
  support::write_png(output, sheet.image(3));
  return shown > 0 && failed == failed_on_cpu ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace

int main(int argc, char* argv[])
try
{
  return run(std::vector<std::string>(argv + 1, argv + argc));
}
catch(const std::exception& e)
{
  std::cerr << e.what() << '\n';
  return EXIT_FAILURE;
}
