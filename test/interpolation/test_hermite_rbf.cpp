#include <boost/test/unit_test.hpp>

#include "raise_to.h"
#include "says.h"

#include <Shape_characteristics/curvature/implicit_surface_curvatures.h>
#include <Shape_characteristics/interpolation/Exponential_cubic.h>
#include <Shape_characteristics/interpolation/Gaussian.h>
#include <Shape_characteristics/interpolation/Hermite_rbf_interpolant.h>
#include <Shape_characteristics/interpolation/Inverse_multiquadric.h>
#include <Shape_characteristics/interpolation/Inverse_multiquadric_cubic.h>
#include <Shape_characteristics/interpolation/Inverse_quadratic.h>
#include <Shape_characteristics/interpolation/Matern_9_2.h>
#include <Shape_characteristics/interpolation/Multiquadric.h>
#include <Shape_characteristics/interpolation/Polyharmonic.h>
#include <Shape_characteristics/interpolation/Polyharmonic_logarithmic.h>
#include <Shape_characteristics/interpolation/Wendland_1_1.h>
#include <Shape_characteristics/interpolation/Wendland_3_2.h>

#include <CGAL/Simple_cartesian.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <list>
#include <random>
#include <stdexcept>
#include <tuple>
#include <vector>

BOOST_AUTO_TEST_SUITE(hermite_rbf)

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;

namespace {

// all with second derivatives at the origin
using Basis_functions = std::tuple<SC::Gaussian,
                                   SC::Multiquadric,
                                   SC::Inverse_quadratic,
                                   SC::Inverse_multiquadric,
                                   SC::Inverse_multiquadric_cubic,
                                   SC::Exponential_cubic,
                                   SC::Matern_9_2,
                                   SC::Wendland_1_1,
                                   SC::Wendland_3_2,
                                   SC::Polyharmonic<3>,
                                   SC::Polyharmonic<5>,
                                   SC::Polyharmonic<7>,
                                   SC::Polyharmonic_logarithmic<4>>;

const double quiet_nan = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

struct Cloud
{
  std::vector<Point_3> points;
  std::vector<Vector_3> normals;
};

// points spread evenly over an ellipsoid with half axes a, b, c: a Fibonacci lattice
Cloud ellipsoid(int n, double a, double b, double c, const Point_3& center = CGAL::ORIGIN)
{
  Cloud cloud;
  for(int i = 0; i < n; ++i)
  {
    const double z = 1 - (2 * i + 1.) / n, s = std::sqrt(1 - z * z), angle = 2.399963229728653 * i;
    const double x = s * std::cos(angle), y = s * std::sin(angle);
    cloud.points.push_back(center + Vector_3(a * x, b * y, c * z));
    const Vector_3 n_i(x / a, y / b, z / c);
    cloud.normals.push_back(n_i / std::sqrt(n_i.squared_length()));
  }
  return cloud;
}

std::vector<Point_3> random_points(int n, unsigned seed, double size, const Point_3& center = CGAL::ORIGIN)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::vector<Point_3> result;
  for(int i = 0; i < n; ++i)
  {
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    result.push_back(center + size * Vector_3(x, y, z));
  }
  return result;
}

/*
  The system of the thesis, equations 3.9 to 3.11, in long double and the long way round: rows and columns of phi(r), its
  gradient phi' d / r and its Hessian matrix (phi'' - phi' / r) d d^T / r^2 + phi' / r I, with the derivatives by r written
  out for each basis function. Its betas are the negated ones of the class.
*/
struct Radial // phi and its first two derivatives by r; at 0 the second one is the limit of phi' / r as well
{
  long double (*value)(long double);
  long double (*first)(long double);
  long double (*second)(long double);
};

class Plain_solution
{
public:
  using Real = long double;
  using Vector = Eigen::Matrix<Real, 3, 1>;
  using Matrix = Eigen::Matrix<Real, 3, 3>;

