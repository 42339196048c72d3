#include <boost/test/unit_test.hpp>

#include "estimator_checks.h"

#include <Shape_characteristics/curvature/Dynamic_curvatures.h>
#include <Shape_characteristics/curvature/Dynamic_rusinkiewicz_curvatures.h>
#include <Shape_characteristics/curvature/goldfeather_interrante_curvatures.h>
#include <Shape_characteristics/curvature/hildebrandt_polthier_curvatures.h>
#include <Shape_characteristics/curvature/hrbf_curvatures.h>
#include <Shape_characteristics/curvature/integral_invariant_curvatures.h>
#include <Shape_characteristics/curvature/jet_fitting_curvatures.h>
#include <Shape_characteristics/curvature/meyer_curvatures.h>
#include <Shape_characteristics/curvature/rusinkiewicz_curvatures.h>

#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(dynamic_curvatures)

using namespace estimator_checks;

namespace {

using Vertex = Surface_mesh::Vertex_index;
using S = SC::Estimation_status;

// the maps of a mesh, by name
struct Maps
{
  Surface_mesh::Property_map<Vertex, Curvatures> curvatures;
  Surface_mesh::Property_map<Vertex, double> mean, Gaussian;
  Surface_mesh::Property_map<Vertex, S> status;

  Maps(Surface_mesh& mesh, const std::string& name)
    : curvatures(mesh.add_property_map<Vertex, Curvatures>("v:curvatures" + name).first),
      mean(mesh.add_property_map<Vertex, double>("v:mean" + name).first),
      Gaussian(mesh.add_property_map<Vertex, double>("v:Gaussian" + name).first),
      status(mesh.add_property_map<Vertex, S>("v:status" + name, S::CANCELLED).first)
  {}

  auto parameters() const
  {
    return SC::parameters::vertex_principal_curvatures_and_directions_map(curvatures)
        .vertex_mean_curvature_map(mean)
        .vertex_Gaussian_curvature_map(Gaussian)
        .vertex_status_map(status);
  }
};

// the first vertex where two differ; the number of vertices if there is none
std::size_t first_difference(const Surface_mesh& mesh, const Maps& a, const Maps& b)
{
  for(const Vertex v : mesh.vertices())
    if(!same_bits(a.curvatures[v], b.curvatures[v]) || !same_bits(a.mean[v], b.mean[v]) ||
       !same_bits(a.Gaussian[v], b.Gaussian[v]) || a.status[v] != b.status[v])
      return v.idx();
  return mesh.number_of_vertices();
}

Kernel::Point_3 displaced(const Kernel::Point_3& p, double size, std::mt19937& random)
{
  std::uniform_real_distribution<double> number(-size, size);
  const double x = number(random), y = number(random), z = number(random);
  return {p.x() + x, p.y() + y, p.z() + z};
}

std::vector<Analytic_surface> surfaces()
{
  return {test_support::torus(1., .4, 24, 12, .2, 6), test_support::monkey_saddle(.5, 10, .2, 7)};
}

// Moves vertices many times, few or many, a little or out of all proportion, and compares with an estimate of the whole.
template <typename Dynamic, typename Full>
void check_updates(Surface_mesh& mesh, Dynamic& dynamic, const Maps& updated, const Full& full, double edge)
{
  std::mt19937 random(5);
  Maps whole(mesh, " of the whole");
  BOOST_TEST(full(whole) == dynamic.updated_vertices().size() - (mesh.number_of_vertices() - full(whole)));
  BOOST_TEST_REQUIRE(first_difference(mesh, updated, whole) == mesh.number_of_vertices());
  for(int step = 0; step < 8; ++step)
  {
    std::vector<Vertex> moved;
    const std::size_t number = step % 3 == 2 ? 20 : 2;
    for(std::size_t k = 0; k < number; ++k)
    {
      const Vertex v(static_cast<unsigned>(random() % mesh.number_of_vertices()));
      moved.push_back(v);
      const Kernel::Point_3 p = mesh.point(v);
      mesh.point(v) = step == 3   ? Kernel::Point_3(std::numeric_limits<double>::quiet_NaN(), 0., 0.)
                      : step == 4 ? mesh.point(Vertex(static_cast<unsigned>(random() % 50)))
                                  : displaced(std::isnan(p.x()) ? Kernel::Point_3(0., 0., 0.) : p,
                                              step == 5 ? 3. : .3 * edge, random);
    }
    moved.push_back(moved.front()); // twice
    const std::size_t failures = dynamic.update(moved);
    BOOST_TEST(failures == full(whole));
    BOOST_TEST(dynamic.updated_vertices().size() < mesh.number_of_vertices() + 1);
    const std::size_t difference = first_difference(mesh, updated, whole);
    BOOST_TEST(difference == mesh.number_of_vertices(), "step " << step << ": vertex " << difference);
  }
  BOOST_TEST(dynamic.update(std::vector<Vertex>()) == full(whole));
  BOOST_TEST(dynamic.updated_vertices().empty());
  BOOST_CHECK_THROW(dynamic.update(std::vector<Vertex>{Vertex(1u << 30)}), std::invalid_argument);
}

template <typename Estimator, typename Full>
void check_estimator(const Estimator& estimator, const Full& full)
{
  for(const Analytic_surface& s : surfaces())
    BOOST_TEST_CONTEXT(s.name)
    {
      Surface_mesh mesh = surface_mesh_of(s);
      Maps maps(mesh, "");
      const auto np = maps.parameters();
      SC::Dynamic_curvatures<Surface_mesh, Estimator, std::decay_t<decltype(np)> > dynamic(mesh, estimator,
                                                                                           np);
      check_updates(
          mesh, dynamic, maps, [&](const Maps& m) { return full(mesh, m.parameters()); },
          s.mean_edge_length());
    }
}

} // namespace

