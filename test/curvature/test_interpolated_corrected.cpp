#include <boost/test/unit_test.hpp>

#include <Shape_characteristics/curvature/interpolated_corrected_curvatures.h>

#ifdef SHAPE_CHARACTERISTICS_HAS_INTERPOLATED_CORRECTED_CURVATURES
#include "estimator_checks.h"
#include "raise_to.h"
#include "says.h"

#include <CGAL/Polygon_mesh_processing/interpolated_corrected_curvatures.h>

#include <cmath>
#include <stdexcept>
#include <vector>
#endif

BOOST_AUTO_TEST_SUITE(interpolated_corrected)

#ifndef SHAPE_CHARACTERISTICS_HAS_INTERPOLATED_CORRECTED_CURVATURES

BOOST_AUTO_TEST_CASE(skipped)
{
  BOOST_TEST_MESSAGE("  skipped: CGAL 6 has this estimator, this CGAL hasn't");
}

#else

using namespace estimator_checks;

namespace {

struct Interpolated_corrected
{
  double ball_radius = -1.;

  template <typename Tag, typename Mesh, typename Np>
  std::size_t all(const Mesh& mesh, const Np& np) const
  {
    return SC::interpolated_corrected_curvatures<Tag>(mesh, np.ball_radius(ball_radius));
  }
  template <typename Vertex, typename Mesh, typename Np>
  SC::Estimation_status one(Vertex v, const Mesh& mesh, const Np& np) const
  {
    return SC::interpolated_corrected_curvatures(v, mesh, np.ball_radius(ball_radius));
  }
};

} // namespace

// CGAL's function, called directly with a mean edge of 1
BOOST_AUTO_TEST_CASE(equals_a_direct_call)
{
  for(const Analytic_surface& original : typical_surfaces())
  {
    const Analytic_surface s =
        transformed(original, 1. / original.mean_edge_length(), Eigen::Matrix3d::Identity(), {0., 0., 0.});
    for(const double radius : {-1., 1.7})
    {
      Surface_mesh mesh = surface_mesh_of(s);
      auto normals = mesh.add_property_map<Surface_mesh::Vertex_index, Kernel::Vector_3>("v:n").first;
      for(const auto v : mesh.vertices())
        normals[v] = {s.exact[v].normal[0], s.exact[v].normal[1], s.exact[v].normal[2]};
      auto mean = mesh.add_property_map<Surface_mesh::Vertex_index, double>("v:H").first;
      auto Gaussian = mesh.add_property_map<Surface_mesh::Vertex_index, double>("v:K").first;
      using Principal = CGAL::Polygon_mesh_processing::Principal_curvatures_and_directions<Kernel>;
      auto principal = mesh.add_property_map<Surface_mesh::Vertex_index, Principal>("v:k").first;
      CGAL::Polygon_mesh_processing::interpolated_corrected_curvatures(
          mesh, CGAL::parameters::vertex_normal_map(normals)
                    .ball_radius(radius)
                    .vertex_mean_curvature_map(mean)
                    .vertex_Gaussian_curvature_map(Gaussian)
                    .vertex_principal_curvatures_and_directions_map(principal));

      const Result result = run(Interpolated_corrected{radius}, mesh, s, Normals::EXACT);
      BOOST_TEST(result.failures == 0u);
      const double unit = 1. / largest_curvature(s);
      double measured = 0., eigenvalues = 0.;
      for(const auto v : mesh.vertices())
      {
        test_support::raise_to(measured, unit * std::abs(result.mean[v] - mean[v]),
                               unit * unit * std::abs(result.Gaussian[v] - Gaussian[v]));
        test_support::raise_to(
            eigenvalues, unit * std::abs(result.curvatures[v].min_curvature - principal[v].min_curvature),
            unit * std::abs(result.curvatures[v].max_curvature - principal[v].max_curvature));
      }
      BOOST_TEST_MESSAGE("  " << s.name << ", radius " << radius << ": mean and Gaussian " << measured
                              << ", principal " << eigenvalues);
      // the measures are the same; the principal curvatures differ by how far the normal's eigenvector is off
      BOOST_TEST(measured < 1e-12);
      BOOST_TEST(eigenvalues < .02);
    }
  }
}

BOOST_AUTO_TEST_CASE(signs_and_exact_values)
{
  for(const double jitter : {0., .2})
  {
    const Result sphere =
        run(Interpolated_corrected(), test_support::sphere(2., 3, jitter, 3), Normals::EXACT);
    for(std::size_t i = 0; i < sphere.mean.size(); ++i)
    {
      BOOST_TEST(std::abs(sphere.mean[i] - .5) < 1e-13);
      BOOST_TEST(std::abs(sphere.Gaussian[i] - .25) < 1e-13);
      BOOST_TEST(std::abs(sphere.curvatures[i].min_curvature - .5) < .005);
    }
    for(const Curvatures& c :
        run(Interpolated_corrected(), test_support::plane(1., 12, jitter, 3), Normals::EXACT).curvatures)
      BOOST_TEST((c.min_curvature == 0. && c.max_curvature == 0.));
  }
}