  Plain_solution(const Cloud& cloud, const Radial& phi) : m_phi(phi)
  {
    const Eigen::Index m = Eigen::Index(cloud.points.size());
    m_center.setZero();
    for(const Point_3& p : cloud.points)
      m_center += Vector(p.x(), p.y(), p.z()) / Real(m);
    Real square = 0;
    for(const Point_3& p : cloud.points)
      square += (Vector(p.x(), p.y(), p.z()) - m_center).squaredNorm() / Real(m);
    m_size = std::sqrt(square);
    for(const Point_3& p : cloud.points)
      m_points.push_back((Vector(p.x(), p.y(), p.z()) - m_center) / m_size);

    Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic> system(4 * m, 4 * m);
    Eigen::Matrix<Real, Eigen::Dynamic, 1> right(4 * m);
    for(Eigen::Index i = 0; i < m; ++i)
    {
      const Vector_3& n = cloud.normals[std::size_t(i)];
      right.segment<4>(4 * i) << 0, n.x(), n.y(), n.z();
      right.segment<3>(4 * i + 1) /= std::sqrt(Real(n.squared_length()));
      for(Eigen::Index j = 0; j < m; ++j)
      {
        Real value;
        Vector gradient;
        Matrix hessian;
        evaluate(m_points[std::size_t(i)] - m_points[std::size_t(j)], value, gradient, hessian);
        system(4 * i, 4 * j) = value;
        system.block<1, 3>(4 * i, 4 * j + 1) = gradient.transpose();
        system.block<3, 1>(4 * i + 1, 4 * j) = gradient;
        system.block<3, 3>(4 * i + 1, 4 * j + 1) = hessian;
      }
    }
    m_weights = system.fullPivLu().solve(right);
  }

  Real value(const Point_3& p) const
  {
    const Vector x = (Vector(p.x(), p.y(), p.z()) - m_center) / m_size;
    Real sum = 0;
    for(std::size_t j = 0; j < m_points.size(); ++j)
    {
      Real value;
      Vector gradient;
      Matrix hessian;
      evaluate(x - m_points[j], value, gradient, hessian);
      sum += m_weights[4 * Eigen::Index(j)] * value +
             m_weights.segment<3>(4 * Eigen::Index(j) + 1).dot(gradient);
    }
    return m_size * sum;
  }

  Vector gradient(const Point_3& p) const
  {
    const Vector x = (Vector(p.x(), p.y(), p.z()) - m_center) / m_size;
    Vector sum = Vector::Zero();
    for(std::size_t j = 0; j < m_points.size(); ++j)
    {
      Real value;
      Vector gradient;
      Matrix hessian;
      evaluate(x - m_points[j], value, gradient, hessian);
      sum +=
          m_weights[4 * Eigen::Index(j)] * gradient + hessian * m_weights.segment<3>(4 * Eigen::Index(j) + 1);
    }
    return sum;
  }

private:
  void evaluate(const Vector& d, Real& value, Vector& gradient, Matrix& hessian) const
  {
    const Real r = std::sqrt(d.squaredNorm());
    value = m_phi.value(r);
    if(r == 0)
    {
      gradient.setZero();
      hessian = m_phi.second(0) * Matrix::Identity();
      return;
    }
    const Vector u = d / r;
    const Real first = m_phi.first(r), second = m_phi.second(r);
    gradient = first * u;
    hessian = (second - first / r) * u * u.transpose() + first / r * Matrix::Identity();
  }

  Radial m_phi;
  Vector m_center;
  Real m_size = 1;
  std::vector<Vector> m_points;
  Eigen::Matrix<Real, Eigen::Dynamic, 1> m_weights;
};

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(values_and_normals_are_interpolated, Function, Basis_functions)
{
  Cloud cloud = ellipsoid(80, 3, 2, 4, Point_3(1, -2, 3));
  std::vector<Vector_3> of_any_length;
  for(std::size_t i = 0; i < cloud.normals.size(); ++i)
    of_any_length.push_back(std::pow(10., int(i % 7) - 3) * cloud.normals[i]);
  const SC::Hermite_rbf_interpolant f(cloud.points, of_any_length, Function());
  BOOST_REQUIRE(f.is_valid());
  BOOST_TEST(f.number_of_centers() == 80u);
  double largest_value = 0, largest_gradient = 0;
  for(std::size_t i = 0; i < cloud.points.size(); ++i)
  {
    test_support::raise_to(largest_value, std::abs(f(cloud.points[i])));
    const Vector_3 difference = f.gradient(cloud.points[i]) - cloud.normals[i];
    test_support::raise_to(largest_gradient, std::sqrt(difference.squared_length()));
  }
  BOOST_TEST(largest_value < 1e-9);
  BOOST_TEST(largest_gradient < 1e-9);
}

