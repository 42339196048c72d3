#include <boost/test/unit_test.hpp>

#include "estimator_checks.h"
#include "plain_triangle_tensors.h"
#include "raise_to.h"

#include <Shape_characteristics/curvature/meyer_curvatures.h>
#include <Shape_characteristics/curvature/taubin_curvatures.h>
#include <Shape_characteristics/curvature/theisel_curvatures.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_type_config.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(one_ring_estimators)

// The estimators that look at the triangles at a vertex and nothing else: Theisel's, Meyer's and Taubin's.
using namespace estimator_checks;

namespace {

enum class Method
{
  THEISEL,
  MEYER,
  TAUBIN
};

// One type for all three: what the checks instantiate is compiled once.
struct One_ring_estimator
{
  Method method;

  template <typename Tag, typename Mesh, typename Np>
  std::size_t all(const Mesh& mesh, const Np& np) const
  {
    switch(method)
    {
    case Method::THEISEL:
      return SC::theisel_curvatures<Tag>(mesh, np);
    case Method::MEYER:
      return SC::meyer_curvatures<Tag>(mesh, np);
    default:
      return SC::taubin_curvatures<Tag>(mesh, np);
    }
  }
  template <typename Vertex, typename Mesh, typename Np>
  SC::Estimation_status one(Vertex v, const Mesh& mesh, const Np& np) const
  {
    switch(method)
    {
    case Method::THEISEL:
      return SC::theisel_curvatures(v, mesh, np);
    case Method::MEYER:
      return SC::meyer_curvatures(v, mesh, np);
    default:
      return SC::taubin_curvatures(v, mesh, np);
    }
  }
};

const One_ring_estimator theisel{Method::THEISEL}, meyer{Method::MEYER}, taubin{Method::TAUBIN};
const std::array<One_ring_estimator, 3> all_methods = {theisel, meyer, taubin};

// Theisel's mean curvature as the paper writes it, with the point at the vertex, and the mean over the triangles
double plain_theisel(const Analytic_surface& s, std::size_t vertex)
{
  double H = 0., weights = 0.;
  for(const plain::Corner& c : plain::corners_at(s, vertex))
  {
    const Eigen::Vector3d &n0 = c.normals[0], &n1 = c.normals[1], &n2 = c.normals[2];
    const Eigen::Vector3d m = (c.points[1] - c.points[0]).cross(c.points[2] - c.points[0]);
    const Eigen::Vector3d h = n0.cross(c.points[1] - c.points[2]) + n1.cross(c.points[2] - c.points[0]) +
                              n2.cross(c.points[0] - c.points[1]);
    const double weight = plain::mixed_area(c.points) * n0.dot(m) / m.norm();
    H += weight * .5 * n0.dot(h) / n0.dot(m);
    weights += weight;
  }
  return H / weights;
}

struct Plain_meyer
{
  double H, K, area;
};

Plain_meyer plain_meyer(const Analytic_surface& s, std::size_t vertex)
{
  const auto angle = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b)
  { return std::acos(a.normalized().dot(b.normalized())); };
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double angles = 0., area = 0.;
  for(const plain::Corner& c : plain::corners_at(s, vertex))
  {
    const Eigen::Vector3d &p = c.points[0], &q = c.points[1], &r = c.points[2];
    sum += (p - q) / std::tan(angle(p - r, q - r)) + (p - r) / std::tan(angle(p - q, r - q));
    angles += angle(q - p, r - p);
    area += plain::mixed_area(c.points);
  }
  return {sum.dot(eigen(s.exact[vertex].normal)) / (4. * area), (2. * CGAL_PI - angles) / area, area};
}

// the eigenvalues of Taubin's 3 x 3 matrix
Eigen::Vector2d plain_taubin(const Analytic_surface& s, std::size_t vertex)
{
  const Eigen::Vector3d n = eigen(s.exact[vertex].normal);
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  double weights = 0.;
  for(const plain::Corner& c : plain::corners_at(s, vertex))
    for(const std::size_t k : {1u, 2u})
    {
      const double area = (c.points[1] - c.points[0]).cross(c.points[2] - c.points[0]).norm();
      const Eigen::Vector3d d = c.points[k] - c.points[0];
      const Eigen::Vector3d t = (d - n.dot(d) * n).normalized();
      matrix -= area * 2. * n.dot(d) / d.squaredNorm() * t * t.transpose();
      weights += area;
    }
  const Eigen::Vector2d m = plain::eigenvalues(matrix / weights, n);
  return {3. * m[0] - m[1], 3. * m[1] - m[0]};
}

