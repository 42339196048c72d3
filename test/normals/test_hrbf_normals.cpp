#include <boost/test/unit_test.hpp>

#include <Shape_characteristics/interpolation/Polyharmonic.h>
#include <Shape_characteristics/normals/hrbf_normals.h>
#include <Shape_characteristics/normals/vertex_normals.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "analytic_surfaces.h"
#include "build_mesh.h"
#include "normal_errors.h"
#include "raise_to.h"

#include "../../benchmark/support/test_functions.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(hrbf_normals)

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Vector_3 = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Normal_map = Mesh::Property_map<Mesh::Vertex_index, Vector_3>;
using Status_map = Mesh::Property_map<Mesh::Vertex_index, SC::Estimation_status>;
using test_support::Analytic_surface;
using test_support::normal_error;
using test_support::normal_of;

namespace {

Analytic_surface f1e(double jitter)
{
  const auto& f = benchmark_support::explicit_function("f1e");
  return test_support::graph("f1e", f.value, f.gradient, f.hessian, f.half, 60, jitter, 3);
}

struct Mean_errors
{
  double of_max = 0, of_hrbf = 0, largest = 0;
};

// the vertices of the border aside: there faces see one side of the surface only
template <typename NamedParameters>
Mean_errors mean_errors(const Analytic_surface& s, const NamedParameters& np)
{
  Mesh mesh = test_support::build_mesh<Mesh>(s);
  const Normal_map by_max = mesh.add_property_map<Mesh::Vertex_index, Vector_3>("v:max").first;
  const Normal_map by_hrbf = mesh.add_property_map<Mesh::Vertex_index, Vector_3>("v:hrbf").first;
  BOOST_TEST(SC::vertex_normals(mesh, by_max) == 0u);
  BOOST_TEST(SC::hrbf_normals(mesh, by_hrbf, np) == 0u);
  Mean_errors e;
  std::size_t count = 0;
  for(const auto v : vertices(mesh))
  {
    const Vector_3 n = normal_of(s.exact[v.idx()].normal);
    BOOST_TEST(std::abs(by_hrbf[v].squared_length() - 1) < 1e-12);
    if(s.exact[v.idx()].border)
      continue;
    ++count;
    e.of_max += normal_error(by_max[v], n);
    e.of_hrbf += normal_error(by_hrbf[v], n);
    test_support::raise_to(e.largest, normal_error(by_hrbf[v], n));
  }
  e.of_max /= double(count);
  e.of_hrbf /= double(count);
  BOOST_TEST_MESSAGE(s.name << ": mean error of Max's normals " << e.of_max << ", of HRBF " << e.of_hrbf
                            << ", largest " << e.largest);
  return e;
}

const auto two_rings = SC::parameters::number_of_rings(2u);

} // namespace

BOOST_AUTO_TEST_CASE(better_than_what_they_start_from)
{
  // (on a regular torus, Max's normals are exact)
  for(const Analytic_surface& s :
      {f1e(0.), f1e(.2), test_support::ellipsoid(1., .8, .6, 3),
       test_support::ellipsoid(1., .8, .6, 3, .2, 3), test_support::torus(1., .4, 60, 30, .2, 3)})
  {
    const Mean_errors e = mean_errors(s, two_rings);
    BOOST_TEST(e.of_hrbf < e.of_max / 100, s.name);
  }
}

// The thesis's function interpolates the normals that it is given: averages over its pattern are about as good as those.
BOOST_AUTO_TEST_CASE(formulation_of_the_thesis)
{
  const auto np = two_rings.radial_basis_function(SC::Polyharmonic<3>());
  for(const Analytic_surface& s : {f1e(0.), test_support::ellipsoid(1., .8, .6, 3, .2, 3)})
  {
    const Mean_errors e = mean_errors(s, np);
    BOOST_TEST(e.of_hrbf < 4 * e.of_max, s.name);
  }
}

// where Max's normals are exact, nothing is spoiled
BOOST_AUTO_TEST_CASE(sphere)
{
  for(const double jitter : {0., .2})
    BOOST_TEST(mean_errors(test_support::sphere(3., 3, jitter, 3), two_rings).largest < 5e-9);
}