// A polynomial part leaves nothing to radial functions where data are those of a polynomial of its degree: that of a unit sphere is
// (|x|^2 - 1) / 2, that of a plane its height, which no polynomial but those of the height tell from zero there.
BOOST_AUTO_TEST_CASE(polynomials_are_reproduced)
{
  const double size = 3., center = 2.;
  const Cloud ball = ellipsoid(60, size, size, size, Point_3(center, 0, 0));
  const std::vector<Point_3> anywhere = random_points(50, 5, 2. * size);
  const auto check_ball = [&](const auto& f)
  {
    BOOST_REQUIRE(f.is_valid());
    for(const Point_3& p : anywhere)
    {
      const Vector_3 d = p - Point_3(center, 0, 0);
      BOOST_TEST(std::abs(f(p) - (d.squared_length() / size - size) / 2.) < 1e-9);
      BOOST_TEST(std::sqrt((f.gradient(p) - d / size).squared_length()) < 1e-9);
      BOOST_TEST((f.hessian(p) - Eigen::Matrix3d::Identity() / size).norm() < 1e-9);
    }
  };
  check_ball(SC::Hermite_rbf_interpolant(ball.points, ball.normals, SC::Polyharmonic<5>(), 2));
  check_ball(SC::Hermite_rbf_interpolant(ball.points, ball.normals, SC::Polyharmonic<7>(), 3));
  check_ball(SC::Hermite_rbf_interpolant(ball.points, ball.normals, SC::Polyharmonic_logarithmic<4>(), 2));

  Cloud plane;
  for(const Point_3& p : random_points(40, 6, 1.))
  {
    plane.points.emplace_back(p.x(), p.y(), 0);
    plane.normals.emplace_back(0, 0, 1);
  }
  const SC::Hermite_rbf_interpolant f(plane.points, plane.normals, SC::Polyharmonic<9>(), 4);
  BOOST_REQUIRE(f.is_valid());
  for(const Point_3& p : random_points(20, 7, 1.))
  {
    const Point_3 on_plane(p.x(), p.y(), 0);
    BOOST_TEST(std::abs(f(on_plane)) < 1e-9);
    BOOST_TEST(std::sqrt((f.gradient(on_plane) - Vector_3(0, 0, 1)).squared_length()) < 1e-9);
  }
}

// What isn't a polynomial is interpolated as without a polynomial part, and the weights see none.
BOOST_AUTO_TEST_CASE(values_and_normals_are_interpolated_with_polynomials)
{
  const Cloud cloud = ellipsoid(80, 3, 2, 4, Point_3(1, -2, 3));
  const auto check = [&](const auto& f, const double tolerance)
  {
    BOOST_REQUIRE(f.is_valid());
    for(std::size_t i = 0; i < cloud.points.size(); ++i)
    {
      BOOST_TEST(std::abs(f(cloud.points[i])) < tolerance);
      BOOST_TEST(std::sqrt((f.gradient(cloud.points[i]) - cloud.normals[i]).squared_length()) < tolerance);
    }
  };
  for(const int degree : {0, 1, 2, 3})
    BOOST_TEST_CONTEXT("degree " << degree)
    {
      check(SC::Hermite_rbf_interpolant(cloud.points, cloud.normals, SC::Polyharmonic<3>(), degree), 1e-9);
      check(SC::Hermite_rbf_interpolant(cloud.points, cloud.normals, SC::Polyharmonic<7>(), degree), 1e-8);
    }
  // three points: 12 equations, for which a polynomial of a higher degree than 1 is too much
  Cloud few;
  few.points.assign(cloud.points.begin(), cloud.points.begin() + 3);
  few.normals.assign(cloud.normals.begin(), cloud.normals.begin() + 3);
  const SC::Hermite_rbf_interpolant f(few.points, few.normals, SC::Polyharmonic<9>(), 8);
  const SC::Hermite_rbf_interpolant g(few.points, few.normals, SC::Polyharmonic<9>(), 1);
  BOOST_TEST(f(CGAL::ORIGIN) == g(CGAL::ORIGIN));
}

