#include <boost/test/unit_test.hpp>

#include "estimator_checks.h"
#include "raise_to.h"

#include <Shape_characteristics/curvature/integral_invariant_curvatures.h>

#include <CGAL/boost/graph/generators.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(integral_invariants)

using namespace estimator_checks;

namespace {

struct Invariants
{
  unsigned int rings = 2;
  double radius = 0.; // 0: rings

  template <typename Tag, typename Mesh, typename Np>
  std::size_t all(const Mesh& mesh, const Np& np) const
  {
    return radius != 0. ? SC::integral_invariant_curvatures<Tag>(mesh, np.neighbor_radius(radius))
                        : SC::integral_invariant_curvatures<Tag>(mesh, np.number_of_rings(rings));
  }
  template <typename Vertex, typename Mesh, typename Np>
  SC::Estimation_status one(Vertex v, const Mesh& mesh, const Np& np) const
  {
    return SC::integral_invariant_curvatures(v, mesh, np.number_of_rings(rings));
  }
};

Invariants with_radius(double radius)
{
  return {2, radius};
}

// Moments by counting: a midpoint rule along two axes, exact intervals along the third
SC::internal::Volume_moments
plain_box(const Eigen::Vector3d& low, const Eigen::Vector3d& high, std::size_t steps)
{
  SC::internal::Volume_moments m;
  const Eigen::Vector3d step = (high - low) / double(steps);
  for(std::size_t i = 0; i < steps; ++i)
    for(std::size_t j = 0; j < steps; ++j)
    {
      const double x = low[0] + (double(i) + .5) * step[0], y = low[1] + (double(j) + .5) * step[1];
      const double square = 1. - x * x - y * y;
      if(!(square > 0.))
        continue;
      const double a = std::max(low[2], -std::sqrt(square)), b = std::min(high[2], std::sqrt(square));
      if(!(a < b))
        continue;
      const double z0 = (b - a) * step[0] * step[1], z1 = (b * b - a * a) / 2. * step[0] * step[1],
                   z2 = (b * b * b - a * a * a) / 3. * step[0] * step[1];
      m.volume += z0;
      m.first += Eigen::Vector3d(x * z0, y * z0, z1);
      Eigen::Matrix3d second;
      second << x * x * z0, x * y * z0, x * z1, x * y * z0, y * y * z0, y * z1, x * z1, y * z1, z2;
      m.second += second;
    }
  return m;
}

// The shape operator in the tangent plane of a convex solid or the complement of one, from the moments of the solid between
// its faces' planes, along rays: an integral over directions, with nothing of the estimator's
Eigen::Vector2d plain_curvatures(const Analytic_surface& s, std::size_t vertex, double radius)
{
  const Eigen::Vector3d center = eigen(s.points[vertex]), n = eigen(s.exact[vertex].normal);
  Eigen::Vector3d t1 = n.unitOrthogonal(), t2 = n.cross(t1);
  struct Plane
  {
    Eigen::Vector3d normal;
    double distance;
  };
  std::vector<Plane> planes;
  for(const auto& t : s.triangles)
  {
    const Eigen::Vector3d a = (eigen(s.points[t[0]]) - center) / radius,
                          b = (eigen(s.points[t[1]]) - center) / radius,
                          c = (eigen(s.points[t[2]]) - center) / radius;
    const Eigen::Vector3d normal = (b - a).cross(c - a).normalized();
    const bool is_at_vertex = t[0] == vertex || t[1] == vertex || t[2] == vertex;
    const double distance = is_at_vertex ? 0. : normal.dot(a);
    if(distance < 1.)
      planes.push_back({normal, distance});
  }
  // midpoint rules in the sine of the height and around
  const std::size_t rows = 320, columns = 640;
  double volume = 0., xx = 0., xy = 0., yy = 0.;
  for(std::size_t i = 0; i < rows; ++i)
    for(std::size_t j = 0; j < columns; ++j)
    {
      const double z = -1. + 2. * (double(i) + .5) / double(rows);
      const double angle = 2. * CGAL_PI * (double(j) + .5) / double(columns), c = std::sqrt(1. - z * z);
      const Eigen::Vector3d d = c * std::cos(angle) * t1 + c * std::sin(angle) * t2 + z * n;
      double length = 1.;
      for(const Plane& p : planes)
        if(const double slope = p.normal.dot(d); slope > 0.)
          length = std::min(length, p.distance / slope);
      const double weight = 4. * CGAL_PI / double(rows * columns), x = d.dot(t1), y = d.dot(t2);
      volume += weight * std::pow(length, 3) / 3.;
      xx += weight * std::pow(length, 5) / 5. * x * x;
      xy += weight * std::pow(length, 5) / 5. * x * y;
      yy += weight * std::pow(length, 5) / 5. * y * y;
    }
  const double half_ball = 2. * CGAL_PI / 15.;
  volume -= 2. * CGAL_PI / 3.;
  xx -= half_ball;
  yy -= half_ball;
  const double sum = 48. / CGAL_PI * (volume / 2. - xx - yy);
  const double difference = 24. / CGAL_PI * std::hypot(xx - yy, 2. * xy);
  return {.5 * (sum - difference) / radius, .5 * (sum + difference) / radius};
}

} // namespace

