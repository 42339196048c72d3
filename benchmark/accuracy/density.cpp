// The errors of estimators over the number of points of a surface, and pictures of them: the experiments of the thesis's
// section 7.3.1 (figures 7.4 to 7.6), for all estimators.
#include "Command_line.h"
#include "fitted_exponent.h"

#include "parts/Report.h"
#include "parts/Sample.h"
#include "parts/Table.h"
#include "parts/estimators.h"
#include "parts/measure.h"

#if __has_include(<support/Contact_sheet.h>) // what the examples share, where its dependencies are found
#include <support/Contact_sheet.h>
#include <support/Mesh_renderer.h>
#include <support/Plot.h>
#include <support/drawable_mesh.h>
#define SHAPE_CHARACTERISTICS_HAS_PICTURES
#endif

#include <Shape_characteristics/curvature/tangent_space_curvatures.h>
#include <Shape_characteristics/internal/CGAL_compatibility.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace accuracy {
namespace {

// f1 and f2 of the thesis's chapter 7 are the first two of its chapter 8.
const std::vector<std::string> surfaces = {"f1e", "f2e"};

// exact normals and random points
Table experiment()
{
  Table table;
  table.name = "7.5";
  table.title = "error over the number of points";
  table.surfaces = surfaces;
  return table;
}

Estimator tangent_space(unsigned int edges)
{
  return {"tangent space",
          std::to_string(edges) + " edges",
          {},
          [edges](const Task& t)
          { SC::tangent_space_curvatures(t.mesh, t.parameters().number_of_edges(edges)); },
          Cost::LOW};
}

// Those of table 8.3; the one of the tangent space in both its kinds, which are first.
std::vector<Estimator> compared_estimators(bool costly)
{
  std::vector<Estimator> result = {tangent_space(2), tangent_space(3)};
  for(const Estimator& e : estimators())
    for(const Appearance& a : e.appearances)
      if(a.table == "8.3" && e.name != result[0].name && (costly || e.cost == Cost::LOW))
        result.push_back(e);
  return result;
}

// One estimator on one surface, for each number of points.
struct Course
{
  std::string surface, estimator;
  std::vector<Errors> errors;

  // The power of the distance of the points with which the error falls: n points have distances like n^(-1/2).
  double order(const std::vector<std::uint64_t>& points) const
  {
    std::vector<double> maes;
    for(const Errors& e : errors)
      maes.push_back(e.all.mae());
    return -2. * benchmark_support::fitted_exponent(std::vector<double>(points.begin(), points.end()), maes);
  }
};

void print(const std::string& surface,
           const std::vector<Course>& courses,
           const std::vector<std::uint64_t>& points)
{
  std::cout << "\n## " << surface << ": MAE(k_max) + MAE(k_min), exact normals\n\n| estimator |";
  for(const std::uint64_t n : points)
    std::cout << ' ' << n << " points |";
  std::cout << " order |\n|---|";
  for(std::size_t i = 0; i <= points.size(); ++i)
    std::cout << "---:|";
  std::cout << '\n';
  for(const Course& c : courses)
    if(c.surface == surface)
    {
      std::cout << "| " << c.estimator << " |";
      for(const Errors& e : c.errors)
        std::cout << ' ' << to_text(e.all.mae()) << " |";
      std::cout << ' ' << to_text(c.order(points)) << " |\n";
    }
}

void write_csv(const std::string& file,
               const std::vector<Course>& courses,
               const std::vector<std::uint64_t>& points)
{
  std::ofstream out(file);
  out.precision(17);
  out << "surface,estimator,points,vertices,flagged,mae,mse,median,mae_of_Gaussian,mse_of_Gaussian,seconds\n";
  for(const Course& c : courses)
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      const Errors& e = c.errors[i];
      out << c.surface << ",\"" << c.estimator << "\"," << points[i] << ',' << e.all.vertices() << ','
          << e.all.flagged() << ',' << e.all.mae() << ',' << e.all.mse() << ',' << e.all.median() << ','
          << e.gaussian_all.mae() << ',' << e.gaussian_all.mse() << ',' << e.seconds << '\n';
    }
  if(!out)
    throw std::runtime_error("can't write " + file);
}

