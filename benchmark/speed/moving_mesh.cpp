// Time of curvatures of a mesh that moves: frames in which all vertices move, and updates after one vertex in a hundred
// has, next to each other or anywhere, compared to an estimate of the whole mesh.
//
//   build/benchmark/benchmark/benchmark_speed_moving_mesh --vertices 100000 --threads 2
//
// Each time is the least of several. All updates are compared with the whole, bit by bit.
#include "Command_line.h"
#include "Random.h"

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/curvature/Dynamic_curvatures.h>
#include <Shape_characteristics/curvature/Dynamic_rusinkiewicz_curvatures.h>
#include <Shape_characteristics/curvature/goldfeather_interrante_curvatures.h>
#include <Shape_characteristics/curvature/hildebrandt_polthier_curvatures.h>
#include <Shape_characteristics/curvature/hrbf_curvatures.h>
#include <Shape_characteristics/curvature/rusinkiewicz_curvatures.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iomanip>
#include <iostream>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace moving_mesh {

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Number_map = Mesh::Property_map<Vertex, double>;

Mesh torus(unsigned int around, unsigned int across)
{
  Mesh mesh;
  for(unsigned int i = 0; i < around; ++i)
    for(unsigned int j = 0; j < across; ++j)
    {
      const double u = 2. * CGAL_PI * i / around, v = 2. * CGAL_PI * j / across, r = 2. + std::cos(v);
      mesh.add_vertex(Kernel::Point_3(r * std::cos(u), r * std::sin(u), std::sin(v)));
    }
  const auto vertex = [=](unsigned int i, unsigned int j)
  { return Vertex((i % around) * across + j % across); };
  for(unsigned int i = 0; i < around; ++i)
    for(unsigned int j = 0; j < across; ++j)
    {
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  return mesh;
}

enum class Choice
{
  TOGETHER,
  ANYWHERE
};

// one vertex in a hundred
std::vector<Vertex> choose(const Mesh& mesh, Choice choice)
{
  const std::size_t count = mesh.number_of_vertices() / 100;
  std::vector<Vertex> vertices;
  if(choice == Choice::ANYWHERE)
  {
    benchmark_support::Random random(1);
    for(std::size_t k = 0; k < count; ++k)
      vertices.push_back(Vertex(
          static_cast<Mesh::size_type>(random.uniform(0., 1.) * double(mesh.number_of_vertices() - 1))));
    return vertices;
  }
  std::vector<std::pair<double, Vertex> > distances;
  const Kernel::Point_3 center = mesh.point(Vertex(0));
  for(const Vertex v : mesh.vertices())
    distances.emplace_back(CGAL::squared_distance(center, mesh.point(v)), v);
  std::nth_element(distances.begin(), distances.begin() + std::ptrdiff_t(count), distances.end());
  for(std::size_t k = 0; k < count; ++k)
    vertices.push_back(distances[k].second);
  return vertices;
}

void move(Mesh& mesh, const std::vector<Vertex>& vertices, double factor)
{
  for(const Vertex v : vertices)
    mesh.point(v) = CGAL::ORIGIN + factor * (mesh.point(v) - CGAL::ORIGIN);
}

template <typename Function>
double milliseconds(const Function& function)
{
  const auto start = std::chrono::steady_clock::now();
  function();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

struct Result
{
  bool is_exact = true;
};

// `whole` estimates to the map "v:whole"
template <typename Dynamic, typename Whole>
void measure(const std::string& name,
             Mesh& mesh,
             Dynamic& dynamic,
             const Whole& whole,
             const std::vector<Choice>& choices,
             int repetitions,
             Result& result)
{
  const Number_map a = mesh.add_property_map<Vertex, double>("v:updated").first,
                   b = mesh.add_property_map<Vertex, double>("v:whole").first;
  for(const Choice choice : choices)
  {
    const std::vector<Vertex> moved = choose(mesh, choice);
    double update = std::numeric_limits<double>::infinity(), all = update;
    for(int k = 0; k < repetitions; ++k)
    {
      move(mesh, moved, k % 2 == 0 ? 1.001 : 1. / 1.001);
      update = std::min(update, milliseconds([&] { dynamic.update(moved); }));
      all = std::min(all, milliseconds(whole));
      for(const Vertex v : mesh.vertices())
        result.is_exact = result.is_exact && a[v] == b[v];
    }
    std::cout << "| " << name << " | " << moved.size()
              << (choice == Choice::TOGETHER ? " together" : " anywhere") << " | "
              << dynamic.updated_vertices().size() << " | " << update << " | " << all << " | "
              << 100. * update / all << " % |\n";
  }
}

template <typename Estimator, typename Whole>
void measure_any(const std::string& name,
                 Mesh& mesh,
                 const Estimator& estimator,
                 const Whole& whole,
                 int repetitions,
                 Result& result)
{
  const auto updated =
      SC::parameters::vertex_mean_curvature_map(mesh.add_property_map<Vertex, double>("v:updated").first);
  const auto all =
      SC::parameters::vertex_mean_curvature_map(mesh.add_property_map<Vertex, double>("v:whole").first);
  SC::Dynamic_curvatures<Mesh, Estimator, std::decay_t<decltype(updated)> > dynamic(mesh, estimator, updated);
  measure(
      name, mesh, dynamic, [&] { whole(mesh, all); }, {Choice::TOGETHER}, repetitions, result);
}

int run(const benchmark_support::Command_line& arguments)
{
  const bool is_quick = arguments.has("quick");
  const auto number = double(arguments.number("vertices", is_quick ? 5000 : 100000, 1000));
  const int repetitions = is_quick ? 2 : 3;
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  arguments.number("threads", 2, 1));
#endif
  const auto across = static_cast<unsigned int>(std::sqrt(number / 2.));
  Mesh mesh = torus(2 * across, across);
  const auto updated =
      SC::parameters::vertex_mean_curvature_map(mesh.add_property_map<Vertex, double>("v:updated").first);
  const auto whole =
      SC::parameters::vertex_mean_curvature_map(mesh.add_property_map<Vertex, double>("v:whole").first);
  Result result;

  std::cout << std::setprecision(3) << mesh.number_of_vertices() << " vertices\n\n";
  SC::Dynamic_rusinkiewicz_curvatures<Mesh, std::decay_t<decltype(updated)> > fast(mesh, updated);
  const std::vector<Vertex> all(mesh.vertices().begin(), mesh.vertices().end());
  double frame = std::numeric_limits<double>::infinity(), scratch = frame;
  for(int k = 0; k < 2 * repetitions; ++k)
  {
    move(mesh, all, k % 2 == 0 ? 1.001 : 1. / 1.001);
    frame = std::min(frame, milliseconds([&] { fast.update(); }));
    scratch = std::min(scratch, milliseconds([&] { SC::rusinkiewicz_curvatures(mesh, whole); }));
  }
  std::cout << "Rusinkiewicz, all vertices move: " << frame << " ms a frame, " << 1000. / frame
            << " frames a second; from scratch " << scratch << " ms\n\n"
            << "| estimator | vertices moved | vertices estimated | update, ms | whole, ms | share |\n"
            << "|---|---|---|---|---|---|\n";
  measure(
      "Rusinkiewicz", mesh, fast, [&] { SC::rusinkiewicz_curvatures(mesh, whole); },
      {Choice::TOGETHER, Choice::ANYWHERE}, repetitions, result);
  measure_any(
      "Rusinkiewicz, as any", mesh,
      [](auto v, const auto& m, const auto& np) { return SC::rusinkiewicz_curvatures(v, m, np); },
      [](const auto& m, const auto& np) { SC::rusinkiewicz_curvatures(m, np); }, repetitions, result);
  measure_any(
      "Goldfeather-Interrante", mesh,
      [](auto v, const auto& m, const auto& np) { return SC::goldfeather_interrante_curvatures(v, m, np); },
      [](const auto& m, const auto& np) { SC::goldfeather_interrante_curvatures(m, np); }, repetitions,
      result);
  measure_any(
      "Hildebrandt-Polthier", mesh,
      [](auto v, const auto& m, const auto& np) { return SC::hildebrandt_polthier_curvatures(v, m, np); },
      [](const auto& m, const auto& np) { SC::hildebrandt_polthier_curvatures(m, np); }, repetitions, result);
  measure_any(
      "HRBF, exact normals", mesh,
      [](auto v, const auto& m, const auto& np)
      { return SC::hrbf_curvatures(v, m, np.normals_are_exact(true).fits_are_shared(false)); },
      [](const auto& m, const auto& np)
      { SC::hrbf_curvatures(m, np.normals_are_exact(true).fits_are_shared(false)); },
      repetitions, result);
  std::cout << (result.is_exact ? "\nAll bits are those of the whole.\n" : "\nNOT the bits of the whole.\n");
  return result.is_exact ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace moving_mesh

int main(int argc, char** argv)
{
  try
  {
    return moving_mesh::run(benchmark_support::Command_line(argc, argv, {"vertices", "threads"}, {"quick"}));
  }
  catch(const std::exception& e)
  {
    std::cerr << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