BOOST_AUTO_TEST_CASE(box_in_ball)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-1.2, 1.2);
  double largest = 0.;
  for(int i = 0; i < 40; ++i)
  {
    Eigen::Vector3d low, high;
    for(int k = 0; k < 3; ++k)
    {
      const double a = i % 5 == 0 && k == 0 ? 0. : number(random), b = number(random);
      low[k] = std::min(a, b);
      high[k] = std::max(a, b);
    }
    const auto exact = SC::internal::box_in_ball(low, high), plain = plain_box(low, high, 250);
    test_support::raise_to(largest, std::abs(exact.volume - plain.volume), (exact.first - plain.first).norm(),
                           (exact.second - plain.second).norm());
  }
  BOOST_TEST_MESSAGE("  largest difference " << largest);
  BOOST_TEST(largest < 2e-4); // of the rule

  const Eigen::Vector3d all = Eigen::Vector3d::Constant(1.5);
  const auto ball = SC::internal::box_in_ball(-all, all);
  BOOST_TEST(std::abs(ball.volume - 4. * CGAL_PI / 3.) < 1e-14);
  BOOST_TEST((ball.second - 4. * CGAL_PI / 15. * Eigen::Matrix3d::Identity()).norm() < 1e-14);
  const auto eighth = SC::internal::box_in_ball(Eigen::Vector3d::Zero(), all);
  BOOST_TEST(std::abs(eighth.volume - CGAL_PI / 6.) < 1e-14);
  BOOST_TEST((eighth.first - Eigen::Vector3d::Constant(CGAL_PI / 16.)).norm() < 1e-14);
  Eigen::Vector3d small = Eigen::Vector3d::Constant(.5);
  const auto cube = SC::internal::box_in_ball(-small, small);
  BOOST_TEST(std::abs(cube.volume - 1.) < 1e-14);
  BOOST_TEST((cube.second - Eigen::Matrix3d::Identity() / 12.).norm() < 1e-14);
}

BOOST_AUTO_TEST_CASE(equals_plain_implementation)
{
  // convex ones are the intersection of the half-spaces of their faces
  for(const Analytic_surface& s :
      {test_support::ellipsoid(1., .8, .6, 2, .2, 5), test_support::sphere(1., 2)})
    for(const double edges : {.7, 1.6, 2.5})
    {
      const double radius = edges * s.mean_edge_length(), unit = 1. / largest_curvature(s);
      const Result result = run(with_radius(radius), s, Normals::EXACT);
      double largest = 0.;
      for(std::size_t i = 0; i < s.points.size(); i += 67)
      {
        const Eigen::Vector2d k = plain_curvatures(s, i, radius);
        test_support::raise_to(largest, unit * std::abs(result.curvatures[i].min_curvature - k[0]),
                               unit * std::abs(result.curvatures[i].max_curvature - k[1]));
      }
      BOOST_TEST_MESSAGE("  " << s.name << ", " << edges << " edges: " << largest);
      BOOST_TEST(largest < .005); // of the rule
    }
}

BOOST_AUTO_TEST_CASE(planes_are_flat)
{
  for(const double jitter : {0., .2})
  {
    const Result result = run(Invariants(), test_support::plane(1., 12, jitter, 3), Normals::EXACT);
    BOOST_TEST(result.failures == 0u);
    for(const Curvatures& c : result.curvatures)
      BOOST_TEST((std::abs(c.min_curvature) < 1e-12 && std::abs(c.max_curvature) < 1e-12));
  }
}

BOOST_AUTO_TEST_CASE(errors_per_vertex)
{
  check_errors(Invariants(), 0., Normals::EXACT, 4., {.15, .01});
  check_errors(Invariants(), .2, Normals::EXACT, 4., {.16, .03});
  check_errors(Invariants(), .2, Normals::ESTIMATED, 4., {.16, .06});
}

