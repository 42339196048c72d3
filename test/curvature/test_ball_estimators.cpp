#include <boost/test/unit_test.hpp>

#include "estimator_checks.h"
#include "plain_triangle_tensors.h"

#include <Shape_characteristics/curvature/hildebrandt_polthier_curvatures.h>
#include <Shape_characteristics/curvature/normal_cycle_curvatures.h>

#include <CGAL/boost/graph/generators.h>
#include <CGAL/number_type_config.h>

#include "plain_algebra.h"
#include "raise_to.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(ball_estimators)

// The estimators that look at the triangles in a ball: Cohen-Steiner's and Morvan's, and Hildebrandt's and Polthier's.
using namespace estimator_checks;

namespace {

enum class Method
{
  NORMAL_CYCLE,
  HILDEBRANDT_POLTHIER
};

// One type for both: what the checks instantiate is compiled once.
struct Ball_estimator
{
  Method method;
  unsigned int rings = 2;

  template <typename Tag, typename Mesh, typename Np>
  std::size_t all(const Mesh& mesh, const Np& np) const
  {
    return method == Method::NORMAL_CYCLE
               ? SC::normal_cycle_curvatures<Tag>(mesh, np.number_of_rings(rings))
               : SC::hildebrandt_polthier_curvatures<Tag>(mesh, np.number_of_rings(rings));
  }
  template <typename Vertex, typename Mesh, typename Np>
  SC::Estimation_status one(Vertex v, const Mesh& mesh, const Np& np) const
  {
    return method == Method::NORMAL_CYCLE
               ? SC::normal_cycle_curvatures(v, mesh, np.number_of_rings(rings))
               : SC::hildebrandt_polthier_curvatures(v, mesh, np.number_of_rings(rings));
  }
};

const Ball_estimator normal_cycle{Method::NORMAL_CYCLE}, hildebrandt_polthier{Method::HILDEBRANDT_POLTHIER};
const std::array<Ball_estimator, 2> both = {normal_cycle, hildebrandt_polthier};

struct With_radius
{
  Method method;
  double radius;

