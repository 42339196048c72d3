#include "Experiment.h"
#include "Gpu_timer.h"
#include "test_functions.h"

#include <Shape_characteristics/screen_space/OpenGL/Ambient_occlusion_pass.h>
#include <Shape_characteristics/screen_space/OpenGL/Screen_space_curvature_pass.h>
#include <Shape_characteristics/screen_space/OpenGL/Sphere_fit_mean_curvature_pass.h>
#include <Shape_characteristics/screen_space/OpenGL/read_screen_space_curvatures.h>
#include <Shape_characteristics/screen_space/Two_part_ambient_occlusion.h>

#include <support/Image.h>
#include <support/Plot.h>

#include <CGAL/property_map.h>

#include <epoxy/gl.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace screen_space {
namespace {

namespace SC = Shape_characteristics;

// The graph of f2 from above, which fills the picture: depths and normals are exact, and so is the curvature known.
struct Scene
{
  int width, height;
  SC::Camera camera;
  std::vector<float> depths, normals; // four numbers each
  std::vector<double> mean;

  Scene(int w, int h)
    : width(w),
      height(h),
      camera(SC::Camera::look_at({0., 0., 20.}, {0., 0., 0.}, {0., 1., 0.}),
             SC::Camera::perspective(.45, double(w) / h, 5., 50.),
             SC::Depth_convention::EYE_DISTANCE)
  {
    const benchmark_support::Explicit_function& f = benchmark_support::explicit_function("f2e");
    const Eigen::Vector3d eye = camera.world_point({0., 0., 0.});
    const Eigen::Matrix3d to_view = camera.view().topLeftCorner<3, 3>();
    for(int y = 0; y < h; ++y)
      for(int x = 0; x < w; ++x)
      {
        const Eigen::Vector3d d = camera.world_point(camera.view_point(x + .5, y + .5, 1., w, h)) - eye;
        double t = 20.; // distance along the direction of view; Newton's steps towards the surface
        for(int step = 0; step < 30; ++step)
        {
          const Eigen::Vector3d p = eye + t * d;
          const auto g = f.gradient(p.x(), p.y());
          t -= (p.z() - f.value(p.x(), p.y())) / (d.z() - g[0] * d.x() - g[1] * d.y());
        }
        const Eigen::Vector3d p = eye + t * d;
        if(!(std::abs(p.z() - f.value(p.x(), p.y())) < 1e-9))
          throw std::logic_error("frame time: a ray misses the surface");
        const benchmark_support::Exact_curvature truth = f.exact(p.x(), p.y());
        const Eigen::Vector3d n = to_view * Eigen::Vector3d(truth.normal.x, truth.normal.y, truth.normal.z);
        depths.push_back(float(t));
        for(const double c : {n.x(), n.y(), n.z(), 0.})
          normals.push_back(float(c));
        mean.push_back(truth.mean());
      }
  }

  // depths with a surface in the middle only, as much of the picture as asked
  std::vector<float> covered(double share) const
  {
    std::vector<float> result = depths;
    const double side = std::sqrt(share);
    for(int y = 0; y < height; ++y)
      for(int x = 0; x < width; ++x)
        if(std::abs(2. * (x + .5) / width - 1.) > side || std::abs(2. * (y + .5) / height - 1.) > side)
          result[std::size_t(y * width + x)] = std::numeric_limits<float>::infinity();
    return result;
  }
};

class Texture
{
public:
  Texture(GLenum format, int width, int height) : m_width(width), m_height(height)
  {
    glGenTextures(1, &m_name);
    glBindTexture(GL_TEXTURE_2D, m_name);
    glTexStorage2D(GL_TEXTURE_2D, 1, format, width, height);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glBindTexture(GL_TEXTURE_2D, 0);
  }
  ~Texture() { glDeleteTextures(1, &m_name); }
  Texture(const Texture&) = delete;
  Texture& operator=(const Texture&) = delete;

  void upload(GLenum channels, const std::vector<float>& values)
  {
    glBindTexture(GL_TEXTURE_2D, m_name);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, m_width, m_height, channels, GL_FLOAT, values.data());
    glBindTexture(GL_TEXTURE_2D, 0);
  }
  unsigned name() const { return m_name; }

private:
  GLuint m_name = 0;
  int m_width, m_height;
};

