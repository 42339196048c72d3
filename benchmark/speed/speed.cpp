// Speed of the curvature estimators, next to peers and to what the processor can do.
//
//   cmake --preset benchmark && cmake --build build/benchmark        for this machine's processor
//   build/benchmark/benchmark/benchmark_speed_speed --markdown speed.md --csv speed.csv --plot speed_plots
//
// The preset `benchmark-O2` builds the same with -O2 for any processor, in build/benchmark-O2. `--help` tells the
// options. The lines of Google Benchmark go to the error stream, the tables to the standard output; arguments that
// begin with --benchmark_ are Google Benchmark's (--benchmark_filter, say).
//
// A whole run takes about ten minutes, and needs some 5 GB of memory for the surfaces of up to 3 million vertices.
// Nothing else should run meanwhile, yet a little does no harm to what runs on one thread: of all repetitions the
// quickest one counts, in time of the processor, and the repetitions of what is compared are shuffled.
//
// The parts, which `--parts` selects:
//   peak         what one core computes at most, and the speed of the factorizations in HRBF
//   comparison   all estimators and peers on 10000 points of f1e, as in the tables of benchmark/accuracy
//   surfaces     HRBF with exact normals on surfaces that are harder
//   cost         time against the number of rings, and against the size of the neighbourhood
//   sizes        time against the number of vertices, with one thread and with several
//
// Peers: CGAL::Monge_via_jet_fitting on the neighbourhoods of our estimators (searched within the time, or given), and
// pcl::PrincipalCurvaturesEstimation where CMake finds PCL.
#include "Command_line.h"
#include "parts/Session.h"
#include "parts/cgal_jets.h"
#include "parts/estimators.h"
#include "parts/factorizations.h"
#include "parts/goals.h"
#include "parts/pcl_curvatures.h"
#include "parts/peak.h"
#include "parts/plain_thesis.h"
#include "parts/report.h"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace speed {

struct Options
{
  std::vector<std::string> parts;
  std::size_t points, grid;
  std::vector<std::uint64_t> sizes;
  std::uint64_t seed;
  unsigned int threads;
  int repetitions;
  bool quick, full;

  bool has(const std::string& part) const
  {
    return std::find(parts.begin(), parts.end(), part) != parts.end();
  }
};

const std::string all_parts = "peak,comparison,surfaces,cost,sizes";

void add(Session& session,
         const std::string& group,
         const Estimator& e,
         const std::shared_ptr<Workload>& workload,
         const std::string& surface,
         Order order,
         unsigned int threads,
         double size = nan_value)
{
  Figure figure;
  figure.group = group;
  figure.estimator = e.name;
  figure.neighbourhood = e.neighbourhood;
  figure.surface = surface;
  figure.order = to_string(order);
  figure.threads = threads;
  figure.size = size;
  session.add(figure, workload, [run = e.run, threads](Workload& w) { run(w, threads); });
}

// Results that are used can't be left out.
void use(const std::vector<double>& results)
{
  static volatile double sink = 0.;
  for(const double x : results)
    sink = sink + x;
}

void measure_peak(Session& session, const Options& options)
{
  const std::size_t steps = options.quick ? 10000 : 1000000;
  for(const Arithmetic_peak& peak : arithmetic_peaks())
  {
    Figure figure;
    figure.group = "peak";
    figure.estimator = "registers, " + peak.name;
    figure.operations = double(steps) * double(peak.operations_per_step);
    session.add(figure, {}, [peak, steps] { use({peak.run(steps)}); });
  }
  const auto product = std::make_shared<Matrix_product>(512);
  Figure figure;
  figure.group = "peak";
  figure.estimator = "Eigen's matrix product";
  figure.neighbourhood = "512 x 512";
  figure.operations = product->operations();
  session.add(figure, {}, [product] { use({product->run()}); });

  const double enough_operations = options.quick ? 1. : 2e6; // for a clock that is read once a run
  for(const Factorization& f : factorizations(enough_operations))
  {
    Figure of_factorization;
    of_factorization.group = "factorization";
    of_factorization.estimator = f.name;
    of_factorization.neighbourhood = std::to_string(f.equations) + " equations";
    of_factorization.operations = f.operations;
    session.add(of_factorization, f.prepare,
                [f]
                {
                  if(!f.run())
                    throw std::runtime_error(f.name + " failed");
                });
  }
  session.run(options.repetitions);
}