BOOST_AUTO_TEST_CASE(any_estimator)
{
  BOOST_TEST_MESSAGE("meyer");
  check_estimator([](auto v, const auto& mesh, const auto& np) { return SC::meyer_curvatures(v, mesh, np); },
                  [](const auto& mesh, const auto& np) { return SC::meyer_curvatures(mesh, np); });
  BOOST_TEST_MESSAGE("Goldfeather-Interrante");
  check_estimator([](auto v, const auto& mesh, const auto& np)
                  { return SC::goldfeather_interrante_curvatures(v, mesh, np); },
                  [](const auto& mesh, const auto& np)
                  { return SC::goldfeather_interrante_curvatures(mesh, np); });
  BOOST_TEST_MESSAGE("jets");
  check_estimator([](auto v, const auto& mesh, const auto& np)
                  { return SC::jet_fitting_curvatures(v, mesh, np.degree_fitting(2)); },
                  [](const auto& mesh, const auto& np)
                  { return SC::jet_fitting_curvatures(mesh, np.degree_fitting(2)); });
}

// the radius of the ball follows from the edges
BOOST_AUTO_TEST_CASE(balls)
{
  check_estimator([](auto v, const auto& mesh, const auto& np)
                  { return SC::hildebrandt_polthier_curvatures(v, mesh, np.number_of_rings(3)); },
                  [](const auto& mesh, const auto& np)
                  { return SC::hildebrandt_polthier_curvatures(mesh, np.number_of_rings(3)); });
  check_estimator([](auto v, const auto& mesh, const auto& np)
                  { return SC::integral_invariant_curvatures(v, mesh, np.neighbor_radius(.2)); },
                  [](const auto& mesh, const auto& np)
                  { return SC::integral_invariant_curvatures(mesh, np.neighbor_radius(.2)); });
}

BOOST_AUTO_TEST_CASE(hrbf)
{
  check_estimator([](auto v, const auto& mesh, const auto& np)
                  { return SC::hrbf_curvatures(v, mesh, np.normals_are_exact(true).fits_are_shared(false)); },
                  [](const auto& mesh, const auto& np)
                  { return SC::hrbf_curvatures(mesh, np.normals_are_exact(true).fits_are_shared(false)); });
}

BOOST_AUTO_TEST_CASE(rusinkiewicz)
{
  for(const Analytic_surface& s : surfaces())
  {
    Surface_mesh mesh = surface_mesh_of(s);
    Maps maps(mesh, "");
    const auto np = maps.parameters();
    SC::Dynamic_rusinkiewicz_curvatures<Surface_mesh, std::decay_t<decltype(np)> > dynamic(mesh, np);
    check_updates(
        mesh, dynamic, maps, [&](const Maps& m) { return SC::rusinkiewicz_curvatures(mesh, m.parameters()); },
        s.mean_edge_length());
  }
}

