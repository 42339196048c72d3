#include <boost/test/unit_test.hpp>

#include "Numbered_points.h"
#include "estimator_checks.h"

#include <Shape_characteristics/curvature/batagelo_wu_curvatures.h>
#include <Shape_characteristics/curvature/kalogerakis_curvatures.h>
#include <Shape_characteristics/curvature/moving_least_squares_curvatures.h>
#include <Shape_characteristics/curvature/razdan_bae_curvatures.h>

#include <CGAL/number_type_config.h>

#include "plain_algebra.h"
#include "raise_to.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(neighbor_estimators)

// The estimators that see neighbors and no faces, on meshes and on point sets: Batagelo's and Wu's, Yang's and Qian's, Razdan's
// and Bae's, and Kalogerakis's.
using namespace estimator_checks;

namespace {

enum class Method
{
  BATAGELO_WU,
  MOVING_LEAST_SQUARES,
  RAZDAN_BAE,
  KALOGERAKIS
};

// One type for all of them: what the checks instantiate is compiled once.
struct Neighbor_estimator
{
  Method method;
  unsigned int rings;

  template <typename Tag, typename Input, typename Np>
  static std::size_t call(Method method, Input& input, const Np& np)
  {
    switch(method)
    {
    case Method::BATAGELO_WU:
      return SC::batagelo_wu_curvatures<Tag>(input, np);
    case Method::MOVING_LEAST_SQUARES:
      return SC::moving_least_squares_curvatures<Tag>(input, np);
    case Method::RAZDAN_BAE:
      return SC::razdan_bae_curvatures<Tag>(input, np);
    default:
      return SC::kalogerakis_curvatures<Tag>(input, np);
    }
  }
  template <typename Tag, typename Mesh, typename Np>
  std::size_t all(const Mesh& mesh, const Np& np) const
  {
    return call<Tag>(method, mesh, np.number_of_rings(rings));
  }
  template <typename Vertex, typename Mesh, typename Np>
  SC::Estimation_status one(Vertex v, const Mesh& mesh, const Np& np) const
  {
    switch(method)
    {
    case Method::BATAGELO_WU:
      return SC::batagelo_wu_curvatures(v, mesh, np.number_of_rings(rings));
    case Method::MOVING_LEAST_SQUARES:
      return SC::moving_least_squares_curvatures(v, mesh, np.number_of_rings(rings));
    case Method::RAZDAN_BAE:
      return SC::razdan_bae_curvatures(v, mesh, np.number_of_rings(rings));
    default:
      return SC::kalogerakis_curvatures(v, mesh, np.number_of_rings(rings));
    }
  }
};

const Neighbor_estimator batagelo_wu{Method::BATAGELO_WU, 1},
    moving_least_squares{Method::MOVING_LEAST_SQUARES, 3}, razdan_bae{Method::RAZDAN_BAE, 2},
    kalogerakis{Method::KALOGERAKIS, 2};
const std::array<Neighbor_estimator, 4> all_methods = {batagelo_wu, moving_least_squares, razdan_bae,
                                                       kalogerakis};

struct With_defaults
{
  Method method;