BOOST_AUTO_TEST_CASE(equals_the_plain_solution_anywhere)
{
  const Point_3 center(5, -1, 2);
  const Cloud cloud = ellipsoid(25, 3, 2, 4, center);
  const auto check = [&](const auto& phi, const Radial& plain_phi)
  {
    const SC::Hermite_rbf_interpolant f(cloud.points, cloud.normals, phi);
    BOOST_REQUIRE(f.is_valid());
    const Plain_solution plain(cloud, plain_phi);
    double error = 0, size = 0;
    for(const Point_3& p : random_points(40, 3, 5, center))
    {
      test_support::raise_to(error, std::abs(double(f(p) - plain.value(p))));
      test_support::raise_to(size, std::abs(double(plain.value(p))));
      const Plain_solution::Vector g = plain.gradient(p);
      for(int k = 0; k < 3; ++k)
        test_support::raise_to(error, std::abs(double(f.gradient(p)[k] - g[k])));
    }
    BOOST_TEST(error < 1e-9 * size);
    BOOST_TEST(size > .1);
  };
  using Real = long double;
  check(SC::Polyharmonic<3>(),
        {[](Real r) { return r * r * r; }, [](Real r) { return 3 * r * r; }, [](Real r) { return 6 * r; }});
  check(SC::Polyharmonic<5>(),
        {[](Real r) { return r * r * r * r * r; }, [](Real r) { return 5 * r * r * r * r; },
         [](Real r) { return 20 * r * r * r; }});
  check(SC::Exponential_cubic(.7),
        {[](Real r) { return std::exp(Real(-.7) * r * r * r); },
         [](Real r) { return Real(-2.1) * r * r * std::exp(Real(-.7) * r * r * r); },
         [](Real r)
         { return (Real(4.41) * r * r * r * r - Real(4.2) * r) * std::exp(Real(-.7) * r * r * r); }});
  check(SC::Gaussian(1.5),
        {[](Real r) { return std::exp(Real(-2.25) * r * r); },
         [](Real r) { return Real(-4.5) * r * std::exp(Real(-2.25) * r * r); },
         [](Real r) { return (Real(20.25) * r * r - Real(4.5)) * std::exp(Real(-2.25) * r * r); }});
  check(SC::Multiquadric(2), {[](Real r) { return std::sqrt(1 + 4 * r * r); },
                              [](Real r) { return 4 * r / std::sqrt(1 + 4 * r * r); },
                              [](Real r) { return 4 / std::pow(1 + 4 * r * r, Real(1.5)); }});
  check(SC::Inverse_multiquadric(2),
        {[](Real r) { return 1 / std::sqrt(1 + 4 * r * r); },
         [](Real r) { return -4 * r / std::pow(1 + 4 * r * r, Real(1.5)); },
         [](Real r) { return (32 * r * r - 4) / std::pow(1 + 4 * r * r, Real(2.5)); }});
  check(SC::Wendland_1_1(.4), {[](Real r)
                               {
                                 const Real a = Real(.4) * r, b = std::max(1 - a, Real(0));
                                 return b * b * b * (3 * a + 1);
                               },
                               [](Real r)
                               {
                                 const Real a = Real(.4) * r, b = std::max(1 - a, Real(0));
                                 return Real(.4) * -12 * a * b * b;
                               },
                               [](Real r)
                               {
                                 const Real a = Real(.4) * r, b = std::max(1 - a, Real(0));
                                 return Real(.16) * (-12 * b * b + 24 * a * b);
                               }});
}

BOOST_AUTO_TEST_CASE_TEMPLATE(derivatives_are_those_of_the_value, Function, Basis_functions)
{
  const double size = 7;
  const Cloud cloud = ellipsoid(40, size, .8 * size, .6 * size);
  const SC::Hermite_rbf_interpolant f(cloud.points, cloud.normals, Function());
  BOOST_REQUIRE(f.is_valid());
  // away from the points and from the ends of supports, where not every function is smooth
  const double h = 1e-3 * size;
  double largest_gradient = 0, largest_hessian = 0, gradient_error = 0, hessian_error = 0, asymmetry = 0;
  for(const Point_3& p : random_points(20, 5, size))
  {
    const Vector_3 g = f.gradient(p);
    const auto hessian = f.hessian(p);
    for(int k = 0; k < 3; ++k)
    {
      const Vector_3 e(k == 0, k == 1, k == 2);
      // fourth order
      const double quotient =
          (8 * (f(p + h * e) - f(p - h * e)) - (f(p + 2 * h * e) - f(p - 2 * h * e))) / (12 * h);
      test_support::raise_to(gradient_error, std::abs(g[k] - quotient));
      test_support::raise_to(largest_gradient, std::abs(quotient));
      const Vector_3 column = (8 * (f.gradient(p + h * e) - f.gradient(p - h * e)) -
                               (f.gradient(p + 2 * h * e) - f.gradient(p - 2 * h * e))) /
                              (12 * h);
      for(int l = 0; l < 3; ++l)
      {
        test_support::raise_to(hessian_error, std::abs(hessian(l, k) - column[l]));
        test_support::raise_to(largest_hessian, std::abs(column[l]));
        test_support::raise_to(asymmetry, std::abs(hessian(l, k) - hessian(k, l)));
      }
    }
  }
  BOOST_TEST(gradient_error < 1e-5 * largest_gradient);
  BOOST_TEST(hessian_error < 1e-4 * largest_hessian);
  BOOST_TEST(asymmetry < 1e-9 * largest_hessian);
}

