#include "Experiment.h"
#include "Mesh.h"
#include "surfaces.h"

#include <Shape_characteristics/screen_space/OpenGL/G_buffer_renderer.h>
#include <Shape_characteristics/screen_space/OpenGL/Screen_space_curvature_pass.h>
#include <Shape_characteristics/screen_space/OpenGL/read_g_buffer.h>
#include <Shape_characteristics/screen_space/OpenGL/read_screen_space_curvatures.h>

#include <support/Color_gradient.h>
#include <support/Contact_sheet.h>
#include <support/Image.h>
#include <support/Value_range.h>

#include <CGAL/property_map.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace screen_space {

namespace {

namespace SC = Shape_characteristics;

// blue is concave, red convex
support::Image colored(const std::vector<float>& values, int size, double extreme)
{
  const support::Color_gradient gradient = support::Color_gradient::blue_green_red();
  support::Image image(size, size);
  for(int y = 0; y < size; ++y)
    for(int x = 0; x < size; ++x)
    {
      const float value = values[std::size_t(y * size + x)];
      image.at(x, size - 1 - y) = std::isfinite(value) ? gradient.pixel(.5 + .5 * double(value) / extreme)
                                                       : support::missing_value_color;
    }
  return image;
}

} // namespace

Findings measure_normal_map(const Settings& settings)
{
  Findings findings{Table("normal_map", "A plane with the normals of a relief (Figure 7.15)",
                          {"shape", "pixels", "failed", "median magnitude of H", "median error of H",
                           "median magnitude of K", "median error of K"}),
                    {},
                    true};
  const int size = settings.is_quick ? 256 : 900, texels = settings.is_quick ? 256 : 1024;

  Mesh plane;
  auto coordinates = plane.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:texture").first;
  std::vector<Mesh::Vertex_index> corners;
  for(const auto& [x, y] : {std::pair{0., 0.}, std::pair{1., 0.}, std::pair{1., 1.}, std::pair{0., 1.}})
  {
    corners.push_back(plane.add_vertex({4. * x - 2., 4. * y - 2., 0.}));
    put(coordinates, corners.back(), Kernel::Point_2(x, y));
  }
  plane.add_face(corners);
  std::vector<float> normals;
  for(int y = 0; y < texels; ++y)
    for(int x = 0; x < texels; ++x)
    {
      const Relief r = relief(4. * (x + .5) / texels - 2., 4. * (y + .5) / texels - 2., 0.);
      for(const double c : {r.normal.x, r.normal.y, r.normal.z})
        normals.push_back(float(c));
    }

  SC::G_buffer_renderer renderer;
  SC::Screen_space_curvature_pass pass;
  renderer.set_mesh(plane, SC::parameters::vertex_texture_coordinates_map(coordinates));
  renderer.set_normal_map(texels, texels, normals.data());
  const SC::Camera camera(SC::Camera::look_at({0., 0., 5.}, {0., 0., 0.}, {0., 1., 0.}),
                          SC::Camera::orthographic(4., 1., 1., 10.));
  const SC::G_buffer_textures textures = renderer.draw(camera, size, size);
  std::vector<float> depths, directions, mean(std::size_t(size) * std::size_t(size)), gaussian(mean),
      status(mean);
  const SC::G_buffer g = SC::read_g_buffer(textures, depths, directions);
  SC::read_screen_space_curvatures(pass(textures), size, size,
                                   SC::parameters::mean_curvature_map(CGAL::make_property_map(mean))
                                       .Gaussian_curvature_map(CGAL::make_property_map(gaussian)));

  const double margin = 4. * 4. / std::min(size, texels); // of pixels or texels that see an edge
  const char* names[] = {"sphere", "torus", "cone", "pyramid", "plane between"};
  std::vector<float> true_mean(mean.size()), true_gaussian(mean.size());
  std::vector<double> H[5], dH[5], K[5], dK[5];
  std::size_t failed[5] = {};
  for(std::size_t i = 0; i < mean.size(); ++i)
  {
    const Eigen::Vector3d p = camera.world_point(g.view_point(i));
    const Relief r = relief(p.x(), p.y(), margin);
    true_mean[i] = float(r.curvature.mean());
    true_gaussian[i] = float(r.curvature.gaussian());
    const bool is_border = std::max(std::abs(p.x()), std::abs(p.y())) > 2. - margin;
    // the sphere and the torus end in vertical walls, where the curvature of the normal map has no bound
    if(!r.is_smooth || is_border || r.normal.z < .3)
      continue;
    const std::size_t shape = r.height == 0. ? 4 : p.y() >= 0. ? (p.x() < 0. ? 0 : 1) : (p.x() < 0. ? 2 : 3);
    if(!std::isfinite(mean[i]) || !std::isfinite(gaussian[i]))
    {
      ++failed[shape];
      continue;
    }
    H[shape].push_back(std::abs(r.curvature.mean()));
    K[shape].push_back(std::abs(r.curvature.gaussian()));
    dH[shape].push_back(std::abs(mean[i] - r.curvature.mean()));
    dK[shape].push_back(std::abs(gaussian[i] - r.curvature.gaussian()));
  }
  for(std::size_t s = 0; s < 5; ++s)
    findings.all.add(
        {names[s], H[s].size(), failed[s], median(H[s]), median(dH[s]), median(K[s]), median(dK[s])});
  findings.is_plausible = median(dH[0]) < .05 * median(H[0]) && median(dH[1]) < .05 * median(H[1]);

  Table digest = findings.all;
  digest.remark("Seen from above, without perspective, " + std::to_string(size) + " x " +
                std::to_string(size) + " pixels of 4 x 4 units, " + std::to_string(texels) + " x " +
                std::to_string(texels) +
                " texels; pixels near edges, and walls (normals less than 17 degrees " +
                "from the plane), aside. Flat positions give the curvature of the relief itself: the mean "
                "curvature of " +
                "a graph is half the divergence of its normal on the plane, and the Gaussian curvature the "
                "determinant " +
                "of the derivative.");
  findings.digests.push_back(digest);

  support::Contact_sheet sheet("Curvature of a plane with a normal map");
  const double extreme_H = 4., extreme_K = 12.;
  sheet.add(colored(mean, size, extreme_H), "mean curvature");
  sheet.add(colored(gaussian, size, extreme_K), "Gaussian curvature");
  sheet.add(colored(true_mean, size, extreme_H), "mean curvature of the relief");
  sheet.add(colored(true_gaussian, size, extreme_K), "Gaussian curvature of the relief");
  support::write_png(settings.folder + "/normal_map.png", sheet.image(2));
  return findings;
}

} // namespace screen_space
