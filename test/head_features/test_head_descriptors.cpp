#include <boost/test/unit_test.hpp>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "analytic_surfaces.h"
#include "bad_meshes.h"
#include "build_mesh.h"

#include <Shape_characteristics/head_features/Head_pose.h>
#include <Shape_characteristics/head_features/head_descriptors.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/number_type_config.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(head_descriptors)

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Curvatures = SC::Principal_curvatures_and_directions<Kernel>;

namespace {

// curvatures that were known before, in the order of the vertices
struct Given_curvatures
{
  const std::vector<std::array<double, 2> >* values; // min, max; NaN: not estimated

  template <typename Graph, typename NamedParameters>
  void operator()(const Graph& mesh, const NamedParameters& np) const
  {
    const auto curvature_map =
        SC::parameters::get_parameter(np, SC::internal_np::vertex_principal_curvatures_and_directions_map);
    const auto status_map = SC::parameters::get_parameter(np, SC::internal_np::vertex_status_map);
    std::size_t i = 0;
    for(const auto v : vertices(mesh))
    {
      const auto [k_min, k_max] = (*values)[i++];
      put(curvature_map, v, Curvatures(k_min, k_max, Kernel::Vector_3(1, 0, 0), Kernel::Vector_3(0, 1, 0)));
      put(status_map, v,
          std::isnan(k_min) ? SC::Estimation_status::DEGENERATE : SC::Estimation_status::ESTIMATED);
    }
  }
};

template <typename Graph, typename NamedParameters>
std::vector<SC::Head_descriptor>
descriptors(const Graph& mesh, const NamedParameters& np, std::size_t* failures = nullptr)
{
  auto map = get(CGAL::dynamic_vertex_property_t<SC::Head_descriptor>(), mesh);
  const std::size_t n = SC::head_descriptors<CGAL::Sequential_tag>(mesh, np.vertex_head_descriptor_map(map));
  if(failures != nullptr)
    *failures = n;
  std::vector<SC::Head_descriptor> result;
  for(const auto v : vertices(mesh))
    result.push_back(get(map, v));
  return result;
}

std::vector<std::array<double, 2> > exact_curvatures(const test_support::Analytic_surface& surface)
{
  std::vector<std::array<double, 2> > result;
  for(const auto& e : surface.exact)
    result.push_back({e.k_min, e.k_max});
  return result;
}

void check_equal(const SC::Head_descriptor& a, const SC::Head_descriptor& b, double tolerance)
{
  BOOST_TEST(std::abs(a.shape_index - b.shape_index) <= tolerance);
  BOOST_TEST(std::abs(a.curvedness - b.curvedness) <= tolerance);
  BOOST_TEST(std::abs(a.mean_curvature - b.mean_curvature) <= tolerance);
  BOOST_TEST(std::abs(a.Willmore_energy - b.Willmore_energy) <= tolerance);
}

} // namespace

// A torus with the radii 1 and r = 0.4: k_max = 1 / r, k_min = cos(t) / (1 + r cos(t)), from -1/0.6 to 1/1.4. All four
// characteristics have their extremes at the inner or the outer equator.
BOOST_AUTO_TEST_CASE(closed_form_on_a_torus)
{
  const test_support::Analytic_surface torus = test_support::torus(1., .4);
  const Mesh mesh = test_support::build_mesh<Mesh>(torus);
  const std::vector<std::array<double, 2> > curvatures = exact_curvatures(torus);
  const auto found = descriptors(
      mesh, SC::parameters::curvature_estimator(Given_curvatures{&curvatures}).averaging_radius(0.));
  BOOST_REQUIRE_EQUAL(found.size(), torus.points.size());

  double low[3] = {1e9, 1e9, 1e9}, high[3] = {-1e9, -1e9, -1e9};
  std::vector<std::array<double, 3> > expected;
  for(const auto& [k_min, k_max] : curvatures)
  {
    expected.push_back({std::sqrt((k_min * k_min + k_max * k_max) / 2), (k_min + k_max) / 2,
                        (k_max - k_min) * (k_max - k_min) / 4});
    for(std::size_t k = 0; k < 3; ++k)
    {
      low[k] = std::min(low[k], expected.back()[k]);
      high[k] = std::max(high[k], expected.back()[k]);
    }
  }
  for(std::size_t i = 0; i < found.size(); ++i)
  {
    const auto [k_min, k_max] = curvatures[i];
    SC::Head_descriptor e;
    e.shape_index = 2 / CGAL_PI * std::atan2(k_max + k_min, k_max - k_min);
    e.curvedness = (expected[i][0] - low[0]) / (high[0] - low[0]);
    e.mean_curvature = (expected[i][1] - low[1]) / (high[1] - low[1]);
    e.Willmore_energy = (expected[i][2] - low[2]) / (high[2] - low[2]);
    check_equal(found[i], e, 1e-12);
  }
}