void compare(Session& session, const Options& options)
{
  const auto workload = std::make_shared<Workload>("f1e", options.points, options.seed, Order::RANDOM);
  for(const Estimator& e : estimators())
  {
    const bool is_ring = e.neighbourhood.find("ring") != std::string::npos;
    add(session, "comparison", e, workload, "f1e", Order::RANDOM, 1,
        is_ring ? mean_size_of_rings(*workload, unsigned(std::stoul(e.neighbourhood)))
                : std::stod(e.neighbourhood));
  }

  Figure peer;
  peer.group = "comparison";
  peer.surface = "f1e";
  peer.order = to_string(Order::RANDOM);
  peer.estimator = "CGAL jet d=4";
  for(unsigned int rings : {2u, 3u})
  {
    const auto given = std::make_shared<Neighbourhoods>(gather_neighbourhoods(*workload, rings));
    peer.size = double(given->points.size()) / double(workload->size());
    peer.neighbourhood = std::to_string(rings) + " rings given";
    session.add(peer, workload, [given](Workload& w) { cgal_jets(w, *given); });
    peer.neighbourhood = std::to_string(rings) + " rings";
    session.add(peer, workload, [rings](Workload& w) { cgal_jets(w, rings); });
  }
  peer.estimator = "HRBF of the thesis, plain";
  peer.neighbourhood = "2 rings";
  peer.size = mean_size_of_rings(*workload, 2);
  session.add(peer, workload, [](Workload& w) { plain_thesis(w, 2); });
  constexpr unsigned int nearest = 18;
  if(const auto pcl = pcl_principal_curvatures(*workload, nearest))
  {
    peer.estimator = "PCL, exact normals";
    peer.neighbourhood = std::to_string(nearest) + " nearest";
    peer.size = nearest;
    peer.has_errors = false;
    session.add(peer, workload, [pcl](Workload&) { pcl(); });
  }
  session.run(options.repetitions);
}

void measure_surfaces(Session& session, const Options& options)
{
  for(const std::string surface : {"f2e", "f4e", "f1i"})
  {
    const bool is_explicit = surface.back() == 'e';
    const auto workload = std::make_shared<Workload>(surface, is_explicit ? options.points : options.grid,
                                                     options.seed, Order::RANDOM);
    add(session, "surfaces", hrbf_exact(2), workload, surface, Order::RANDOM, 1);
  }
  session.run(std::min(options.repetitions, 3));
}

void measure_costs(Session& session, const Options& options)
{
  const auto workload = std::make_shared<Workload>("f1e", options.points, options.seed, Order::RANDOM);
  const auto add_rings = [&](const Estimator& e, unsigned int rings)
  { add(session, "rings", e, workload, "f1e", Order::RANDOM, 1, mean_size_of_rings(*workload, rings)); };
  for(unsigned int rings : {1u, 2u, 3u, 4u})
    if(rings < 4 || !options.quick)
      add_rings(hrbf_exact(rings), rings);
  for(unsigned int rings : {1u, 2u, 3u, 4u})
    if(rings < (options.quick ? 3 : (options.full ? 5 : 4)))
      add_rings(thesis_path(rings), rings);
  for(unsigned int rings : {2u, 3u, 4u}) // one ring has not the points for degree 4
    if(rings < 4 || options.full)
      add_rings(jet(4, rings), rings);
  for(unsigned int nearest : {6u, 9u, 12u, 18u, 27u, 40u, 60u})
    if(nearest < 20 || !options.quick)
      add(session, "nearest", hrbf_exact_nearest(nearest), workload, "f1e", Order::RANDOM, 1, nearest);
  session.run(std::min(options.repetitions, 3));
}

