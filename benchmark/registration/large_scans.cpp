// Time and memory of register_partial_scans() on scans of many points: parts of a head that overlap, as in
// benchmark_registration_registration, sampled at random.
//
//   build/benchmark/benchmark/benchmark_registration_large_scans --points 100000,1000000
//
// Memory is what the process has at its peak beyond what it had before the call, when the scans were there.
#include "Command_line.h"
#include "parts/heads.h"
#include "parts/register_scans.h"
#include "parts/splits.h"
#include "peak_memory_in_bytes.h"

#include <Shape_characteristics/registration/Registration_verdict.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

namespace {

namespace SC = Shape_characteristics;
using namespace registration;
using benchmark_support::Command_line;

int run(const Command_line& arguments)
{
  std::string comment;
  const std::vector<std::string> files = head_files(arguments.text("heads", ""), comment);
  std::cout << comment << "\n\n";
  if(files.empty())
    return EXIT_SUCCESS;
  const std::uint64_t seed = arguments.number("seed", 1);
  const Head head =
      read_head(files.front(), {20000, 18000}, seed, arguments.text("cache", "registration_cache"));

  std::cout << "| points of the source | of the target | seconds | µs/point | peak memory, MB | bytes/point "
               "beyond the scans "
               "| error | verdict |\n|---:|---:|---:|---:|---:|---:|---:|---|\n";
  bool is_right = true;
  // memory at its peak never falls: from few points to many
  for(const std::uint64_t points : arguments.numbers("points", "30000,100000,300000,1000000"))
  {
    const Split parts = split(random_points(head.fine, points * 3 / 2, seed),
                              random_points(head.fine, points * 3 / 2, seed + 1), Split_protocol(), seed);
    const Point_range source = to_range(parts.source), target = to_range(parts.target);
    const double memory_before = benchmark_support::peak_memory_in_bytes();
    const std::clock_t start = std::clock(); // of the processor: others may be at work
    const Registration_result found = register_scans(source, target);
    const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
    const double memory = benchmark_support::peak_memory_in_bytes();

    const double error = registration_error(parts, motion(found));
    is_right = is_right && found.verdict == SC::Registration_verdict::SUCCESS && error < .1;
    const double n = double(source.size() + target.size());
    std::cout << "| " << source.size() << " | " << target.size() << " | " << std::setprecision(4) << seconds
              << " | " << 1e6 * seconds / n << " | " << 1e-6 * memory << " | " << (memory - memory_before) / n
              << " | " << error << " | " << to_string(found.verdict) << " |" << std::endl;
  }
  return arguments.has("check") && !is_right ? EXIT_FAILURE : EXIT_SUCCESS;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    return run(Command_line(argc, argv, {"heads", "points", "cache", "seed"}, {"check"}));
  }
  catch(const std::exception& e)
  {
    std::cerr << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