  template <typename Tag, typename Mesh, typename Np>
  std::size_t all(const Mesh& mesh, const Np& np) const
  {
    return Neighbor_estimator::call<Tag>(method, mesh, np);
  }
};

using Long_vector_3 = Eigen::Matrix<long double, 3, 1>;
using test_support::Long_matrix;
using Long_vector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

Long_vector_3 long_vector(const test_support::Vector& v)
{
  return {v[0], v[1], v[2]};
}

Eigen::Vector2d eigenvalues(double l, double m, double n)
{
  Eigen::Matrix2d matrix;
  matrix << l, m, m, n;
  return test_support::symmetric_eigenvalues(matrix);
}

// The least squares of the changes of the normal, by a decomposition of the equations
Eigen::Vector2d
plain_batagelo_wu(const Analytic_surface& s, std::size_t i, const std::vector<std::uint32_t>& neighbors)
{
  const Long_vector_3 n = long_vector(s.exact[i].normal), u = n.unitOrthogonal(), v = n.cross(u);
  Long_matrix matrix(2 * Eigen::Index(neighbors.size()), 3);
  Long_vector side(matrix.rows());
  for(std::size_t k = 0; k < neighbors.size(); ++k)
  {
    const Long_vector_3 d = long_vector(s.points[neighbors[k]]) - long_vector(s.points[i]);
    const Long_vector_3 change = long_vector(s.exact[neighbors[k]].normal) - n;
    const Long_vector_3 projected = d - d.dot(n) * n, unit = projected.normalized();
    const long double weight = projected.norm() / d.norm(), x = unit.dot(u), y = unit.dot(v); // of equations
    matrix.row(2 * Eigen::Index(k)) << weight * x, weight * y, 0;
    matrix.row(2 * Eigen::Index(k) + 1) << 0, weight * x, weight * y;
    side[2 * Eigen::Index(k)] = weight * change.dot(u) / projected.norm();
    side[2 * Eigen::Index(k) + 1] = weight * change.dot(v) / projected.norm();
  }
  const Long_vector x = test_support::least_squares(matrix, side);
  return eigenvalues(double(x[0]), double(x[1]), double(x[2]));
}

// A patch with Bernstein's polynomials on the box of the neighborhood; its curvatures by the fundamental forms
Eigen::Vector2d
plain_razdan_bae(const Analytic_surface& s, std::size_t i, const std::vector<std::uint32_t>& neighbors)
{
  const Long_vector_3 n = long_vector(s.exact[i].normal), p = long_vector(s.points[i]);
  const Long_vector_3 first = long_vector(s.points[neighbors[0]]) - p;
  const Long_vector_3 u = (first - first.dot(n) * n).normalized(), v = n.cross(u);
  std::vector<Long_vector_3> points = {Long_vector_3::Zero()};
  for(const std::uint32_t j : neighbors)
  {
    const Long_vector_3 d = long_vector(s.points[j]) - p;
    points.emplace_back(d.dot(u), d.dot(v), d.dot(n));
  }
  Long_vector_3 low = points[0], high = points[0];
  for(const Long_vector_3& q : points)
  {
    low = low.cwiseMin(q);
    high = high.cwiseMax(q);
  }
  const auto bernstein = [](long double t) {
    return std::array<long double, 3>{(1 - t) * (1 - t), 2 * t * (1 - t), t * t};
  };
  const auto slope = [](long double t) { return std::array<long double, 3>{2 * t - 2, 2 - 4 * t, 2 * t}; };
  const std::array<long double, 3> bend = {2, -4, 2};
  Long_matrix matrix(Eigen::Index(points.size()), 9), sides(Eigen::Index(points.size()), 3);
  for(Eigen::Index k = 0; k < matrix.rows(); ++k)
  {
    const Long_vector_3& q = points[std::size_t(k)];
    const auto a = bernstein((q[0] - low[0]) / (high[0] - low[0])),
               b = bernstein((q[1] - low[1]) / (high[1] - low[1]));
    for(std::size_t c = 0; c < 9; ++c)
      matrix(k, Eigen::Index(c)) = a[c / 3] * b[c % 3];
    sides.row(k) = q.transpose();
  }
  const Long_matrix control =
      test_support::least_squares(matrix, sides); // all three coordinates, as in the paper
  const long double s_0 = -low[0] / (high[0] - low[0]), t_0 = -low[1] / (high[1] - low[1]);
  const auto derivative = [&](const std::array<long double, 3>& a, const std::array<long double, 3>& b)
  {
    Long_vector_3 sum = Long_vector_3::Zero();
    for(std::size_t c = 0; c < 9; ++c)
      sum += a[c / 3] * b[c % 3] * control.row(Eigen::Index(c)).transpose();
    return sum;
  };
  const Long_vector_3 x_1 = derivative(slope(s_0), bernstein(t_0)),
                      x_2 = derivative(bernstein(s_0), slope(t_0)), x_11 = derivative(bend, bernstein(t_0)),
                      x_12 = derivative(slope(s_0), slope(t_0)), x_22 = derivative(bernstein(s_0), bend);
  const Long_vector_3 normal = x_1.cross(x_2).normalized();
  const long double E = x_1.dot(x_1), F = x_1.dot(x_2), G = x_2.dot(x_2), L = -x_11.dot(normal),
                    M = -x_12.dot(normal), N = -x_22.dot(normal), area = E * G - F * F;
  const long double H = (E * N - 2 * F * M + G * L) / (2 * area), K = (L * N - M * M) / area;
  const long double root = std::sqrt(std::max(H * H - K, 0.L));
  return {double(H - root), double(H + root)};
}

// The function of the moving least squares as the paper writes it, differentiated numerically
Eigen::Vector2d plain_moving_least_squares(const Analytic_surface& s,
                                           std::size_t i,
                                           const std::vector<std::uint32_t>& neighbors)
{
  const Long_vector_3 p = long_vector(s.points[i]);
  long double square = 0;
  for(const std::uint32_t j : neighbors)
    square += (long_vector(s.points[j]) - p).squaredNorm();
  const long double size = std::sqrt(square / (long double)(neighbors.size())), h = .5L * size;
  std::vector<std::uint32_t> all = neighbors;
  all.push_back(std::uint32_t(i));
  const auto g = [&](const Long_vector_3& x)
  {
    Long_vector_3 mean = Long_vector_3::Zero();
    for(const std::uint32_t j : all)
      mean +=
          std::exp(-(x - long_vector(s.points[j])).squaredNorm() / (h * h)) * long_vector(s.exact[j].normal);
    mean.normalize();
    long double sum = 0;
    for(const std::uint32_t j : all)
    {
      const Long_vector_3 d = x - long_vector(s.points[j]);
      const long double t = d.dot(mean);
      sum += std::exp(-d.squaredNorm() / (h * h)) * t * (1 - t * t / (h * h));
    }
    return sum;
  };
  const long double step = 1e-4L * size;
  const auto gradient = [&](const Long_vector_3& x)
  {
    Long_vector_3 result;
    for(int c = 0; c < 3; ++c)
    {
      const Long_vector_3 e = step * Long_vector_3::Unit(c);
      result[c] = (8 * (g(x + e) - g(x - e)) - (g(x + 2 * e) - g(x - 2 * e))) / (12 * step);
    }
    return result;
  };
  Long_vector_3 x = p;
  for(int k = 0; k < 8; ++k)
  {
    const Long_vector_3 d = gradient(x);
    x -= g(x) / d.squaredNorm() * d;
  }
  const Long_vector_3 d = gradient(x), normal = d.normalized(), u = normal.unitOrthogonal(),
                      v = normal.cross(u);
  const auto second = [&](const Long_vector_3& a, const Long_vector_3& b)
  {
    const Long_vector_3 e = step * b;
    return double(
        a.dot(8 * (gradient(x + e) - gradient(x - e)) - (gradient(x + 2 * e) - gradient(x - 2 * e))) /
        (12 * step * d.norm()));
  };
  return eigenvalues(second(u, u), second(u, v), second(v, v));
}

} // namespace