// What is alike everywhere is 0 after the mapping, and not 0 / 0.
BOOST_AUTO_TEST_CASE(all_alike_on_a_sphere)
{
  const test_support::Analytic_surface sphere = test_support::sphere(2., 2);
  const Mesh mesh = test_support::build_mesh<Mesh>(sphere);
  const std::vector<std::array<double, 2> > curvatures(sphere.points.size(), {.5, .5});
  for(const auto& d : descriptors(mesh, SC::parameters::curvature_estimator(Given_curvatures{&curvatures})))
  {
    BOOST_TEST(d.shape_index == 1.);
    BOOST_TEST(d.curvedness == 0.);
    BOOST_TEST(d.mean_curvature == 0.);
    BOOST_TEST(d.Willmore_energy == 0.);
  }
}

// The mean over all vertices in a ball, by looking at all pairs: on a sphere the ball is connected.
BOOST_AUTO_TEST_CASE(averages_over_the_ball)
{
  const test_support::Analytic_surface sphere = test_support::sphere(1., 3);
  const Mesh mesh = test_support::build_mesh<Mesh>(sphere);
  std::vector<std::array<double, 2> > curvatures;
  for(const auto& p : sphere.points)
    curvatures.push_back({p[0], p[0] + 1. + p[1]});
  curvatures[7] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  const auto np = [&](double radius)
  { return SC::parameters::curvature_estimator(Given_curvatures{&curvatures}).averaging_radius(radius); };
  std::size_t failures = 0;
  const auto single = descriptors(mesh, np(0.));
  const auto averaged = descriptors(mesh, np(.15), &failures); // the sphere's box has the size 2
  BOOST_TEST(failures == 1u);
  for(std::size_t i = 0; i < sphere.points.size(); ++i)
  {
    if(i == 7)
    {
      BOOST_TEST(std::isnan(averaged[i].curvedness));
      BOOST_TEST(std::isnan(averaged[i].shape_index));
      continue;
    }
    double sum = 0., number = 0.;
    for(std::size_t j = 0; j < sphere.points.size(); ++j)
    {
      double squared = 0.;
      for(std::size_t k = 0; k < 3; ++k)
        squared += std::pow(sphere.points[i][k] - sphere.points[j][k], 2);
      if(j != 7 && squared <= .09)
      {
        sum += single[j].mean_curvature;
        ++number;
      }
    }
    BOOST_TEST(number > 3.);
    BOOST_TEST(std::abs(averaged[i].mean_curvature - sum / number) < 1e-12);
  }
}

// With the default estimator: no unit, no place, no mesh type.
BOOST_AUTO_TEST_CASE(neither_unit_nor_mesh_type_matters)
{
  test_support::Analytic_surface torus = test_support::torus(1., .4);
  const auto expected =
      descriptors(test_support::build_mesh<Mesh>(torus), SC::parameters::averaging_radius(.05));
  const auto polyhedron = descriptors(test_support::build_mesh<CGAL::Polyhedron_3<Kernel> >(torus),
                                      SC::parameters::averaging_radius(.05));
  for(std::size_t i = 0; i < expected.size(); ++i)
    check_equal(polyhedron[i], expected[i], 0.);
  for(const double scale : {1e-6, 1e6})
  {
    test_support::Analytic_surface scaled = torus;
    for(auto& p : scaled.points)
      for(std::size_t k = 0; k < 3; ++k)
        p[k] *= scale;
    const auto found =
        descriptors(test_support::build_mesh<Mesh>(scaled), SC::parameters::averaging_radius(.05));
    for(std::size_t i = 0; i < expected.size(); ++i)
      check_equal(found[i], expected[i], 1e-7);
  }
}