// What the machine itself gains by more threads at this time: virtual processors, and whatever else is running, may
// leave less than there should be. Every thread computes in its registers.
void measure_threads(Session& session, const Options& options)
{
  const Arithmetic_peak peak = arithmetic_peaks().back();
  const std::size_t steps = options.quick ? 100000 : 20000000;
  for(const unsigned int threads : {1u, options.threads})
  {
    Figure figure;
    figure.group = "threads";
    figure.estimator = "registers, " + peak.name;
    figure.neighbourhood = std::to_string(threads) + (threads == 1 ? " thread" : " threads");
    figure.threads = threads;
    figure.operations = double(threads) * double(steps) * double(peak.operations_per_step);
    session.add(figure, {},
                [peak, steps, threads]
                {
                  std::vector<double> results(threads);
                  std::vector<std::thread> others;
                  for(std::size_t i = 1; i < threads; ++i)
                    others.emplace_back([&result = results[i], peak, steps] { result = peak.run(steps); });
                  results[0] = peak.run(steps);
                  for(std::thread& thread : others)
                    thread.join();
                  use(results);
                });
  }
}

// All sizes are there at once, so that their repetitions are shuffled, too. What there is a goal for comes by itself: while others
// run, free memory goes back to where it may be slow to come from, as the host of a virtual machine.
void measure_sizes(Session& session, const Options& options)
{
  const std::size_t most_for_slow_ones = options.full    ? std::numeric_limits<std::size_t>::max()
                                         : options.quick ? 0
                                                         : 100000;
  const int repetitions = std::min(options.repetitions, 3);
  std::vector<std::shared_ptr<Workload> > workloads;
  for(const std::size_t points : options.sizes)
    workloads.push_back(std::make_shared<Workload>("f1e", points, options.seed, Order::CURVE));
  const std::string label_with_goal = hrbf_exact(2).label();
  for(const bool has_goal : {true, false})
  {
    for(const std::shared_ptr<Workload>& workload : workloads)
      for(const Estimator& e : estimators())
        for(const unsigned int threads : {1u, options.threads})
          if((e.label() == label_with_goal) == has_goal &&
             (!e.is_slow || workload->size() <= most_for_slow_ones))
            add(session, "sizes", e, workload, "f1e", Order::CURVE, threads);
    if(has_goal)
      measure_threads(session, options);
    session.run(repetitions);
  }

  for(const std::size_t points : options.sizes)
  {
    const auto workload = std::make_shared<Workload>("f1e", points, options.seed, Order::RANDOM);
    // one that searches and computes much, and one that does little of either
    for(const Estimator& e : {hrbf_exact(2), estimator("Rusinkiewicz, 1 ring")})
      add(session, "sizes", e, workload, "f1e", Order::RANDOM, 1);
  }
  session.run(repetitions);
}

/// Whether all figures are there, and in an order that holds on each machine.
bool check(const Session& session)
{
  bool all_hold = true;
  for(const Figure& f : session.figures())
    if(!f.is_complete())
    {
      std::cerr << "no figures: " << f.group << ", " << f.label() << ", " << f.vertices << " vertices\n";
      all_hold = false;
    }
  const auto is_faster = [&](const std::string& fast, const std::string& slow)
  {
    const Figure *f = session.find("comparison", fast), *s = session.find("comparison", slow);
    const bool holds = f != nullptr && s != nullptr && f->seconds < s->seconds;
    if(!holds)
      std::cerr << fast << " isn't faster than " << slow << "\n";
    return holds;
  };
  for(const std::string slow : {"HRBF of the thesis, r^5, 2 rings", "CGAL jet d=4, 2 rings given"})
    for(const std::string fast :
        {"HRBF, exact normals, 2 rings", "Rusinkiewicz, 1 ring", "tangent space, 1 ring"})
      all_hold = is_faster(fast, slow) && all_hold;
  return all_hold;
}