  template <typename Tag, typename Mesh, typename Np>
  std::size_t all(const Mesh& mesh, const Np& np) const
  {
    return method == Method::NORMAL_CYCLE
               ? SC::normal_cycle_curvatures<Tag>(mesh, np.neighbor_radius(radius))
               : SC::hildebrandt_polthier_curvatures<Tag>(mesh, np.neighbor_radius(radius));
  }
};

// Triangles divided so often that what is not clipped doesn't matter: lengths and areas by counting.
double plain_share(const std::vector<Eigen::Vector3d>& corners, const Eigen::Vector3d& center, double radius)
{
  const int n = 150;
  int inside = 0, all = 0;
  double nearest = (corners[0] - center).norm(), farthest = nearest, longest = 0.;
  for(const Eigen::Vector3d& p : corners)
  {
    nearest = (std::min)(nearest, (p - center).norm());
    test_support::raise_to(farthest, (p - center).norm());
    test_support::raise_to(longest, (p - corners[0]).norm());
  }
  if(farthest < radius || nearest - 2. * longest > radius)
    return farthest < radius ? 1. : 0.;
  for(int i = 0; i < n; ++i)
    if(corners.size() == 2)
    {
      const double t = (i + .5) / n;
      inside += ((1. - t) * corners[0] + t * corners[1] - center).norm() < radius;
      ++all;
    }
    else
      for(int j = 0; i + j < n; ++j)
      {
        const double u = (i + 1. / 3.) / n, v = (j + 1. / 3.) / n;
        inside += ((1. - u - v) * corners[0] + u * corners[1] + v * corners[2] - center).norm() < radius;
        ++all;
      }
  return double(inside) / double(all);
}

// Equation 5.2 as it stands, over all triangles and edges of the mesh
Eigen::Vector2d plain_normal_cycle(const Analytic_surface& s, std::size_t vertex, double radius)
{
  std::map<std::pair<std::size_t, std::size_t>, Eigen::Vector3d> normal_at; // of the triangle left of an edge
  const Eigen::Vector3d center = eigen(s.points[vertex]);
  double area = 0.;
  for(const auto& t : s.triangles)
  {
    const std::vector<Eigen::Vector3d> p = {eigen(s.points[t[0]]), eigen(s.points[t[1]]),
                                            eigen(s.points[t[2]])};
    const Eigen::Vector3d cross = (p[1] - p[0]).cross(p[2] - p[0]);
    for(std::size_t k = 0; k < 3; ++k)
      normal_at[{t[k], t[(k + 1) % 3]}] = cross.normalized();
    area += .5 * cross.norm() * plain_share(p, center, radius);
  }
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for(const auto& [edge, left] : normal_at)
  {
    const auto found = normal_at.find({edge.second, edge.first});
    if(edge.first > edge.second || found == normal_at.end())
      continue;
    const Eigen::Vector3d p = eigen(s.points[edge.first]), q = eigen(s.points[edge.second]);
    const Eigen::Vector3d e = (q - p).normalized();
    const double angle = std::asin(left.cross(found->second).dot(e));
    sum += angle * (q - p).norm() * plain_share({p, q}, center, radius) * e * e.transpose();
  }
  return plain::eigenvalues(sum / area, eigen(s.exact[vertex].normal));
}

// The integral of the normal times the gradient, over triangles divided into small ones on which the function of the distance
// is linear
Eigen::Vector2d plain_hildebrandt_polthier(const Analytic_surface& s, std::size_t vertex, double radius)
{
  const Eigen::Vector3d center = eigen(s.points[vertex]);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  double weight = 0.;
  for(const auto& t : s.triangles)
  {
    std::vector<Eigen::Vector3d> polygon, clipped;
    for(const std::size_t v : t)
      polygon.push_back((eigen(s.points[v]) - center) / radius);
    const Eigen::Vector3d normal = (polygon[1] - polygon[0]).cross(polygon[2] - polygon[0]).normalized();
    for(std::size_t k = 0; k < 3; ++k)
    {
      const Eigen::Vector3d p = polygon[k], q = polygon[(k + 1) % 3];
      if(p.norm() < 1.)
        clipped.push_back(p);
      if((p.norm() < 1.) != (q.norm() < 1.))
      {
        double a = 0., b = 1.; // bisection
        for(int step = 0; step < 60; ++step)
          (((p + .5 * (a + b) * (q - p)).norm() < 1.) == (p.norm() < 1.) ? a : b) = .5 * (a + b);
        clipped.push_back(p + a * (q - p));
      }
    }
    if(clipped.size() < 3)
      continue;
    // two fans: a quadrilateral is split along both diagonals
    for(std::size_t first = 0; first < 2;
        ++first, std::rotate(clipped.begin(), clipped.begin() + 1, clipped.end()))
      for(std::size_t k = 1; k + 1 < clipped.size(); ++k)
      {
        const Eigen::Vector3d &a = clipped[0], &b = clipped[k], &c = clipped[k + 1];
        Eigen::Matrix3d m;
        m << (b - a).transpose(), (c - a).transpose(), normal.transpose();
        const auto value = [](const Eigen::Vector3d& p) { return (std::max)(1. - p.norm(), 0.); };
        const Eigen::Vector3d gradient =
            test_support::least_squares(m, Eigen::Vector3d(value(b) - value(a), value(c) - value(a), 0.));
        const double area = .5 * (b - a).cross(c - a).norm();
        sum -= .5 * area * normal * gradient.transpose();
        weight += .5 * area * (value(a) + value(b) + value(c)) / 3.;
      }
  }
  const Eigen::Matrix3d symmetric = .5 * (sum + sum.transpose()) / (weight * radius);
  return plain::eigenvalues(symmetric, eigen(s.exact[vertex].normal));
}

} // namespace

