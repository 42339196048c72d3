#include <boost/test/unit_test.hpp>

#include "Numbered_points.h"
#include "estimator_checks.h"
#include "raise_to.h"
#include "says.h"

#include <Shape_characteristics/curvature/jet_fitting_curvatures.h>

#include <CGAL/Monge_via_jet_fitting.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(jet_fitting)

using namespace estimator_checks;

namespace {

struct Jet_fitting
{
  int degree = 4;
  unsigned int rings = 2;

  template <typename Tag, typename Mesh, typename Np>
  std::size_t all(const Mesh& mesh, const Np& np) const
  {
    return SC::jet_fitting_curvatures<Tag>(mesh, np.degree_fitting(degree).number_of_rings(rings));
  }
  template <typename Vertex, typename Mesh, typename Np>
  SC::Estimation_status one(Vertex v, const Mesh& mesh, const Np& np) const
  {
    return SC::jet_fitting_curvatures(v, mesh, np.degree_fitting(degree).number_of_rings(rings));
  }
};

struct Default_jet_fitting
{
  template <typename Tag, typename Mesh, typename Np>
  std::size_t all(const Mesh& mesh, const Np& np) const
  {
    return SC::jet_fitting_curvatures<Tag>(mesh, np);
  }
};

template <typename Extend>
Result run_on_points(const test_support::Numbered_points& points, const Extend& extend)
{
  return points.estimates([&](const auto& numbers, const auto& np)
                          { return SC::jet_fitting_curvatures<CGAL::Sequential_tag>(numbers, extend(np)); });
}

} // namespace

// CGAL's class with the same neighbors, where they are
BOOST_AUTO_TEST_CASE(equals_a_direct_call)
{
  using Monge_via_jet_fitting = CGAL::Monge_via_jet_fitting<Kernel>;
  for(const Analytic_surface& s : typical_surfaces())
    for(const int degree : {2, 3, 4})
    {
      const Surface_mesh mesh = surface_mesh_of(s);
      const Result result = run(Jet_fitting{degree, 2}, mesh, s, Normals::EXACT);
      const SC::Face_graph_samples samples =
          SC::sampled_surface<CGAL::Sequential_tag>(mesh, SC::Neighborhood::rings(2));
      SC::Face_graph_samples::Workspace workspace;
      const double unit = 1. / largest_curvature(s);
      std::size_t compared = 0;
      for(std::size_t i = 0; i < s.points.size(); ++i)
      {
        const std::size_t needed = std::size_t((degree + 1) * (degree + 2) / 2);
        std::vector<Kernel::Point_3> points(1, mesh.point(Surface_mesh::Vertex_index(std::uint32_t(i))));
        for(const auto j : samples.neighbors(i, needed - 1, workspace))
          points.push_back(mesh.point(Surface_mesh::Vertex_index(j)));
        if(points.size() < needed)
        {
          BOOST_TEST((result.status[i] == SC::Estimation_status::FEW_NEIGHBOURS));
          continue;
        }
        Monge_via_jet_fitting fit;
        auto monge = fit(points.begin(), points.end(), std::size_t(degree), 2);
        if(!(fit.condition_number() < 1e6)) // then the last digits are up to rounding errors
          continue;
        const auto& n = s.exact[i].normal;
        monge.comply_wrt_given_normal(Kernel::Vector_3(n[0], n[1], n[2]));
        BOOST_TEST_REQUIRE(SC::is_estimated(result.status[i]));
        BOOST_TEST(unit * std::abs(result.curvatures[i].min_curvature + monge.principal_curvatures(0)) <
                   1e-8);
        BOOST_TEST(unit * std::abs(result.curvatures[i].max_curvature + monge.principal_curvatures(1)) <
                   1e-8);
        const double sine = eigen(result.curvatures[i].max_direction)
                                .cross(eigen(monge.minimal_principal_direction()))
                                .norm();
        BOOST_TEST(unit * sine * (result.curvatures[i].max_curvature - result.curvatures[i].min_curvature) <
                   1e-8);
        ++compared;
      }
      BOOST_TEST(compared > s.points.size() / 2);
    }
}

BOOST_AUTO_TEST_CASE(defaults)
{
  const Analytic_surface s = test_support::monkey_saddle(.5, 10, .2, 7);
  BOOST_TEST(
      same_bits(run(Default_jet_fitting(), s, Normals::EXACT), run(Jet_fitting{4, 2}, s, Normals::EXACT)));
}

