// Every estimator on several meshes and a point set: a table on the standard output and, in the folder that is
// given as argument, for each run a PLY file with all the results and a picture of the mean curvature, and for
// each mesh a sheet that compares the estimators.
#include "support/Contact_sheet.h"
#include "support/Mesh_renderer.h"
#include "support/Ply_file.h"
#include "support/Progress_bar.h"
#include "support/camera_for.h"
#include "support/data_file.h"
#include "support/drawable_mesh.h"
#include "support/drawable_point_set.h"
#include "support/picture.h"

#include <Shape_characteristics/characteristics/Gaussian_curvature.h>
#include <Shape_characteristics/characteristics/Willmore_energy.h>
#include <Shape_characteristics/characteristics/curvedness.h>
#include <Shape_characteristics/characteristics/mean_curvature.h>
#include <Shape_characteristics/characteristics/shape_index.h>
#include <Shape_characteristics/curvature/hrbf_curvatures.h>
#include <Shape_characteristics/curvature/jet_fitting_curvatures.h>
#include <Shape_characteristics/curvature/rusinkiewicz_curvatures.h>
#include <Shape_characteristics/curvature/tangent_space_curvatures.h>
#include <Shape_characteristics/interpolation/Polyharmonic.h>
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
#include <Shape_characteristics/curvature/interpolated_corrected_curvatures.h>
#endif

#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO/XYZ.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace {

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Point_set = CGAL::Point_set_3<Kernel::Point_3>;
using Curvatures = SC::Principal_curvatures_and_directions<Kernel>;

// What an estimator answered, one value per vertex or point.
struct Estimates
{
  std::vector<Curvatures> curvatures;
  std::vector<double> mean_curvatures;
  std::vector<SC::Estimation_status> status;
  std::size_t flagged = 0;
  double seconds = 0;
};

// -- How an estimator is called ---------------------------------------------------------------------------

template <typename Surface, typename Maps, typename Estimator>
Estimates run(const Surface& surface, const Maps& maps, const std::string& label, const Estimator& estimator)
{
  using Clock = std::chrono::steady_clock;
  Estimates result;
  const Clock::time_point begin = Clock::now();
  result.flagged = estimator(surface, maps.callback(support::Progress_bar(label)));
  result.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return result;
}

template <typename Sample, typename CurvatureMap, typename StatusMap>
void collect(const Sample& sample,
             const CurvatureMap& curvature_map,
             const StatusMap& status_map,
             Estimates& result)
{
  result.curvatures.push_back(get(curvature_map, sample));
  result.mean_curvatures.push_back(SC::mean_curvature(result.curvatures.back()));
  result.status.push_back(get(status_map, sample));
}

template <typename Estimator>
Estimates estimate(Mesh& mesh, const std::string& label, const Estimator& estimator)
{
  const auto curvature_map = get(CGAL::dynamic_vertex_property_t<Curvatures>(), mesh);
  const auto status_map = get(CGAL::dynamic_vertex_property_t<SC::Estimation_status>(), mesh);
  Estimates result = run(mesh,
                         SC::parameters::vertex_principal_curvatures_and_directions_map(curvature_map)
                             .vertex_status_map(status_map),
                         label, estimator);
  for(const auto v : vertices(mesh))
    collect(v, curvature_map, status_map, result);
  return result;
}

template <typename Estimator>
Estimates estimate(Point_set& points, const std::string& label, const Estimator& estimator)
{
  const auto curvature_map = points.add_property_map<Curvatures>("curvatures").first;
  const auto status_map = points.add_property_map<SC::Estimation_status>("status").first;
  Estimates result = run(
      points, SC::parameters::principal_curvatures_and_directions_map(curvature_map).status_map(status_map),
      label, estimator);
  for(const Point_set::Index& i : points)
    collect(i, curvature_map, status_map, result);
  return result;
}

