// Time and memory of register_partial_scans() on scans of many points: parts of a head that overlap, as in
// benchmark_registration_registration, sampled at random.
//
//   build/benchmark/benchmark/benchmark_registration_large_scans --points 100000,1000000
//
// Memory is what the process has at its peak beyond what it had before the call, when the scans were there.
#include "Command_line.h"
#include "parts/heads.h"
#include "parts/splits.h"

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/internal/affine_conversions.h>
#include <Shape_characteristics/registration/Registration_verdict.h>
#include <Shape_characteristics/registration/register_partial_scans.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <sys/resource.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <iomanip>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace SC = Shape_characteristics;
using namespace registration;
using benchmark_support::Command_line;
using Kernel = CGAL::Simple_cartesian<double>;
using Point_and_normal = std::pair<Kernel::Point_3, Kernel::Vector_3>;

std::vector<Point_and_normal> as_range(const Scan& scan)
{
  std::vector<Point_and_normal> range;
  range.reserve(scan.points.size());
  for(std::size_t i = 0; i < scan.points.size(); ++i)
  {
    const Eigen::Vector3d &p = scan.points[i], &n = scan.normals[i];
    range.emplace_back(Kernel::Point_3(p.x(), p.y(), p.z()), Kernel::Vector_3(n.x(), n.y(), n.z()));
  }
  return range;
}

double peak_memory_in_bytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024. * double(usage.ru_maxrss); // Linux counts in kilobytes
}

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
    const std::vector<Point_and_normal> source = as_range(parts.source), target = as_range(parts.target);
    const double memory_before = peak_memory_in_bytes();
    const auto maps = SC::parameters::point_map(CGAL::First_of_pair_property_map<Point_and_normal>())
                          .normal_map(CGAL::Second_of_pair_property_map<Point_and_normal>());
    const std::clock_t start = std::clock(); // of the processor: others may be at work
    const SC::Registration_result<Kernel> found =
        SC::register_partial_scans<CGAL::Sequential_tag>(source, target, maps, maps);
    const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
    const double memory = peak_memory_in_bytes();

    const Eigen::Isometry3d motion(SC::internal::affine_to_eigen(found.transformation).matrix());
    const double error = registration_error(parts, motion);
    const bool is_registered = found.verdict == SC::Registration_verdict::SUCCESS;
    is_right = is_right && is_registered && error < .1;
    const double n = double(source.size() + target.size());
    std::cout << "| " << source.size() << " | " << target.size() << " | " << std::setprecision(4) << seconds
              << " | " << 1e6 * seconds / n << " | " << 1e-6 * memory << " | " << (memory - memory_before) / n
              << " | " << error << " | " << (is_registered ? "success" : "none") << " |" << std::endl;
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
