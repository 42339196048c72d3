// Time and memory of HRBF on a point set of millions: a torus with exact normals.
//
//   build/benchmark/benchmark/benchmark_speed_large_cloud --points 10000000 --threads 2
//
// Memory is what the process has at its peak beyond what it had before the call, when input and output were there.
#include "Command_line.h"
#include "Error_statistics.h"
#include "Random.h"
#include "peak_memory_in_bytes.h"

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/hrbf_curvatures.h>

#if __has_include(<support/Progress_bar.h>) // what the examples share, where its dependencies are found
#include <support/Progress_bar.h>
#define SHAPE_CHARACTERISTICS_LARGE_CLOUD_PROGRESS
#endif

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iomanip>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace large_cloud {

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;

struct Sample
{
  Kernel::Point_3 point;
  Kernel::Vector_3 normal;
  double k_min, k_max; // the results
};

// the places of all that in a sample; directions of curvature are not kept
struct Point_map
{
  using key_type = Sample;
  using value_type = Kernel::Point_3;
  using reference = const value_type&;
  using category = boost::readable_property_map_tag;

  friend reference get(const Point_map&, const Sample& sample) { return sample.point; }
};

struct Normal_map
{
  using key_type = Sample;
  using value_type = Kernel::Vector_3;
  using reference = const value_type&;
  using category = boost::readable_property_map_tag;

  friend reference get(const Normal_map&, const Sample& sample) { return sample.normal; }
};

struct Curvature_map
{
  using key_type = Sample;
  using value_type = SC::Principal_curvatures_and_directions<Kernel>;
  using reference = value_type;
  using category = boost::writable_property_map_tag;

  friend void put(const Curvature_map&, Sample& sample, const value_type& curvatures)
  {
    sample.k_min = curvatures.min_curvature;
    sample.k_max = curvatures.max_curvature;
  }
};

// radii of the torus: of the circle in its middle, and of the tube
constexpr double radius = 1., tube = .4;

// Points spread evenly over the area.
std::vector<Sample> sample_torus(std::size_t points, std::uint64_t seed)
{
  constexpr double turn = 6.283185307179586476925;
  benchmark_support::Random random(seed);
  std::vector<Sample> samples;
  samples.reserve(points);
  while(samples.size() < points)
  {
    const double u = random.uniform(0., turn), v = random.uniform(0., turn);
    if(random.uniform(0., radius + tube) > radius + tube * std::cos(v)) // the inner side has less area
      continue;
    const Kernel::Vector_3 normal(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
    const Kernel::Vector_3 middle(radius * std::cos(u), radius * std::sin(u), 0.);
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    samples.push_back({CGAL::ORIGIN + (middle + tube * normal), normal, nothing, nothing});
  }
  return samples;
}

double exact_k_min(const Sample& s)
{
  const double from_axis = std::hypot(s.point.x(), s.point.y());
  return (from_axis - radius) / tube / from_axis; // cos(v) / (radius + tube cos(v))
}

std::function<bool(double)> progress_bar()
{
#ifdef SHAPE_CHARACTERISTICS_LARGE_CLOUD_PROGRESS
  return support::Progress_bar("HRBF");
#else
  return [](double) { return true; };
#endif
}

std::size_t estimate(std::vector<Sample>& samples, unsigned int neighbours, unsigned int threads)
{
  const auto parameters = SC::parameters::point_map(Point_map())
                              .normal_map(Normal_map())
                              .principal_curvatures_and_directions_map(Curvature_map())
                              .number_of_neighbors(neighbours)
                              .normals_are_exact(true)
                              .callback(progress_bar());
  if(threads == 1)
    return SC::hrbf_curvatures<CGAL::Sequential_tag>(samples, parameters);
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
#endif
  return SC::hrbf_curvatures(samples, parameters);
}

const char* const help =
    "Time and memory of HRBF on a point set of millions: a torus with exact normals.\n\n"
    "  --points N       (10000000)\n"
    "  --neighbours N   nearest points in a neighbourhood (18)\n"
    "  --threads N      (2)\n"
    "  --seed N         seed of the random points (1)\n"
    "  --check          fails if a point isn't estimated, or if the mean error is above a hundredth\n"
    "  --help           this text\n";

int run(int argc, char** argv)
{
  const benchmark_support::Command_line arguments(argc, argv, {"points", "neighbours", "threads", "seed"},
                                                  {"check", "help"});
  if(arguments.has("help"))
  {
    std::cout << help;
    return 0;
  }
  const std::size_t points = arguments.number("points", 10000000, 100);
  const unsigned int neighbours = unsigned(arguments.number("neighbours", 18, 5));
  const unsigned int threads = unsigned(arguments.number("threads", 2, 1));

  std::vector<Sample> samples = sample_torus(points, arguments.number("seed", 1));
  const double memory_before = benchmark_support::peak_memory_in_bytes();
  const auto start = std::chrono::steady_clock::now();
  const std::size_t not_estimated = estimate(samples, neighbours, threads);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const double memory = benchmark_support::peak_memory_in_bytes();

  benchmark_support::Error_statistics errors;
  for(const Sample& s : samples)
    errors.add(s.k_max - 1. / tube, s.k_min - exact_k_min(s));

  const double n = double(points);
  std::cout << "| points | neighbours | threads | seconds | µs/point | peak memory, MB | bytes/point beyond "
               "input and "
               "output | MAE | median | not estimated |\n"
            << "|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n"
            << "| " << points << " | " << neighbours << " | " << threads << " | " << std::setprecision(4)
            << seconds << " | " << 1e6 * seconds / n << " | " << 1e-6 * memory << " | "
            << (memory - memory_before) / n << " | " << std::setprecision(3) << errors.mae() << " | "
            << errors.median() << " | " << not_estimated << " |\n";
  const bool is_right = not_estimated == 0 && errors.mae() < .01;
  return arguments.has("check") && !is_right ? 1 : 0;
}

} // namespace large_cloud

int main(int argc, char** argv)
{
  try
  {
    return large_cloud::run(argc, argv);
  }
  catch(const std::invalid_argument& error)
  {
    std::cerr << error.what() << "\n\n" << large_cloud::help;
    return 2;
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