// Calls `task` for every estimator that knows what to do with a `Surface`; HRBF comes first.
template <typename Surface, typename Task>
void for_each_estimator(const Task& task)
{
  task("HRBF", "hrbf", [](const auto& surface, const auto& np) { return SC::hrbf_curvatures(surface, np); });
  task("HRBF of the thesis", "hrbf_thesis",
       [](const auto& surface, const auto& np)
       { return SC::hrbf_curvatures(surface, np.radial_basis_function(SC::Polyharmonic<3>())); });
  if constexpr(std::is_same_v<Surface, Mesh>)
  {
    task("Rusinkiewicz", "rusinkiewicz",
         [](const auto& mesh, const auto& np) { return SC::rusinkiewicz_curvatures(mesh, np); });
    task("tangent space", "tangent_space",
         [](const auto& mesh, const auto& np) { return SC::tangent_space_curvatures(mesh, np); });
  }
  for(const unsigned int degree : {2u, 4u})
    task("jet of degree " + std::to_string(degree), "jet_" + std::to_string(degree),
         [degree](const auto& surface, const auto& np)
         { return SC::jet_fitting_curvatures(surface, np.degree_fitting(degree)); });
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
  if constexpr(std::is_same_v<Surface, Mesh>)
    task("interpolated corrected", "interpolated_corrected",
         [](const auto& mesh, const auto& np) { return SC::interpolated_corrected_curvatures(mesh, np); });
#endif
}

// -- What is made of the answers --------------------------------------------------------------------------

void write_ply(const std::string& file_name, const support::Drawable& shape, const Estimates& estimates)
{
  const std::size_t n = shape.points.size();
  std::vector<double> k_min(n), k_max(n), Gaussian(n), index(n), curvedness(n), energy(n);
  std::vector<support::Vector> d_min(n), d_max(n);
  std::vector<std::uint8_t> status(n);
  for(std::size_t i = 0; i < n; ++i)
  {
    const Curvatures& c = estimates.curvatures[i];
    k_min[i] = c.min_curvature;
    k_max[i] = c.max_curvature;
    Gaussian[i] = SC::Gaussian_curvature(c);
    index[i] = SC::shape_index(c);
    curvedness[i] = SC::curvedness(c);
    energy[i] = SC::Willmore_energy(c);
    d_min[i] = {c.min_direction.x(), c.min_direction.y(), c.min_direction.z()};
    d_max[i] = {c.max_direction.x(), c.max_direction.y(), c.max_direction.z()};
    status[i] = std::uint8_t(estimates.status[i]);
  }

  support::Ply_file file(shape.points);
  if(!shape.triangles.empty())
    file.set_triangles(shape.triangles);
  if(!shape.normals.empty())
    file.add_normals(shape.normals);
  file.add_scalar("k_min", k_min);
  file.add_scalar("k_max", k_max);
  file.add_scalar("mean_curvature", estimates.mean_curvatures);
  file.add_scalar("Gaussian_curvature", Gaussian);
  file.add_scalar("shape_index", index);
  file.add_scalar("curvedness", curvedness);
  file.add_scalar("Willmore_energy", energy);
  file.add_vector("min_direction", d_min);
  file.add_vector("max_direction", d_max);
  file.add_uchar("status", status);
  file.add_comment(
      "curvatures are positive where the surface is convex; status 0 and 1: estimated, others: NaN");
  file.write(file_name);
}

// Rows of a Markdown table, on the standard output and in a file.
class Table
{
public:
  explicit Table(const std::string& file_name) : file_(file_name)
  {
    if(!file_)
      throw std::runtime_error("cannot write " + file_name);
    print("| shape        | estimator              | vertices | estimated | flagged | vertices/s | mean "
          "abs(H) of HRBF "
          "| mean abs. difference of H to it | median |\n"
          "|:-------------|:-----------------------|---------:|----------:|--------:|-----------:|-----------"
          "---------:"
          "|--------------------------------:|-------:|\n");
  }

  void add(const std::string& shape,
           const std::string& estimator,
           const Estimates& estimates,
           const Estimates& reference)
  {
    std::vector<double> differences;
    double difference = 0, size = 0;
    for(std::size_t i = 0; i < estimates.status.size(); ++i)
      if(SC::is_estimated(estimates.status[i]) && SC::is_estimated(reference.status[i]))
      {
        differences.push_back(std::abs(estimates.mean_curvatures[i] - reference.mean_curvatures[i]));
        difference += differences.back();
        size += std::abs(reference.mean_curvatures[i]);
      }
    if(differences.empty())
      throw std::runtime_error(shape + ", " + estimator + ": nothing could be estimated");
    const std::size_t n = estimates.status.size();
    char row[256];
    std::snprintf(row, sizeof row,
                  "| %-12s | %-22s | %8zu | %9zu | %7zu | %10.0f | %19.4g | %31.4g | %6.3g |\n",
                  shape.c_str(), estimator.c_str(), n, n - estimates.flagged, estimates.flagged,
                  double(n) / estimates.seconds, size / double(differences.size()),
                  difference / double(differences.size()), support::percentile(differences, 0.5));
    print(row);
  }

private:
  void print(const std::string& text)
  {
    std::cout << text << std::flush;
    file_ << text << std::flush;
  }
  std::ofstream file_;
};

