#include "Experiment.h"
#include "Mesh.h"
#include "surfaces.h"

#include <Shape_characteristics/screen_space/OpenGL/G_buffer_renderer.h>
#include <Shape_characteristics/screen_space/OpenGL/Screen_space_curvature_pass.h>
#include <Shape_characteristics/screen_space/OpenGL/Sphere_fit_mean_curvature_pass.h>
#include <Shape_characteristics/screen_space/OpenGL/read_g_buffer.h>
#include <Shape_characteristics/screen_space/OpenGL/read_screen_space_curvatures.h>

#include <support/Image.h>
#include <support/Orbit_camera.h>
#include <support/Plot.h>

#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace screen_space {
namespace {

namespace SC = Shape_characteristics;

struct Estimate
{
  std::vector<float> mean, gaussian;
  std::size_t failed = 0;
};

struct Error
{
  double mse = 0., mae = 0., median = 0.; // the median relative to that of the true magnitudes
};

Error error_of(const std::vector<float>& values,
               const std::vector<double>& truth,
               const std::vector<bool>& counts)
{
  Error error;
  std::vector<double> differences, magnitudes;
  for(std::size_t i = 0; i < values.size(); ++i)
    if(counts[i] && std::isfinite(values[i]))
    {
      const double d = std::abs(double(values[i]) - truth[i]);
      differences.push_back(d);
      magnitudes.push_back(std::abs(truth[i]));
      error.mae += d;
      error.mse += d * d;
    }
  const double n = double(differences.size());
  error.mae /= n;
  error.mse /= n;
  error.median = median(differences) / median(magnitudes);
  return error;
}

// Pixels that are at least `margin` away from the background.
std::vector<bool> inner_pixels(const SC::G_buffer& g, int margin)
{
  const int width = g.width(), height = g.height();
  std::vector<bool> inner(g.size());
  for(std::size_t i = 0; i < g.size(); ++i)
    inner[i] = g.is_valid(i);
  for(const bool is_row : {true, false}) // a square is a product of intervals
  {
    const int lines = is_row ? height : width, length = is_row ? width : height;
    for(int line = 0; line < lines; ++line)
    {
      const auto index = [&](int k) { return is_row ? g.index(k, line) : g.index(line, k); };
      int run = 0; // since the last background
      std::vector<int> before(std::size_t(length), 0);
      for(int k = 0; k < length; ++k)
        before[std::size_t(k)] = run = inner[index(k)] ? run + 1 : 0;
      run = 0;
      for(int k = length - 1; k >= 0; --k)
      {
        run = inner[index(k)] ? run + 1 : 0;
        inner[index(k)] = std::min(run, before[std::size_t(k)]) > margin;
      }
    }
  }
  return inner;
}

struct Subject
{
  std::string surface;
  std::size_t vertices;
  std::string name;
};

} // namespace

