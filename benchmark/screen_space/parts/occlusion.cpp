#include "Experiment.h"
#include "Mesh.h"

#include <Shape_characteristics/screen_space/Griffin_ambient_occlusion.h>
#include <Shape_characteristics/screen_space/Hattori_ambient_occlusion.h>
#include <Shape_characteristics/screen_space/OpenGL/G_buffer_renderer.h>
#include <Shape_characteristics/screen_space/OpenGL/Screen_space_curvature_pass.h>
#include <Shape_characteristics/screen_space/OpenGL/read_g_buffer.h>
#include <Shape_characteristics/screen_space/OpenGL/read_screen_space_curvatures.h>
#include <Shape_characteristics/screen_space/Two_part_ambient_occlusion.h>
#include <Shape_characteristics/screen_space/mean_curvature_extreme.h>
#include <Shape_characteristics/screen_space/ray_cast_ambient_occlusion.h>

#include <support/Contact_sheet.h>
#include <support/Image.h>
#include <support/Orbit_camera.h>
#include <support/Progress_bar.h>
#include <support/camera_for.h>
#include <support/data_file.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace screen_space {
namespace {

namespace SC = Shape_characteristics;
using Light = std::vector<float>;

struct Picture
{
  std::vector<float> k_min, k_max, mean;
  Light truth;

  // what a mapping makes of the curvatures
  template <typename Mapping>
  Light light(const Mapping& mapping) const
  {
    Light result(k_min.size(), std::numeric_limits<float>::quiet_NaN());
    for(std::size_t i = 0; i < result.size(); ++i)
      if(std::isfinite(k_min[i]) && std::isfinite(k_max[i]))
      {
        SC::Screen_space_curvature c;
        c.min_curvature = k_min[i];
        c.max_curvature = k_max[i];
        result[i] = float(mapping(c));
      }
    return result;
  }
};

struct Agreement
{
  double rms = 0., correlation = 0.;
  std::size_t pixels = 0;
};

Agreement compare(const Light& light, const Light& truth)
{
  Agreement a;
  double sum = 0., sx = 0., sy = 0., sxx = 0., syy = 0., sxy = 0.;
  for(std::size_t i = 0; i < light.size(); ++i)
    if(!std::isnan(light[i]) && !std::isnan(truth[i]))
    {
      const double x = light[i], y = truth[i];
      sum += (x - y) * (x - y);
      sx += x;
      sy += y;
      sxx += x * x;
      syy += y * y;
      sxy += x * y;
      ++a.pixels;
    }
  const double n = double(a.pixels);
  a.rms = std::sqrt(sum / n);
  const double vx = sxx / n - sx / n * (sx / n), vy = syy / n - sy / n * (sy / n);
  a.correlation = vx > 0. && vy > 0. ? (sxy / n - sx / n * (sy / n)) / std::sqrt(vx * vy) : 0.;
  return a;
}

// the parameter of a mapping with the smallest error: what the method could do at its best, if one knew the truth
template <typename Make>
double best_parameter(const Picture& picture, const Make& make)
{
  double best = 1., least = std::numeric_limits<double>::infinity();
  for(double p = 1e-4; p < 1e4; p *= 1.1)
    if(const double rms = compare(picture.light(make(p)), picture.truth).rms; rms < least)
    {
      least = rms;
      best = p;
    }
  return best;
}

support::Image grey(const Light& light, int size)
{
  support::Image image(size, size, {209, 222, 237, 255});
  for(int y = 0; y < size; ++y)
    for(int x = 0; x < size; ++x)
      if(const float value = light[std::size_t(y * size + x)]; !std::isnan(value))
      {
        const auto level = std::uint8_t(std::lround(255. * double(value)));
        image.at(x, size - 1 - y) = {level, level, level, 255};
      }
  return image;
}

// in a box whose diagonal is 2, for which the thesis's parameters are of use
Mesh read_mesh(const std::string& name)
{
  Mesh mesh;
  const std::string file = support::data_file("meshes/" + name + ".off");
  if(!CGAL::IO::read_polygon_mesh(file, mesh))
    throw std::runtime_error(file + " is no mesh that can be read");
  CGAL::Bbox_3 box;
  for(const auto v : mesh.vertices())
    box += mesh.point(v).bbox();
  const Kernel::Vector_3 center(.5 * (box.xmin() + box.xmax()), .5 * (box.ymin() + box.ymax()),
                                .5 * (box.zmin() + box.zmax()));
  const double scale =
      2. / std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
  for(const auto v : mesh.vertices())
    mesh.point(v) = CGAL::ORIGIN + scale * (mesh.point(v) - CGAL::ORIGIN - center);
  return mesh;
}

} // namespace