const char* const help =
    "Speed of the curvature estimators, next to peers and to what the processor can do.\n\n"
    "  --parts A,B,...   of peak, comparison, surfaces, cost, sizes (all)\n"
    "  --points N        vertices of the comparison (10000)\n"
    "  --grid N          samples per axis of marching cubes for f1i (128)\n"
    "  --sizes N,M,...   numbers of vertices of the sizes (35000,300000,3000000)\n"
    "  --seed N          seed of the random points (1)\n"
    "  --threads N       what the sizes are run with besides one thread (2)\n"
    "  --repetitions N   of the comparison; surfaces, cost and sizes have 3 at most (5)\n"
    "  --full            slow estimators on large sizes and with 4 rings, too: this takes hours\n"
    "  --quick           small sizes, once each, and slow estimators in the comparison only; fails if a\n"
    "                    figure is missing, or if HRBF isn't faster than its peers\n"
    "  --csv FILE        writes all figures to FILE\n"
    "  --markdown FILE   writes the tables to FILE (standard output)\n"
    "  --plot FOLDER     draws plots in FOLDER\n"
    "  --help            this text\n"
    "  --benchmark_...   options of Google Benchmark\n";

void check_file(const std::ostream& out, const std::string& name)
{
  if(!out)
    throw std::runtime_error("cannot write " + name);
}

int run(int argc, char** argv)
{
  Session session(argc, argv);
  const benchmark_support::Command_line arguments(
      argc, argv,
      {"parts", "points", "grid", "sizes", "seed", "threads", "repetitions", "csv", "markdown", "plot"},
      {"quick", "full", "help"});
  if(arguments.has("help"))
  {
    std::cout << help;
    return 0;
  }
  Options options;
  options.quick = arguments.has("quick");
  options.full = arguments.has("full");
  options.parts = arguments.list("parts", all_parts);
  options.points = arguments.number("points", options.quick ? 1000 : 10000, 100);
  options.grid = arguments.number("grid", options.quick ? 24 : 128, 2);
  options.sizes = arguments.numbers("sizes", options.quick ? "1000,3000" : "35000,300000,3000000");
  if(options.sizes.empty() || *std::min_element(options.sizes.begin(), options.sizes.end()) < 100)
    throw std::invalid_argument("--sizes: of 100 vertices at least");
  options.seed = arguments.number("seed", 1);
  options.threads = unsigned(arguments.number("threads", 2, 2));
  options.repetitions = int(arguments.number("repetitions", options.quick ? 1 : 5, 1));
  for(const std::string& part : options.parts)
    if(("," + all_parts + ",").find("," + part + ",") == std::string::npos)
      throw std::invalid_argument("--parts: no part " + part);
  if(arguments.has("plot") && !has_plots())
    throw std::invalid_argument("--plot: built without the support for plots");
  // files that can't be written are better known before the long run
  std::ofstream csv, markdown;
  if(arguments.has("csv"))
  {
    csv.open(arguments.text("csv", ""));
    check_file(csv, arguments.text("csv", ""));
  }
  if(arguments.has("markdown"))
  {
    markdown.open(arguments.text("markdown", ""));
    check_file(markdown, arguments.text("markdown", ""));
  }
  if(options.quick)
    session.set_shortest_time(0.);

  if(options.has("peak"))
    measure_peak(session, options);
  if(options.has("comparison"))
    compare(session, options);
  if(options.has("surfaces"))
    measure_surfaces(session, options);
  if(options.has("cost"))
    measure_costs(session, options);
  if(options.has("sizes"))
    measure_sizes(session, options);

  write_markdown(session, markdown.is_open() ? static_cast<std::ostream&>(markdown) : std::cout);
  if(csv.is_open())
    write_csv(session, csv);
  if(arguments.has("plot"))
    draw_plots(session, arguments.text("plot", ""));
  return options.quick && !check(session) ? 1 : 0;
}

} // namespace speed

int main(int argc, char** argv)
{
  try
  {
    return speed::run(argc, argv);
  }
  catch(const std::invalid_argument& error)
  {
    std::cerr << error.what() << "\n\n" << speed::help;
    return 2;
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