BOOST_AUTO_TEST_CASE(errors_per_vertex)
{
  check_errors(Interpolated_corrected(), 0., Normals::EXACT, 3., {.03, .01}, false);
  check_errors(Interpolated_corrected(), 0., Normals::ESTIMATED, 3., {.05, .01}, false);
  check_errors(Interpolated_corrected(), .2, Normals::EXACT, 3., {.1, .08}, false);
  check_errors(Interpolated_corrected(), .2, Normals::ESTIMATED, 3., {.22, .1}, false);
}

BOOST_AUTO_TEST_CASE(convergence)
{
  const auto torus = [](double jitter)
  { return [jitter](unsigned int f) { return test_support::torus(1., .4, 24 * f, 12 * f, jitter, 4); }; };
  const auto monkey_saddle = [](double jitter)
  { return [jitter](unsigned int f) { return test_support::monkey_saddle(.5, 12 * f, jitter, 4); }; };
  BOOST_TEST(convergence_order(Interpolated_corrected(), torus(0.), Normals::EXACT) > 1.8);
  BOOST_TEST(convergence_order(Interpolated_corrected(), monkey_saddle(0.), Normals::EXACT, .25) > 1.8);
  BOOST_TEST(convergence_order(Interpolated_corrected(), torus(.2), Normals::EXACT) > .8);
  BOOST_TEST(convergence_order(Interpolated_corrected(), monkey_saddle(.2), Normals::EXACT, .25) > .8);
}

// CGAL's own results change beyond recognition with the unit of length
BOOST_AUTO_TEST_CASE(motion_and_scale)
{
  check_motion_and_scale(Interpolated_corrected(), 1e-6);
}

BOOST_AUTO_TEST_CASE(concave_creases)
{
  // a sharp valley: curvature of about pi / 2 per edge across it, by far the largest eigenvalue with wrong units
  for(const double scale : {1e-6, 1., 1e6})
  {
    Surface_mesh mesh;
    std::vector<Surface_mesh::Vertex_index> v;
    for(int i = -1; i <= 1; ++i)
      for(int j = 0; j < 5; ++j)
        v.push_back(mesh.add_vertex(Kernel::Point_3(scale * i, scale * j, scale * 3. * std::abs(i))));
    for(std::size_t i = 0; i < 2; ++i)
      for(std::size_t j = 0; j < 4; ++j)
      {
        mesh.add_face(v[5 * i + j], v[5 * i + 5 + j], v[5 * i + 6 + j]);
        mesh.add_face(v[5 * i + j], v[5 * i + 6 + j], v[5 * i + 1 + j]);
      }
    Curvatures c;
    const SC::Estimation_status status = SC::interpolated_corrected_curvatures(
        v[7], mesh, SC::parameters::vertex_principal_curvatures_and_directions(std::ref(c)));
    BOOST_TEST((status == SC::Estimation_status::ESTIMATED));
    BOOST_TEST(c.min_curvature * scale < -.3);
    BOOST_TEST(std::abs(c.max_curvature) * scale < 1e-5);
    BOOST_TEST(std::abs(c.min_direction.x()) > .999);
  }
}

BOOST_AUTO_TEST_CASE(flipped_normals)
{
  check_flip(Interpolated_corrected());
}
BOOST_AUTO_TEST_CASE(order_of_the_input)
{
  check_permutation(Interpolated_corrected());
  check_permutation(Interpolated_corrected{.3});
}
BOOST_AUTO_TEST_CASE(mesh_types)
{
  check_mesh_types(Interpolated_corrected());
}
BOOST_AUTO_TEST_CASE(threads)
{
  check_threads(Interpolated_corrected());
}
BOOST_AUTO_TEST_CASE(one_vertex)
{
  check_one_vertex(Interpolated_corrected());
  check_one_vertex(Interpolated_corrected{.3});
}
BOOST_AUTO_TEST_CASE(callback)
{
  check_callback(Interpolated_corrected());
}

BOOST_AUTO_TEST_CASE(bad_parameters)
{
  const Surface_mesh mesh = surface_mesh_of(test_support::sphere(1., 1));
  for(const double radius : {0., -2., std::nan(""), HUGE_VAL})
    BOOST_CHECK_EXCEPTION(SC::interpolated_corrected_curvatures(mesh, SC::parameters::ball_radius(radius)),
                          std::invalid_argument, test_support::says("ball_radius"));
}

#endif

BOOST_AUTO_TEST_SUITE_END()