BOOST_AUTO_TEST_CASE(independent_of_unit_and_position)
{
  const Cloud reference = ellipsoid(60, 1, .9, .8);
  const auto check = [&](const auto& phi)
  {
    const SC::Hermite_rbf_interpolant f(reference.points, reference.normals, phi);
    BOOST_REQUIRE(f.is_valid());
    for(double scale : {1e-150, 1e-6, 1e6, 1e150})
    {
      const Point_3 center(3 * scale, -5 * scale, scale);
      std::vector<Point_3> points;
      for(const Point_3& p : reference.points)
        points.push_back(center + scale * (p - CGAL::ORIGIN));
      const SC::Hermite_rbf_interpolant g(points, reference.normals, phi);
      BOOST_REQUIRE(g.is_valid());
      for(const Point_3& p : random_points(10, 6, 1.2))
      {
        const Point_3 q = center + scale * (p - CGAL::ORIGIN);
        BOOST_TEST(std::abs(f(p) - g(q) / scale) < 1e-9 * (1 + std::abs(f(p))));
        const Vector_3 gradient = f.gradient(p);
        BOOST_TEST(std::sqrt((gradient - g.gradient(q)).squared_length()) <
                   1e-9 * (1 + std::sqrt(gradient.squared_length())));
        BOOST_TEST((f.hessian(p) - g.hessian(q) * scale).norm() < 1e-8 * (1 + f.hessian(p).norm()));
      }
    }
    // to the last bit for powers of two
    for(double scale : {std::ldexp(1., -300), 8., std::ldexp(1., 300)})
    {
      std::vector<Point_3> points;
      for(const Point_3& p : reference.points)
        points.push_back(CGAL::ORIGIN + scale * (p - CGAL::ORIGIN));
      const SC::Hermite_rbf_interpolant g(points, reference.normals, phi);
      for(const Point_3& p : random_points(10, 6, 1.2))
      {
        const Point_3 q = CGAL::ORIGIN + scale * (p - CGAL::ORIGIN);
        BOOST_TEST(f(p) == g(q) / scale);
        BOOST_TEST(f.gradient(p) == g.gradient(q));
        BOOST_TEST((f.hessian(p) == g.hessian(q) * scale));
      }
    }
  };
  check(SC::Polyharmonic<3>());
  check(SC::Inverse_multiquadric());
}

// Vector instructions longer than what malloc() aligns for must not add in an order that depends on addresses.
BOOST_AUTO_TEST_CASE_TEMPLATE(addresses_do_not_count, Function, Basis_functions)
{
  const Cloud cloud = ellipsoid(11, 1., .8, .6);
  const std::vector<Point_3> where = random_points(5, 3, 1.);
  // all at once, at addresses of their own
  std::list<SC::Hermite_rbf_interpolant<Kernel, Function>> interpolants;
  std::list<std::vector<char>> between;
  for(int i = 0; i < 16; ++i)
  {
    interpolants.emplace_back(cloud.points, cloud.normals);
    between.emplace_back(40);
    for(const Point_3& p : where)
    {
      BOOST_TEST(interpolants.back()(p) == interpolants.front()(p));
      BOOST_TEST((interpolants.back().hessian(p) == interpolants.front().hessian(p)));
    }
  }
}