BOOST_AUTO_TEST_CASE(equal_plain_implementations)
{
  for(const Analytic_surface& s :
      {test_support::ellipsoid(1., .8, .6, 2, .2, 5), test_support::torus(1., .4, 24, 12, .2, 6),
       test_support::monkey_saddle(.5, 10, .2, 7)})
    for(const double edges : {.7, 1.6, 2.5})
    {
      const double radius = edges * s.mean_edge_length(), unit = 1. / largest_curvature(s);
      const Result of_cycle = run(With_radius{Method::NORMAL_CYCLE, radius}, s, Normals::EXACT),
                   of_operator = run(With_radius{Method::HILDEBRANDT_POLTHIER, radius}, s, Normals::EXACT);
      const std::vector<bool> far = far_from_singularities(s, edges + .1);
      double cycle = 0., shape = 0.;
      for(std::size_t i = 0; i < s.points.size(); i += 41)
      {
        const Eigen::Vector2d k = plain_normal_cycle(s, i, radius);
        test_support::raise_to(cycle, unit * std::abs(of_cycle.curvatures[i].min_curvature - k[0]),
                               unit * std::abs(of_cycle.curvatures[i].max_curvature - k[1]));
        if(!far[i])
          continue; // the plain one knows no border
        const Eigen::Vector2d h = plain_hildebrandt_polthier(s, i, radius);
        test_support::raise_to(shape, unit * std::abs(of_operator.curvatures[i].min_curvature - h[0]),
                               unit * std::abs(of_operator.curvatures[i].max_curvature - h[1]));
      }
      BOOST_TEST_MESSAGE("  " << s.name << ", " << edges << " edges: " << cycle << ", " << shape);
      BOOST_TEST(cycle < .01); // of counting
      BOOST_TEST(shape < 1e-9);
    }
}

