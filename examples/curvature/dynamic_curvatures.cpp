// Curvatures of a mesh that is deformed: frame by frame, and where a brush has touched it.
#include <Shape_characteristics/curvature/Dynamic_curvatures.h>
#include <Shape_characteristics/curvature/Dynamic_rusinkiewicz_curvatures.h>
#include <Shape_characteristics/curvature/jet_fitting_curvatures.h>
#include <Shape_characteristics/curvature/rusinkiewicz_curvatures.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <type_traits>
#include <vector>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Number_map = Mesh::Property_map<Vertex, double>;

namespace {

const unsigned int side = 150;

Mesh sheet()
{
  Mesh mesh;
  for(unsigned int i = 0; i < side; ++i)
    for(unsigned int j = 0; j < side; ++j)
      mesh.add_vertex(Kernel::Point_3(double(i) / side, double(j) / side, 0.));
  const auto vertex = [](unsigned int i, unsigned int j) { return Vertex(i * side + j); };
  for(unsigned int i = 0; i + 1 < side; ++i)
    for(unsigned int j = 0; j + 1 < side; ++j)
    {
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  return mesh;
}

// a wave that travels through the sheet
void wave(Mesh& mesh, double time)
{
  for(const Vertex v : mesh.vertices())
  {
    const Kernel::Point_3 p = mesh.point(v);
    mesh.point(v) = Kernel::Point_3(p.x(), p.y(), .05 * std::sin(6. * (p.x() + .3 * p.y() - time)));
  }
}

// lifts the vertices in a disk of about a hundredth of the sheet, and returns them
std::vector<Vertex> brush(Mesh& mesh, double x, double y)
{
  std::vector<Vertex> moved;
  for(const Vertex v : mesh.vertices())
  {
    const Kernel::Point_3 p = mesh.point(v);
    const double square = (std::pow(p.x() - x, 2) + std::pow(p.y() - y, 2)) / (.056 * .056);
    if(square >= 1.)
      continue;
    mesh.point(v) = Kernel::Point_3(p.x(), p.y(), p.z() + .01 * std::pow(1. - square, 3));
    moved.push_back(v);
  }
  return moved;
}

template <typename Function>
double milliseconds(const Function& function)
{
  const auto start = std::chrono::steady_clock::now();
  function();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

bool are_equal(const Mesh& mesh, const Number_map& a, const Number_map& b)
{
  return std::all_of(mesh.vertices().begin(), mesh.vertices().end(),
                     [&](const Vertex v) { return a[v] == b[v]; });
}

} // namespace

int main()
{
  Mesh mesh = sheet();
  const Number_map updated = mesh.add_property_map<Vertex, double>("v:updated").first,
                   whole = mesh.add_property_map<Vertex, double>("v:whole").first;
  const auto outputs = SC::parameters::vertex_mean_curvature_map(updated);
  const auto outputs_of_whole = SC::parameters::vertex_mean_curvature_map(whole);
  using Outputs = std::decay_t<decltype(outputs)>;
  bool is_exact = true;

  SC::Dynamic_rusinkiewicz_curvatures<Mesh, Outputs> frames(mesh, outputs);
  double frame = 0., again = 0.;
  const int number_of_frames = 20;
  for(int i = 0; i < number_of_frames; ++i)
  {
    wave(mesh, .02 * i);
    frame += milliseconds([&] { frames.update(); }) / number_of_frames;
    again += milliseconds([&] { SC::rusinkiewicz_curvatures(mesh, outputs_of_whole); }) / number_of_frames;
    is_exact = is_exact && are_equal(mesh, updated, whole);
  }
  std::cout << mesh.number_of_vertices() << " vertices\n"
            << "Rusinkiewicz, a frame: " << frame << " ms (" << 1000. / frame
            << " frames a second); from scratch " << again << " ms\n";

  std::vector<Vertex> moved = brush(mesh, .5, .5);
  const double touch = milliseconds([&] { frames.update(moved); });
  again = milliseconds([&] { SC::rusinkiewicz_curvatures(mesh, outputs_of_whole); });
  is_exact = is_exact && are_equal(mesh, updated, whole);
  std::cout << "Rusinkiewicz, " << moved.size() << " vertices moved: " << touch << " ms for "
            << frames.updated_vertices().size() << " vertices; from scratch " << again << " ms\n";

  // any estimator of a vertex
  const auto jets = [](auto v, const auto& m, const auto& np)
  { return SC::jet_fitting_curvatures(v, m, np.degree_fitting(2)); };
  SC::Dynamic_curvatures<Mesh, std::decay_t<decltype(jets)>, Outputs> sculpture(mesh, jets, outputs);
  moved = brush(mesh, .3, .6);
  const double touch_of_jets = milliseconds([&] { sculpture.update(moved); });
  again = milliseconds([&] { SC::jet_fitting_curvatures(mesh, outputs_of_whole.degree_fitting(2)); });
  is_exact = is_exact && are_equal(mesh, updated, whole);
  std::cout << "jets, " << moved.size() << " vertices moved: " << touch_of_jets << " ms for "
            << sculpture.updated_vertices().size() << " vertices; from scratch " << again << " ms\n"
            << (is_exact ? "the same bits as from scratch" : "NOT the same as from scratch") << '\n';
  return is_exact ? EXIT_SUCCESS : EXIT_FAILURE;
}
