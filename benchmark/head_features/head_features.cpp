// The experiment of the thesis's chapter on the feature points of heads (9.2): the errors of the points that are found on heads
// whose features are known, in several ways; the verdicts on shapes that are no heads; and how far heads that are deformed by
// these points are from those deformed by the true ones. One command runs it and prints its tables.
//
//     head_features --heads folder --markdown errors.md --csv errors.csv --plot errors.png
//
// A head is a file `<name>_<variant>.ply` with its truth, `<name>_<variant>.json`, beside it.
#include "Command_line.h"
#include "parts/Head.h"
#include "parts/deformation.h"
#include "parts/detection.h"
#include "parts/errors.h"
#include "parts/report.h"

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using benchmark_support::Command_line;
using namespace head_features;
using SC::Head_feature;

std::size_t number_found(const Features& features)
{
  return std::size_t(std::count_if(features.points.begin(), features.points.end(),
                                   [](const auto& p) { return p.is_found; }));
}

// Nothing is known of this shape but its name.
Shape_row judged(const std::string& name, const Mesh& mesh, const Features* truth = nullptr)
{
  const Verdict v = judge(mesh);
  Shape_row row{name,         to_string(v.verdict),     to_string(v.obstacle),
                v.confidence, number_found(v.features), ""};
  if(truth && v.features.is_head)
  {
    std::vector<double> errors;
    for(std::size_t i = 0; i < SC::number_of_head_features; ++i)
      if(v.features.points[i].is_found && truth->points[i].is_found)
        errors.push_back(
            100. *
            std::sqrt(CGAL::squared_distance(v.features.points[i].position, truth->points[i].position)) /
            truth->head_height);
    const Error_summary s = summary(errors);
    row.remark = "points off by " + std::to_string(s.median).substr(0, 5) + " % of its height (median), " +
                 std::to_string(s.maximum).substr(0, 5) + " % at most";
  }
  return row;
}

