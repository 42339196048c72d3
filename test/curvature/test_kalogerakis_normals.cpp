#include <boost/test/unit_test.hpp>

#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/kalogerakis_curvatures.h>
#include <Shape_characteristics/curvature/kalogerakis_normals.h>
#include <Shape_characteristics/normals/vertex_normals.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "analytic_surfaces.h"
#include "build_mesh.h"
#include "normal_errors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(kalogerakis_normals)

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Vector_3 = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Normal_map = Mesh::Property_map<Mesh::Vertex_index, Vector_3>;
using Status_map = Mesh::Property_map<Mesh::Vertex_index, SC::Estimation_status>;
using test_support::Analytic_surface;
using test_support::disturbed;
using test_support::normal_error;
using test_support::normal_of;

namespace {

Normal_map normal_map(Mesh& mesh, const char* name)
{
  return mesh.add_property_map<Mesh::Vertex_index, Vector_3>(name).first;
}

} // namespace

BOOST_AUTO_TEST_CASE(noisy_normals)
{
  for(const Analytic_surface& s : {test_support::ellipsoid(1., .8, .6, 4, .2, 3),
                                   test_support::torus(1., .4, 60, 30, .2, 3), test_support::sphere(1., 4)})
  {
    Mesh mesh = test_support::build_mesh<Mesh>(s);
    const Normal_map normals = normal_map(mesh, "v:normals");
    benchmark_support::Random random(5);
    double before = 0., after = 0.;
    for(const auto v : vertices(mesh))
    {
      const Vector_3 exact = normal_of(s.exact[v.idx()].normal);
      normals[v] = disturbed(exact, .05, random);
      before += normal_error(normals[v], exact);
    }
    BOOST_TEST(SC::kalogerakis_normals(mesh, normals, SC::parameters::vertex_normal_map(normals)) == 0u);
    for(const auto v : vertices(mesh))
    {
      after += normal_error(normals[v], normal_of(s.exact[v.idx()].normal));
      BOOST_TEST(std::abs(normals[v].squared_length() - 1.) < 1e-12);
    }
    BOOST_TEST_MESSAGE(s.name << ": error " << before / double(s.points.size()) << " -> "
                              << after / double(s.points.size()));
    BOOST_TEST(after < before / 4., s.name);
  }
}

// The roof of a house: whatever the noise, the normals of one side don't bend towards the other.
BOOST_AUTO_TEST_CASE(feature_lines)
{
  const std::size_t n = 24;
  Analytic_surface roof;
  for(std::size_t j = 0; j <= n; ++j)
    for(std::size_t i = 0; i <= n; ++i)
    {
      const double x = double(i) / double(n) - .5;
      roof.points.push_back({x, double(j) / double(n), -std::abs(x)});
    }
  for(std::size_t j = 0; j < n; ++j)
    for(std::size_t i = 0; i < n; ++i)
    {
      const std::size_t a = j * (n + 1) + i, b = a + n + 1;
      roof.triangles.push_back({a, a + 1, b + 1});
      roof.triangles.push_back({a, b + 1, b});
    }
  Mesh mesh = test_support::build_mesh<Mesh>(roof);
  const Normal_map normals = normal_map(mesh, "v:normals");
  benchmark_support::Random random(7);
  const auto exact = [&](const Mesh::Vertex_index v)
  { return Vector_3(mesh.point(v).x() > 0 ? 1 : -1, 0, 1) / std::sqrt(2.); };
  double before = 0., after = 0.;
  for(const auto v : vertices(mesh))
    normals[v] = disturbed(exact(v), .01, random);
  const auto beside_the_ridge = [&](const Mesh::Vertex_index v)
  { return std::abs(std::abs(mesh.point(v).x()) - 1. / double(n)) < 1e-9 && !mesh.is_border(v); };
  for(const auto v : vertices(mesh))
    if(beside_the_ridge(v))
      before += normal_error(normals[v], exact(v));
  SC::kalogerakis_normals(mesh, normals, SC::parameters::vertex_normal_map(normals));
  for(const auto v : vertices(mesh))
    if(beside_the_ridge(v))
      after += normal_error(normals[v], exact(v));
  BOOST_TEST_MESSAGE("beside the ridge: error " << before << " -> " << after);
  BOOST_TEST(before > 0.);
  BOOST_TEST(after < before);
}

// the normals are those that the curvatures come from
BOOST_AUTO_TEST_CASE(directions_of_curvature)
{
  const Analytic_surface s = test_support::waves(.1, 4., 1., 16, .2, 3);
  Mesh mesh = test_support::build_mesh<Mesh>(s);
  const Normal_map normals = normal_map(mesh, "v:normals");
  const auto curvatures =
      mesh.add_property_map<Mesh::Vertex_index, SC::Principal_curvatures_and_directions<Kernel>>(
              "v:curvatures")
          .first;
  SC::kalogerakis_normals(mesh, normals);
  SC::kalogerakis_curvatures(mesh,
                             SC::parameters::vertex_principal_curvatures_and_directions_map(curvatures));
  for(const auto v : vertices(mesh))
  {
    BOOST_TEST(std::abs(normals[v] * curvatures[v].min_direction) < 1e-12);
    BOOST_TEST(std::abs(normals[v] * curvatures[v].max_direction) < 1e-12);
  }
}