double relative(const Analytic_surface& s, double difference)
{
  return std::abs(difference) / largest_curvature(s);
}

} // namespace

BOOST_AUTO_TEST_CASE(equal_plain_implementations)
{
  for(const double jitter : {0., .2})
    for(const Analytic_surface& s : test_support::all_analytic_surfaces(jitter, 11))
    {
      const Result of_theisel = run(theisel, s, Normals::EXACT), of_meyer = run(meyer, s, Normals::EXACT),
                   of_taubin = run(taubin, s, Normals::EXACT);
      BOOST_TEST(of_meyer.failures == 0u);
      check_that_tips_alone_fail(s, of_theisel);
      check_that_tips_alone_fail(s, of_taubin);
      double largest = 0.;
      for(std::size_t i = 0; i < s.points.size(); i += 7)
      {
        if(!s.exact[i].singular)
        {
          test_support::raise_to(largest, relative(s, of_theisel.mean[i] - plain_theisel(s, i)));
          const Eigen::Vector2d k = plain_taubin(s, i);
          test_support::raise_to(largest, relative(s, of_taubin.curvatures[i].min_curvature - k[0]),
                                 relative(s, of_taubin.curvatures[i].max_curvature - k[1]));
        }
        if(s.exact[i].border)
        {
          BOOST_TEST((of_meyer.status[i] == SC::Estimation_status::BORDER));
          continue;
        }
        const Plain_meyer m = plain_meyer(s, i);
        test_support::raise_to(largest, relative(s, of_meyer.mean[i] - m.H),
                               relative(s, of_meyer.Gaussian[i] - m.K) / largest_curvature(s));
        const double radius = std::sqrt((std::max)(m.H * m.H - m.K, 0.));
        const double width = of_meyer.curvatures[i].max_curvature - of_meyer.curvatures[i].min_curvature;
        // a square root of a difference
        BOOST_TEST(relative(s, width * width - 4. * radius * radius) / largest_curvature(s) < 1e-10);
      }
      BOOST_TEST(largest < 1e-10, s.name << ": " << largest);
    }
}