// By hand: along a prism of n sides, all edges that bend are parallel to the axis.
BOOST_AUTO_TEST_CASE(prism)
{
  const std::size_t n = 12, rows = 24;
  const Analytic_surface s = test_support::cylinder(1., 4., n, rows);
  const double angle = 2. * CGAL_PI / double(n), side = 2. * std::sin(angle / 2.), radius = .9 * side;
  const Result result = run(With_radius{Method::NORMAL_CYCLE, radius}, s, Normals::EXACT);
  // the edge through the vertex, and the halves of a disk on both sides
  const double expected = angle * 2. * radius / (CGAL_PI * radius * radius);
  for(std::size_t i = 0; i < s.points.size(); ++i)
  {
    if(std::abs(s.points[i][2] - 2.) > 1.)
      continue;
    const Curvatures& c = result.curvatures[i];
    BOOST_TEST(std::abs(c.max_curvature - expected) < 1e-12);
    BOOST_TEST(std::abs(c.min_curvature) < 1e-12);
    BOOST_TEST(std::abs(c.min_direction.z()) > 1. - 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(planes_are_flat)
{
  for(const Ball_estimator& estimator : both)
    for(const double jitter : {0., .2})
    {
      const Result result = run(estimator, test_support::plane(1., 12, jitter, 3), Normals::EXACT);
      BOOST_TEST(result.failures == 0u);
      for(const Curvatures& c : result.curvatures)
        BOOST_TEST((std::abs(c.min_curvature) < 1e-13 && std::abs(c.max_curvature) < 1e-13));
    }
}

BOOST_AUTO_TEST_CASE(errors_per_vertex)
{
  BOOST_TEST_MESSAGE("normal cycle");
  check_errors(normal_cycle, 0., Normals::EXACT, 4., {.12, .02});
  check_errors(normal_cycle, .2, Normals::EXACT, 4., {.2, .05});
  BOOST_TEST_MESSAGE("Hildebrandt-Polthier");
  check_errors(hildebrandt_polthier, 0., Normals::EXACT, 4., {.21, .025});
  check_errors(hildebrandt_polthier, .2, Normals::EXACT, 4., {.29, .065});
}

// with a ball of so many edges, and with one that shrinks as the square root of the edges
BOOST_AUTO_TEST_CASE(convergence)
{
  const auto torus = [](double jitter)
  { return [jitter](unsigned int f) { return test_support::torus(1., .4, 24 * f, 12 * f, jitter, 4); }; };
  for(const Ball_estimator& estimator : both)
  {
    const double expected = estimator.method == Method::NORMAL_CYCLE ? .9 : 1.7;
    BOOST_TEST(convergence_order(estimator, torus(0.), Normals::EXACT) > expected);
    BOOST_TEST(convergence_order(estimator, torus(.2), Normals::EXACT) > expected);
    const auto error = [&](unsigned int f)
    {
      const Analytic_surface s = torus(.2)(f);
      return errors(s, run(With_radius{estimator.method, .4 / std::sqrt(double(f))}, s, Normals::EXACT), 0.)
          .mean;
    };
    const double order = std::log2(error(1) / error(4)) / 2.;
    BOOST_TEST_MESSAGE("  square root: order " << order);
    BOOST_TEST(order > .75);
  }
}

BOOST_AUTO_TEST_CASE(motion_and_scale)
{
  for(const Ball_estimator& estimator : both)
    check_motion_and_scale(estimator, 1e-10);
}
BOOST_AUTO_TEST_CASE(flipped_normals)
{
  for(const Ball_estimator& estimator : both)
    check_flip(estimator);
}
BOOST_AUTO_TEST_CASE(order_of_the_input)
{
  for(const Ball_estimator& estimator : both)
    check_permutation(estimator);
}
BOOST_AUTO_TEST_CASE(mesh_types)
{
  for(const Ball_estimator& estimator : both)
    check_mesh_types(estimator);
}
BOOST_AUTO_TEST_CASE(threads)
{
  for(const Ball_estimator& estimator : both)
    check_threads(estimator);
}
BOOST_AUTO_TEST_CASE(one_vertex)
{
  for(Ball_estimator estimator : both)
    for(const unsigned int rings : {1u, 2u})
    {
      estimator.rings = rings;
      check_one_vertex(estimator);
    }
}
BOOST_AUTO_TEST_CASE(callback)
{
  for(const Ball_estimator& estimator : both)
    check_callback(estimator);
}

// A second sheet in the ball, which isn't connected with the first there, changes nothing.
BOOST_AUTO_TEST_CASE(other_sheets_do_not_count)
{
  const Analytic_surface s = test_support::monkey_saddle(.5, 10, .2, 7);
  Analytic_surface two = s;
  for(std::size_t i = 0; i < s.points.size(); ++i)
  {
    two.points.push_back({s.points[i][0], s.points[i][1], s.points[i][2] + .01});
    two.exact.push_back(s.exact[i]);
  }
  for(const auto& t : s.triangles)
    two.triangles.push_back({t[0] + s.points.size(), t[1] + s.points.size(), t[2] + s.points.size()});
  for(const Ball_estimator& estimator : both)
  {
    const Result one = run(estimator, s, Normals::EXACT), of_two = run(estimator, two, Normals::EXACT);
    for(std::size_t i = 0; i < s.points.size(); ++i)
      BOOST_TEST(same_bits(one.curvatures[i], of_two.curvatures[i]));
  }
}

BOOST_AUTO_TEST_CASE(preconditions)
{
  Surface_mesh triangle;
  CGAL::make_triangle(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0), Kernel::Point_3(1, 1, 0), triangle);
  const auto np = SC::parameters::normal_weighting(SC::Normal_weighting::MAX);
  for(const Ball_estimator& estimator : both)
  {
    check_needs_triangles(estimator, np);
    BOOST_CHECK_THROW(run(Ball_estimator{estimator.method, 0}, test_support::plane(1., 2), Normals::EXACT),
                      std::invalid_argument);
    for(const double radius : {0., -1., std::nan("")})
      BOOST_CHECK_THROW(
          run(With_radius{estimator.method, radius}, test_support::plane(1., 2), Normals::EXACT),
          std::invalid_argument);
    BOOST_TEST(
        (estimator.one(*vertices(triangle).begin(), triangle, np) == SC::Estimation_status::FEW_NEIGHBOURS));
  }
}

BOOST_AUTO_TEST_SUITE_END()