// negative inside, positive outside, about the distance near the surface, and all of it negated with the normals
BOOST_AUTO_TEST_CASE(sides)
{
  const Point_3 center(1, 2, 3);
  const double radius = 2;
  Cloud cloud = ellipsoid(150, radius, radius, radius, center);
  const SC::Hermite_rbf_interpolant f(cloud.points, cloud.normals);
  for(Vector_3& n : cloud.normals)
    n = -n;
  const SC::Hermite_rbf_interpolant flipped(cloud.points, cloud.normals);
  BOOST_REQUIRE(f.is_valid());
  BOOST_REQUIRE(flipped.is_valid());
  for(const Point_3& direction : random_points(40, 8, 1))
  {
    const Vector_3 n = (direction - CGAL::ORIGIN) / std::sqrt((direction - CGAL::ORIGIN).squared_length());
    for(double distance : {-.2, -.05, .05, .2})
    {
      const Point_3 p = center + (radius + distance) * n;
      BOOST_TEST(std::abs(f(p) - distance) < .15 * std::abs(distance));
      BOOST_TEST(flipped(p) == -f(p));
    }
  }
}

// between the points: on the zero set, its curvatures are those of the sphere and the torus
BOOST_AUTO_TEST_CASE(curvatures_of_a_sphere)
{
  const double radius = 5;
  const Point_3 center(-1, 0, 4);
  const Cloud cloud = ellipsoid(200, radius, radius, radius, center);
  const auto error = [&](const auto& phi)
  {
    const SC::Hermite_rbf_interpolant f(cloud.points, cloud.normals, phi);
    BOOST_TEST(f.is_valid());
    double worst = 0;
    for(const Point_3& direction : random_points(60, 9, 1))
    {
      const Vector_3 d = direction - CGAL::ORIGIN;
      Point_3 p = center + radius / std::sqrt(d.squared_length()) * d;
      for(int step = 0; step < 3; ++step)
        p = p - f(p) / f.gradient(p).squared_length() * f.gradient(p);
      test_support::raise_to(worst, std::abs(std::sqrt((p - center).squared_length()) / radius - 1));
      const auto k = SC::implicit_surface_curvatures(f.gradient(p), f.hessian(p));
      test_support::raise_to(worst, std::abs(k.min_curvature * radius - 1));
      test_support::raise_to(worst, std::abs(k.max_curvature * radius - 1));
    }
    BOOST_TEST_MESSAGE("sphere: largest relative error " << worst);
    return worst;
  };
  // On a sphere (x - p) . n is -|x - p|^2 / 2 for all centers p: powers of the distance vanish exactly on all of it.
  BOOST_TEST(error(SC::Polyharmonic<3>()) < 1e-11);
  BOOST_TEST(error(SC::Polyharmonic<5>()) < 1e-11);
  BOOST_TEST(error(SC::Gaussian()) < 1e-6);
  BOOST_TEST(error(SC::Inverse_multiquadric()) < 2e-3);
  BOOST_TEST(error(SC::Matern_9_2()) < 2e-5);
}

BOOST_AUTO_TEST_CASE(curvatures_of_a_torus)
{
  const double ring = 3, tube = 1, two_pi = 6.283185307179586;
  Cloud cloud;
  for(int i = 0; i < 24; ++i)
    for(int j = 0; j < 10; ++j)
    {
      const double a = two_pi * i / 24, b = two_pi * (j + .5 * (i % 2)) / 10;
      const Vector_3 out(std::cos(a), std::sin(a), 0);
      const Vector_3 n = std::cos(b) * out + Vector_3(0, 0, std::sin(b));
      cloud.points.push_back(CGAL::ORIGIN + ring * out + tube * n);
      cloud.normals.push_back(n);
    }
  const SC::Hermite_rbf_interpolant f(cloud.points, cloud.normals, SC::Polyharmonic<5>());
  BOOST_REQUIRE(f.is_valid());
  double worst = 0;
  for(int k = 0; k < 60; ++k)
  {
    const double a = 1.1 * k, b = 2.3 * k;
    const Vector_3 out(std::cos(a), std::sin(a), 0);
    Point_3 p = CGAL::ORIGIN + ring * out + tube * (std::cos(b) * out + Vector_3(0, 0, std::sin(b)));
    for(int step = 0; step < 3; ++step)
      p = p - f(p) / f.gradient(p).squared_length() * f.gradient(p);
    const auto c = SC::implicit_surface_curvatures(f.gradient(p), f.hessian(p));
    test_support::raise_to(worst, std::abs(c.max_curvature - 1 / tube));
    test_support::raise_to(worst, std::abs(c.min_curvature - std::cos(b) / (ring + tube * std::cos(b))));
  }
  BOOST_TEST_MESSAGE("torus: largest error " << worst);
  BOOST_TEST(worst < 1e-3);
}

