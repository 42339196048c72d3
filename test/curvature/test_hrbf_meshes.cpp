#include <boost/test/unit_test.hpp>

#include "Numbered_points.h"
#include "hrbf_estimator.h"
#include "raise_to.h"
#include "says.h"

#include <Shape_characteristics/interpolation/Polyharmonic.h>
#include <Shape_characteristics/interpolation/fit_hermite_rbf.h>
#include <Shape_characteristics/normals/sampled_surface.h>

#include <boost/property_map/function_property_map.hpp>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(hrbf_meshes)

namespace SC = Shape_characteristics;
using namespace estimator_checks;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;

namespace {

// With given normals `exact` is set or not; without, they are estimated. The level of noise is given where results are
// compared that see different surroundings.
const Hrbf by_default{[](const auto& np) { return np.number_of_rings(2u); }};
const Hrbf exact{[](const auto& np) { return np.normals_are_exact(true); }};
const Hrbf exact_own{[](const auto& np) { return np.normals_are_exact(true).fits_are_shared(false); }};
const Hrbf in_ball{[](const auto& np)
                   { return np.normals_are_exact(true).fits_are_shared(false).neighbor_radius(.5); }};
const Hrbf with_level{[](const auto& np) { return np.noise_level(1e-3).number_of_passes(2u); }};
const Hrbf with_level_own{[](const auto& np)
                          { return np.noise_level(1e-3).number_of_passes(4u).fits_are_shared(false); }};
const Hrbf cubic{[](const auto& np) { return np.radial_basis_function(SC::Polyharmonic<3>()); }};

const Hrbf cubic_exact{[](const auto& np)
                       { return np.normals_are_exact(true).radial_basis_function(SC::Polyharmonic<3>()); }};

template <typename Extend>
Result run_on_points(const Hrbf<Extend>& estimator, const test_support::Numbered_points& points)
{
  return points.estimates([&](const auto& numbers, const auto& np)
                          { return estimator.template all<CGAL::Sequential_tag>(numbers, np); });
}

// the largest, of what `run` estimates on a surface
template <typename Run>
double change_when_scaled(const Analytic_surface& s, const Run& run)
{
  const Result original = run(s);
  double largest = 0.;
  for(const double scale : {1e-6, 1e6, 3.})
    test_support::raise_to(
        largest, difference(s, original,
                            run(transformed(s, scale, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero())),
                            scale, Eigen::Matrix3d::Identity()));
  return largest;
}

} // namespace

// The systems are nearly singular (that is why they are accurate). Factors that are powers of two have no rounding errors, see below.
BOOST_AUTO_TEST_CASE(motion_and_scale)
{
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1., 2., -1.5).normalized()).toRotationMatrix();
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  const auto check = [&](const char* name, const auto& estimator, Normals normals, double tolerance)
  {
    double largest = 0.;
    for(const Analytic_surface& s : typical_surfaces())
    {
      const Result original = run(estimator, s, normals);
      const auto compare = [&](double scale, const Eigen::Matrix3d& r, const Eigen::Vector3d& shift)
      {
        test_support::raise_to(
            largest,
            difference(s, original, run(estimator, transformed(s, scale, r, shift), normals), scale, r));
      };
      compare(1., rotation, {3., -5., 2.});
      for(const double scale : {1e-6, 1e6, 1e-100, 1e100})
        compare(scale, identity, Eigen::Vector3d::Zero());
    }
    BOOST_TEST_MESSAGE(name << ": moved, turned or scaled, the curvatures differ by " << largest);
    BOOST_TEST(largest < tolerance, name);
  };
  check("exact", exact, Normals::EXACT, 1e-9);
  check("default, given normals", by_default, Normals::EXACT, 1e-9);
  check("default", by_default, Normals::ESTIMATED, 1e-9);
  check("noise level 0.001", with_level, Normals::ESTIMATED, 1e-9);
  check("r^3, exact", cubic_exact, Normals::EXACT, 1e-9);
}