Mesh sphere()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point_3(0, 0, 0), 1.);
  for(int level = 0; level < 4; ++level)
  {
    // each triangle becomes four
    std::map<Mesh::Edge_index, Mesh::Vertex_index> middles;
    Mesh finer;
    for(const auto v : mesh.vertices())
      finer.add_vertex(mesh.point(v));
    for(const auto e : mesh.edges())
      middles[e] =
          finer.add_vertex(CGAL::midpoint(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
    for(const auto f : mesh.faces())
    {
      const auto h = mesh.halfedge(f), n = mesh.next(h), p = mesh.prev(h);
      const auto a = mesh.source(h), b = mesh.target(h), c = mesh.target(n);
      const auto ab = middles[mesh.edge(h)], bc = middles[mesh.edge(n)], ca = middles[mesh.edge(p)];
      finer.add_face(a, ab, ca);
      finer.add_face(b, bc, ab);
      finer.add_face(c, ca, bc);
      finer.add_face(ab, bc, ca);
    }
    mesh = finer;
  }
  for(const auto v : mesh.vertices())
  {
    const Kernel::Vector_3 r = mesh.point(v) - CGAL::ORIGIN;
    mesh.point(v) = CGAL::ORIGIN + r / std::sqrt(r.squared_length());
  }
  return mesh;
}

// the part of a head at positive x
Mesh half_of(Mesh mesh)
{
  const std::vector<Mesh::Face_index> all(mesh.faces().begin(), mesh.faces().end());
  for(const Mesh::Face_index f : all)
  {
    bool is_left = false;
    for(const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      is_left = is_left || mesh.point(v).x() < 0.;
    if(is_left)
      CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  }
  mesh.collect_garbage();
  return mesh;
}

std::vector<Shape_row> shapes(const std::vector<Head_file>& files, bool is_quick)
{
  std::vector<Shape_row> rows;
  const auto add = [&](const std::string& name, const Mesh& mesh, const Features* truth = nullptr)
  {
    rows.push_back(judged(name, mesh, truth));
    std::cerr << name << " done\n";
  };
  add("sphere", sphere());
#ifdef SHAPE_CHARACTERISTICS_DATA_DIR
  const std::vector<std::string> names =
      is_quick ? std::vector<std::string>{"fandisk.off"}
               : std::vector<std::string>{
                     "elephant.off",        "fandisk.off", "bunny00.off", "lion-head.off", "head.off",
                     "mannequin-devil.off", "man.off",     "pig.off",     "camel.off",     "dino.off"};
  for(const std::string& name : names)
  {
    const std::string file = std::string(SHAPE_CHARACTERISTICS_DATA_DIR) + "/meshes/" + name;
    std::error_code ignored;
    if(std::filesystem::is_regular_file(file, ignored))
      add(name, read_mesh(file));
  }
#endif
  for(const Head_file& file : files)
    if(file.variant == "crop")
    {
      const Head head = read_head(file);
      add("half a head", half_of(head.mesh));
      break;
    }
  for(const Head_file& file : files)
    if(file.variant == "head")
    {
      Head head = read_head(file);
      const auto turned = [](const Point_3& p) { return Point_3(-p.x(), -p.y(), p.z()); };
      for(const auto v : head.mesh.vertices())
        head.mesh.point(v) = turned(head.mesh.point(v));
      for(auto& p : head.truth.points)
        p.position = turned(p.position);
      add("upside-down bust, any pose", head.mesh, &head.truth);
      const Features aligned = detect(head.mesh, "aligned");
      rows.push_back({"upside-down bust, said to be aligned", to_string(aligned.verdict),
                      to_string(aligned.obstacle), 0., number_found(aligned), ""});
      break;
    }
  return rows;
}

int run(const Command_line& arguments)
{
  const bool is_quick = arguments.has("quick");
  const std::vector<std::string> variants = arguments.list(
      "variants", is_quick ? "crop,posed" : "crop,head,posed,smile,jawopen,noisy,skin,loop1,closed,asym");
  const std::vector<std::string> modes =
      arguments.list("modes", is_quick ? "default" : "default,aligned,thesis");
  std::string comment;
  std::vector<Head_file> files = head_files(arguments.text("heads", ""), variants, comment);
  const std::size_t most = arguments.number("models", is_quick ? 1 : files.size());
  std::map<std::string, std::size_t> taken;
  files.erase(std::remove_if(files.begin(), files.end(),
                             [&](const Head_file& f) { return ++taken[f.variant] > most; }),
              files.end());
  std::cout << comment << "\n\n";

  Measurements measurements;
  std::vector<Deformation_difference> deformations;
  std::map<std::string, std::pair<Features, Features> > tessellations; // by name and mode: skin and loop1
  std::map<std::string, double> heights;
  std::map<std::string, std::pair<double, std::size_t> > seconds;
  const std::string deformed_variant = arguments.text("deformed", "crop");
  for(const Head_file& file : files)
  {
    const Head head = read_head(file);
    std::vector<std::string> its_modes = modes;
    if(!is_quick && file.variant == "crop" && !arguments.has("modes"))
      its_modes = all_modes();
    for(const std::string& mode : its_modes)
    {
      if(file.variant == "posed" && mode != "default") // which say that the pose is that of the coordinates
        continue;
      const auto start = std::chrono::steady_clock::now();
      const Features found = detect(head.mesh, mode);
      auto& time = seconds[mode];
      time.first += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      ++time.second;
      measurements.add(head, mode, found);
      if(mode == "default" && file.variant == deformed_variant)
        for(std::size_t i = 0; i < SC::number_of_head_expressions; ++i)
          deformations.push_back(deformation_difference(head, found, static_cast<SC::Head_expression>(i)));
      if(file.variant == "skin")
        tessellations[file.name + ", " + mode].first = found;
      if(file.variant == "loop1")
        tessellations[file.name + ", " + mode].second = found;
      heights[file.name + ", " + mode] = head.truth.head_height;
    }
    std::cerr << file.name << ' ' << file.variant << " done\n";
  }

  std::string report;
  const std::string heading = "Errors are median / largest, in percent of the head's height. "
                              "Bold: the goal is missed.\n\n";
  if(!files.empty())
  {
    for(const std::string& mode : modes)
    {
      report += "### Errors of mode `" + mode + "`\n\n" + heading +
                markdown_errors(measurements, variants, mode, mode != "thesis");
      report +=
          "Regions: precision, recall (their least), in numbers of vertices. The goal of ears is 0.9.\n\n" +
          markdown_regions(measurements, variants, mode);
    }
    const auto has = [&](const std::string& v)
    { return std::find(variants.begin(), variants.end(), v) != variants.end() && taken[v] > 0; };
    if(has("head") && has("posed"))
      for(const std::string reference : {"default", "aligned"})
        if(std::find(modes.begin(), modes.end(), reference) != modes.end())
          report += "### In any pose, against mode `" + reference + "` in the frame of heads\n\n" +
                    markdown_ratio(measurements, "posed", "default", "head", reference, 1.5);
    if(has("crop") && !is_quick)
      report += "### Modes and curvature estimators, on `crop`\n\n" +
                markdown_modes(measurements, "crop", arguments.has("modes") ? modes : all_modes());
    std::vector<Tessellation_row> rows;
    for(const auto& [name, both] : tessellations)
    {
      if(!both.first.is_head || !both.second.is_head)
        continue;
      Tessellation_row row{name, {}, {}, {}};
      for(std::size_t i = 0; i < SC::number_of_head_features; ++i)
      {
        const auto &a = both.first.points[i], &b = both.second.points[i];
        if(a.is_found && b.is_found)
        {
          row.distances.push_back(100. * std::sqrt(CGAL::squared_distance(a.position, b.position)) /
                                  heights.at(name));
          if(row.distances.back() > .3)
            row.far.push_back(SC::to_string(static_cast<Head_feature>(i)));
        }
        else if(a.is_found != b.is_found)
          row.only_on_one.push_back(SC::to_string(static_cast<Head_feature>(i)));
      }
      rows.push_back(row);
    }
    if(!rows.empty())
      report += "### The same points on another tessellation (`skin` against `loop1`)\n\n"
                "Distances in percent of the head's height; the goal is 0.3.\n\n" +
                markdown_tessellations(rows);
    if(!deformations.empty())
      report += "### Deformed by the points found against by the true ones, on `" + deformed_variant +
                "`\n\nIn percent of the head's height.\n\n" + markdown_deformations(deformations);
  }
  if(!arguments.has("no-shapes"))
    report += "### Other shapes\n\n" + markdown_shapes(shapes(files, is_quick));
  if(!seconds.empty())
  {
    report += "### Time\n\n| mode | seconds a head |\n|---|---:|\n";
    for(const auto& [mode, time] : seconds)
      report += "| " + mode + " | " + std::to_string(time.first / double(time.second)).substr(0, 5) + " |\n";
  }
  std::cout << report;
  if(arguments.has("markdown"))
  {
    std::ofstream out(arguments.text("markdown", ""));
    out << report;
    if(!out)
      throw std::runtime_error("can't write " + arguments.text("markdown", ""));
  }
  if(arguments.has("csv"))
    write_csv(arguments.text("csv", ""), measurements);
  if(arguments.has("plot") &&
     !write_plot(arguments.text("plot", ""), measurements, variants, {"default", "thesis"}))
    std::cout << "No plot: built without the library of the examples\n";

  if(is_quick && !files.empty()) // what a test can say of one head: the points are where they belong
  {
    std::vector<double> errors;
    for(const Point_error& e : measurements.points)
      if(e.mode == "default" && e.is_found)
        errors.push_back(e.error);
    const Error_summary s = summary(errors);
    std::cout << s.found << " points, " << s.median << " % off\n";
    return s.found >= 40 && s.median < 2. ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    return run(Command_line(argc, argv,
                            {"heads", "variants", "modes", "models", "deformed", "csv", "markdown", "plot"},
                            {"quick", "no-shapes"}));
  }
  catch(const std::exception& e)
  {
    std::cerr << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
