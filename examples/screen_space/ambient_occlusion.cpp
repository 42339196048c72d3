// How much of the ambient light reaches what a picture shows: guessed from its curvature in three ways, and found by rays.
//
//     ambient_occlusion mesh out.png [--size 320] [--rays 48] [--reach 1] [--lod 0.01]
//
// Without a mesh, one that comes with CGAL is taken. `--reach` is how far away something may be and still occlude in the ray-cast picture, and
// `--lod` how far away the pixels are from which curvature is estimated, both in diagonals of the bounding box.
#include "../support/Contact_sheet.h"
#include "../support/Image.h"
#include "../support/Offscreen_context.h"
#include "../support/Orbit_camera.h"
#include "../support/Progress_bar.h"
#include "../support/camera_for.h"
#include "../support/data_file.h"

#include <Shape_characteristics/screen_space/Griffin_ambient_occlusion.h>
#include <Shape_characteristics/screen_space/Hattori_ambient_occlusion.h>
#include <Shape_characteristics/screen_space/OpenGL/Ambient_occlusion_pass.h>
#include <Shape_characteristics/screen_space/OpenGL/G_buffer_renderer.h>
#include <Shape_characteristics/screen_space/OpenGL/Screen_space_curvature_pass.h>
#include <Shape_characteristics/screen_space/OpenGL/read_g_buffer.h>
#include <Shape_characteristics/screen_space/OpenGL/read_screen_space_curvatures.h>
#include <Shape_characteristics/screen_space/Two_part_ambient_occlusion.h>
#include <Shape_characteristics/screen_space/ambient_occlusion.h>
#include <Shape_characteristics/screen_space/mean_curvature_extreme.h>
#include <Shape_characteristics/screen_space/ray_cast_ambient_occlusion.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/property_map.h>

#include <epoxy/gl.h>

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
using Light = std::vector<float>;

namespace {

// grey levels, on a background that is told from white; four pixels become one
support::Image picture_of(const Light& light, int size)
{
  support::Image image(size / 2, size / 2);
  for(int y = 0; y < size / 2; ++y)
    for(int x = 0; x < size / 2; ++x)
    {
      constexpr double background[3] = {0.82, 0.87, 0.93};
      double color[3] = {0, 0, 0};
      for(int k = 0; k < 4; ++k)
      {
        const float value = light[std::size_t((2 * y + k / 2) * size + 2 * x + k % 2)];
        for(int c = 0; c < 3; ++c)
          color[c] += (std::isnan(value) ? background[c] : double(value)) / 4;
      }
      support::Rgba& pixel = image.at(x, size / 2 - 1 - y);
      pixel = {std::uint8_t(std::lround(255 * color[0])), std::uint8_t(std::lround(255 * color[1])),
               std::uint8_t(std::lround(255 * color[2])), 255};
    }
  return image;
}

Light read_light(unsigned texture, int size)
{
  Light light(std::size_t(size) * std::size_t(size));
  glBindTexture(GL_TEXTURE_2D, texture);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RED, GL_FLOAT, light.data());
  glBindTexture(GL_TEXTURE_2D, 0);
  return light;
}

// root of the mean square of the differences
double difference(const Light& light, const Light& truth)
{
  double sum = 0;
  std::size_t count = 0;
  for(std::size_t i = 0; i < light.size(); ++i)
    if(!std::isnan(light[i]) && !std::isnan(truth[i]))
    {
      sum += (double(light[i]) - truth[i]) * (double(light[i]) - truth[i]);
      ++count;
    }
  return count > 0 ? std::sqrt(sum / double(count)) : 0;
}