// Graphs of functions as point sets, coarse and fine. At their borders, and most so in their corners, neighbors lie on one side:
// weights are large.
BOOST_AUTO_TEST_CASE(scale_of_open_point_sets)
{
  for(const std::size_t n : {6, 16, 40})
    for(const Analytic_surface& s :
        {test_support::waves(.1, 4., 1., n, .2, 3), test_support::monkey_saddle(.5, n, .2, 3)})
      for(const std::size_t neighbors : {18, 36})
        for(const bool are_exact : {true, false})
        {
          const double largest = change_when_scaled(
              s,
              [&](const Analytic_surface& surface)
              {
                return run_on_points(Hrbf{[&](const auto& np) {
                                       return np.number_of_neighbors(neighbors).normals_are_exact(are_exact);
                                     }},
                                     test_support::Numbered_points(surface));
              });
          BOOST_TEST_MESSAGE(s.name << ", " << s.points.size() << " points, " << neighbors << " neighbors"
                                    << (are_exact ? ", exact" : "") << ": changed by " << largest);
          BOOST_TEST(largest < 1e-9);
        }
}

// Over rings, weights are as large in places, and only the largest are found with more digits.
BOOST_AUTO_TEST_CASE(scale_of_rings)
{
  double largest[2] = {0., 0.};
  for(const std::size_t n : {16, 40})
    for(const Analytic_surface& s :
        {test_support::waves(.1, 4., 1., n, .2, 3), test_support::monkey_saddle(.5, n, .2, 3)})
      for(const unsigned int rings : {2u, 3u})
        for(const bool are_exact : {true, false})
        {
          const Hrbf estimator{[&](const auto& np)
                               { return np.number_of_rings(rings).normals_are_exact(are_exact); }};
          const double change = change_when_scaled(
              s, [&](const Analytic_surface& surface)
              { return run(estimator, surface, are_exact ? Normals::EXACT : Normals::ESTIMATED); });
          BOOST_TEST_MESSAGE(s.name << ", " << s.points.size() << " points, " << rings << " rings"
                                    << (are_exact ? ", exact" : "") << ": changed by " << change);
          test_support::raise_to(largest[are_exact], change);
        }
  BOOST_TEST(largest[false] < 1e-8);
  BOOST_TEST(largest[true] < 5e-8);
}

// The neighbors of a border vertex are on one side. Two rings of them are few; so rings grow there.
BOOST_AUTO_TEST_CASE(borders)
{
  for(const Analytic_surface& s : {test_support::saddle(1., 24, .3), test_support::waves(.1, 2., 1., 32, .3),
                                   test_support::monkey_saddle(.5, 24, .3)})
  {
    const Result result = run(by_default, s, Normals::ESTIMATED);
    double sum = 0., count = 0.;
    for(std::size_t i = 0; i < s.exact.size(); ++i)
      if(const Exact_vertex& e = s.exact[i]; e.border)
      {
        BOOST_TEST((result.status[i] == SC::Estimation_status::BORDER));
        const Curvatures& c = result.curvatures[i];
        sum += std::abs(c.min_curvature - e.k_min) + std::abs(c.max_curvature - e.k_max);
        count += 1.;
      }
    const double error = sum / (count * largest_curvature(s));
    BOOST_TEST_MESSAGE(s.name << ": error at the border " << error);
    BOOST_TEST(error < .003);
  }
}

// to the last bit
BOOST_AUTO_TEST_CASE(powers_of_two)
{
  const auto check = [](const auto& estimator, Normals normals)
  {
    for(const Analytic_surface& s : typical_surfaces())
    {
      const Result original = run(estimator, s, normals);
      for(const double scale : {std::ldexp(1., -100), .5, std::ldexp(1., 100)})
      {
        Result scaled = run(
            estimator, transformed(s, scale, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()), normals);
        for(std::size_t i = 0; i < s.points.size(); ++i)
        {
          scaled.curvatures[i].min_curvature *= scale;
          scaled.curvatures[i].max_curvature *= scale;
          scaled.mean[i] *= scale;
          scaled.Gaussian[i] *= scale * scale;
        }
        BOOST_TEST(same_bits(original, scaled), s.name << ", scale " << scale);
      }
    }
  };
  check(exact, Normals::EXACT);
  check(by_default, Normals::ESTIMATED);
  check(cubic, Normals::ESTIMATED);
}