BOOST_AUTO_TEST_CASE(equal_plain_implementations)
{
  for(const Analytic_surface& s : typical_surfaces())
    for(const unsigned int rings : {1u, 2u})
    {
      const Surface_mesh mesh = surface_mesh_of(s);
      const auto result = [&](Method m) {
        return run(Neighbor_estimator{m, rings}, mesh, s, Normals::EXACT);
      };
      const Result of_batagelo = result(Method::BATAGELO_WU), of_mls = result(Method::MOVING_LEAST_SQUARES),
                   of_razdan = result(Method::RAZDAN_BAE);
      const SC::Face_graph_samples samples =
          SC::sampled_surface<CGAL::Sequential_tag>(mesh, SC::Neighborhood::rings(rings));
      SC::Face_graph_samples::Workspace workspace;
      const double unit = 1. / largest_curvature(s);
      const auto difference = [&](const Result& r, std::size_t i, const Eigen::Vector2d& k)
      {
        return unit * (std::max)(std::abs(r.curvatures[i].min_curvature - k[0]),
                                 std::abs(r.curvatures[i].max_curvature - k[1]));
      };
      double batagelo = 0., mls = 0., razdan = 0.;
      for(std::size_t i = 0; i < s.points.size(); i += 3)
      {
        if(s.exact[i].border)
          continue; // where rings are added
        BOOST_TEST_REQUIRE((SC::is_estimated(of_batagelo.status[i]) && SC::is_estimated(of_mls.status[i])));
        test_support::raise_to(
            batagelo,
            difference(of_batagelo, i, plain_batagelo_wu(s, i, samples.neighbors(i, 3, workspace))));
        if(i % 25 == 0)
          test_support::raise_to(
              mls,
              difference(of_mls, i, plain_moving_least_squares(s, i, samples.neighbors(i, 3, workspace))));
        if(rings == 2)
          test_support::raise_to(
              razdan, difference(of_razdan, i, plain_razdan_bae(s, i, samples.neighbors(i, 8, workspace))));
      }
      BOOST_TEST_MESSAGE("  " << s.name << ": " << batagelo << ", " << mls << ", " << razdan);
      BOOST_TEST(batagelo < 1e-11);
      BOOST_TEST(mls < 1e-7);
      BOOST_TEST(razdan < 1e-7);
    }
}

