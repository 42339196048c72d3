#include <boost/test/unit_test.hpp>

#include "estimator_checks.h"
#include "plain_triangle_tensors.h"
#include "raise_to.h"

#include <Shape_characteristics/curvature/rusinkiewicz_curvatures.h>

#include <cmath>

BOOST_AUTO_TEST_SUITE(rusinkiewicz)

using namespace estimator_checks;

namespace {

struct Rusinkiewicz
{
  template <typename Tag, typename Mesh, typename Np>
  std::size_t all(const Mesh& mesh, const Np& np) const
  {
    return SC::rusinkiewicz_curvatures<Tag>(mesh, np);
  }
  template <typename Vertex, typename Mesh, typename Np>
  SC::Estimation_status one(Vertex v, const Mesh& mesh, const Np& np) const
  {
    return SC::rusinkiewicz_curvatures(v, mesh, np);
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(equals_the_plain_implementation)
{
  for(const double jitter : {0., .2})
    for(const Analytic_surface& s : test_support::all_analytic_surfaces(jitter, 11))
    {
      const Result result = run(Rusinkiewicz(), s, Normals::EXACT);
      check_that_tips_alone_fail(s, result);
      const double unit = 1. / largest_curvature(s);
      double largest = 0.;
      for(std::size_t i = 0; i < s.points.size(); i += 7)
      {
        if(s.exact[i].singular)
          continue;
        const Eigen::Vector2d k = plain::rusinkiewicz(s, i);
        test_support::raise_to(largest, unit * std::abs(result.curvatures[i].min_curvature - k[0]),
                               unit * std::abs(result.curvatures[i].max_curvature - k[1]));
      }
      BOOST_TEST(largest < 1e-12, s.name << ": " << largest);
    }
}

// Where all normal sections of the surface are circles, the differences of exact normals are multiples of the edges.
BOOST_AUTO_TEST_CASE(exact_on_spheres_and_planes)
{
  for(const Normals normals : {Normals::EXACT, Normals::ESTIMATED}) // Max's are exact on spheres
    for(const double jitter : {0., .2})
    {
      const Errors sphere = errors(test_support::sphere(2., 3, jitter, 3),
                                   run(Rusinkiewicz(), test_support::sphere(2., 3, jitter, 3), normals), 0.);
      BOOST_TEST(sphere.largest < 1e-13);
      const Analytic_surface plane = test_support::plane(1., 12, jitter, 3);
      for(const Curvatures& c : run(Rusinkiewicz(), plane, normals).curvatures)
        BOOST_TEST((c.min_curvature == 0. && c.max_curvature == 0.));
    }
}

BOOST_AUTO_TEST_CASE(errors_per_vertex)
{
  check_errors(Rusinkiewicz(), 0., Normals::EXACT, 3., {.02, .006});
  check_errors(Rusinkiewicz(), 0., Normals::ESTIMATED, 3., {.045, .006});
  check_errors(Rusinkiewicz(), .2, Normals::EXACT, 3., {.08, .065});
  check_errors(Rusinkiewicz(), .2, Normals::ESTIMATED, 3., {.22, .1});
}

BOOST_AUTO_TEST_CASE(convergence)
{
  const auto torus = [](double jitter)
  { return [jitter](unsigned int f) { return test_support::torus(1., .4, 24 * f, 12 * f, jitter, 4); }; };
  const auto monkey_saddle = [](double jitter)
  { return [jitter](unsigned int f) { return test_support::monkey_saddle(.5, 12 * f, jitter, 4); }; };
  BOOST_TEST(convergence_order(Rusinkiewicz(), torus(0.), Normals::EXACT) > 1.8);
  BOOST_TEST(convergence_order(Rusinkiewicz(), torus(0.), Normals::ESTIMATED) > 1.8);
  BOOST_TEST(convergence_order(Rusinkiewicz(), monkey_saddle(0.), Normals::EXACT, .25) > 1.8);
  BOOST_TEST(convergence_order(Rusinkiewicz(), torus(.2), Normals::EXACT) > .8);
  BOOST_TEST(convergence_order(Rusinkiewicz(), monkey_saddle(.2), Normals::EXACT, .25) > .8);
}

BOOST_AUTO_TEST_CASE(motion_and_scale)
{
  check_motion_and_scale(Rusinkiewicz(), 1e-11);
}
BOOST_AUTO_TEST_CASE(flipped_normals)
{
  check_flip(Rusinkiewicz());
}
BOOST_AUTO_TEST_CASE(order_of_the_input)
{
  check_permutation(Rusinkiewicz());
}
BOOST_AUTO_TEST_CASE(mesh_types)
{
  check_mesh_types(Rusinkiewicz());
}
BOOST_AUTO_TEST_CASE(threads)
{
  check_threads(Rusinkiewicz());
}
BOOST_AUTO_TEST_CASE(one_vertex)
{
  check_one_vertex(Rusinkiewicz());
}
BOOST_AUTO_TEST_CASE(callback)
{
  check_callback(Rusinkiewicz());
}

BOOST_AUTO_TEST_CASE(needs_triangles)
{
  check_needs_triangles(Rusinkiewicz(), SC::parameters::default_values());
}

// a triangle without area, or with a point that is not finite, changes nothing for its neighbors' other triangles
BOOST_AUTO_TEST_CASE(useless_triangles_count_for_nothing)
{
  const Analytic_surface s = test_support::sphere(1., 2, .2, 9);
  Surface_mesh mesh = surface_mesh_of(s);
  // vertex 0 moves onto its neighbor: two of its triangles lose their area
  const Surface_mesh::Vertex_index v(0);
  const auto h = mesh.halfedge(v);
  mesh.point(v) = mesh.point(mesh.source(h));
  const Result collapsed = run(Rusinkiewicz(), mesh, s, Normals::EXACT);
  for(std::size_t i = 0; i < s.points.size(); ++i)
    BOOST_TEST(
        (std::isfinite(collapsed.curvatures[i].min_curvature) && SC::is_estimated(collapsed.status[i])));

  mesh.point(v) = Kernel::Point_3(std::nan(""), 0., 0.);
  const Result broken = run(Rusinkiewicz(), mesh, s, Normals::EXACT);
  BOOST_TEST((broken.status[0] == SC::Estimation_status::NON_FINITE_INPUT));
  BOOST_TEST(broken.failures == 1u);
  for(std::size_t i = 1; i < s.points.size(); ++i)
    BOOST_TEST(std::abs(broken.curvatures[i].min_curvature - 1.) < 1e-12);
}

BOOST_AUTO_TEST_SUITE_END()
