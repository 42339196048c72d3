#include <boost/test/unit_test.hpp>

#include "estimator_checks.h"
#include "plain_triangle_tensors.h"
#include "raise_to.h"
#include "says.h"

#include <Shape_characteristics/curvature/tangent_space_curvatures.h>

#include <cmath>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(tangent_space)

using namespace estimator_checks;
using SC::Face_weighting;

namespace {

struct Tangent_space
{
  int number_of_edges = 3;
  Face_weighting weighting = Face_weighting::UNIFORM;

  template <typename Tag, typename Mesh, typename Np>
  std::size_t all(const Mesh& mesh, const Np& np) const
  {
    return SC::tangent_space_curvatures<Tag>(mesh,
                                             np.number_of_edges(number_of_edges).face_weighting(weighting));
  }
  template <typename Vertex, typename Mesh, typename Np>
  SC::Estimation_status one(Vertex v, const Mesh& mesh, const Np& np) const
  {
    return SC::tangent_space_curvatures(v, mesh,
                                        np.number_of_edges(number_of_edges).face_weighting(weighting));
  }
};

struct Default_tangent_space
{
  template <typename Tag, typename Mesh, typename Np>
  std::size_t all(const Mesh& mesh, const Np& np) const
  {
    return SC::tangent_space_curvatures<Tag>(mesh, np);
  }
};

const std::vector<Tangent_space> variants = {{3, Face_weighting::UNIFORM},
                                             {3, Face_weighting::AREA},
                                             {2, Face_weighting::UNIFORM},
                                             {2, Face_weighting::AREA}};

} // namespace

BOOST_AUTO_TEST_CASE(equals_the_plain_implementation)
{
  for(const Tangent_space& variant : variants)
    for(const double jitter : {0., .2})
      for(const Analytic_surface& s : test_support::all_analytic_surfaces(jitter, 11))
      {
        const Result result = run(variant, s, Normals::EXACT);
        check_that_tips_alone_fail(s, result);
        const double unit = 1. / largest_curvature(s);
        double largest = 0.;
        for(std::size_t i = 0; i < s.points.size(); i += 7)
        {
          if(s.exact[i].singular)
            continue;
          const Eigen::Vector2d k =
              plain::tangent_space(s, i, variant.number_of_edges, variant.weighting == Face_weighting::AREA);
          test_support::raise_to(largest, unit * std::abs(result.curvatures[i].min_curvature - k[0]),
                                 unit * std::abs(result.curvatures[i].max_curvature - k[1]));
        }
        BOOST_TEST(largest < 1e-12, s.name << ", " << variant.number_of_edges << " edges: " << largest);
      }
}

BOOST_AUTO_TEST_CASE(defaults)
{
  const Analytic_surface s = test_support::torus(1., .4, 24, 12, .2, 6);
  BOOST_TEST(same_bits(run(Default_tangent_space(), s, Normals::EXACT),
                       run(Tangent_space{3, Face_weighting::UNIFORM}, s, Normals::EXACT)));
}

BOOST_AUTO_TEST_CASE(exact_on_spheres_and_planes)
{
  for(const Tangent_space& variant : variants)
    for(const Normals normals : {Normals::EXACT, Normals::ESTIMATED})
      for(const double jitter : {0., .2})
      {
        const Analytic_surface sphere = test_support::sphere(2., 3, jitter, 3);
        BOOST_TEST(errors(sphere, run(variant, sphere, normals), 0.).largest < 1e-13);
        for(const Curvatures& c : run(variant, test_support::plane(1., 12, jitter, 3), normals).curvatures)
          BOOST_TEST((c.min_curvature == 0. && c.max_curvature == 0.));
      }
}

// The largest errors are at umbilics, around which the mean of eigenvalues isn't the eigenvalue of a mean.
BOOST_AUTO_TEST_CASE(errors_per_vertex)
{
  for(const Tangent_space& variant : variants)
  {
    BOOST_TEST_MESSAGE(" " << variant.number_of_edges << " edges, weights " << int(variant.weighting));
    check_errors(variant, 0., Normals::EXACT, 3., {.08, .016});
    check_errors(variant, 0., Normals::ESTIMATED, 3., {.08, .016});
    check_errors(variant, .2, Normals::EXACT, 3., {.11, .09});
    check_errors(variant, .2, Normals::ESTIMATED, 3., {.27, .12});
  }
}

BOOST_AUTO_TEST_CASE(convergence)
{
  const auto torus = [](double jitter)
  { return [jitter](unsigned int f) { return test_support::torus(1., .4, 24 * f, 12 * f, jitter, 4); }; };
  const auto ellipsoid = [](unsigned int f)
  { return test_support::ellipsoid(1., .8, .6, f == 1 ? 2 : 4, .2, 4); };
  for(const Tangent_space& variant : variants)
  {
    // two edges of regular triangles are no symmetric choice: they lose an order
    const bool symmetric = variant.number_of_edges == 3;
    BOOST_TEST(convergence_order(variant, torus(0.), Normals::EXACT) > (symmetric ? 1.8 : .8));
    BOOST_TEST(convergence_order(variant, torus(.2), Normals::EXACT) > .8);
    BOOST_TEST(convergence_order(variant, ellipsoid, Normals::EXACT) > .8);
  }
}

BOOST_AUTO_TEST_CASE(motion_and_scale)
{
  // which two edges are used depends on the direction of the axes
  check_motion_and_scale(Tangent_space{3, Face_weighting::UNIFORM}, 1e-11);
  check_motion_and_scale(Tangent_space{3, Face_weighting::AREA}, 1e-11);
}
BOOST_AUTO_TEST_CASE(flipped_normals)
{
  for(const Tangent_space& variant : variants)
    check_flip(variant);
}
BOOST_AUTO_TEST_CASE(order_of_the_input)
{
  for(const Tangent_space& variant : variants)
    check_permutation(variant);
}
BOOST_AUTO_TEST_CASE(mesh_types)
{
  check_mesh_types(Tangent_space());
}
BOOST_AUTO_TEST_CASE(threads)
{
  check_threads(Tangent_space());
}
BOOST_AUTO_TEST_CASE(one_vertex)
{
  for(const Tangent_space& variant : variants)
    check_one_vertex(variant);
}
BOOST_AUTO_TEST_CASE(callback)
{
  check_callback(Tangent_space());
}

BOOST_AUTO_TEST_CASE(bad_parameters)
{
  const Surface_mesh mesh = surface_mesh_of(test_support::sphere(1., 1));
  for(const int edges : {-1, 0, 1, 4})
  {
    BOOST_CHECK_EXCEPTION(SC::tangent_space_curvatures(mesh, SC::parameters::number_of_edges(edges)),
                          std::invalid_argument, test_support::says("number_of_edges"));
    BOOST_CHECK_EXCEPTION(
        SC::tangent_space_curvatures(*vertices(mesh).begin(), mesh, SC::parameters::number_of_edges(edges)),
        std::invalid_argument, test_support::says("number_of_edges"));
  }
  BOOST_CHECK_NO_THROW(SC::tangent_space_curvatures(mesh, SC::parameters::number_of_edges(2u)));
}

BOOST_AUTO_TEST_SUITE_END()
