#include <boost/test/unit_test.hpp>

#include "raise_to.h"

#include <Shape_characteristics/curvature/internal/shape_operator.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <Eigen/Dense>

#include <random>

BOOST_AUTO_TEST_SUITE(shape_operator)

namespace internal = Shape_characteristics::internal;
using Eigen::Vector3d;
using Real = boost::multiprecision::cpp_bin_float_100;

namespace {

const Vector3d x_axis(1, 0, 0), y_axis(0, 1, 0), z_axis(0, 0, 1);

internal::Shape_operator_eigen eigen_of(double l, double m, double n)
{
  return internal::eigen_of_shape_operator(z_axis, l, m, n, x_axis, y_axis);
}

// the textbook formula, which cancels, but not in 100 digits
void exact(double l, double m, double n, Real& k_min, Real& k_max)
{
  const Real mean = (Real(l) + n) / 2, delta = (Real(l) - n) / 2, radius = sqrt(delta * delta + Real(m) * m);
  k_min = mean - radius;
  k_max = mean + radius;
}

double relative_error(double computed, const Real& expected)
{
  return expected == 0 ? std::abs(computed)
                       : static_cast<double>(Real(abs((computed - expected) / expected)));
}

// directions are unit, orthogonal to each other and to the normal
double frame_error(const internal::Shape_operator_eigen& e, const Vector3d& normal)
{
  double largest = 0.;
  test_support::raise_to(largest, std::abs(e.min_direction.norm() - 1), std::abs(e.max_direction.norm() - 1),
                         std::abs(e.min_direction.dot(e.max_direction)),
                         std::abs(e.min_direction.dot(normal)), std::abs(e.max_direction.dot(normal)));
  return largest;
}

Vector3d random_direction(std::mt19937& random)
{
  std::normal_distribution<double> normal;
  return Vector3d(normal(random), normal(random), normal(random)).normalized();
}

} // namespace