// The error falls with the square of the radius as long as the edges are small, and with that of the edges where the ball is as
// large as some of them.
BOOST_AUTO_TEST_CASE(convergence)
{
  const Analytic_surface fine = test_support::torus(1., .4, 144, 72, 0., 4);
  const auto error = [&](double radius)
  { return errors(fine, run(with_radius(radius), fine, Normals::EXACT), 0.).mean; };
  const double order_of_radius = std::log2(error(.3) / error(.15));
  BOOST_TEST_MESSAGE("  radius: order " << order_of_radius);
  BOOST_TEST(order_of_radius > 1.9);
  for(const double jitter : {0., .2})
    BOOST_TEST(convergence_order(
                   Invariants(),
                   [jitter](unsigned int f)
                   { return test_support::torus(1., .4, 24 * f, 12 * f, jitter, 4); },
                   Normals::EXACT) > 1.);
}

// A vertex that noise has moved along its normal: the height cancels to first order.
BOOST_AUTO_TEST_CASE(moved_vertex)
{
  Analytic_surface s = test_support::torus(1., .4, 96, 48, 0., 4);
  const std::size_t i = 1000;
  const double radius = 5. * s.mean_edge_length(), height = .02 * radius;
  const Result before = run(with_radius(radius), s, Normals::EXACT);
  for(int k = 0; k < 3; ++k)
    s.points[i][k] += height * s.exact[i].normal[k];
  const Result after = run(with_radius(radius), s, Normals::EXACT);
  // with the volume alone it would be 4 height / radius^2
  BOOST_TEST(std::abs(after.mean[i] - before.mean[i]) < .25 * 4. * height / (radius * radius));
}

BOOST_AUTO_TEST_CASE(borders)
{
  const Analytic_surface s = test_support::cylinder(1., 2., 32, 16);
  const double radius = 2.5 * s.mean_edge_length();
  const Result result = run(with_radius(radius), s, Normals::EXACT);
  BOOST_TEST(result.failures == 0u);
  for(std::size_t i = 0; i < s.points.size(); ++i)
  {
    const double distance = std::min(s.points[i][2], 2. - s.points[i][2]);
    BOOST_TEST((result.status[i] == SC::Estimation_status::BORDER) == s.exact[i].border);
    if(distance >= .75 * radius)
      BOOST_TEST(std::abs(result.curvatures[i].max_curvature - 1.) < .08);
    BOOST_TEST(result.curvatures[i].max_curvature < 1.05);
    BOOST_TEST(result.curvatures[i].max_curvature > .3);
    BOOST_TEST(std::abs(result.curvatures[i].min_curvature) < .3);
  }
}

BOOST_AUTO_TEST_CASE(motion_and_scale)
{
  check_motion_and_scale(Invariants(), 1e-10);
}
BOOST_AUTO_TEST_CASE(flipped_normals)
{
  check_flip(Invariants());
}
BOOST_AUTO_TEST_CASE(order_of_the_input)
{
  check_permutation(Invariants());
}
BOOST_AUTO_TEST_CASE(mesh_types)
{
  check_mesh_types(Invariants());
}
BOOST_AUTO_TEST_CASE(threads)
{
  check_threads(Invariants());
}
BOOST_AUTO_TEST_CASE(one_vertex)
{
  check_one_vertex(Invariants());
}
BOOST_AUTO_TEST_CASE(callback)
{
  check_callback(Invariants());
}

BOOST_AUTO_TEST_CASE(preconditions)
{
  Surface_mesh triangle;
  CGAL::make_triangle(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0), Kernel::Point_3(1, 1, 0), triangle);
  const auto np = SC::parameters::normal_weighting(SC::Normal_weighting::MAX);
  check_needs_triangles(Invariants(), np);
  BOOST_CHECK_THROW(run(Invariants{0, 0.}, test_support::plane(1., 2), Normals::EXACT),
                    std::invalid_argument);
  for(const double radius : {-1., std::nan("")})
    BOOST_CHECK_THROW(run(with_radius(radius), test_support::plane(1., 2), Normals::EXACT),
                      std::invalid_argument);
  BOOST_TEST(
      (Invariants().one(*vertices(triangle).begin(), triangle, np) == SC::Estimation_status::FEW_NEIGHBOURS));
}

BOOST_AUTO_TEST_SUITE_END()