// Theisel: normals that are linear in the points. Taubin: circles in all directions, all with the same weight.
BOOST_AUTO_TEST_CASE(exact_where_they_can_be)
{
  for(const double jitter : {0., .2})
  {
    for(const Analytic_surface& s :
        {test_support::sphere(2., 3, jitter, 3), test_support::cylinder(1., 2., 40, 12, jitter, 3)})
    {
      const Result result = run(theisel, s, Normals::EXACT);
      for(std::size_t i = 0; i < s.points.size(); ++i)
      {
        BOOST_TEST(std::abs(result.curvatures[i].min_curvature - s.exact[i].k_min) < 1e-12);
        BOOST_TEST(std::abs(result.curvatures[i].max_curvature - s.exact[i].k_max) < 1e-12);
      }
    }
    for(const One_ring_estimator& estimator : all_methods)
      for(const Curvatures& c :
          run(estimator, test_support::plane(1., 12, jitter, 3), Normals::EXACT).curvatures)
        BOOST_TEST((std::abs(c.min_curvature) < 1e-12 && std::abs(c.max_curvature) < 1e-12));
  }
  Analytic_surface octahedron;
  octahedron.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  octahedron.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                          {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for(const auto& p : octahedron.points)
  {
    octahedron.exact.emplace_back();
    octahedron.exact.back().normal = p;
  }
  for(const Curvatures& c : run(taubin, octahedron, Normals::EXACT).curvatures)
    BOOST_TEST((std::abs(c.min_curvature - 1.) < 1e-14 && std::abs(c.max_curvature - 1.) < 1e-14));
  // Meyer by hand: cotangents 1 / sqrt(3), four angles of 60 degrees, a third of four triangles with area sqrt(3) / 2
  const Result result = run(meyer, octahedron, Normals::EXACT);
  for(std::size_t i = 0; i < 6; ++i)
  {
    const double area = 2. / std::sqrt(3.);
    BOOST_TEST(std::abs(result.mean[i] - 4. * 2. / std::sqrt(3.) / (4. * area)) < 1e-14);
    BOOST_TEST(std::abs(result.Gaussian[i] - 2. * CGAL_PI / 3. / area) < 1e-14);
  }
}

// Gauss and Bonnet: over a closed mesh, angle defects add up to 2 pi times the Euler characteristic.
BOOST_AUTO_TEST_CASE(total_Gaussian_curvature)
{
  for(const auto& [s, characteristic] : {std::pair(test_support::ellipsoid(1., .8, .6, 2, .25, 5), 2.),
                                         std::pair(test_support::torus(1., .4, 24, 12, .25, 6), 0.)})
  {
    const Result result = run(meyer, s, Normals::EXACT);
    double sum = 0.;
    for(std::size_t i = 0; i < s.points.size(); ++i)
      sum += result.Gaussian[i] * plain_meyer(s, i).area;
    BOOST_TEST(std::abs(sum - 2. * CGAL_PI * characteristic) < 1e-11);
  }
}

BOOST_AUTO_TEST_CASE(errors_per_vertex)
{
  BOOST_TEST_MESSAGE("Theisel");
  check_errors(theisel, 0., Normals::EXACT, 3., {.02, .005});
  check_errors(theisel, 0., Normals::ESTIMATED, 3., {.045, .006});
  check_errors(theisel, .2, Normals::EXACT, 3., {.08, .065});
  check_errors(theisel, .2, Normals::ESTIMATED, 3., {.22, .11});
  BOOST_TEST_MESSAGE("Meyer");
  check_errors(meyer, 0., Normals::EXACT, 3., {.07, .1}, false);
  check_errors(meyer, .2, Normals::EXACT, 3., {.75, .55}, false);
  BOOST_TEST_MESSAGE("Taubin");
  check_errors(taubin, 0., Normals::EXACT, 3., {.7, .55});
  check_errors(taubin, .2, Normals::EXACT, 3., {.85, .8});
  check_errors(taubin, .2, Normals::ESTIMATED, 3., {.85, 1.});
}

// What Meyer's and Taubin's methods say doesn't converge on irregular meshes, and Taubin's only where the edges leave a
// vertex in evenly spread directions: here they don't.
BOOST_AUTO_TEST_CASE(convergence)
{
  BOOST_TEST(convergence_order(theisel, torus_refined(0.), Normals::EXACT) > 1.8);
  BOOST_TEST(convergence_order(theisel, torus_refined(.2), Normals::EXACT) > .8);
  BOOST_TEST(convergence_order(meyer, torus_refined(0.), Normals::EXACT) > 1.8);
  BOOST_TEST(std::abs(convergence_order(meyer, torus_refined(.2), Normals::EXACT)) < .2);
  BOOST_TEST(std::abs(convergence_order(taubin, torus_refined(0.), Normals::EXACT)) < .2);
  BOOST_TEST(std::abs(convergence_order(taubin, torus_refined(.2), Normals::EXACT)) < .2);
}

BOOST_AUTO_TEST_CASE(motion_and_scale)
{
  check_motion_and_scale(theisel, 1e-11);
  check_motion_and_scale(taubin, 1e-11);
  check_motion_and_scale(meyer, 1e-6); // the root of a difference
}

BOOST_AUTO_TEST_CASE(flipped_normals)
{
  for(const One_ring_estimator& estimator : all_methods)
    check_flip(estimator);
}
BOOST_AUTO_TEST_CASE(order_of_the_input)
{
  for(const One_ring_estimator& estimator : all_methods)
    check_permutation(estimator);
}
BOOST_AUTO_TEST_CASE(mesh_types)
{
  for(const One_ring_estimator& estimator : all_methods)
    check_mesh_types(estimator);
}
BOOST_AUTO_TEST_CASE(threads)
{
  for(const One_ring_estimator& estimator : all_methods)
    check_threads(estimator);
}
BOOST_AUTO_TEST_CASE(one_vertex)
{
  for(const One_ring_estimator& estimator : all_methods)
    check_one_vertex(estimator);
}
BOOST_AUTO_TEST_CASE(callback)
{
  for(const One_ring_estimator& estimator : all_methods)
    check_callback(estimator);
}

BOOST_AUTO_TEST_CASE(need_triangles)
{
  for(const One_ring_estimator& estimator : all_methods)
    check_needs_triangles(estimator, SC::parameters::default_values());
}

BOOST_AUTO_TEST_CASE(useless_triangles_count_for_nothing)
{
  for(const One_ring_estimator& estimator : all_methods)
    for(const SC::Estimation_status status : check_useless_triangles(estimator))
      if(estimator.method == Method::MEYER)
        BOOST_TEST((status == SC::Estimation_status::BORDER));
}

BOOST_AUTO_TEST_SUITE_END()