struct Method
{
  std::string name, stage;
  int bytes_of_surface, bytes_of_background; // a pixel, read and written once
  std::function<unsigned()> frame;
  bool has_mean;
};

double error_of(unsigned texture, const Scene& scene)
{
  std::vector<float> mean(scene.mean.size());
  SC::read_screen_space_curvatures(texture, scene.width, scene.height,
                                   SC::parameters::mean_curvature_map(CGAL::make_property_map(mean)));
  std::vector<double> differences, magnitudes;
  for(std::size_t i = 0; i < mean.size(); ++i)
    if(std::isfinite(mean[i]))
    {
      differences.push_back(std::abs(mean[i] - scene.mean[i]));
      magnitudes.push_back(std::abs(scene.mean[i]));
    }
  return median(differences) / median(magnitudes);
}

} // namespace

Findings measure_frame_time(const Settings& settings)
{
  Findings findings{Table("frame_time", "Time of a frame",
                          {"method", "stage", "coverage", "gpu_ms", "wall_ms", "processor_ms", "frames",
                           "ns_per_surface_pixel", "bytes_per_pixel", "GB_per_s", "share_of_copy",
                           "share_of_peak", "median_relative_H"}),
                    {},
                    true};
  const int width = settings.is_quick ? 320 : settings.width,
            height = settings.is_quick ? 180 : settings.height;
  const std::vector<double> coverages =
      settings.is_quick ? std::vector<double>{.1, 1.} : std::vector<double>{.02, .1, .25, .5, .75, 1.};
  const double seconds = settings.is_quick ? .05 : 1.;
  const Scene scene(width, height);
  Texture depths(GL_R32F, width, height), normals(GL_RGBA32F, width, height),
      small_normals(GL_RGBA16_SNORM, width, height), small_target(GL_RG32F, width, height);
  normals.upload(GL_RGBA, scene.normals);
  small_normals.upload(GL_RGBA, scene.normals);
  const SC::G_buffer_textures g = {width,          height,       depths.name(),
                                   normals.name(), scene.camera, SC::Normal_space::VIEW};
  SC::G_buffer_textures small = g;
  small.normals = small_normals.name();

  SC::Screen_space_curvature_pass fragment, compute(SC::Shader_stage::COMPUTE);
  SC::Sphere_fit_mean_curvature_pass fit, fit_compute(SC::Shader_stage::COMPUTE);
  SC::Ambient_occlusion_pass occlude, occlude_compute(SC::Shader_stage::COMPUTE);
  const SC::Two_part_ambient_occlusion mapping(1.);
  const double eight_pixels = 8.5 * 20. * 2. * std::tan(.5 * .45) / height;
  const auto by_length = SC::Level_of_detail::by_length(eight_pixels);

  const std::vector<Method> methods = {
      {"ours", "fragment", 36, 20, [&] { return fragment(g); }, true},
      {"ours", "compute", 36, 20, [&] { return compute(g); }, true},
      {"ours, one triangle (thesis)", "fragment", 36, 20,
       [&] { return fragment(g, SC::parameters::number_of_triangles(1)); }, true},
      {"ours, LOD of 8 pixels", "fragment", 36, 20,
       [&] { return fragment(g, SC::parameters::level_of_detail(by_length)); }, true},
      {"ours, 16-bit normals", "fragment", 20, 12,
       [&]
       {
         fragment.draw_into(small_target.name(), small);
         return small_target.name();
       },
       false},
      {"ours and ambient occlusion", "fragment", 56, 40,
       [&] { return occlude(fragment(g), width, height, mapping); }, false},
      {"ours and ambient occlusion", "compute", 56, 40,
       [&] { return occlude_compute(compute(g), width, height, mapping); }, false},
      {"Mellado, radius 8", "fragment", 36, 20, [&] { return fit(g, SC::parameters::pixel_radius(8)); },
       true},
      {"Mellado, radius 8", "compute", 36, 20,
       [&] { return fit_compute(g, SC::parameters::pixel_radius(8)); }, true}};

  const double copy = measured_bandwidth();
  const bool is_software = is_software_renderer();
  std::vector<std::string> columns = {"coverage, %"};
  for(const Method& m : methods)
    columns.push_back(m.name + " (" + m.stage + ")");
  columns.push_back("Mellado / ours, quickest of each");
  Table digest("frame_time_ms",
               "Frame time in ms at " + std::to_string(width) + " x " + std::to_string(height) +
                   " (Figure 7.16)",
               columns);
  std::map<std::string, support::Plot_series> series;
  std::vector<std::string> order;
  std::map<std::string, double> errors;
  double least_ratio = std::numeric_limits<double>::infinity(), last_ratio = 0., largest_share = 0.;
  for(const double coverage : coverages)
  {
    depths.upload(GL_RED, scene.covered(coverage));
    glFinish();
    std::vector<Table::Cell> row = {100. * coverage};
    double ours = std::numeric_limits<double>::infinity(), theirs = ours;
    for(const Method& m : methods)
    {
      const std::string title = m.name + " (" + m.stage + ")";
      if(errors.count(title) == 0 || coverage == 1.)
        errors[title] = m.has_mean ? error_of(m.frame(), scene) : std::numeric_limits<double>::quiet_NaN();
      const Frame_time time = time_of([&] { m.frame(); }, seconds);
      const double ms = is_software ? time.processor : time.gpu;
      const double pixels = double(width) * double(height);
      const double bytes = coverage * m.bytes_of_surface + (1. - coverage) * m.bytes_of_background;
      const double rate = bytes * pixels / (1e6 * ms);
      findings.all.add({m.name, m.stage, coverage, time.gpu, time.wall, time.processor, time.frames,
                        1e6 * ms / (coverage * pixels), bytes, rate, rate / copy,
                        settings.peak_bandwidth > 0. ? rate / settings.peak_bandwidth
                                                     : std::numeric_limits<double>::quiet_NaN(),
                        errors[title]});
      row.emplace_back(ms);
      if(m.name == "ours")
      {
        ours = std::min(ours, ms);
        if(coverage == 1.)
          largest_share = std::max(largest_share, rate / copy);
      }
      if(m.name == "Mellado, radius 8")
        theirs = std::min(theirs, ms);
      support::Plot_series& s = series[title];
      if(s.x.empty())
        order.push_back(title);
      s.name = title;
      s.x.push_back(100. * coverage);
      s.y.push_back(ms);
    }
    row.emplace_back(theirs / ours);
    last_ratio = theirs / ours;
    least_ratio = std::min(least_ratio, last_ratio);
    digest.add(row);
  }
  digest.remark(
      "On " + renderer_name() + ", " +
      (is_software ? "a program on the processor: times are those of the processor, of all threads together."
                   : "times by the timer of the GPU.") +
      " Ours is " + readable(least_ratio) + " times as fast as Mellado's at least, " + readable(last_ratio) +
      " times where all of the picture is covered; median error of the mean curvature on this scene, in "
      "% of the median magnitude: " +
      "ours " + readable(100. * errors["ours (fragment)"]) + ", one triangle " +
      readable(100. * errors["ours, one triangle (thesis) (fragment)"]) + ", LOD of 8 pixels " +
      readable(100. * errors["ours, LOD of 8 pixels (fragment)"]) + ", Mellado, radius 8 " +
      readable(100. * errors["Mellado, radius 8 (fragment)"]) + ".");
  digest.remark("A pixel with a surface has to have 36 bytes read and written at least: 4 of depth, 16 of "
                "normals, 16 of results (20 with "
                "16-bit normals and two channels of results).");
  if(!is_software)
    digest.remark("A copy of a large texture moves " + readable(copy) +
                  " GB/s here; at full coverage ours moves " + readable(100. * largest_share) + " % of that" +
                  (settings.peak_bandwidth > 0.
                       ? ", " + readable(100. * largest_share * copy / settings.peak_bandwidth) +
                             " % of the memory's " + readable(settings.peak_bandwidth) + " GB/s."
                       : "."));
  findings.digests.push_back(digest);
  findings.is_plausible = errors["ours (fragment)"] < .02 && errors["ours (compute)"] < .02;

  support::Plot plot;
  plot.title = "Frame time, " + renderer_name();
  plot.x_label = "pixels with a surface, %";
  plot.y_label = "ms";
  plot.y_logarithmic = true;
  for(const std::string& title : order)
    plot.series.push_back(series[title]);
  support::write_png(settings.folder + "/frame_time.png", plot.image(1500, 900));
  return findings;
}

} // namespace screen_space