Findings measure_occlusion(const Settings& settings)
{
  Findings findings{Table("occlusion", "Ambient occlusion against rays",
                          {"mesh", "faces", "reach", "method", "parameter", "pixels", "rms", "correlation"}),
                    {},
                    true};
  const int size = settings.is_quick ? 96 : 480, rays = settings.is_quick ? 32 : 128;
  const std::vector<std::string> meshes =
      settings.is_quick ? std::vector<std::string>{"elephant"}
                        : std::vector<std::string>{"armadillo", "bunny00", "lion-head", "ChineseDragon-10kv"};
  const std::vector<std::string> methods = {"ours",
                                            "Hattori, radius 0.25",
                                            "Griffin, scale 5",
                                            "ours, best extreme",
                                            "Hattori, best radius",
                                            "Griffin, best scale",
                                            "the same grey everywhere"};
  std::vector<std::string> columns = {"mesh", "reach of rays"};
  columns.insert(columns.end(), methods.begin(), methods.end());
  Table errors("occlusion_rms", "Ambient occlusion: rms error to the ray-cast picture (Figure 7.17)",
               columns);
  columns.pop_back();
  Table correlations("occlusion_correlation", "Ambient occlusion: correlation with the ray-cast picture",
                     columns);

  SC::G_buffer_renderer renderer;
  SC::Screen_space_curvature_pass pass;
  std::size_t printed_wins = 0, best_wins = 0;
  for(const std::string& name : meshes)
  {
    const Mesh mesh = read_mesh(name);
    renderer.set_mesh(mesh);
    CGAL::Bbox_3 box;
    for(const auto v : mesh.vertices())
      box += mesh.point(v).bbox();
    support::Orbit_camera view(box, support::camera_for(name + ".off"));
    view.move(.85);
    const SC::G_buffer_textures textures = renderer.draw(view.camera(size, size), size, size);
    std::vector<float> depths, directions;
    const SC::G_buffer g = SC::read_g_buffer(textures, depths, directions);
    Picture picture;
    picture.k_min.resize(g.size());
    picture.k_max.resize(g.size());
    picture.mean.resize(g.size());
    picture.truth.resize(g.size());
    SC::read_screen_space_curvatures(pass(textures), size, size,
                                     SC::parameters::min_curvature_map(CGAL::make_property_map(picture.k_min))
                                         .max_curvature_map(CGAL::make_property_map(picture.k_max))
                                         .mean_curvature_map(CGAL::make_property_map(picture.mean)));
    const double extreme = SC::mean_curvature_extreme(picture.mean);

    for(const double reach : {std::numeric_limits<double>::infinity(), .2})
    {
      const bool is_far = std::isinf(reach);
      SC::ray_cast_ambient_occlusion(
          mesh, g,
          SC::parameters::ambient_occlusion_map(CGAL::make_property_map(picture.truth))
              .number_of_rays(rays)
              .maximum_ray_length(reach)
              .callback(support::Progress_bar(name + ", rays")));
      const auto two_part = [](double p) { return SC::Two_part_ambient_occlusion(p); };
      const auto Hattori = [](double p) { return SC::Hattori_ambient_occlusion(p); };
      const auto Griffin = [](double p) { return SC::Griffin_ambient_occlusion(p); };
      const double best[3] = {best_parameter(picture, two_part), best_parameter(picture, Hattori),
                              best_parameter(picture, Griffin)};
      double mean = 0.;
      std::size_t count = 0;
      for(std::size_t i = 0; i < g.size(); ++i)
        if(!std::isnan(picture.truth[i]) && std::isfinite(picture.mean[i]))
        {
          mean += picture.truth[i];
          ++count;
        }
      Light constant(g.size(), float(mean / double(count)));
      for(std::size_t i = 0; i < g.size(); ++i)
        if(!std::isfinite(picture.mean[i]))
          constant[i] = std::numeric_limits<float>::quiet_NaN();
      const double parameters[7] = {extreme, .25, 5., best[0], best[1], best[2], mean / double(count)};
      const Light lights[7] = {picture.light(two_part(extreme)),
                               picture.light(Hattori(.25)),
                               picture.light(Griffin(5.)),
                               picture.light(two_part(best[0])),
                               picture.light(Hattori(best[1])),
                               picture.light(Griffin(best[2])),
                               constant};
      const std::string reach_text = is_far ? "any" : "a tenth of the diagonal";
      std::vector<Table::Cell> rms_row = {name, reach_text}, correlation_row = rms_row;
      Agreement agreements[7];
      for(std::size_t m = 0; m < methods.size(); ++m)
      {
        agreements[m] = compare(lights[m], picture.truth);
        findings.all.add({name, mesh.number_of_faces() + 0., is_far ? "inf" : "0.2", methods[m],
                          parameters[m], agreements[m].pixels, agreements[m].rms, agreements[m].correlation});
        rms_row.emplace_back(agreements[m].rms);
        if(m + 1 < methods.size())
          correlation_row.emplace_back(agreements[m].correlation);
      }
      errors.add(rms_row);
      correlations.add(correlation_row);
      if(!is_far)
        continue;
      const double ours = agreements[0].rms;
      printed_wins += ours < agreements[1].rms && ours < agreements[2].rms ? 1 : 0;
      best_wins += ours < agreements[4].rms && ours < agreements[5].rms ? 1 : 0;
      support::Contact_sheet sheet(name);
      for(const std::size_t m : {0, 1, 2, 3, 4, 5})
        sheet.add(grey(lights[m], size), methods[m] + "\nrms error " + readable(agreements[m].rms));
      sheet.add(grey(picture.truth, size), "rays");
      support::write_png(settings.folder + "/occlusion_" + name + ".png", sheet.image(4));
    }
  }
  const std::string of = " of " + std::to_string(meshes.size()) + " meshes";
  errors.remark("Ours, with the 99.9 % quantile of the picture as extreme, is nearer to the rays than "
                "Hattori's and Griffin's with the "
                "thesis's parameters on " +
                std::to_string(printed_wins) + of +
                ", and nearer than theirs with the parameters that are the best for the very picture on " +
                std::to_string(best_wins) + of + " (rays of any length).");
  errors.remark(
      "Meshes in boxes whose diagonal is 2, pictures of " + std::to_string(size) + " x " +
      std::to_string(size) + ", " + std::to_string(rays) +
      " rays a pixel, without level of detail. A single grey knows the mean of the ray-cast picture.");
  findings.digests = {errors, correlations};
  findings.is_plausible = settings.is_quick || printed_wins > 0;
  return findings;
}

} // namespace screen_space