Findings measure_accuracy(const Settings& settings)
{
  Findings findings{Table("accuracy", "Error over the distance of the camera",
                          {"surface", "vertices", "distance", "pixels_across", "method", "pixels", "failed",
                           "mse_H", "mae_H", "median_relative_H", "mse_K", "mae_K", "median_relative_K"}),
                    {},
                    true};
  const std::vector<Subject> subjects =
      settings.is_quick
          ? std::vector<Subject>{{"sphere", 2562, "sphere"}, {"torus", 1000, "torus"}}
          : std::vector<Subject>{
                {"sphere", 40962, "sphere"}, {"torus", 1000, "torus"}, {"torus", 200000, "torus (fine)"},
                {"f1", 15000, "f1"},         {"f2", 15000, "f2"},      {"f1", 400000, "f1 (fine)"},
                {"f2", 400000, "f2 (fine)"}};
  const int size = settings.is_quick ? 256 : 1024;
  std::vector<double> distances;
  for(double d = 1.; d < (settings.is_quick ? 3. : 10.); d *= std::sqrt(2.))
    distances.push_back(d);
  const int margin = 8;

  SC::G_buffer_renderer renderer;
  SC::Screen_space_curvature_pass ours;
  SC::Sphere_fit_mean_curvature_pass sphere_fit;

  std::vector<std::string> methods;
  Table digest_H("", "", {}), digest_K("", "", {});
  for(const Subject& subject : subjects)
  {
    const Surface s = surface(subject.surface, subject.vertices, settings.seed);
    Normal_map normals;
    const Mesh mesh = mesh_of(s, normals);
    renderer.set_mesh(mesh, SC::parameters::vertex_normal_map(normals));
    CGAL::Bbox_3 box;
    for(const auto v : mesh.vertices())
      box += mesh.point(v).bbox();
    support::Camera view;
    view.towards_eye = {s.towards_eye.x, s.towards_eye.y, s.towards_eye.z};
    view.up = {s.up.x, s.up.y, s.up.z};
    const double edge = mean_edge(mesh);

    std::map<std::string, support::Plot_series> of_H, of_K;
    for(const double distance : distances)
    {
      support::Orbit_camera orbit(box, view);
      // one far plane for all distances: the thesis's level of detail depends on it
      const double far_plane = 12. * orbit.camera(size, size).far_plane();
      orbit.move(distance);
      const SC::Camera near_camera = orbit.camera(size, size);
      const SC::Camera camera(near_camera.view(),
                              SC::Camera::perspective(2. * std::atan(1. / near_camera.projection()(1, 1)), 1.,
                                                      near_camera.near_plane(), far_plane));
      const SC::G_buffer_textures textures = renderer.draw(camera, size, size);
      std::vector<float> depths, directions;
      const SC::G_buffer g = SC::read_g_buffer(textures, depths, directions);
      const std::vector<bool> counts = inner_pixels(g, margin);
      std::vector<double> H(g.size()), K(g.size());
      std::size_t pixels = 0;
      int left = size, right = 0;
      for(std::size_t i = 0; i < g.size(); ++i)
        if(g.is_valid(i))
        {
          const Eigen::Vector3d p = g.camera().world_point(g.view_point(i));
          const Exact_curvature truth = s.truth({p.x(), p.y(), p.z()});
          H[i] = truth.mean();
          K[i] = truth.gaussian();
          pixels += counts[i] ? 1 : 0;
          left = std::min(left, int(i) % size);
          right = std::max(right, int(i) % size + 1);
        }

      using Run = std::function<unsigned()>;
      const auto with = [&](const SC::Level_of_detail& level, int triangles)
      {
        return [&, level, triangles]
        { return ours(textures, SC::parameters::level_of_detail(level).number_of_triangles(triangles)); };
      };
      const std::vector<std::pair<std::string, Run>> runs = {
          {"ours", with(SC::Level_of_detail::none(), 4)},
          {"ours, one triangle (thesis)", with(SC::Level_of_detail::none(), 1)},
          {"ours, LOD by length", with(SC::Level_of_detail::by_length(edge), 4)},
          {"ours, LOD of the thesis", with(SC::Level_of_detail::by_depth(20.), 4)},
          {"Mellado, radius 8", [&] { return sphere_fit(textures, SC::parameters::pixel_radius(8)); }}};
      methods.clear();
      std::vector<Table::Cell> row_H = {subject.name, distance, right - left}, row_K = row_H;
      for(const auto& [method, run] : runs)
      {
        methods.push_back(method);
        Estimate e;
        e.mean.resize(g.size());
        e.gaussian.resize(g.size());
        e.failed = SC::read_screen_space_curvatures(
            run(), size, size,
            SC::parameters::mean_curvature_map(CGAL::make_property_map(e.mean))
                .Gaussian_curvature_map(CGAL::make_property_map(e.gaussian)));
        const bool has_K = method.rfind("Mellado", 0) != 0; // a sphere has none of its own
        const Error error_H = error_of(e.mean, H, counts), nothing{NAN, NAN, NAN};
        const Error error_K = has_K ? error_of(e.gaussian, K, counts) : nothing;
        findings.all.add({subject.name, subject.vertices, distance, right - left, method, pixels, e.failed,
                          error_H.mse, error_H.mae, error_H.median, error_K.mse, error_K.mae,
                          error_K.median});
        row_H.emplace_back(100. * error_H.median);
        if(has_K)
          row_K.emplace_back(100. * error_K.median);
        const auto plot = [&, &name = method](std::map<std::string, support::Plot_series>& series, double y)
        {
          support::Plot_series& p = series[name];
          p.name = name;
          p.x.push_back(distance);
          p.y.push_back(y);
        };
        plot(of_H, error_H.mse);
        if(has_K)
          plot(of_K, error_K.mse);
        // a broken pass doesn't come near the truth
        if(method == "ours" && distance == 1. && subject.surface == "sphere")
          findings.is_plausible = findings.is_plausible && error_H.median < .02 && error_K.median < .04;
      }
      if(digest_H.title().empty())
      {
        std::vector<std::string> columns = {"surface", "distance", "pixels across"};
        columns.insert(columns.end(), methods.begin(), methods.end());
        digest_H = Table("accuracy_H",
                         "Mean curvature: median error, in % of the median magnitude (Figure 7.7)", columns);
        columns.pop_back();
        digest_K =
            Table("accuracy_K", "Gaussian curvature: median error, in % of the median magnitude (Figure 7.8)",
                  columns);
      }
      digest_H.add(row_H);
      digest_K.add(row_K);
    }

    const auto write = [&](const std::string& quantity, const std::string& letter,
                           std::map<std::string, support::Plot_series>& series)
    {
      support::Plot plot;
      plot.title = subject.name + ": error of the " + quantity + " curvature";
      plot.x_label = "distance of the camera (1: the picture is filled)";
      plot.y_label = "mean squared error";
      plot.x_logarithmic = plot.y_logarithmic = true;
      for(const std::string& method : methods)
        if(series.count(method) != 0)
          plot.series.push_back(series[method]);
      std::string file = subject.name;
      std::replace(file.begin(), file.end(), ' ', '_');
      file.erase(std::remove_if(file.begin(), file.end(), [](char c) { return c == '(' || c == ')'; }),
                 file.end());
      support::write_png(settings.folder + "/accuracy_" + letter + "_" + file + ".png", plot.image());
    };
    write("mean", "H", of_H);
    write("Gaussian", "K", of_K);
  }
  const std::string remark =
      "Pixels at least " + std::to_string(margin) + " away from the background. Pictures of " +
      std::to_string(size) + " x " + std::to_string(size) +
      ", exact normals at the vertices. LOD by length takes the mean edge of the mesh.";
  digest_H.remark(remark);
  digest_K.remark(remark);
  findings.digests = {digest_H, digest_K};
  return findings;
}

} // namespace screen_space