BOOST_AUTO_TEST_CASE(flip)
{
  check_flip(exact);
  check_flip(by_default);
  check_flip(cubic);
}

BOOST_AUTO_TEST_CASE(permutation)
{
  check_permutation(exact_own);
  check_permutation(with_level_own);
}

BOOST_AUTO_TEST_CASE(mesh_types)
{
  check_mesh_types(exact);
  check_mesh_types(by_default);
}

BOOST_AUTO_TEST_CASE(one_vertex)
{
  check_one_vertex(exact_own);
  check_one_vertex(in_ball);
  check_one_vertex(with_level_own);
}

BOOST_AUTO_TEST_CASE(callback)
{
  check_callback(exact);
}

// where the ball of the points is that of the mesh
BOOST_AUTO_TEST_CASE(point_set_equals_mesh)
{
  const Analytic_surface s = test_support::ellipsoid(1., .8, .6, 3, .2, 5);
  const Surface_mesh mesh = surface_mesh_of(s);
  const test_support::Numbered_points points(s);
  const double radius = 2.2 * s.mean_edge_length();
  for(const bool are_exact : {true, false})
  {
    const Hrbf ball{[&](const auto& np) {
      return np.normals_are_exact(are_exact).fits_are_shared(false).neighbor_radius(radius);
    }};
    BOOST_TEST(same_bits(run(ball, mesh, s, Normals::EXACT), run_on_points(ball, points)));
  }
}

BOOST_AUTO_TEST_CASE(point_sets_are_accurate)
{
  for(const Analytic_surface& s :
      {test_support::sphere(2., 3, .2, 5), test_support::torus(1., .4, 48, 24, .2, 5)})
  {
    const test_support::Numbered_points points(s);
    const auto check = [&](const char* name, double bound, const auto& extend)
    {
      const Result result = run_on_points(Hrbf{extend}, points);
      check_consistency(result);
      const Errors e = errors(s, result, 0.);
      BOOST_TEST_MESSAGE(s.name << ", " << name << ": largest error " << e.largest);
      BOOST_TEST(e.largest < bound);
    };
    const auto own = [](const auto& np) { return np.fits_are_shared(false); };
    const auto exact_own = [](const auto& np) { return np.fits_are_shared(false).normals_are_exact(true); };
    check("shared, 18 neighbors, exact", 5e-4, [](const auto& np) { return np.normals_are_exact(true); });
    check("shared, 18 neighbors", .06, [](const auto& np) { return np; });
    check("18 neighbors, exact", 3e-4, exact_own);
    check("12 neighbors, exact", 2e-3,
          [&](const auto& np) { return exact_own(np).number_of_neighbors(12u); });
    check("ball, exact", 3e-4,
          [&](const auto& np) { return exact_own(np).neighbor_radius(2.2 * s.mean_edge_length()); });
    check("18 neighbors", .015, own);
    check("r^3, exact", .1,
          [&](const auto& np) { return exact_own(np).radial_basis_function(SC::Polyharmonic<3>()); });
  }
}

namespace {

// what CGAL 6 has under the name of Principal_curvatures_and_directions
struct Other_curvatures
{
  double min_curvature = 0., max_curvature = 0.;
  Vector_3 min_direction = CGAL::NULL_VECTOR, max_direction = CGAL::NULL_VECTOR;

  Other_curvatures() = default;
  Other_curvatures(double min, double max, const Vector_3& min_direction, const Vector_3& max_direction)
    : min_curvature(min),
      max_curvature(max),
      min_direction(min_direction),
      max_direction(max_direction)
  {}
};

} // namespace

