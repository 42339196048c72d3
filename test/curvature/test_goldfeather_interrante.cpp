#include <boost/test/unit_test.hpp>

#include "Numbered_points.h"
#include "estimator_checks.h"

#include <Shape_characteristics/curvature/goldfeather_interrante_curvatures.h>

#include "plain_algebra.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(goldfeather_interrante)

using namespace estimator_checks;

namespace {

struct Goldfeather_interrante
{
  unsigned int rings = 2;

  template <typename Tag, typename Mesh, typename Np>
  std::size_t all(const Mesh& mesh, const Np& np) const
  {
    return SC::goldfeather_interrante_curvatures<Tag>(mesh, np.number_of_rings(rings));
  }
  template <typename Vertex, typename Mesh, typename Np>
  SC::Estimation_status one(Vertex v, const Mesh& mesh, const Np& np) const
  {
    return SC::goldfeather_interrante_curvatures(v, mesh, np.number_of_rings(rings));
  }
};

struct Default_goldfeather_interrante
{
  template <typename Tag, typename Mesh, typename Np>
  std::size_t all(const Mesh& mesh, const Np& np) const
  {
    return SC::goldfeather_interrante_curvatures<Tag>(mesh, np);
  }
};

using test_support::Long_matrix;
using Long_vector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

// The eigenvalues of the fitted second fundamental form, negated, by a decomposition of the equations themselves, in the
// frame that comes first and in the unit of the input.
Eigen::Vector2d
plain_fit(const Analytic_surface& s, std::size_t i, const std::vector<std::uint32_t>& neighbors)
{
  const Eigen::Vector3d n = eigen(s.exact[i].normal);
  const Eigen::Vector3d u = n.unitOrthogonal(), v = n.cross(u);
  const Eigen::Vector3d p(s.points[i][0], s.points[i][1], s.points[i][2]);
  double sum = 0.;
  for(const std::uint32_t j : neighbors)
    sum += (Eigen::Vector3d(s.points[j][0], s.points[j][1], s.points[j][2]) - p).squaredNorm();
  const double unit =
      std::sqrt(sum / double(neighbors.size())); // equations of heights and slopes are added up
  Long_matrix matrix(3 * neighbors.size(), 7);
  Long_vector right_side(3 * neighbors.size());
  Eigen::Index row = 0;
  for(const std::uint32_t j : neighbors)
  {
    const Eigen::Vector3d d = (Eigen::Vector3d(s.points[j][0], s.points[j][1], s.points[j][2]) - p) / unit;
    const Eigen::Vector3d normal = eigen(s.exact[j].normal);
    const long double x = d.dot(u), y = d.dot(v), c = normal.dot(n);
    matrix.row(row) << x * x / 2, x * y, y * y / 2, x * x * x, x * x * y, x * y * y, y * y * y;
    right_side[row++] = d.dot(n);
    matrix.row(row) << c * x, c * y, 0, c * 3 * x * x, c * 2 * x * y, c * y * y, 0;
    right_side[row++] = -normal.dot(u);
    matrix.row(row) << 0, c * x, c * y, 0, c * x * x, c * 2 * x * y, c * 3 * y * y;
    right_side[row++] = -normal.dot(v);
  }
  const Long_vector solution = test_support::least_squares(matrix, right_side);
  Eigen::Matrix2d form;
  form << double(solution[0]), double(solution[1]), double(solution[1]), double(solution[2]);
  return test_support::symmetric_eigenvalues(Eigen::Matrix2d(-form / unit));
}

} // namespace

BOOST_AUTO_TEST_CASE(equals_a_plain_fit)
{
  for(const Analytic_surface& s : typical_surfaces())
    for(const unsigned int rings : {1u, 2u, 3u})
    {
      const Surface_mesh mesh = surface_mesh_of(s);
      const Result result = run(Goldfeather_interrante{rings}, mesh, s, Normals::EXACT);
      const SC::Face_graph_samples samples =
          SC::sampled_surface<CGAL::Sequential_tag>(mesh, SC::Neighborhood::rings(rings));
      SC::Face_graph_samples::Workspace workspace;
      const double unit = 1. / largest_curvature(s);
      for(std::size_t i = 0; i < s.points.size(); ++i)
      {
        const std::vector<std::uint32_t>& neighbors = samples.neighbors(i, 3, workspace);
        BOOST_TEST_REQUIRE(SC::is_estimated(result.status[i]));
        const Eigen::Vector2d expected = plain_fit(s, i, neighbors);
        BOOST_TEST(unit * std::abs(result.curvatures[i].min_curvature - expected[0]) < 1e-9);
        BOOST_TEST(unit * std::abs(result.curvatures[i].max_curvature - expected[1]) < 1e-9);
      }
    }
}

BOOST_AUTO_TEST_CASE(defaults)
{
  const Analytic_surface s = test_support::monkey_saddle(.5, 10, .2, 7);
  BOOST_TEST(same_bits(run(Default_goldfeather_interrante(), s, Normals::EXACT),
                       run(Goldfeather_interrante{2}, s, Normals::EXACT)));
}