int run(const std::vector<std::string>& arguments)
{
  std::vector<std::string> files;
  int size = 320, rays = 48;
  double reach = 1, lod = 0.01;
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
    if(!(a == "--size"    ? value >> size
         : a == "--rays"  ? value >> rays
         : a == "--reach" ? value >> reach
         : a == "--lod"   ? value >> lod
                          : throw std::invalid_argument("unknown argument " + a)))
      throw std::invalid_argument(a + " is no number: " + arguments[i]);
  }
  if(files.size() > 2 || size < 16 || size > 4000 || !(lod >= 0))
    throw std::invalid_argument(
        "usage: ambient_occlusion mesh out.png [--size 320] [--rays 48] [--reach 1] [--lod 0.01]");
  const std::string input = files.empty() ? support::data_file("meshes/ChineseDragon-10kv.off") : files[0];
  const std::string output = files.size() < 2 ? "ambient_occlusion.png" : files[1];

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(input, mesh) || mesh.is_empty())
    throw std::runtime_error(input + " is no mesh that can be read");
  CGAL::Bbox_3 box;
  for(const auto v : mesh.vertices())
    box += mesh.point(v).bbox();
  support::Orbit_camera view(box, support::camera_for(input));
  view.move(0.85);
  const double diagonal = 2 * view.radius();

  // depths and normals, and curvature of them; twice as fine as the picture
  const support::Offscreen_context context;
  const int fine = 2 * size;
  SC::G_buffer_renderer renderer;
  renderer.set_mesh(mesh);
  const SC::G_buffer_textures textures = renderer.draw(view.camera(fine, fine), fine, fine);
  SC::Screen_space_curvature_pass estimate;
  const SC::Level_of_detail level =
      lod > 0 ? SC::Level_of_detail::by_length(lod * diagonal) : SC::Level_of_detail::none();
  const unsigned curvatures = estimate(textures, SC::parameters::level_of_detail(level));
  std::vector<float> mean(std::size_t(fine) * std::size_t(fine));
  SC::read_screen_space_curvatures(curvatures, fine, fine,
                                   SC::parameters::mean_curvature_map(CGAL::make_property_map(mean)));
  const double extreme = SC::mean_curvature_extreme(mean);
  std::cout << input << ": extreme of the mean curvature " << extreme << '\n';

  // the truth
  std::vector<float> depths, normals;
  const SC::G_buffer g_buffer = SC::read_g_buffer(textures, depths, normals);
  Light truth(mean.size());
  SC::ray_cast_ambient_occlusion(mesh, g_buffer,
                                 SC::parameters::ambient_occlusion_map(CGAL::make_property_map(truth))
                                     .number_of_rays(rays)
                                     .maximum_ray_length(reach * diagonal)
                                     .callback(support::Progress_bar("rays")));

  support::Contact_sheet sheet;
  SC::Ambient_occlusion_pass occlude;
  const auto show = [&](const std::string& name, const auto& mapping)
  {
    const Light light = read_light(occlude(curvatures, fine, fine, mapping), fine);
    std::ostringstream text;
    text.precision(3);
    text << name << "\nrms difference " << difference(light, truth);
    std::cout << "  " << name << ": rms difference to the rays " << difference(light, truth) << '\n';
    sheet.add(picture_of(light, fine), text.str());
    return light;
  };
  const SC::Two_part_ambient_occlusion two_parts(extreme > 0 ? extreme : 1);
  const Light ours = show("two parts (thesis)", two_parts);
  show("Hattori", SC::Hattori_ambient_occlusion(0.01 * diagonal));
  show("Griffin", SC::Griffin_ambient_occlusion(0.03 * diagonal));
  sheet.add(picture_of(truth, fine), "rays");
  support::write_png(output, sheet.image(2));
  std::cout << "wrote " << output << '\n';

  // the same without a GPU
  Light on_cpu(mean.size());
  SC::ambient_occlusion(g_buffer, SC::parameters::ambient_occlusion_map(CGAL::make_property_map(on_cpu))
                                      .ambient_occlusion_mapping(two_parts)
                                      .level_of_detail(level));
  std::cout << "  rms difference of CPU and GPU: " << difference(on_cpu, ours) << '\n';
  return difference(on_cpu, ours) < 1e-3 ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    return run(std::vector<std::string>(argv + 1, argv + argc));
  }
  catch(const std::exception& e)
  {
    std::cerr << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