BOOST_AUTO_TEST_CASE(eigenvalues_have_full_relative_accuracy)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> entry(-1, 1), exponent(-12, 0);
  Real k_min, k_max;
  for(int i = 0; i < 20000; ++i)
  {
    double l = entry(random), m = entry(random), n = entry(random);
    switch(i % 4)
    {
    case 1: // near an umbilic
      n = l + std::pow(10, exponent(random)) * n;
      m *= std::pow(10, exponent(random));
      break;
    case 2: // near a cylinder in any direction: one eigenvalue almost vanishes
      n = m * m / l + std::pow(10, exponent(random)) * n;
      break;
    case 3: // different sizes
      m *= std::pow(10, exponent(random));
      n *= std::pow(10, exponent(random));
      break;
    }
    exact(l, m, n, k_min, k_max);
    const auto e = eigen_of(l, m, n);
    BOOST_TEST(relative_error(e.min_curvature, k_min) < 2e-15);
    BOOST_TEST(relative_error(e.max_curvature, k_max) < 2e-15);
    BOOST_TEST(e.min_curvature <= e.max_curvature);
    BOOST_TEST(frame_error(e, z_axis) < 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(directions_belong_to_their_curvatures)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> entry(-1, 1);
  for(int i = 0; i < 5000; ++i)
  {
    const double scale = std::pow(10, 3 * entry(random));
    const double l = scale * entry(random), m = scale * entry(random), n = scale * entry(random);
    Eigen::Matrix2d matrix;
    matrix << l, m, m, n;
    const auto e = eigen_of(l, m, n);
    const Eigen::Vector2d a = e.min_direction.head<2>(), b = e.max_direction.head<2>();
    BOOST_TEST((matrix * a - e.min_curvature * a).norm() < 1e-15 * matrix.norm());
    BOOST_TEST((matrix * b - e.max_curvature * b).norm() < 1e-15 * matrix.norm());
  }
}

BOOST_AUTO_TEST_CASE(special_matrices)
{
  auto e = eigen_of(0, 0, 0);
  BOOST_TEST(e.min_curvature == 0);
  BOOST_TEST(e.max_curvature == 0);
  BOOST_TEST(frame_error(e, z_axis) == 0);

  for(double k : {1. / 3, -1. / 3, 0.1, -7.7, 1e200, 1e-300}) // umbilics
  {
    e = eigen_of(k, 0, k);
    BOOST_TEST(e.min_curvature == k);
    BOOST_TEST(e.max_curvature == k);
    BOOST_TEST(frame_error(e, z_axis) < 1e-15);
  }

  e = eigen_of(2, 0, 0); // convex cylinder along y
  BOOST_TEST(e.min_curvature == 0);
  BOOST_TEST(e.max_curvature == 2);
  BOOST_TEST(std::abs(e.min_direction.y()) == 1);
  e = eigen_of(-2, 0, 0); // concave
  BOOST_TEST(e.min_curvature == -2);
  BOOST_TEST(e.max_curvature == 0);
  BOOST_TEST(std::abs(e.min_direction.x()) == 1);
  e = eigen_of(0, 3, 0); // saddle
  BOOST_TEST(e.min_curvature == -3);
  BOOST_TEST(e.max_curvature == 3);
  BOOST_TEST(std::abs(e.max_direction.x() - e.max_direction.y()) < 1e-15);
}

BOOST_AUTO_TEST_CASE(range_of_double)
{
  for(double scale : {1e-307, 1e-200, 1e-150, 1e150, 1e200, 1e307})
  {
    const auto e = eigen_of(3 * scale, 0.5 * scale, -1 * scale);
    const double radius = std::sqrt(4.25);
    BOOST_TEST(std::abs(e.max_curvature / scale - (1 + radius)) < 1e-14);
    BOOST_TEST(std::abs(e.min_curvature / scale - (1 - radius)) < 1e-14);
    BOOST_TEST(frame_error(e, z_axis) < 1e-15);
  }
}

// The squares of what distinguishes the curvatures vanish beside a curvature of any size.
BOOST_AUTO_TEST_CASE(almost_umbilic)
{
  for(const double curvature : {0., 1e-90, -1., 1e90})
    for(double m = 5e-324; m < 1e-120; m *= 7.)
      for(const double sign : {1., -1.})
      {
        const internal::Shape_operator_eigen e = eigen_of(curvature, sign * m, curvature);
        BOOST_TEST(frame_error(e, z_axis) < 1e-15, "curvature " << curvature << ", m " << m);
        BOOST_TEST(std::abs(e.max_direction[0] - sign * e.max_direction[1]) < 1e-15);
      }
}

BOOST_AUTO_TEST_CASE(non_finite_input_gives_nan_only)
{
  const double inf = std::numeric_limits<double>::infinity(),
               quiet_nan = std::numeric_limits<double>::quiet_NaN();
  for(double wrong : {inf, -inf, quiet_nan})
    for(int i = 0; i < 3; ++i)
    {
      const auto e = eigen_of(i == 0 ? wrong : 1, i == 1 ? wrong : 1, i == 2 ? wrong : 1);
      BOOST_TEST(std::isnan(e.min_curvature));
      BOOST_TEST(std::isnan(e.max_curvature));
      BOOST_TEST(e.min_direction.array().isNaN().all());
      BOOST_TEST(e.max_direction.array().isNaN().all());
      BOOST_TEST(!e.is_finite());
    }
}

BOOST_AUTO_TEST_CASE(tangent_basis_is_orthonormal)
{
  std::mt19937 random(3);
  const auto check = [](const Vector3d& n)
  {
    Vector3d t1, t2;
    internal::tangent_basis(n, t1, t2);
    Eigen::Matrix3d frame;
    frame << t1, t2, n;
    BOOST_TEST((frame.transpose() * frame - Eigen::Matrix3d::Identity()).norm() < 1e-15);
    BOOST_TEST(frame.determinant() > 0);
  };
  for(int i = 0; i < 1000; ++i)
    check(random_direction(random));
  for(const Vector3d& n : {x_axis, y_axis, z_axis})
  {
    check(n);
    check(-n);
  }
  check(Vector3d(1e-9, 0, -1).normalized());
  check(Vector3d(1e-9, 1e-12, 1).normalized());
  check(Vector3d(1, 0, -0.));
}

// A quadric with the given normal, curvatures and directions; the derivatives along the normal don't matter.
BOOST_AUTO_TEST_CASE(implicit_surface_with_given_curvatures)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> entry(-1, 1);
  for(int i = 0; i < 3000; ++i)
  {
    const Vector3d n = random_direction(random);
    const Vector3d d_max = n.cross(random_direction(random)).normalized(), d_min = n.cross(d_max);
    const double k_max = 1 + entry(random),
                 k_min = i % 3 == 0 ? k_max - 1e-9 : k_max - 3 * std::abs(entry(random));
    const double length = std::pow(10, (i % 5 - 2) * 60.);
    const Vector3d w(entry(random), entry(random), entry(random));
    const Eigen::Matrix3d hessian =
        length * (k_max * d_max * d_max.transpose() + k_min * d_min * d_min.transpose() + n * w.transpose() +
                  w * n.transpose());
    const auto e = internal::curvatures_of_implicit(length * n, hessian);
    BOOST_TEST(std::abs(e.min_curvature - k_min) < 1e-14);
    BOOST_TEST(std::abs(e.max_curvature - k_max) < 1e-14);
    BOOST_TEST(frame_error(e, n) < 2e-15);
    const double gap = k_max - k_min;
    BOOST_TEST((1 - std::abs(e.max_direction.dot(d_max))) * gap < 1e-14);
    // the same zero set from the other side
    const auto f = internal::curvatures_of_implicit(-length * n, -hessian);
    BOOST_TEST(f.min_curvature == -e.max_curvature);
    BOOST_TEST(f.max_curvature == -e.min_curvature);
  }
}