// normals that are given are where it starts from; the result may replace them
BOOST_AUTO_TEST_CASE(into_the_map_of_the_input)
{
  const Analytic_surface s = test_support::torus(1., .4, 36, 18, .2, 3);
  Mesh mesh = test_support::build_mesh<Mesh>(s);
  const Normal_map elsewhere = mesh.add_property_map<Mesh::Vertex_index, Vector_3>("v:elsewhere").first;
  const Normal_map in_place = mesh.add_property_map<Mesh::Vertex_index, Vector_3>("v:in_place").first;
  const Normal_map by_default = mesh.add_property_map<Mesh::Vertex_index, Vector_3>("v:default").first;
  SC::vertex_normals(mesh, in_place);
  for(const auto v : vertices(mesh))
    in_place[v] = (1. + v.idx()) * in_place[v]; // of any length
  SC::hrbf_normals(mesh, elsewhere, SC::parameters::vertex_normal_map(in_place));
  SC::hrbf_normals(mesh, in_place, SC::parameters::vertex_normal_map(in_place));
  SC::hrbf_normals(mesh, by_default);
  double largest = 0;
  std::size_t different = 0;
  for(const auto v : vertices(mesh))
  {
    different += in_place[v] != elsewhere[v];
    test_support::raise_to(largest, normal_error(by_default[v], in_place[v]));
  }
  BOOST_TEST(different == 0u);
  BOOST_TEST(largest < 1e-10);
}

BOOST_AUTO_TEST_CASE(one_vertex)
{
  const Analytic_surface s = test_support::waves(.1, 4., 1., 16, .2, 3);
  Mesh mesh = test_support::build_mesh<Mesh>(s);
  const Normal_map all = mesh.add_property_map<Mesh::Vertex_index, Vector_3>("v:all").first;
  const Status_map status =
      mesh.add_property_map<Mesh::Vertex_index, SC::Estimation_status>("v:status").first;
  const auto np = SC::parameters::noise_level(1e-3).number_of_passes(2u).fits_are_shared(false);
  SC::hrbf_normals(mesh, all, np.vertex_status_map(status));
  for(const auto v : vertices(mesh))
  {
    Vector_3 n;
    BOOST_TEST((SC::hrbf_normals(v, mesh, n, np) == status[v]));
    BOOST_TEST(n == all[v]);
    BOOST_TEST((status[v] == (s.exact[v.idx()].border ? SC::Estimation_status::BORDER
                                                      : SC::Estimation_status::ESTIMATED)));
  }
}

// with the normals of the faces around it turned away a little, a point finds its own back
BOOST_AUTO_TEST_CASE(point_set)
{
  const Analytic_surface s = test_support::ellipsoid(1., .8, .6, 3, .2, 3);
  CGAL::Point_set_3<Kernel::Point_3> set;
  set.add_normal_map();
  benchmark_support::Random random(5);
  double before = 0, after = 0;
  for(std::size_t i = 0; i < s.points.size(); ++i)
  {
    const Vector_3 exact = normal_of(s.exact[i].normal), n = test_support::disturbed(exact, .05, random);
    const auto& p = s.points[i];
    set.insert(Kernel::Point_3(p[0], p[1], p[2]), n);
    before += normal_error(n, exact);
  }
  BOOST_TEST(SC::hrbf_normals(set, set.normal_map()) == 0u);
  for(std::size_t i = 0; i < s.points.size(); ++i)
    after += normal_error(set.normal(*(set.begin() + std::ptrdiff_t(i))), normal_of(s.exact[i].normal));
  BOOST_TEST_MESSAGE("point set: error " << before / double(s.points.size()) << " -> "
                                         << after / double(s.points.size()));
  BOOST_TEST(after < before / 100);
}

BOOST_AUTO_TEST_CASE(points_without_an_answer)
{
  Mesh mesh = test_support::build_mesh<Mesh>(test_support::sphere(1., 2));
  const auto lonely = mesh.add_vertex(Kernel::Point_3(5, 5, 5));
  const auto broken = *vertices(mesh).begin();
  mesh.point(broken) = Kernel::Point_3(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  const Normal_map normals = mesh.add_property_map<Mesh::Vertex_index, Vector_3>("v:normals").first;
  const Status_map status =
      mesh.add_property_map<Mesh::Vertex_index, SC::Estimation_status>("v:status").first;
  BOOST_TEST(SC::hrbf_normals(mesh, normals, SC::parameters::vertex_status_map(status)) == 2u);
  BOOST_TEST((status[lonely] == SC::Estimation_status::UNREFERENCED));
  BOOST_TEST((status[broken] == SC::Estimation_status::NON_FINITE_INPUT));
  for(const auto v : vertices(mesh))
    BOOST_TEST(std::isnan(normals[v].x()) == !SC::is_estimated(status[v]));

  BOOST_CHECK_THROW(SC::hrbf_normals(mesh, normals, SC::parameters::number_of_rings(0u)),
                    std::invalid_argument);
  BOOST_CHECK_THROW(
      SC::hrbf_normals(mesh, normals, SC::parameters::radial_basis_function(SC::Polyharmonic<4>())),
      std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