BOOST_AUTO_TEST_CASE(defaults)
{
  const Analytic_surface s = test_support::monkey_saddle(.5, 10, .2, 7);
  for(const Neighbor_estimator& estimator : all_methods)
    BOOST_TEST(same_bits(run(With_defaults{estimator.method}, s, Normals::EXACT),
                         run(estimator, s, Normals::EXACT)));
}

BOOST_AUTO_TEST_CASE(exact_where_they_can_be)
{
  for(const double jitter : {0., .2})
  {
    for(const Neighbor_estimator& estimator : all_methods)
    {
      const Result result = run(estimator, test_support::plane(1., 12, jitter, 3), Normals::EXACT);
      BOOST_TEST(result.failures == 0u);
      for(const Curvatures& c : result.curvatures)
        BOOST_TEST((std::abs(c.min_curvature) < 1e-13 && std::abs(c.max_curvature) < 1e-13));
    }
    // the normal of a sphere is linear in the point
    for(const Curvatures& c :
        run(batagelo_wu, test_support::sphere(2., 3, jitter, 3), Normals::EXACT).curvatures)
      BOOST_TEST((std::abs(c.min_curvature - .5) < 1e-13 && std::abs(c.max_curvature - .5) < 1e-13));
  }
  // the middle of a paraboloid, over its tangent plane
  const Analytic_surface bowl = test_support::paraboloid(1., .5, 1., 24, 0.);
  const Curvatures c = run(razdan_bae, bowl, Normals::EXACT).curvatures[bowl.points.size() / 2];
  BOOST_TEST((std::abs(c.max_curvature + .5) < 1e-12 && std::abs(c.min_curvature + 1.) < 1e-12));
}

BOOST_AUTO_TEST_CASE(errors_per_vertex)
{
  BOOST_TEST_MESSAGE("Batagelo-Wu");
  check_errors(batagelo_wu, 0., Normals::EXACT, 3., {.02, .006});
  check_errors(batagelo_wu, .2, Normals::EXACT, 3., {.085, .065});
  check_errors(batagelo_wu, .2, Normals::ESTIMATED, 3., {.23, .12});
  BOOST_TEST_MESSAGE("moving least squares");
  for(const double jitter : {0., .2}) // not on a cone, at whose apex there is no such surface
    for(const Analytic_surface& s :
        {test_support::sphere(2., 3, jitter, 2), test_support::cylinder(1., 2., 40, 12, jitter, 2),
         test_support::torus(1., .4, 48, 24, jitter, 2), test_support::saddle(1., 24, jitter, 2),
         test_support::waves(.1, 4., 1., 32, jitter, 2)})
    {
      const Result result = run(moving_least_squares, s, Normals::EXACT);
      check_consistency(result);
      const Errors e = errors(s, result, 5.);
      BOOST_TEST_MESSAGE("  " << s.name << ": mean " << e.mean << ", largest " << e.largest << ", direction "
                              << e.direction);
      BOOST_TEST(e.largest < (jitter > 0. ? .6 : .25));
    }
  BOOST_TEST_MESSAGE("Razdan-Bae");
  check_errors(razdan_bae, 0., Normals::EXACT, 4., {.09, .02});
  check_errors(razdan_bae, .2, Normals::EXACT, 4., {.16, .075});
  BOOST_TEST_MESSAGE("Kalogerakis");
  check_errors(kalogerakis, 0., Normals::EXACT, 5., {.15, .05});
  check_errors(kalogerakis, .2, Normals::ESTIMATED, 5., {.2, .12});
}