// all vertices move: frames
BOOST_AUTO_TEST_CASE(frames)
{
  const Analytic_surface s = test_support::torus(1., .4, 48, 24, .2, 6);
  Surface_mesh mesh = surface_mesh_of(s);
  Maps maps(mesh, ""), whole(mesh, " of the whole");
  const auto np = maps.parameters();
  SC::Dynamic_rusinkiewicz_curvatures<Surface_mesh, std::decay_t<decltype(np)>, CGAL::Sequential_tag>
      one_thread(mesh, np);
  SC::Dynamic_rusinkiewicz_curvatures<Surface_mesh, std::decay_t<decltype(np)> > all_threads(mesh, np);
  for(int frame = 1; frame < 5; ++frame)
  {
    for(const Vertex v : mesh.vertices())
    {
      const Kernel::Point_3 p = mesh.point(v);
      const double angle = .3 * frame * p.z();
      mesh.point(v) = Kernel::Point_3(std::cos(angle) * p.x() - std::sin(angle) * p.y(),
                                      std::sin(angle) * p.x() + std::cos(angle) * p.y(), 1.1 * p.z());
    }
    const std::size_t failures = SC::rusinkiewicz_curvatures(mesh, whole.parameters());
    BOOST_TEST(one_thread.update() == failures);
    BOOST_TEST(first_difference(mesh, maps, whole) == mesh.number_of_vertices());
    BOOST_TEST(all_threads.update() == failures);
    BOOST_TEST(first_difference(mesh, maps, whole) == mesh.number_of_vertices());
    BOOST_TEST(all_threads.updated_vertices().size() == mesh.number_of_vertices());
  }
}

// normals that are given change, too
BOOST_AUTO_TEST_CASE(given_normals)
{
  const Analytic_surface s = test_support::torus(1., .4, 24, 12, .2, 6);
  Surface_mesh mesh = surface_mesh_of(s);
  auto normals = mesh.add_property_map<Vertex, Kernel::Vector_3>("v:normal").first;
  for(const Vertex v : mesh.vertices())
    normals[v] =
        Kernel::Vector_3(s.exact[v.idx()].normal[0], s.exact[v.idx()].normal[1], s.exact[v.idx()].normal[2]);
  Maps a(mesh, " a"), b(mesh, " b"), whole(mesh, " of the whole");
  const auto np_a = a.parameters().vertex_normal_map(normals),
             np_b = b.parameters().vertex_normal_map(normals);
  using Np = std::decay_t<decltype(np_a)>;
  const auto estimator = [](auto v, const auto& m, const auto& np)
  { return SC::rusinkiewicz_curvatures(v, m, np); };
  SC::Dynamic_curvatures<Surface_mesh, std::decay_t<decltype(estimator)>, Np> any(mesh, estimator, np_a);
  SC::Dynamic_rusinkiewicz_curvatures<Surface_mesh, Np> fast(mesh, np_b);
  BOOST_TEST(any.number_of_failures() == 0u);
  BOOST_TEST(fast.number_of_failures() == 0u);
  std::mt19937 random(2);
  for(int step = 0; step < 4; ++step)
  {
    const std::vector<Vertex> moved = {Vertex(static_cast<unsigned>(random() % 200)), Vertex(7)};
    for(const Vertex v : moved)
    {
      if(step % 2 == 0)
        normals[v] = step == 2 ? Kernel::Vector_3(0., 0., 0.)
                               : displaced(CGAL::ORIGIN + normals[v], .1, random) - CGAL::ORIGIN;
      mesh.point(v) = displaced(mesh.point(v), .01, random);
    }
    any.update(moved);
    fast.update(moved);
    SC::rusinkiewicz_curvatures(mesh, whole.parameters().vertex_normal_map(normals));
    BOOST_TEST(first_difference(mesh, a, whole) == mesh.number_of_vertices());
    BOOST_TEST(first_difference(mesh, b, whole) == mesh.number_of_vertices());
    BOOST_TEST(fast.updated_vertices().size() < 90u);
  }
}

// far from what moved, nothing is done
BOOST_AUTO_TEST_CASE(updates_are_local)
{
  Surface_mesh mesh = surface_mesh_of(test_support::torus(1., .4, 96, 48));
  const auto estimator = [](auto v, const auto& m, const auto& np)
  { return SC::rusinkiewicz_curvatures(v, m, np); };
  SC::Dynamic_curvatures<Surface_mesh, std::decay_t<decltype(estimator)> > any(mesh, estimator);
  SC::Dynamic_rusinkiewicz_curvatures<Surface_mesh> fast(mesh);
  any.update(std::vector<Vertex>{Vertex(1000)});
  fast.update(std::vector<Vertex>{Vertex(1000)});
  BOOST_TEST(fast.updated_vertices().size() == 19u); // two rings
  BOOST_TEST(any.updated_vertices().size() < 100u);
}