#ifdef SHAPE_CHARACTERISTICS_HAS_PICTURES
void write_plot(const std::string& file,
                const std::string& surface,
                const std::vector<Course>& courses,
                const std::vector<std::uint64_t>& points)
{
  support::Plot plot;
  plot.title = surface + ", exact normals";
  plot.x_label = "points";
  plot.y_label = "MAE(k_max) + MAE(k_min)";
  plot.x_logarithmic = plot.y_logarithmic = true;
  for(const Course& c : courses)
    if(c.surface == surface)
    {
      support::Plot_series series;
      series.name = c.estimator;
      for(std::size_t i = 0; i < points.size(); ++i)
      {
        series.x.push_back(double(points[i]));
        series.y.push_back(c.errors[i].all.mae());
      }
      plot.series.push_back(series);
    }
  support::write_png(
      file, plot.image(1400, 160 + 42 * int(plot.series.size()))); // the list of names is the longest
}

// The mean curvature as a picture: the truth, and what some estimators make of it, with their errors.
void write_pictures(const std::string& file,
                    const std::string& surface,
                    const std::vector<Estimator>& compared,
                    std::uint64_t seed,
                    const Resolution& resolution)
{
  Sample sample = make_sample(experiment(), surface, seed, resolution);
  const Normal_map normals = make_normals(sample, Normals::EXACT);
  support::Drawable shape = support::drawable_mesh(sample.mesh);
  support::Render_options options;
  options.width = 420;
  options.height = 380;
  options.camera.towards_eye = {.4, -.8, .9};
  options.camera.up = {0., 0., 1.};
  for(const auto& e : sample.exact)
    shape.scalars.push_back(.5 * (e.k_min + e.k_max));
  options.range = support::percentile_range(shape.scalars, .02, true);
  support::Mesh_renderer renderer;
  support::Contact_sheet sheet("mean curvature of " + surface + ", " + std::to_string(resolution.points) +
                               " random points");
  sheet.add(renderer.render(shape, options), "exact");
  for(const Estimator& e : compared)
  {
    const Errors errors = measure(e, sample, normals, true);
    const Curvature_map curvatures = *SC::internal::to_optional(
        sample.mesh.property_map<Vertex, SC::Principal_curvatures_and_directions<Kernel>>("v:curvatures"));
    for(const Vertex v : vertices(sample.mesh))
      shape.scalars[v] = .5 * (curvatures[v].min_curvature + curvatures[v].max_curvature);
    sheet.add(renderer.render(shape, options), e.label() + "\nerror " + to_text(errors.all.mae()));
  }
  support::Legend legend;
  legend.title = "mean curvature";
  legend.range = options.range;
  sheet.set_legend(legend);
  support::write_png(file, sheet.image(3));
}
#endif

// What the thesis reads off its figures: errors fall as points get denser; it makes little difference whether two or three
// edges are used; Bezier triangles of random points are worse.
bool is_as_expected(const std::vector<Course>& courses, const std::vector<std::uint64_t>& points)
{
  bool is_right = true;
  const auto check = [&](bool holds, const std::string& what)
  {
    std::cout << "- " << what << ": " << (holds ? "yes" : "NO") << '\n';
    is_right = is_right && holds;
  };
  const auto course = [&](const std::string& surface, const std::string& estimator) -> const Course&
  {
    for(const Course& c : courses)
      if(c.surface == surface && c.estimator == estimator)
        return c;
    throw std::logic_error("no estimator " + estimator);
  };
  std::cout << '\n';
  for(const std::string& s : surfaces)
  {
    const Course &two = course(s, "tangent space, 2 edges"), &three = course(s, "tangent space, 3 edges"),
                 &bezier = course(s, "Zhihong, 1 ring");
    check(two.order(points) > .7 && three.order(points) > .7, s + ": both kinds converge");
    const double quotient = two.errors.back().all.mae() / three.errors.back().all.mae();
    check(quotient > .8 && quotient < 1.25,
          s + ": two edges have " + to_text(quotient) + " of the error of three, which is little difference");
    check(bezier.errors.back().all.mae() > two.errors.back().all.mae(), s + ": Bezier triangles are worse");
  }
  return is_right;
}