// Moving least squares keep a part of their error.
BOOST_AUTO_TEST_CASE(convergence)
{
  BOOST_TEST(convergence_order(batagelo_wu, torus_refined(0.), Normals::EXACT) > 1.8);
  BOOST_TEST(convergence_order(batagelo_wu, torus_refined(.2), Normals::EXACT) > .8);
  for(const double jitter : {0., .2})
  {
    const Analytic_surface fine = torus_refined(jitter)(4);
    BOOST_TEST(errors(fine, run(moving_least_squares, fine, Normals::EXACT), 0.).mean < .07);
  }
  BOOST_TEST(convergence_order(razdan_bae, torus_refined(0.), Normals::EXACT) > 1.8);
  BOOST_TEST(convergence_order(razdan_bae, torus_refined(.2), Normals::EXACT) > 1.8);
  BOOST_TEST(convergence_order(kalogerakis, torus_refined(0.), Normals::ESTIMATED) > 1.5);
  BOOST_TEST(convergence_order(kalogerakis, torus_refined(.2), Normals::ESTIMATED) > .8);
}

// Along rows of triangles twenty times as long as wide few samples tell of the bend across.
BOOST_AUTO_TEST_CASE(long_triangles)
{
  const Analytic_surface s = test_support::torus(2., .7, 48, 6 * 48);
  const Errors e = errors(s, run(kalogerakis, s, Normals::EXACT), 0.);
  BOOST_TEST(e.mean < .08);
  BOOST_TEST(e.largest < .5);
}

// All neighbors of the middle are on two lines across each other: they say nothing of the products of the coordinates.
BOOST_AUTO_TEST_CASE(neighbors_on_a_cross)
{
  for(const double step : {.1, .025})
  {
    Analytic_surface s;
    s.name = "pole of a paraboloid";
    constexpr std::size_t rings = 8, degree = 4;
    const auto add = [&](double r, double angle)
    {
      const double x = r * std::cos(angle), y = r * std::sin(angle);
      s.points.push_back({x, y, -r * r / 2.});
      test_support::Exact_vertex exact;
      exact.normal = {x, y, 1.};
      s.exact.push_back(exact);
    };
    const auto place = [&](std::size_t ring, std::size_t k)
    { return ring == 0 ? 0 : 1 + (ring - 1) * degree + k % degree; };
    add(0., 0.);
    for(std::size_t ring = 1; ring <= rings; ++ring)
      for(std::size_t k = 0; k < degree; ++k)
      {
        add(step * double(ring), 2. * CGAL_PI * double(k) / double(degree));
        const std::size_t a = place(ring - 1, k), b = place(ring, k), c = place(ring, k + 1),
                          d = place(ring - 1, k + 1);
        s.triangles.push_back({a, b, c});
        if(ring > 1)
          s.triangles.push_back({a, c, d});
      }
    for(const Neighbor_estimator& estimator : {batagelo_wu, razdan_bae, kalogerakis})
    {
      const Result result = run(estimator, s, Normals::EXACT);
      if(!SC::is_estimated(result.status[0]))
        continue;
      BOOST_TEST(std::abs(result.curvatures[0].min_curvature - 1.) < .1);
      BOOST_TEST(std::abs(result.curvatures[0].max_curvature - 1.) < .1);
    }
  }
}