// The squares of such curvatures are no numbers any more.
BOOST_AUTO_TEST_CASE(extraordinary_curvatures)
{
  const Mesh mesh = test_support::build_mesh<Mesh>(test_support::torus(1., .4, 12, 8));
  std::vector<std::array<double, 2> > values, scaled;
  for(std::size_t i = 0; i < mesh.number_of_vertices(); ++i)
    values.push_back({-1. - .01 * double(i), 2. + .03 * double(i)});
  const auto expected =
      descriptors(mesh, SC::parameters::averaging_radius(.05).curvature_estimator(Given_curvatures{&values}));
  for(const int exponent : {-600, 600, 1000})
  {
    scaled = values;
    for(auto& [low, high] : scaled)
    {
      low = std::ldexp(low, exponent);
      high = std::ldexp(high, exponent);
    }
    const auto found = descriptors(
        mesh, SC::parameters::averaging_radius(.05).curvature_estimator(Given_curvatures{&scaled}));
    for(std::size_t i = 0; i < expected.size(); ++i)
      check_equal(found[i], expected[i], 0.);
  }
}

// Points of an exact kernel: curvatures are numbers all the same.
BOOST_AUTO_TEST_CASE(exact_points)
{
  const test_support::Analytic_surface torus = test_support::torus(1., .4, 12, 8);
  using Exact_point = CGAL::Exact_predicates_exact_constructions_kernel::Point_3;
  const auto exact = descriptors(test_support::build_mesh<CGAL::Surface_mesh<Exact_point> >(torus),
                                 SC::parameters::averaging_radius(.05));
  const auto expected =
      descriptors(test_support::build_mesh<Mesh>(torus), SC::parameters::averaging_radius(.05));
  for(std::size_t i = 0; i < expected.size(); ++i)
    check_equal(exact[i], expected[i], 0.);
}

BOOST_AUTO_TEST_CASE(size_of_a_pose)
{
  const Mesh mesh = test_support::build_mesh<Mesh>(test_support::torus(1., .4));
  SC::Head_pose<Kernel> pose;
  pose.size = 2.; // the longest side of the box is 2.8
  const auto a = descriptors(mesh, SC::parameters::averaging_radius(.14).head_pose(pose)),
             b = descriptors(mesh, SC::parameters::averaging_radius(.1));
  for(std::size_t i = 0; i < a.size(); ++i)
    check_equal(a[i], b[i], 1e-12);
}

BOOST_AUTO_TEST_CASE(bad_inputs)
{
  const Mesh torus = test_support::build_mesh<Mesh>(test_support::torus(1., .4));
  BOOST_CHECK_THROW(descriptors(torus, SC::parameters::averaging_radius(-1.)), std::invalid_argument);
  BOOST_CHECK_THROW(descriptors(torus, SC::parameters::averaging_radius(std::nan(""))),
                    std::invalid_argument);
  BOOST_TEST(descriptors(Mesh(), SC::parameters::averaging_radius(.01)).empty());

  for(const auto& polygons : test_support::all_bad_triangle_meshes())
  {
    const Mesh mesh = test_support::build_mesh<Mesh>(polygons);
    std::size_t failures = 0, missing = 0;
    for(const auto& d : descriptors(mesh, SC::parameters::averaging_radius(.01), &failures))
    {
      missing += std::isnan(d.curvedness) ? 1 : 0;
      BOOST_TEST((std::isnan(d.curvedness) || (d.curvedness >= 0. && d.curvedness <= 1.)));
      BOOST_TEST((std::isnan(d.mean_curvature) || (d.mean_curvature >= 0. && d.mean_curvature <= 1.)));
    }
    BOOST_TEST(failures == missing);
  }

  Mesh broken = torus;
  broken.point(Mesh::Vertex_index(3)) = Point_3(std::nan(""), 0, 0);
  std::size_t failures = 0, missing = 0;
  for(const auto& d : descriptors(broken, SC::parameters::averaging_radius(.01), &failures))
    missing += std::isnan(d.curvedness) ? 1 : 0;
  BOOST_TEST(failures >= 1u);
  BOOST_TEST(missing == failures);
}

BOOST_AUTO_TEST_SUITE_END()