BOOST_AUTO_TEST_CASE(shape_parameter_is_used_or_chosen)
{
  const Cloud cloud = ellipsoid(50, 1, 1, 1); // of root mean square radius 1, nearly
  const SC::Hermite_rbf_interpolant set(cloud.points, cloud.normals, SC::Gaussian(2.25));
  BOOST_TEST(set.basis_function().shape_parameter() == 2.25);
  double spacing = 0;
  for(const auto& p : cloud.points)
  {
    double nearest = infinity;
    for(const auto& q : cloud.points)
      if(&p != &q)
        nearest = std::min(nearest, std::sqrt((p - q).squared_length()));
    spacing += nearest / double(cloud.points.size());
  }
  const SC::Hermite_rbf_interpolant chosen(cloud.points, cloud.normals, SC::Gaussian());
  BOOST_TEST(chosen.basis_function().is_shape_parameter_set());
  BOOST_TEST(std::abs(chosen.basis_function()(4 * spacing) - .5) < 1e-3);
  const SC::Hermite_rbf_interpolant growing(cloud.points, cloud.normals, SC::Multiquadric());
  BOOST_TEST(std::abs(growing.basis_function()(4 * spacing) - 2) < 1e-3);

  // narrower where that is too flat for the arithmetic
  const Cloud many = ellipsoid(200, 1, 1, 1);
  const SC::Hermite_rbf_interpolant narrow(many.points, many.normals, SC::Gaussian());
  BOOST_REQUIRE(narrow.is_valid());
  const SC::Hermite_rbf_interpolant wide(many.points, many.normals,
                                         SC::Gaussian(narrow.basis_function().shape_parameter() / 2));
  BOOST_TEST(!wide.is_valid());
}

BOOST_AUTO_TEST_CASE(any_range_and_kernel)
{
  using Float_kernel = CGAL::Simple_cartesian<float>;
  const std::list<Float_kernel::Point_3> points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  const Float_kernel::Vector_3 normals[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 2}};
  const SC::Hermite_rbf_interpolant f(points, normals);
  static_assert(
      std::is_same_v<decltype(f), const SC::Hermite_rbf_interpolant<Float_kernel, SC::Polyharmonic<3>>>);
  BOOST_REQUIRE(f.is_valid());
  for(const auto& p : points)
    BOOST_TEST(std::abs(f(p)) < 1e-6f);

  // a single point: its tangent plane, with a basis function of which one center is enough
  const SC::Hermite_rbf_interpolant one(std::vector<Point_3>{{1, 2, 3}}, std::vector<Vector_3>{{0, 0, 2}},
                                        SC::Gaussian(1e-3));
  BOOST_REQUIRE(one.is_valid());
  BOOST_TEST(std::abs(one(Point_3(1, 2, 3.5)) - .5) < 1e-6);
  BOOST_TEST(std::abs(one(Point_3(5, 7, 3))) < 1e-12);
}