// a polynomial of the degree of the fit, on a plane that the fit finds by itself
BOOST_AUTO_TEST_CASE(exact_on_polynomials)
{
  for(const double jitter : {0., .2})
  {
    for(const Curvatures& c :
        run(Jet_fitting{4, 2}, test_support::plane(1., 12, jitter, 3), Normals::EXACT).curvatures)
      BOOST_TEST((std::abs(c.min_curvature) < 1e-12 && std::abs(c.max_curvature) < 1e-12));
    // the middle of a paraboloid with a symmetric neighborhood: the best plane is horizontal
    const Analytic_surface bowl = test_support::paraboloid(1., .5, 1., 24, 0.);
    const Result result = run(Jet_fitting{2, 2}, bowl, Normals::EXACT);
    const std::size_t middle = bowl.points.size() / 2;
    BOOST_TEST(bowl.exact[middle].k_max == -.5);
    BOOST_TEST(std::abs(result.curvatures[middle].max_curvature + .5) < 1e-12);
    BOOST_TEST(std::abs(result.curvatures[middle].min_curvature + 1.) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(errors_per_vertex)
{
  check_errors(Jet_fitting(), 0., Normals::EXACT, 4., {.014, .018});
  check_errors(Jet_fitting(), .2, Normals::EXACT, 4., {.045, .02});
}

// Beside a border, and on a grid of points, many neighbors are in few rows: more are taken.
BOOST_AUTO_TEST_CASE(few_rows)
{
  const Analytic_surface saddle = test_support::saddle(1., 20);
  const Result result = run(Default_jet_fitting(), saddle, Normals::EXACT);
  double largest = 0.;
  for(std::size_t i = 0; i < saddle.points.size(); ++i)
    test_support::raise_to(largest, std::abs(result.curvatures[i].min_curvature - saddle.exact[i].k_min),
                           std::abs(result.curvatures[i].max_curvature - saddle.exact[i].k_max));
  BOOST_TEST_MESSAGE("saddle, with its border: " << largest);
  BOOST_TEST(largest < .03);
  const Analytic_surface torus = test_support::torus(1., .4, 60, 40);
  const Errors of_points = errors(
      torus, run_on_points(test_support::Numbered_points(torus), [](const auto& np) { return np; }), 0.);
  BOOST_TEST_MESSAGE("points of a torus: " << of_points.largest);
  BOOST_TEST(of_points.largest < .03);
}

// normals only orient the result
BOOST_AUTO_TEST_CASE(normals_do_not_take_part)
{
  for(const Analytic_surface& s : typical_surfaces())
    BOOST_TEST(same_bits(run(Jet_fitting(), s, Normals::EXACT), run(Jet_fitting(), s, Normals::ESTIMATED)),
               s.name);
}

BOOST_AUTO_TEST_CASE(convergence)
{
  const auto torus = [](unsigned int f) { return test_support::torus(1., .4, 24 * f, 12 * f, .2, 4); };
  const auto monkey_saddle = [](unsigned int f) { return test_support::monkey_saddle(.5, 16 * f, .2, 4); };
  // in theory degree - 1; even degrees gain one where neighborhoods are about symmetric
  BOOST_TEST(convergence_order(Jet_fitting{2, 2}, torus, Normals::EXACT) > .9);
  BOOST_TEST(convergence_order(Jet_fitting{3, 2}, torus, Normals::EXACT) > 1.8);
  BOOST_TEST(convergence_order(Jet_fitting{4, 2}, torus, Normals::EXACT) > 2.8);
  BOOST_TEST(convergence_order(Jet_fitting{4, 2}, monkey_saddle, Normals::EXACT, .25) > 2.8);
}

BOOST_AUTO_TEST_CASE(motion_and_scale)
{
  check_motion_and_scale(Jet_fitting{3, 3}, 1e-8);
}
BOOST_AUTO_TEST_CASE(flipped_normals)
{
  check_flip(Jet_fitting());
}
BOOST_AUTO_TEST_CASE(order_of_the_input)
{
  check_permutation(Jet_fitting());
}
BOOST_AUTO_TEST_CASE(mesh_types)
{
  check_mesh_types(Jet_fitting());
}
BOOST_AUTO_TEST_CASE(threads)
{
  check_threads(Jet_fitting());
}
BOOST_AUTO_TEST_CASE(one_vertex)
{
  check_one_vertex(Jet_fitting());
}
BOOST_AUTO_TEST_CASE(callback)
{
  check_callback(Jet_fitting());
}

// 1e7 away from the origin, where coordinates have 2e-9
BOOST_AUTO_TEST_CASE(far_from_the_origin)
{
  const Analytic_surface s = test_support::torus(1., .4, 24, 12, .2, 6);
  const Analytic_surface far = transformed(s, 1., Eigen::Matrix3d::Identity(), {1e7, -1e7, 1e7});
  BOOST_TEST(difference(s, run(Jet_fitting(), s, Normals::EXACT), run(Jet_fitting(), far, Normals::EXACT), 1.,
                        Eigen::Matrix3d::Identity()) < 1e-5);
}

BOOST_AUTO_TEST_CASE(points)
{
  for(const Analytic_surface& s :
      {test_support::torus(1., .4, 48, 24, .2, 6), test_support::ellipsoid(1., .8, .6, 3, .2, 2)})
  {
    const test_support::Numbered_points points(s);
    const Result result = run_on_points(points, [](const auto& np) { return np.number_of_neighbors(24); });
    check_consistency(result);
    BOOST_TEST(result.failures == 0u);
    const Errors e = errors(s, result, 0.);
    BOOST_TEST_MESSAGE("  " << s.name << ": mean " << e.mean << ", largest " << e.largest << ", direction "
                            << e.direction);
    BOOST_TEST(e.largest < .095);

    // a ball
    const Result in_ball =
        run_on_points(points, [&](const auto& np) { return np.neighbor_radius(3. * s.mean_edge_length()); });
    BOOST_TEST(errors(s, in_ball, 0.).largest < .15);

    // the degree is never lowered
    const Result few = run_on_points(points, [](const auto& np) { return np.number_of_neighbors(13); });
    BOOST_TEST(few.failures == points.size());
    for(const SC::Estimation_status status : few.status)
      BOOST_TEST((status == SC::Estimation_status::FEW_NEIGHBOURS));
  }
}

BOOST_AUTO_TEST_CASE(points_that_determine_no_surface)
{
  const Kernel::Vector_3 up(0, 0, 1);
  test_support::Numbered_points line, spot;
  for(int i = 0; i < 30; ++i)
  {
    line.push_back(Kernel::Point_3(.1 * i, .2 * i, 0.), up);
    spot.push_back(Kernel::Point_3(1., 2., 3.), up);
  }
  const auto nearest = [](const auto& np) { return np.number_of_neighbors(20); };
  for(const SC::Estimation_status status : run_on_points(line, nearest).status)
    BOOST_TEST((status == SC::Estimation_status::DEGENERATE));
  BOOST_TEST(run_on_points(spot, nearest).failures == 30u);
}

// rows of long triangles that bend by more than they are wide: their best plane isn't that of the tangents
BOOST_AUTO_TEST_CASE(long_triangles)
{
  for(const std::size_t around : {24, 48})
  {
    const Analytic_surface s = test_support::torus(2., .7, around, 6 * around);
    const Result result = run(Jet_fitting{4, 2}, surface_mesh_of(s), s, Normals::EXACT);
    std::size_t estimated = 0;
    for(std::size_t i = 0; i < s.points.size(); ++i)
    {
      if(!SC::is_estimated(result.status[i]))
        continue;
      ++estimated;
      BOOST_TEST(std::abs(result.curvatures[i].min_curvature - s.exact[i].k_min) < .1);
      BOOST_TEST(std::abs(result.curvatures[i].max_curvature - s.exact[i].k_max) < .1);
    }
    BOOST_TEST(estimated > s.points.size() * 3 / 4);
  }
}

BOOST_AUTO_TEST_CASE(bad_parameters)
{
  const Surface_mesh mesh = surface_mesh_of(test_support::sphere(1., 1));
  for(const double degree : {-1., 0., 1., 13., 2.5, std::numeric_limits<double>::quiet_NaN()})
    BOOST_CHECK_EXCEPTION(SC::jet_fitting_curvatures(mesh, SC::parameters::degree_fitting(degree)),
                          std::invalid_argument, test_support::says("degree_fitting"));
  BOOST_CHECK_EXCEPTION(SC::jet_fitting_curvatures(std::vector<Kernel::Point_3>()), std::invalid_argument,
                        test_support::says("normal_map"));
}

BOOST_AUTO_TEST_SUITE_END()