// Without a pass, curvatures are of the normals as they are given: with exact ones, more exact than after a pass.
BOOST_AUTO_TEST_CASE(curvatures_of_given_normals)
{
  const Analytic_surface s = test_support::torus(1., .4, 60, 30, .2, 3);
  Mesh mesh = test_support::build_mesh<Mesh>(s);
  const Normal_map normals = normal_map(mesh, "v:normals");
  for(const auto v : vertices(mesh))
    normals[v] = normal_of(s.exact[v.idx()].normal);
  const auto curvatures =
      mesh.add_property_map<Mesh::Vertex_index, SC::Principal_curvatures_and_directions<Kernel>>("v:k").first;
  double errors[2] = {0., 0.};
  for(const unsigned int passes : {1u, 0u})
  {
    const auto np = SC::parameters::vertex_normal_map(normals).number_of_passes(passes);
    BOOST_TEST(SC::kalogerakis_curvatures(
                   mesh, np.vertex_principal_curvatures_and_directions_map(curvatures)) == 0u);
    for(const auto v : vertices(mesh))
    {
      errors[passes] += std::abs(curvatures[v].max_curvature - s.exact[v.idx()].k_max);
      SC::Principal_curvatures_and_directions<Kernel> alone;
      SC::kalogerakis_curvatures(v, mesh, np.vertex_principal_curvatures_and_directions(std::ref(alone)));
      BOOST_TEST(alone.max_curvature == curvatures[v].max_curvature);
      if(passes == 0)
        BOOST_TEST(std::abs(normals[v] * curvatures[v].max_direction) < 1e-12);
    }
  }
  BOOST_TEST_MESSAGE("errors " << errors[0] << ", after a pass " << errors[1]);
  BOOST_TEST(errors[0] < .8 * errors[1]);
}

BOOST_AUTO_TEST_CASE(one_vertex_and_threads)
{
  const Analytic_surface s = test_support::waves(.1, 4., 1., 12, .2, 3);
  Mesh mesh = test_support::build_mesh<Mesh>(s);
  const Normal_map all = normal_map(mesh, "v:all"), parallel = normal_map(mesh, "v:parallel");
  const Status_map status =
      mesh.add_property_map<Mesh::Vertex_index, SC::Estimation_status>("v:status").first;
  for(const unsigned int passes : {1u, 2u, 3u})
  {
    const auto np = SC::parameters::number_of_passes(passes);
    SC::kalogerakis_normals<CGAL::Sequential_tag>(mesh, all, np.vertex_status_map(status));
    SC::kalogerakis_normals(mesh, parallel, np);
    for(const auto v : vertices(mesh))
    {
      Vector_3 n;
      BOOST_TEST((SC::kalogerakis_normals(v, mesh, n, np) == status[v]));
      BOOST_TEST(n == all[v]);
      BOOST_TEST(parallel[v] == all[v]);
      BOOST_TEST((status[v] == (s.exact[v.idx()].border ? SC::Estimation_status::BORDER
                                                        : SC::Estimation_status::ESTIMATED)));
    }
  }
}

// Where a surface is folded, fits fail, and ask for more neighbors: in other passes, for others. (It is rare; one of these has it.)
BOOST_AUTO_TEST_CASE(one_vertex_of_folded_surfaces)
{
  for(unsigned int seed = 12; seed < 17; ++seed)
  {
    std::mt19937 random(seed);
    const auto uniform = [&] { return 2. * double(random()) / 4294967296. - 1.; };
    constexpr unsigned int n = 10;
    Mesh mesh;
    for(unsigned int i = 0; i < n * n; ++i)
    {
      const double x = i % n + .2 * uniform(), y = i / n + .2 * uniform();
      const double z = .05 * uniform() + 2. * std::exp(-((x - 5.) * (x - 5.) + (y - 5.) * (y - 5.)) / 4.);
      mesh.add_vertex(Kernel::Point_3(x, y, z));
    }
    for(unsigned int j = 0; j + 1 < n; ++j)
      for(unsigned int i = 0; i + 1 < n; ++i)
      {
        const Mesh::Vertex_index a(j * n + i), b(a + 1), c(a + n), d(c + 1);
        mesh.add_face(a, b, c);
        mesh.add_face(b, d, c);
      }
    for(int k = 0; k < 3; ++k) // these are pulled across the others
    {
      const Mesh::Vertex_index v(random() % (n * n));
      const double x = 8. * uniform(), y = 8. * uniform();
      mesh.point(v) += Vector_3(x, y, uniform());
    }
    const auto mean = mesh.add_property_map<Mesh::Vertex_index, double>("v:mean").first;
    SC::kalogerakis_curvatures(mesh, SC::parameters::vertex_mean_curvature_map(mean));
    for(const auto v : vertices(mesh))
    {
      double of_one;
      SC::kalogerakis_curvatures(v, mesh, SC::parameters::vertex_mean_curvature(std::ref(of_one)));
      BOOST_TEST((of_one == mean[v] || (std::isnan(of_one) && std::isnan(mean[v]))),
                 "seed " << seed << ", vertex " << v);
    }
  }
}