BOOST_AUTO_TEST_CASE(implicit_surface_without_tangent_plane)
{
  const double inf = std::numeric_limits<double>::infinity(),
               quiet_nan = std::numeric_limits<double>::quiet_NaN();
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  for(const Vector3d& g :
      {Vector3d(0, 0, 0), Vector3d(inf, 0, 1), Vector3d(0, quiet_nan, 1), Vector3d(-inf, inf, inf)})
  {
    const auto e = internal::curvatures_of_implicit(g, identity);
    BOOST_TEST((std::isnan(e.min_curvature) && std::isnan(e.max_curvature)));
    BOOST_TEST((e.min_direction.array().isNaN().all() && e.max_direction.array().isNaN().all()));
  }
  for(int i = 0; i < 3; ++i)
    for(int j = i; j < 3; ++j)
    {
      Eigen::Matrix3d h = identity;
      h(i, j) = h(j, i) = quiet_nan;
      const auto e = internal::curvatures_of_implicit(Vector3d(1, 2, 3), h);
      BOOST_TEST((std::isnan(e.min_curvature) && std::isnan(e.max_curvature)));
    }
  // the smallest gradients are gradients
  const auto e = internal::curvatures_of_implicit(Vector3d(0, 0, 1e-310), 1e-310 * identity);
  BOOST_TEST(std::abs(e.max_curvature - 1) < 1e-12);
}

// in any basis of the tangent plane, and however oblique, the same
BOOST_AUTO_TEST_CASE(second_fundamental_form_in_any_basis)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> entry(-1, 1);
  for(int i = 0; i < 3000; ++i)
  {
    const Vector3d n = random_direction(random);
    const Vector3d d_max = n.cross(random_direction(random)).normalized(), d_min = n.cross(d_max);
    const double k_max = 1 + entry(random), k_min = k_max - 3 * std::abs(entry(random));
    const double length = std::pow(10, (i % 3 - 1) * 70.);
    Eigen::Matrix2d c = Eigen::Matrix2d::Random();
    if(std::abs(c.determinant()) < 0.05)
      continue;
    const Vector3d t1 = length * (c(0, 0) * d_max + c(0, 1) * d_min), t2 = c(1, 0) * d_max + c(1, 1) * d_min;
    const auto form = [&](int a, int b) { return -(k_max * c(a, 0) * c(b, 0) + k_min * c(a, 1) * c(b, 1)); };
    const auto e = internal::eigen_of_second_fundamental_form(n, length * length * form(0, 0),
                                                              length * form(0, 1), form(1, 1), t1, t2);
    BOOST_TEST(std::abs(e.min_curvature - k_min) < 2e-11);
    BOOST_TEST(std::abs(e.max_curvature - k_max) < 2e-11);
    BOOST_TEST(frame_error(e, n) < 2e-15);
    BOOST_TEST((1 - std::abs(e.max_direction.dot(d_max))) * (k_max - k_min) < 1e-10);
  }
  BOOST_TEST(std::isnan(
      internal::eigen_of_second_fundamental_form(z_axis, 1, 0, 1, x_axis, 2 * x_axis).max_curvature));
  BOOST_TEST(std::isnan(
      internal::eigen_of_second_fundamental_form(z_axis, 1, 0, 1, x_axis, 0 * x_axis).max_curvature));
}

BOOST_AUTO_TEST_SUITE_END()