// The middle of a paraboloid over its tangent plane: neighbors lie on the polynomial, and so do their slopes.
BOOST_AUTO_TEST_CASE(exact_on_polynomials)
{
  for(const double jitter : {0., .2})
    for(const Curvatures& c :
        run(Goldfeather_interrante(), test_support::plane(1., 12, jitter, 3), Normals::EXACT).curvatures)
      BOOST_TEST((std::abs(c.min_curvature) < 1e-13 && std::abs(c.max_curvature) < 1e-13));
  const Analytic_surface bowl = test_support::paraboloid(1., .5, 1., 24, 0.);
  const std::size_t middle = bowl.points.size() / 2;
  BOOST_TEST(bowl.exact[middle].k_max == -.5);
  for(const unsigned int rings : {1u, 2u, 3u})
  {
    const Result result = run(Goldfeather_interrante{rings}, bowl, Normals::EXACT);
    BOOST_TEST(std::abs(result.curvatures[middle].max_curvature + .5) < 1e-12);
    BOOST_TEST(std::abs(result.curvatures[middle].min_curvature + 1.) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(errors_per_vertex)
{
  check_errors(Goldfeather_interrante{1}, 0., Normals::EXACT, 4., {.045, .01});
  check_errors(Goldfeather_interrante{1}, .2, Normals::EXACT, 4., {.055, .02});
  check_errors(Goldfeather_interrante{2}, .2, Normals::EXACT, 4., {.15, .02});
}

BOOST_AUTO_TEST_CASE(convergence)
{
  const auto torus = [](unsigned int f) { return test_support::torus(1., .4, 24 * f, 12 * f, .2, 4); };
  const auto monkey_saddle = [](unsigned int f) { return test_support::monkey_saddle(.5, 16 * f, .2, 4); };
  for(const unsigned int rings : {1u, 2u})
  {
    BOOST_TEST(convergence_order(Goldfeather_interrante{rings}, torus, Normals::EXACT) > 1.8);
    BOOST_TEST(convergence_order(Goldfeather_interrante{rings}, monkey_saddle, Normals::EXACT, .25) > 1.8);
  }
}

BOOST_AUTO_TEST_CASE(motion_and_scale)
{
  check_motion_and_scale(Goldfeather_interrante{2}, 1e-9);
}
BOOST_AUTO_TEST_CASE(flipped_normals)
{
  check_flip(Goldfeather_interrante());
}
BOOST_AUTO_TEST_CASE(order_of_the_input)
{
  check_permutation(Goldfeather_interrante());
}
BOOST_AUTO_TEST_CASE(mesh_types)
{
  check_mesh_types(Goldfeather_interrante());
}
BOOST_AUTO_TEST_CASE(threads)
{
  check_threads(Goldfeather_interrante());
}
BOOST_AUTO_TEST_CASE(one_vertex)
{
  check_one_vertex(Goldfeather_interrante());
}
BOOST_AUTO_TEST_CASE(callback)
{
  check_callback(Goldfeather_interrante());
}

BOOST_AUTO_TEST_CASE(points)
{
  const Analytic_surface s = test_support::torus(1., .4, 48, 24, .2, 6);
  test_support::Numbered_points points(s);
  const auto result_of = [&]
  {
    const Result result = points.estimates(
        [](const auto& numbers, const auto& np)
        { return SC::goldfeather_interrante_curvatures(numbers, np.number_of_neighbors(12)); });
    check_consistency(result);
    return result;
  };
  const Result result = result_of();
  BOOST_TEST(result.failures == 0u);
  const Errors e = errors(s, result, 0.);
  BOOST_TEST_MESSAGE("  points: largest " << e.largest << ", direction " << e.direction);
  BOOST_TEST(e.largest < .14);

  for(const double step : {.1, 0.}) // points on a line, or in one place, determine no surface
  {
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      points.points[i] = Kernel::Point_3(step * double(i), 2. * step * double(i), 3.);
      points.normals[i] = Kernel::Vector_3(0, 0, 1);
    }
    BOOST_TEST(result_of().failures == points.size());
  }
}

// Neighbors on a circle of an ellipsoid that is seen at a low angle are nearly on a line: they don't tell the curvature across it.
// On rows of long triangles, they do.
BOOST_AUTO_TEST_CASE(near_a_line)
{
  const auto status_and_error = [](const test_support::Numbered_points& points, double k_min,
                                   double k_max) // of the first point
  {
    const Result result = points.estimates(
        [&](const auto& numbers, const auto& np)
        {
          return SC::goldfeather_interrante_curvatures(numbers,
                                                       np.number_of_neighbors(unsigned(numbers.size() - 1)));
        });
    const Curvatures& c = result.curvatures[0];
    return std::make_pair(result.status[0],
                          (std::max)(std::abs(c.min_curvature - k_min), std::abs(c.max_curvature - k_max)));
  };

  const double radius = std::sin(.2), slope = std::cos(.2) / 100.;
  for(const double unit : {1., 1e-6, 1e6})
  {
    test_support::Numbered_points points;
    for(const double angle : {0., -.683, -.479, .372})
    {
      const double x = radius * std::cos(angle), y = radius * std::sin(angle);
      points.push_back(Kernel::Point_3(unit * x, unit * y, 0.), Kernel::Vector_3(x, y, slope));
    }
    BOOST_TEST((status_and_error(points, .01, 5.).first == SC::Estimation_status::DEGENERATE));
  }

  // a cylinder, 3 by 5 points, and the middle one first
  for(const double ratio : {1., 10., 100., 1000.})
  {
    test_support::Numbered_points points;
    for(const int i : {0, -1, 1})
      for(const int j : {0, -2, -1, 1, 2})
      {
        const double angle = .05 * double(j);
        points.push_back(Kernel::Point_3(std::cos(angle), std::sin(angle), .05 * ratio * double(i)),
                         Kernel::Vector_3(std::cos(angle), std::sin(angle), 0.));
      }
    const auto [status, error] = status_and_error(points, 0., 1.);
    BOOST_TEST(SC::is_estimated(status));
    BOOST_TEST(error < .01);
  }
}

BOOST_AUTO_TEST_SUITE_END()