BOOST_AUTO_TEST_CASE(outputs)
{
  const Analytic_surface s = test_support::monkey_saddle(.5, 8, .2, 7);
  Surface_mesh mesh = surface_mesh_of(s);
  const Result expected = run(by_default, mesh, s, Normals::ESTIMATED);

  // each by itself, of types of their own
  std::vector<Other_curvatures> curvatures(num_vertices(mesh));
  const auto index = boost::make_function_property_map<Surface_mesh::Vertex_index>(
      [](const Surface_mesh::Vertex_index v) { return std::size_t(v); });
  SC::hrbf_curvatures(mesh, SC::parameters::vertex_principal_curvatures_and_directions_map(
                                boost::make_iterator_property_map(curvatures.begin(), index)));
  std::vector<float> mean(num_vertices(mesh)), Gaussian(num_vertices(mesh));
  SC::hrbf_curvatures(mesh, SC::parameters::vertex_mean_curvature_map(
                                boost::make_iterator_property_map(mean.begin(), index)));
  SC::hrbf_curvatures(mesh, SC::parameters::vertex_Gaussian_curvature_map(
                                boost::make_iterator_property_map(Gaussian.begin(), index)));
  BOOST_TEST(SC::hrbf_curvatures(mesh) == 0u);
  for(std::size_t i = 0; i < curvatures.size(); ++i)
  {
    BOOST_TEST(curvatures[i].min_curvature == expected.curvatures[i].min_curvature);
    BOOST_TEST(curvatures[i].max_curvature == expected.curvatures[i].max_curvature);
    BOOST_TEST(curvatures[i].min_direction == expected.curvatures[i].min_direction);
    BOOST_TEST(curvatures[i].max_direction == expected.curvatures[i].max_direction);
    BOOST_TEST(mean[i] == float(expected.mean[i]));
    BOOST_TEST(Gaussian[i] == float(expected.Gaussian[i]));
  }
  // border is said to be border
  for(const auto v : vertices(mesh))
    BOOST_TEST((expected.status[v.idx()] ==
                (mesh.is_border(v) ? SC::Estimation_status::BORDER : SC::Estimation_status::ESTIMATED)));
  // a vertex into another type
  Other_curvatures other;
  const auto v = *vertices(mesh).begin();
  Curvatures ours;
  BOOST_TEST((SC::hrbf_curvatures(
                  v, mesh, SC::parameters::vertex_principal_curvatures_and_directions(std::ref(other))) ==
              SC::Estimation_status::BORDER));
  SC::hrbf_curvatures(v, mesh, SC::parameters::vertex_principal_curvatures_and_directions(std::ref(ours)));
  BOOST_TEST(other.max_curvature == ours.max_curvature);
  BOOST_TEST(other.min_direction == ours.min_direction);
}

// a cancelled computation has no values
BOOST_AUTO_TEST_CASE(cancelled)
{
  const Analytic_surface s = test_support::torus(1., .4, 64, 32, .2, 6);
  for(const int stop : {0, 2, 5}) // 4 patches a pass: within the first pass, within the second
  {
    int calls = 0;
    const Hrbf stopped{[&](const auto& np) {
      return np.noise_level(1e-3).number_of_passes(2u).callback([&](double) { return calls++ < stop; });
    }};
    const Result result = run(stopped, s, Normals::ESTIMATED);
    check_consistency(result);
    BOOST_TEST(calls == stop + 1);
    std::size_t cancelled = 0;
    for(const auto status : result.status)
      cancelled += status == SC::Estimation_status::CANCELLED;
    BOOST_TEST(cancelled == result.failures);
    const std::size_t done = stop < 4 ? 0u : std::size_t(stop + 1 - 4) * 512u;
    BOOST_TEST(cancelled == s.points.size() - done);
  }
}