// A roof of two planes: normals in the neighborhood of a vertex near the ridge are of both, but those beyond are cut off.
BOOST_AUTO_TEST_CASE(features)
{
  Analytic_surface roof = test_support::plane(1., 20);
  for(std::size_t i = 0; i < roof.points.size(); ++i)
  {
    roof.points[i][2] = -.8 * std::abs(roof.points[i][0]);
    roof.exact[i].normal = {roof.points[i][0] < 0. ? -.8 : .8, 0., 1.};
  }
  const Result robust = run(kalogerakis, roof, Normals::ESTIMATED),
               plain = run(Neighbor_estimator{Method::BATAGELO_WU, 2}, roof, Normals::ESTIMATED);
  double largest = 0., largest_of_plain = 0.;
  for(std::size_t i = 0; i < roof.points.size(); ++i)
    if(std::abs(std::abs(roof.points[i][0]) - .2) <
       .01) // two edges from the ridge, whose normals are in the middle
    {
      test_support::raise_to(largest, robust.curvatures[i].max_curvature);
      test_support::raise_to(largest_of_plain, plain.curvatures[i].max_curvature);
    }
  BOOST_TEST_MESSAGE("  beside a ridge: " << largest << ", by least squares " << largest_of_plain);
  BOOST_TEST(largest < .2 * largest_of_plain);
}

// Points that move by a tenth of the edges: the curvature of a sphere, from normals of faces
BOOST_AUTO_TEST_CASE(noise)
{
  Analytic_surface s = test_support::sphere(1., 3, .1, 5);
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0., .05 * s.mean_edge_length());
  for(auto& p : s.points)
    for(int c = 0; c < 3; ++c)
      p[c] += noise(random);
  const auto median_error = [&](const Neighbor_estimator& estimator)
  {
    const Result result = run(estimator, s, Normals::ESTIMATED);
    check_consistency(result);
    std::vector<double> error;
    for(const Curvatures& c : result.curvatures)
      error.push_back(std::abs(c.min_curvature - 1.) + std::abs(c.max_curvature - 1.));
    std::nth_element(error.begin(), error.begin() + std::ptrdiff_t(error.size() / 2), error.end());
    return error[error.size() / 2];
  };
  const double robust = median_error(kalogerakis), plain = median_error(batagelo_wu);
  BOOST_TEST_MESSAGE("  noise: " << robust << ", by the first ring " << plain);
  BOOST_TEST(robust < .5 * plain);
}

BOOST_AUTO_TEST_CASE(motion_and_scale)
{
  check_motion_and_scale(batagelo_wu, 1e-11);
  check_motion_and_scale(moving_least_squares, 1e-9);
  check_motion_and_scale(razdan_bae, 1e-7);  // nine coefficients at a border
  check_motion_and_scale(kalogerakis, 1e-6); // iterations end a little earlier or later
}
BOOST_AUTO_TEST_CASE(flipped_normals)
{
  for(const Neighbor_estimator& estimator : all_methods)
    check_flip(estimator);
}
BOOST_AUTO_TEST_CASE(order_of_the_input)
{
  for(const Neighbor_estimator& estimator : all_methods)
    check_permutation(estimator);
}
BOOST_AUTO_TEST_CASE(mesh_types)
{
  for(const Neighbor_estimator& estimator : all_methods)
    check_mesh_types(estimator);
}
BOOST_AUTO_TEST_CASE(threads)
{
  for(const Neighbor_estimator& estimator : all_methods)
    check_threads(estimator);
}
BOOST_AUTO_TEST_CASE(one_vertex)
{
  for(const Neighbor_estimator& estimator : {batagelo_wu, moving_least_squares, razdan_bae})
    check_one_vertex(estimator);
  const Analytic_surface s = test_support::monkey_saddle(.5, 10, .2, 7);
  const Surface_mesh mesh = surface_mesh_of(s);
  const Result all = run(kalogerakis, mesh, s, Normals::ESTIMATED);
  for(std::size_t i = 0; i < s.points.size(); i += 3)
  {
    Curvatures c;
    const SC::Estimation_status status =
        kalogerakis.one(Surface_mesh::Vertex_index(unsigned(i)), mesh,
                        SC::parameters::vertex_principal_curvatures_and_directions(std::ref(c)));
    BOOST_TEST((status == all.status[i]));
    BOOST_TEST(same_bits(c, all.curvatures[i]));
  }
}
BOOST_AUTO_TEST_CASE(callback)
{
  for(const Neighbor_estimator& estimator : all_methods)
    check_callback(estimator);
}