BOOST_AUTO_TEST_CASE(singular_systems_are_announced)
{
  const auto check = [](const auto& f)
  {
    BOOST_TEST(!f.is_valid());
    BOOST_TEST(std::isnan(f(Point_3(.1, .2, .3))));
    BOOST_TEST(std::isnan(f.gradient(Point_3(.1, .2, .3)).x()));
    BOOST_TEST(f.hessian(Point_3(.1, .2, .3)).array().isNaN().all());
  };
  Cloud cloud = ellipsoid(30, 1, .9, .8);
  // too flat
  check(SC::Hermite_rbf_interpolant(cloud.points, cloud.normals, SC::Gaussian(1e-3)));
  check(SC::Hermite_rbf_interpolant(cloud.points, cloud.normals, SC::Multiquadric(1e-3)));
  // the same point and normal twice, and then with another normal
  cloud.points.push_back(cloud.points[3]);
  cloud.normals.push_back(cloud.normals[3]);
  for(int contradiction = 0; contradiction < 2; ++contradiction)
  {
    check(SC::Hermite_rbf_interpolant(cloud.points, cloud.normals, SC::Polyharmonic<3>()));
    check(SC::Hermite_rbf_interpolant(cloud.points, cloud.normals, SC::Polyharmonic<5>()));
    check(SC::Hermite_rbf_interpolant(cloud.points, cloud.normals, SC::Gaussian()));
    check(SC::Hermite_rbf_interpolant(cloud.points, cloud.normals, SC::Wendland_3_2()));
    check(SC::Hermite_rbf_interpolant(cloud.points, cloud.normals, SC::Multiquadric()));
    check(SC::Hermite_rbf_interpolant(cloud.points, cloud.normals, SC::Inverse_multiquadric()));
    cloud.normals.back() = Vector_3(0, 0, 1);
  }
  // two that are nearly one: no reason for basis functions that are too narrow for all the others
  const Cloud many = ellipsoid(100, 1, 1, 1);
  const SC::Hermite_rbf_interpolant without(many.points, many.normals, SC::Inverse_multiquadric());
  BOOST_TEST(without.is_valid());
  for(const double distance : {1e-4, 1e-6, 1e-8, 1e-10})
  {
    Cloud with_copy = many;
    const Vector_3 n = many.normals[40], moved = n + distance * Vector_3(-n.y(), n.x(), 0.);
    with_copy.normals.push_back(moved / std::sqrt(moved.squared_length()));
    with_copy.points.push_back(CGAL::ORIGIN + with_copy.normals.back());
    const SC::Hermite_rbf_interpolant f(with_copy.points, with_copy.normals, SC::Inverse_multiquadric());
    const double quotient = f.basis_function().shape_parameter() / without.basis_function().shape_parameter();
    BOOST_TEST((!f.is_valid() || (quotient > .9 && quotient < 1.1)));
  }
  cloud.points.back() = cloud.points[3] + Vector_3(1e-14, 0., 0.);
  cloud.normals.back() = cloud.normals[3];
  check(SC::Hermite_rbf_interpolant(cloud.points, cloud.normals, SC::Polyharmonic<3>()));
  // all the same
  check(SC::Hermite_rbf_interpolant(std::vector<Point_3>(5, Point_3(1, 1, 1)),
                                    std::vector<Vector_3>(5, Vector_3(0, 0, 1))));
  // a single point: all of the system is zero
  check(SC::Hermite_rbf_interpolant(std::vector<Point_3>{{1, 1, 1}}, std::vector<Vector_3>{{0, 0, 1}}));
}

BOOST_AUTO_TEST_CASE(wrong_arguments_throw)
{
  using Points = std::vector<Point_3>;
  using Vectors = std::vector<Vector_3>;
  using Interpolant = SC::Hermite_rbf_interpolant<Kernel>;
  const Points points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Vectors normals(3, Vector_3(0, 0, 1));

  using test_support::says;
  BOOST_CHECK_EXCEPTION(Interpolant(Points(), Vectors()), std::invalid_argument, says("`points`"));
  BOOST_CHECK_EXCEPTION(Interpolant(points, Vectors(2, normals[0])), std::invalid_argument,
                        says("`normals`"));
  BOOST_CHECK_EXCEPTION(Interpolant(points, Vectors(4, normals[0])), std::invalid_argument,
                        says("`normals`"));
  BOOST_CHECK_EXCEPTION(Interpolant(points, Vectors(3, Vector_3(0, 0, 0))), std::invalid_argument,
                        says("`normals`"));
  BOOST_CHECK_EXCEPTION(Interpolant(points, Vectors(3, Vector_3(0, quiet_nan, 0))), std::invalid_argument,
                        says("`normals`"));
  BOOST_CHECK_EXCEPTION(Interpolant(Points{{0, infinity, 0}}, Vectors{normals[0]}), std::invalid_argument,
                        says("`points`"));
  BOOST_CHECK_EXCEPTION(SC::Hermite_rbf_interpolant(points, normals, SC::Polyharmonic<4>()),
                        std::invalid_argument, says("`basis_function`"));
  BOOST_CHECK_EXCEPTION(SC::Hermite_rbf_interpolant(points, normals, SC::Polyharmonic_logarithmic<3>()),
                        std::invalid_argument, says("`basis_function`"));
  BOOST_CHECK_EXCEPTION(SC::Hermite_rbf_interpolant(points, normals, SC::Polyharmonic<1>()),
                        std::invalid_argument, says("second derivatives"));
  BOOST_CHECK_EXCEPTION(SC::Hermite_rbf_interpolant(points, normals, SC::Polyharmonic_logarithmic<2>()),
                        std::invalid_argument, says("second derivatives"));
  for(const int degree : {-2, 9})
    BOOST_CHECK_EXCEPTION(SC::Hermite_rbf_interpolant(points, normals, SC::Polyharmonic<3>(), degree),
                          std::invalid_argument, says("`polynomial_degree`"));
}

BOOST_AUTO_TEST_SUITE_END()