BOOST_AUTO_TEST_CASE(point_set)
{
  const Analytic_surface s = test_support::ellipsoid(1., .8, .6, 4, .2, 3);
  CGAL::Point_set_3<Kernel::Point_3> set;
  set.add_normal_map();
  benchmark_support::Random random(5);
  double before = 0, after = 0;
  for(std::size_t i = 0; i < s.points.size(); ++i)
  {
    const Vector_3 exact = normal_of(s.exact[i].normal), n = disturbed(exact, .05, random);
    const auto& p = s.points[i];
    set.insert(Kernel::Point_3(p[0], p[1], p[2]), n);
    before += normal_error(n, exact);
  }
  BOOST_TEST(SC::kalogerakis_normals(set, set.normal_map()) == 0u);
  for(std::size_t i = 0; i < s.points.size(); ++i)
    after += normal_error(set.normal(*(set.begin() + std::ptrdiff_t(i))), normal_of(s.exact[i].normal));
  BOOST_TEST_MESSAGE("point set: error " << before << " -> " << after);
  BOOST_TEST(after < before / 4.);
}

BOOST_AUTO_TEST_CASE(points_without_an_answer)
{
  Mesh mesh = test_support::build_mesh<Mesh>(test_support::sphere(1., 2));
  const auto lonely = mesh.add_vertex(Kernel::Point_3(5, 5, 5));
  const auto broken = *vertices(mesh).begin();
  mesh.point(broken) = Kernel::Point_3(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  const Normal_map normals = normal_map(mesh, "v:normals");
  const Status_map status =
      mesh.add_property_map<Mesh::Vertex_index, SC::Estimation_status>("v:status").first;
  const auto np = SC::parameters::vertex_status_map(status);
  BOOST_TEST(SC::kalogerakis_normals(mesh, normals, np) == 2u);
  BOOST_TEST((status[lonely] == SC::Estimation_status::UNREFERENCED));
  BOOST_TEST((status[broken] == SC::Estimation_status::NON_FINITE_INPUT));
  for(const auto v : vertices(mesh))
    BOOST_TEST(std::isnan(normals[v].x()) == !SC::is_estimated(status[v]));

  Mesh empty;
  const Normal_map of_empty = normal_map(empty, "v:normals");
  BOOST_TEST(SC::kalogerakis_normals(empty, of_empty) == 0u);
  BOOST_CHECK_THROW(SC::kalogerakis_normals(mesh, normals, SC::parameters::number_of_rings(0u)),
                    std::invalid_argument);
  for(const double passes : {-1., 0., 1001., 1.5})
    BOOST_CHECK_THROW(SC::kalogerakis_normals(mesh, normals, SC::parameters::number_of_passes(passes)),
                      std::invalid_argument);
  for(const int passes : {-1, 1001})
    BOOST_CHECK_THROW(SC::kalogerakis_curvatures(mesh, SC::parameters::number_of_passes(passes)),
                      std::invalid_argument);
}

// a computation that was stopped has no results
BOOST_AUTO_TEST_CASE(callback)
{
  Mesh mesh = test_support::build_mesh<Mesh>(test_support::sphere(1., 3));
  const Normal_map normals = normal_map(mesh, "v:normals");
  const Status_map status =
      mesh.add_property_map<Mesh::Vertex_index, SC::Estimation_status>("v:status").first;
  double last = 0.;
  bool rises = true;
  const auto np = SC::parameters::vertex_status_map(status);
  BOOST_TEST(SC::kalogerakis_normals<CGAL::Sequential_tag>(mesh, normals,
                                                           np.callback(
                                                               [&](double advancement)
                                                               {
                                                                 rises = rises && advancement >= last;
                                                                 last = advancement;
                                                                 return true;
                                                               })) == 0u);
  BOOST_TEST(rises);
  BOOST_TEST(last == 1.);
  BOOST_TEST(SC::kalogerakis_normals<CGAL::Sequential_tag>(
                 mesh, normals, np.callback([](double advancement) { return advancement < .7; })) ==
             num_vertices(mesh));
  for(const auto v : vertices(mesh))
  {
    BOOST_TEST((status[v] == SC::Estimation_status::CANCELLED));
    BOOST_TEST(std::isnan(normals[v].x()));
  }
}

BOOST_AUTO_TEST_SUITE_END()
