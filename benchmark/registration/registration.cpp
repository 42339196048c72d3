// The experiment of the thesis's chapter on registration (10.2): heads are cut into two parts that overlap, and registered by
// several variants of features and tests. One command runs it and prints its tables; trials that are in the file of an earlier
// run aren't repeated.
#include "Command_line.h"
#include "parts/Trial.h"
#include "parts/heads.h"
#include "parts/report.h"
#include "parts/splits.h"
#include "parts/variants.h"

#include <Shape_characteristics/registration/Registration_verdict.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using benchmark_support::Command_line;
using namespace registration;

/// "mixed", "band.1" (half the width of the band, in radii) or either with "_noise.3" (in mean edges) behind it
Split_protocol parse_protocol(const std::string& name)
{
  Split_protocol protocol;
  const std::size_t noise = name.find("_noise");
  const std::string band = name.substr(0, noise);
  if(band.rfind("band", 0) == 0)
    protocol.least_band = protocol.largest_band = std::stod(band.substr(4));
  else if(band != "mixed")
    throw std::invalid_argument("no protocol " + name);
  if(noise != std::string::npos)
    protocol.noise = std::stod(name.substr(noise + 6));
  return protocol;
}

std::uint64_t seed_of(std::uint64_t seed, std::size_t head, std::size_t number)
{
  return (seed * 1000 + head) * 100000 + number;
}

int run(const Command_line& arguments)
{
  const bool is_quick = arguments.has("quick");
  std::string comment;
  const std::vector<std::string> files = head_files(arguments.text("heads", ""), comment);
  std::cout << comment << '\n';
  if(files.empty())
    return EXIT_SUCCESS;

  const std::uint64_t seed = arguments.number("seed", 1);
  const std::size_t per_head = arguments.number("trials", is_quick ? 2 : 10, 1);
  const std::size_t heads =
      std::min<std::size_t>(arguments.number("models", is_quick ? 1 : files.size(), 1), files.size());
  const std::size_t faces[2] = {arguments.number("faces", is_quick ? 6000 : 20000, 500), 0};
  const std::size_t both_faces[2] = {faces[0], faces[0] * 9 / 10};
  std::string all_variants;
  for(const Variant& v : variants())
    all_variants += v.name + ",";
  const std::vector<std::string> chosen =
      arguments.list("variants", is_quick ? "base,pipeline" : all_variants);
  const std::vector<std::uint64_t> sizes = arguments.numbers("neighbors", is_quick ? "60" : "10,60,150");
  const std::vector<std::string> surfaces = arguments.list("surfaces", is_quick ? "mesh" : "mesh,cloud");
  const std::vector<std::string> protocols = arguments.list("protocols", "mixed");
  Trials trials(arguments.text("csv", is_quick ? "" : "registration.csv")); // a test repeats all of them

  std::set<Trial_id> asked;
  for(std::size_t head = 0; head < heads; ++head)
  {
    Head model;
    const auto load = [&]
    {
      if(model.name.empty())
        model = read_head(files[head], both_faces, seed, arguments.text("cache", "registration_cache"));
    };
    for(const std::string& surface : surfaces)
    {
      Scan first, second;
      for(const std::string& protocol_name : protocols)
      {
        const Split_protocol protocol = parse_protocol(protocol_name);
        for(std::size_t number = 0; number < per_head; ++number)
        {
          Split parts;
          for(const std::uint64_t neighbors : sizes)
            for(const std::string& variant : chosen)
            {
              const Trial_id id{surface, protocol_name, variant, std::size_t(neighbors), head, number};
              asked.insert(id);
              if(trials.contains(id))
                continue;
              load();
              if(first.points.empty())
              {
                // of point sets, as many points as the meshes have vertices
                first = surface == "mesh" ? model.first : poisson_disc_points(model.fine, faces[0] / 2, seed);
                second = surface == "mesh" ? model.second
                                           : poisson_disc_points(model.fine, faces[0] * 9 / 20, seed + 1);
              }
              if(parts.source.points.empty())
                parts = split(first, second, protocol, seed_of(seed, head, number));
              trials.add(id, run_variant(variant, parts, std::size_t(neighbors)));
            }
        }
        std::cerr << "head " << head + 1 << " of " << heads << ": " << surface << ", " << protocol_name
                  << " done\n";
      }
    }
  }

  const std::string report = markdown_report(trials, asked);
  std::cout << report;
  if(arguments.has("markdown"))
  {
    std::ofstream out(arguments.text("markdown", ""));
    out << report;
    if(!out)
      throw std::runtime_error("can't write " + arguments.text("markdown", ""));
  }
  if(arguments.has("plot") && !write_plot(arguments.text("plot", ""), trials, asked))
    std::cout << "No plot: built without the library of the examples\n";

  if(is_quick) // what a test can say of few trials: nothing wrong is called right, and something is right
  {
    std::size_t right = 0, wrong = 0;
    for(const Trial_id& id : asked)
    {
      const Trial_result& result = trials.results().at(id);
      if(result.verdict == to_string(Shape_characteristics::Registration_verdict::SUCCESS))
        ++(result.is_correct() ? right : wrong);
    }
    std::cout << right << " registered, " << wrong << " wrongly\n";
    return wrong == 0 && right > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    return run(Command_line(argc, argv,
                            {"heads", "trials", "models", "faces", "variants", "neighbors", "surfaces",
                             "protocols", "csv", "markdown", "plot", "cache", "seed"},
                            {"quick"}));
  }
  catch(const std::exception& e)
  {
    std::cerr << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