// What the runs have in common.
struct Demo
{
  std::filesystem::path folder;
  support::Mesh_renderer renderer;
  Table table;
  bool is_right = true;

  explicit Demo(const std::filesystem::path& folder) : folder(folder), table((folder / "table.md").string())
  {}
};

// All estimators on one surface. `tail` is the part of the vertices at each end of the mean curvatures whose
// colours are not told apart.
template <typename Surface>
void show(Demo& demo, Surface& surface, support::Drawable shape, const std::string& name, double tail)
{
  Estimates reference;
  support::Picture_options options;
  options.width = 1000;
  options.height = 750;
  options.legend_title = "mean curvature";
  options.title = name;
  options.render.camera = support::camera_for(name);
  support::Contact_sheet sheet(name + ": mean curvature");
  int number_of_estimators = 0;

  for_each_estimator<Surface>(
      [&](const std::string& estimator, const std::string& file, const auto& function)
      {
        Estimates estimates = estimate(surface, name + ", " + estimator, function);
        if(reference.status.empty()) // the range of the first one is that of all, to be compared
        {
          reference = estimates;
          options.render.range = support::percentile_range(estimates.mean_curvatures, tail, true);
        }
        demo.table.add(name, estimator, estimates, reference);
        demo.is_right = demo.is_right && estimates.flagged <= estimates.status.size() / 10;

        const std::string path = (demo.folder / (name + "_" + file)).string();
        write_ply(path + ".ply", shape, estimates);
        shape.scalars = estimates.mean_curvatures;
        options.subtitle = estimator + ", " + std::to_string(shape.points.size()) +
                           (shape.triangles.empty() ? " points" : " vertices");
        support::write_png(path + ".png", support::picture(demo.renderer, shape, options));
        support::Render_options thumbnail = options.render;
        thumbnail.width = 480;
        thumbnail.height = 400;
        sheet.add(demo.renderer.render(shape, thumbnail), estimator);
        ++number_of_estimators;
      });

  support::Legend legend;
  legend.title = options.legend_title;
  legend.range = options.render.range;
  sheet.set_legend(legend);
  const support::Image image = sheet.image((number_of_estimators + 1) / 2); // two rows
  support::write_png((demo.folder / (name + "_comparison.png")).string(), image);
}

void show_mesh(Demo& demo, const std::string& name, double tail)
{
  Mesh mesh;
  const std::string file_name = support::data_file("meshes/" + name + ".off");
  if(!CGAL::IO::read_polygon_mesh(file_name, mesh))
    throw std::runtime_error("cannot read " + file_name);
  show(demo, mesh, support::drawable_mesh(mesh), name, tail);
}

void show_point_set(Demo& demo, const std::string& file, double tail)
{
  Point_set points;
  const std::string file_name = support::data_file("points_3/" + file);
  std::ifstream stream(file_name);
  if(!CGAL::IO::read_XYZ(stream, points) || !points.has_normal_map())
    throw std::runtime_error("cannot read points with normals from " + file_name);
  show(demo, points, support::drawable_point_set(points), std::filesystem::path(file).stem().string(), tail);
}

} // namespace

int main(int argc, char* argv[])
try
{
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  std::filesystem::create_directories(folder);
  Demo demo(folder);
  show_mesh(demo, "elephant", 0.04);
  show_mesh(demo, "lion-head", 0.06);
  show_mesh(demo, "anchor_dense", 0.15); // flat faces, holes and sharp edges: the holes are to be seen
  show_mesh(demo, "bunny00", 0.02);
  show_point_set(demo, "kitten.xyz", 0.02);
  if(!demo.is_right)
    std::cerr << "demo: an estimator left more than a tenth of the vertices without an estimate\n";
  return demo.is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
catch(const std::exception& error)
{
  std::cerr << "demo: " << error.what() << '\n';
  return EXIT_FAILURE;
}