BOOST_AUTO_TEST_CASE(bad_inputs)
{
  Surface_mesh empty, quad;
  SC::Dynamic_rusinkiewicz_curvatures<Surface_mesh> nothing(empty);
  BOOST_TEST(nothing.update() == 0u);
  CGAL::make_quad(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0), Kernel::Point_3(1, 1, 0),
                  Kernel::Point_3(0, 1, 0), quad);
  BOOST_CHECK_THROW(SC::Dynamic_rusinkiewicz_curvatures<Surface_mesh>{quad}, std::invalid_argument);

  // three faces of a soup, whose vertices move onto each other and apart
  Surface_mesh soup;
  for(int k = 0; k < 3; ++k)
    CGAL::make_triangle(Kernel::Point_3(k, 0, 0), Kernel::Point_3(k + .5, 0, 0), Kernel::Point_3(k, 1, 0),
                        soup);
  Maps maps(soup, ""), whole(soup, " of the whole");
  const auto np = maps.parameters();
  SC::Dynamic_rusinkiewicz_curvatures<Surface_mesh, std::decay_t<decltype(np)> > dynamic(soup, np);
  BOOST_TEST(dynamic.number_of_failures() == SC::rusinkiewicz_curvatures(soup, whole.parameters()));
  BOOST_TEST(dynamic.number_of_failures() > 0u);
  for(const double x : {0., 2., 1., 7.})
  {
    const std::vector<S> before(maps.status.begin(), maps.status.end());
    soup.point(Vertex(3)) = Kernel::Point_3(x, 0, 0);
    BOOST_TEST(dynamic.update(std::vector<Vertex>{Vertex(3)}) ==
               SC::rusinkiewicz_curvatures(soup, whole.parameters()));
    BOOST_TEST(first_difference(soup, maps, whole) == soup.number_of_vertices());
    // the vertex that it meets or leaves is updated as well
    const std::vector<Vertex> updated = dynamic.updated_vertices();
    for(const Vertex v : soup.vertices())
      if(maps.status[v] != before[v.idx()])
        BOOST_TEST((std::find(updated.begin(), updated.end(), v) != updated.end()));
  }
}

// A vertex of one face asks for others, in further rings if need be. Whether there are enough of them depends on normals far away.
BOOST_AUTO_TEST_CASE(strips)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Surface_mesh strip;
  for(int k = 0; k < 9; ++k)
    strip.add_vertex(Kernel::Point_3(k, k % 2, .1 * (k % 3)));
  for(unsigned k = 0; k + 2 < 9; ++k)
    strip.add_face(Vertex(k), Vertex(k % 2 == 0 ? k + 2 : k + 1), Vertex(k % 2 == 0 ? k + 1 : k + 2));
  const Surface_mesh whole_strip = strip;
  for(const unsigned broken : {3u, 5u})
  {
    strip = whole_strip;
    strip.point(Vertex(broken)) = strip.point(Vertex(broken + 1)) = Kernel::Point_3(nan, 0, 0);
    const std::vector<Kernel::Point_3> original = {strip.points().begin(), strip.points().end()};
    Maps maps(strip, std::to_string(broken)), whole(strip, " of the whole" + std::to_string(broken));
    const auto np = maps.parameters();
    SC::Dynamic_rusinkiewicz_curvatures<Surface_mesh, std::decay_t<decltype(np)> > dynamic(strip, np);
    const auto check = [&](const std::vector<Vertex>& moved)
    {
      BOOST_TEST(dynamic.update(moved) == SC::rusinkiewicz_curvatures(strip, whole.parameters()));
      BOOST_TEST(first_difference(strip, maps, whole) == strip.number_of_vertices());
    };
    for(unsigned k = 0; k < 8; ++k)
    {
      const std::vector<Vertex> two = {Vertex(k), Vertex(k + 1)};
      for(const Vertex v : two)
        strip.point(v) = original[5];
      check(two);
      for(const Vertex v : two)
        strip.point(v) = Kernel::Point_3(nan, 0, 0);
      check(two);
      for(const Vertex v : two)
        strip.point(v) = original[v];
      check(two);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