const char* const help =
    "Errors of curvature estimators over the number of random points of two graphs (figures 7.4 to 7.6).\n\n"
    "  --points 1000,2000,...  numbers of points (1000,2000,5000,10000,20000,50000)\n"
    "  --seeds 1,2,3           seeds of the points (1,2,3); errors are pooled over them\n"
    "  --costly                with the estimators that take minutes\n"
    "  --out FOLDER            where density.csv, plots and pictures go (none are written)\n"
    "  --quick                 few points, one seed; fails if the estimators are not as expected\n"
    "  --help                  this text\n";

int run(int argc, char** argv)
{
  const benchmark_support::Command_line arguments(argc, argv, {"points", "seeds", "out"},
                                                  {"costly", "quick", "help"});
  if(arguments.has("help"))
  {
    std::cout << help;
    return 0;
  }
  const bool is_quick = arguments.has("quick");
  const std::vector<std::uint64_t> points =
      arguments.numbers("points", is_quick ? "500,2000" : "1000,2000,5000,10000,20000,50000");
  const std::vector<std::uint64_t> seeds = arguments.numbers("seeds", is_quick ? "1" : "1,2,3");
  if(points.size() < 2 || seeds.empty() || *std::min_element(points.begin(), points.end()) < 10)
    throw std::invalid_argument("two numbers of points, of 10 at least, and one seed are the least");
  const std::string folder = arguments.text("out", "");
  const std::vector<Estimator> compared = compared_estimators(arguments.has("costly"));

  std::vector<Course> courses;
  for(const std::string& surface : surfaces)
  {
    const std::size_t first = courses.size();
    for(const Estimator& e : compared)
      courses.push_back({surface, e.label(), std::vector<Errors>(points.size())});
    for(std::size_t i = 0; i < points.size(); ++i)
      for(const std::uint64_t seed : seeds)
      {
        Resolution resolution;
        resolution.points = points[i];
        Sample sample = make_sample(experiment(), surface, seed, resolution);
        const Normal_map normals = make_normals(sample, Normals::EXACT);
        for(std::size_t e = 0; e < compared.size(); ++e)
          courses[first + e].errors[i].add(measure(compared[e], sample, normals, true));
      }
    print(surface, courses, points);
    std::cout.flush();
  }
  if(!folder.empty())
  {
    write_csv(folder + "/density.csv", courses, points);
#ifdef SHAPE_CHARACTERISTICS_HAS_PICTURES
    for(const std::string& surface : surfaces)
      write_plot(folder + "/density_" + surface + ".png", surface, courses, points);
    Resolution resolution;
    resolution.points = 5000;
    write_pictures(folder + "/curvature_f2e.png", "f2e", {compared[0], compared[1]}, seeds[0], resolution);
    const auto bezier = std::find_if(compared.begin(), compared.end(),
                                     [](const Estimator& e) { return e.name == "Zhihong"; });
    write_pictures(folder + "/curvature_f1e.png", "f1e", {compared[0], *bezier}, seeds[0], resolution);
#endif
  }
  return is_as_expected(courses, points) || !is_quick ? 0 : 1;
}

} // namespace
} // namespace accuracy

int main(int argc, char** argv)
{
  try
  {
    return accuracy::run(argc, argv);
  }
  catch(const std::invalid_argument& error)
  {
    std::cerr << error.what() << "\n\n" << accuracy::help;
    return 2;
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