BOOST_AUTO_TEST_CASE(points)
{
  struct Expected
  {
    Neighbor_estimator estimator;
    unsigned int neighbors;
    double mean, largest; // bounds of the errors
  };
  const std::array<Expected, 4> all_expected = {{{batagelo_wu, 18, .013, .045},
                                                 {moving_least_squares, 36, .09, .5},
                                                 {razdan_bae, 18, .085, .25},
                                                 {kalogerakis, 18, .022, .09}}};
  const Analytic_surface s = test_support::torus(1., .4, 48, 24, .2, 6);
  for(const Expected& expected : all_expected)
  {
    const Neighbor_estimator& estimator = expected.estimator;
    test_support::Numbered_points points(s);
    const auto result_of = [&](unsigned int k)
    {
      const Result result = points.estimates(
          [&](const auto& numbers, const auto& np)
          {
            return Neighbor_estimator::call<CGAL::Sequential_tag>(estimator.method, numbers,
                                                                  np.number_of_neighbors(k));
          });
      check_consistency(result);
      return result;
    };
    const Result result = result_of(expected.neighbors);
    BOOST_TEST(result.failures == 0u);
    const Errors e = errors(s, result, 0.);
    BOOST_TEST_MESSAGE("  points: mean " << e.mean << ", largest " << e.largest << ", direction "
                                         << e.direction);
    BOOST_TEST(e.mean < expected.mean);
    BOOST_TEST(e.largest < expected.largest);

    for(const SC::Estimation_status status : result_of(2).status)
      BOOST_TEST((status == SC::Estimation_status::FEW_NEIGHBOURS));
    BOOST_CHECK_THROW(result_of(0), std::invalid_argument);
    for(const double step : {.1, 0.}) // points on a line, or in one place, determine no surface
    {
      for(std::size_t i = 0; i < points.size(); ++i)
      {
        points.points[i] = Kernel::Point_3(step * double(i), 2. * step * double(i), 3.);
        points.normals[i] = Kernel::Vector_3(0, 0, 1);
      }
      BOOST_TEST(result_of(18).failures == points.size());
    }
  }
}

// The nearest points are in one row, which bends in the tangent plane: nothing tells of the curvature across.
BOOST_AUTO_TEST_CASE(points_in_one_row)
{
  const Analytic_surface s = test_support::torus(2., .7, 640, 24);
  std::vector<std::size_t> items(s.points.size());
  std::iota(items.begin(), items.end(), std::size_t(0));
  std::vector<Kernel::Point_3> positions;
  std::vector<Kernel::Vector_3> normals;
  for(std::size_t i = 0; i < items.size(); ++i)
  {
    positions.emplace_back(s.points[i][0], s.points[i][1], s.points[i][2]);
    const auto& n = s.exact[i].normal;
    normals.emplace_back(n[0], n[1], n[2]);
  }
  for(const Neighbor_estimator& estimator : {batagelo_wu, kalogerakis})
  {
    std::vector<SC::Estimation_status> status(items.size());
    const std::size_t failures = Neighbor_estimator::call<CGAL::Sequential_tag>(
        estimator.method, items,
        SC::parameters::point_map(CGAL::make_property_map(positions))
            .normal_map(CGAL::make_property_map(normals))
            .status_map(CGAL::make_property_map(status))
            .number_of_neighbors(8));
    BOOST_TEST(failures == items.size());
    for(const SC::Estimation_status e : status)
      BOOST_TEST((e == SC::Estimation_status::DEGENERATE));
  }
}

// All around a thin cylinder, normals cancel: there is no direction in which the surface is sought.
BOOST_AUTO_TEST_CASE(normals_that_cancel)
{
  const std::size_t rows = 7, columns = 32;
  test_support::Numbered_points points;
  for(std::size_t i = 0; i < rows * columns; ++i)
  {
    const double angle = 2. * CGAL_PI * double(i % columns) / double(columns);
    points.push_back(Kernel::Point_3(std::cos(angle), std::sin(angle), 50. * double(i / columns)),
                     Kernel::Vector_3(std::cos(angle), std::sin(angle), 0.));
  }
  const Result result =
      points.estimates([](const auto& numbers, const auto& np)
                       { return SC::moving_least_squares_curvatures(numbers, np.neighbor_radius(75.)); });
  check_consistency(result);
  for(const SC::Estimation_status status : result.status)
    BOOST_TEST((status == SC::Estimation_status::DEGENERATE));
}

BOOST_AUTO_TEST_SUITE_END()
