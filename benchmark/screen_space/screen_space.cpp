// The experiments of the thesis's chapter on screen-space curvature (7.3, 7.4): one command runs them, without a display, on a GPU if EGL finds
// one and on Mesa's software renderer otherwise, and prints their tables.
//
//   build/release/benchmark/benchmark_screen_space_screen_space [--out screen_space_results] [--quick]
//       [--only accuracy,normal_map,occlusion,frame_time] [--data folder] [--seed 1] [--width 1920 --height 1080]
//       [--bandwidth 3350]
//
// In the folder `--out` are then a CSV file with all figures and a picture or plots of each experiment, and report.md with the tables
// that are printed. `--data` is where the folder meshes/ with the meshes of CGAL is; `--bandwidth` is what the memory of the GPU can
// do at the most, in GB/s. `--quick` takes small pictures and fails if the figures can't be right.
#include "Command_line.h"
#include "parts/Experiment.h"
#include "parts/Gpu_timer.h"

#include <support/Offscreen_context.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using benchmark_support::Command_line;
using namespace screen_space;

void write(const std::string& file, const std::string& text)
{
  std::ofstream out(file);
  out << text;
  if(!out)
    throw std::runtime_error("can't write " + file);
}

int run(const Command_line& arguments)
{
  Settings settings;
  settings.is_quick = arguments.has("quick");
  settings.folder = arguments.text("out", settings.is_quick ? "screen_space_quick" : "screen_space_results");
  settings.seed = arguments.number("seed", 1);
  settings.width = int(arguments.number("width", 1920, 16));
  settings.height = int(arguments.number("height", 1080, 16));
  settings.peak_bandwidth = double(arguments.number("bandwidth", 0));
  if(arguments.has("data"))
    setenv("SHAPE_CHARACTERISTICS_DATA", arguments.text("data", "").c_str(), 1);
  const std::vector<std::pair<std::string, std::function<Findings(const Settings&)>>> experiments = {
      {"frame_time", measure_frame_time},
      {"accuracy", measure_accuracy},
      {"normal_map", measure_normal_map},
      {"occlusion", measure_occlusion}};
  const std::vector<std::string> chosen = arguments.list("only", "frame_time,accuracy,normal_map,occlusion");
  for(const std::string& name : chosen)
    if(std::none_of(experiments.begin(), experiments.end(), [&](const auto& e) { return e.first == name; }))
      throw std::invalid_argument("--only: no experiment " + name);
  std::filesystem::create_directories(settings.folder);

  const support::Offscreen_context context;
  std::string report = "# Curvature in screen space\n\nOn " + context.description() + ".\n\n";
  std::cout << report;
  bool is_plausible = true;
  for(const auto& [name, measure] : experiments)
  {
    if(std::find(chosen.begin(), chosen.end(), name) == chosen.end())
      continue;
    const Findings findings = measure(settings);
    write(settings.folder + "/" + findings.all.name() + ".csv", findings.all.csv());
    for(const Table& digest : findings.digests)
    {
      std::cout << digest.markdown() << std::flush;
      report += digest.markdown();
    }
    if(!findings.is_plausible)
      std::cout << "The figures of " << name << " can't be right.\n";
    is_plausible = is_plausible && findings.is_plausible;
    write(settings.folder + "/report.md", report); // what is there, if a later one fails
  }
  return is_plausible ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    return run(
        Command_line(argc, argv, {"out", "only", "data", "seed", "width", "height", "bandwidth"}, {"quick"}));
  }
  catch(const std::exception& e)
  {
    std::cerr << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