BOOST_AUTO_TEST_CASE(fits_of_the_first_samples)
{
  const Surface_mesh mesh = surface_mesh_of(test_support::torus(1., .4, 24, 12, .2, 3));
  SC::Face_graph_samples surface = SC::sampled_surface(mesh, SC::Neighborhood::rings(2));
  const auto first_fits = [&](const std::size_t size)
  {
    return SC::fit_hermite_rbf<CGAL::Sequential_tag, double>(
        surface, size,
        [](const std::size_t, const SC::Local_implicit_surface& local)
        { return local.displacement.norm() + local.hessian.norm(); },
        SC::parameters::noise_level(1e-3).number_of_passes(1u));
  };
  const std::vector<double> all = first_fits(surface.size()), some = first_fits(7);
  BOOST_TEST(all[0] > 0.);
  BOOST_TEST(some == std::vector<double>(all.begin(), all.begin() + 7), boost::test_tools::per_element());
  BOOST_TEST(first_fits(0).empty());
  BOOST_CHECK_EXCEPTION(first_fits(surface.size() + 1), std::invalid_argument,
                        test_support::says("fit_hermite_rbf()"));
}

BOOST_AUTO_TEST_CASE(wrong_arguments_throw)
{
  const Analytic_surface s = test_support::sphere(1., 1);
  const Surface_mesh mesh = surface_mesh_of(s);
  const double quiet_nan = std::numeric_limits<double>::quiet_NaN();
  using test_support::says;
  const auto vertex = *vertices(mesh).begin();
  using namespace SC::parameters;
  BOOST_CHECK_EXCEPTION(SC::hrbf_curvatures(mesh, radial_basis_function(SC::Polyharmonic<4>())),
                        std::invalid_argument, says("radial_basis_function"));
  BOOST_CHECK_EXCEPTION(SC::hrbf_curvatures(vertex, mesh, radial_basis_function(SC::Polyharmonic<4>())),
                        std::invalid_argument, says("radial_basis_function"));
  for(const int rings : {0, -1})
  {
    BOOST_CHECK_EXCEPTION(SC::hrbf_curvatures(mesh, number_of_rings(rings)), std::invalid_argument,
                          says("number_of_rings"));
    BOOST_CHECK_EXCEPTION(SC::hrbf_curvatures(vertex, mesh, number_of_rings(rings)), std::invalid_argument,
                          says("number_of_rings"));
  }
  for(const double radius : {0., -1., quiet_nan, std::numeric_limits<double>::infinity()})
    BOOST_CHECK_EXCEPTION(SC::hrbf_curvatures(mesh, neighbor_radius(radius)), std::invalid_argument,
                          says("neighbor_radius"));
  for(const double level : {-1., quiet_nan, std::numeric_limits<double>::infinity()})
    BOOST_CHECK_EXCEPTION(SC::hrbf_curvatures(mesh, noise_level(level)), std::invalid_argument,
                          says("noise_level"));
  BOOST_CHECK_EXCEPTION(SC::hrbf_curvatures(mesh, radial_basis_function(SC::Polyharmonic<1>())),
                        std::invalid_argument, says("radial_basis_function"));
  for(const int degree : {-2, 9})
    BOOST_CHECK_EXCEPTION(SC::hrbf_curvatures(mesh, polynomial_degree(degree)), std::invalid_argument,
                          says("polynomial_degree"));
  for(const double distance : {0., -1., 2., quiet_nan})
    BOOST_CHECK_EXCEPTION(SC::hrbf_curvatures(mesh, sampling_distance(distance)), std::invalid_argument,
                          says("sampling_distance"));

  std::vector<Point_3> points;
  for(const auto& p : s.points)
    points.emplace_back(p[0], p[1], p[2]);
  BOOST_CHECK_EXCEPTION(SC::hrbf_curvatures(points), std::invalid_argument, says("normal_map"));
  const test_support::Numbered_points numbered(s);
  BOOST_CHECK_EXCEPTION(
      run_on_points(Hrbf{[](const auto& np) { return np.number_of_neighbors(0); }}, numbered),
      std::invalid_argument, says("number_of_neighbors"));
  BOOST_CHECK_EXCEPTION(
      run_on_points(Hrbf{[&](const auto& np) { return np.neighbor_radius(quiet_nan); }}, numbered),
      std::invalid_argument, says("neighbor_radius"));
}

BOOST_AUTO_TEST_SUITE_END()
