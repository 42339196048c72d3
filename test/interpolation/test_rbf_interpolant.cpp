#include <boost/test/unit_test.hpp>

#include "raise_to.h"
#include "says.h"

#include <Shape_characteristics/interpolation/Exponential_cubic.h>
#include <Shape_characteristics/interpolation/Gaussian.h>
#include <Shape_characteristics/interpolation/Inverse_multiquadric.h>
#include <Shape_characteristics/interpolation/Inverse_multiquadric_cubic.h>
#include <Shape_characteristics/interpolation/Inverse_quadratic.h>
#include <Shape_characteristics/interpolation/Matern_9_2.h>
#include <Shape_characteristics/interpolation/Multiquadric.h>
#include <Shape_characteristics/interpolation/Polyharmonic.h>
#include <Shape_characteristics/interpolation/Polyharmonic_logarithmic.h>
#include <Shape_characteristics/interpolation/Rbf_interpolant.h>
#include <Shape_characteristics/interpolation/Wendland_1_1.h>
#include <Shape_characteristics/interpolation/Wendland_3_2.h>

#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <list>
#include <random>
#include <tuple>
#include <vector>

BOOST_AUTO_TEST_SUITE(rbf_interpolant)

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;

namespace {

using Basis_functions = std::tuple<SC::Gaussian,
                                   SC::Multiquadric,
                                   SC::Inverse_quadratic,
                                   SC::Inverse_multiquadric,
                                   SC::Inverse_multiquadric_cubic,
                                   SC::Exponential_cubic,
                                   SC::Matern_9_2,
                                   SC::Wendland_1_1,
                                   SC::Wendland_3_2,
                                   SC::Polyharmonic<1>,
                                   SC::Polyharmonic<3>,
                                   SC::Polyharmonic<5>,
                                   SC::Polyharmonic_logarithmic<2>,
                                   SC::Polyharmonic_logarithmic<4>>;

const double quiet_nan = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

struct Sphere
{
  std::vector<Point_3> points;
  std::vector<Vector_3> normals;

  Sphere(int n, double radius, const Point_3& center)
  {
    for(int i = 0; i < n; ++i)
    {
      const double z = 1 - (2 * i + 1.) / n, s = std::sqrt(1 - z * z), angle = 2.399963229728653 * i;
      normals.emplace_back(s * std::cos(angle), s * std::sin(angle), z);
      points.push_back(center + radius * normals.back());
    }
  }
};

std::vector<Point_3>
random_points(int n, unsigned seed, double size = 1, const Vector_3& shift = Vector_3(0, 0, 0))
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::vector<Point_3> result;
  for(int i = 0; i < n; ++i)
  {
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    result.push_back(Point_3(size * x, size * y, size * z) + shift);
  }
  return result;
}

double smooth_function(const Point_3& p)
{
  return std::sin(p.x() + 0.5 * p.y()) + p.y() * p.z();
}

std::vector<double> values_at(const std::vector<Point_3>& points)
{
  std::vector<double> result;
  for(const Point_3& p : points)
    result.push_back(smooth_function(p));
  return result;
}

// Gauss-Jordan elimination with full pivoting in long double: the slow plain solution of equation 3.7
std::vector<long double> plain_weights(std::vector<std::vector<long double>> a, std::vector<long double> b)
{
  const std::size_t n = b.size();
  std::vector<std::size_t> variable(n);
  for(std::size_t i = 0; i < n; ++i)
    variable[i] = i;
  for(std::size_t k = 0; k < n; ++k)
  {
    std::size_t row = k, column = k;
    for(std::size_t i = k; i < n; ++i)
      for(std::size_t j = k; j < n; ++j)
        if(std::abs(a[i][j]) > std::abs(a[row][column]))
        {
          row = i;
          column = j;
        }
    std::swap(a[k], a[row]);
    std::swap(b[k], b[row]);
    for(auto& r : a)
      std::swap(r[k], r[column]);
    std::swap(variable[k], variable[column]);
    for(std::size_t i = 0; i < n; ++i)
      if(i != k)
      {
        const long double factor = a[i][k] / a[k][k];
        for(std::size_t j = k; j < n; ++j)
          a[i][j] -= factor * a[k][j];
        b[i] -= factor * b[k];
      }
  }
  std::vector<long double> x(n);
  for(std::size_t k = 0; k < n; ++k)
    x[variable[k]] = b[k] / a[k][k];
  return x;
}

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(values_are_interpolated, Function, Basis_functions)
{
  const auto points = random_points(60, 1);
  const auto values = values_at(points);
  const SC::Rbf_interpolant f(points, values, Function());
  BOOST_REQUIRE(f.is_valid());
  BOOST_TEST(f.number_of_centers() == 60u);
  BOOST_TEST(f.reciprocal_condition_number() > 1e-14);
  for(std::size_t i = 0; i < points.size(); ++i)
    BOOST_TEST(std::abs(f(points[i]) - values[i]) < 1e-9);
}

// between the points as well: the same sum by the plain solution in long double
BOOST_AUTO_TEST_CASE(equals_the_plain_solution_anywhere)
{
  const auto points = random_points(30, 2, 3, Vector_3(5, -1, 2));
  const auto values = values_at(points);

  // the frame of the documentation
  long double c[3] = {0, 0, 0};
  for(const auto& p : points)
    for(int k = 0; k < 3; ++k)
      c[k] += static_cast<long double>(p[k]) / points.size();
  long double square = 0;
  for(const auto& p : points)
    for(int k = 0; k < 3; ++k)
      square += (p[k] - c[k]) * (p[k] - c[k]) / points.size();
  const long double size = std::sqrt(square);

  const auto check = [&](const auto& phi, auto plain_phi)
  {
    const SC::Rbf_interpolant f(points, values, phi);
    BOOST_REQUIRE(f.is_valid());
    const auto distance = [&](const Point_3& p, const Point_3& q)
    {
      long double sum = 0;
      for(int k = 0; k < 3; ++k)
        sum += (static_cast<long double>(p[k]) - q[k]) * (static_cast<long double>(p[k]) - q[k]);
      return std::sqrt(sum) / size;
    };
    std::vector<std::vector<long double>> matrix(points.size(), std::vector<long double>(points.size()));
    for(std::size_t i = 0; i < points.size(); ++i)
      for(std::size_t j = 0; j < points.size(); ++j)
        matrix[i][j] = plain_phi(distance(points[i], points[j]));
    const auto weights = plain_weights(matrix, {values.begin(), values.end()});
    for(const Point_3& p : random_points(20, 3, 4, Vector_3(5, -1, 2)))
    {
      long double expected = 0;
      for(std::size_t i = 0; i < points.size(); ++i)
        expected += weights[i] * plain_phi(distance(p, points[i]));
      BOOST_TEST(std::abs(f(p) - expected) < 1e-10 * (1 + std::abs(expected)));
    }
  };
  check(SC::Polyharmonic<3>(), [](long double r) { return r * r * r; });
  check(SC::Gaussian(1.7), [](long double r) { return std::exp(-(1.7L * r) * (1.7L * r)); });
  check(SC::Wendland_1_1(0.4),
        [](long double r)
        {
          const long double a = 0.4L * r, b = a < 1 ? 1 - a : 0;
          return b * b * b * (3 * a + 1);
        });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(derivatives_are_those_of_the_value, Function, Basis_functions)
{
  const double size = 7;
  const auto points = random_points(40, 4, size);
  std::vector<double> values;
  for(const Point_3& p : points)
    values.push_back(smooth_function(Point_3(p.x() / size, p.y() / size, p.z() / size)));
  const SC::Rbf_interpolant f(points, values, Function());
  BOOST_REQUIRE(f.is_valid());
  // away from the points and from the ends of supports, where not every function is smooth
  const double h = 1e-3 * size;
  double largest_gradient = 0, largest_hessian = 0, gradient_error = 0, hessian_error = 0;
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
        BOOST_TEST(std::abs(hessian(l, k) - hessian(k, l)) <= 1e-10 * (1 + std::abs(hessian(l, k))));
      }
    }
  }
  BOOST_TEST(gradient_error < 1e-5 * largest_gradient);
  BOOST_TEST(hessian_error < 1e-4 * largest_hessian);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_surface_is_zero_and_signed, Function, Basis_functions)
{
  const Sphere sphere(120, 2, Point_3(1, 2, 3));
  const double offset = 0.2;
  const SC::Rbf_interpolant f(sphere.points, sphere.normals, Function(), offset);
  BOOST_REQUIRE(f.is_valid());
  BOOST_TEST(f.number_of_centers() == 360u);
  for(std::size_t i = 0; i < sphere.points.size(); ++i)
  {
    const Point_3& p = sphere.points[i];
    const Vector_3& n = sphere.normals[i];
    BOOST_TEST(std::abs(f(p)) < 1e-8);
    BOOST_TEST(std::abs(f(p + offset * n) - 1) < 1e-8);
    BOOST_TEST(std::abs(f(p - offset * n) + 1) < 1e-8);
  }
}

// the gradient is the normal over the offset, and with it the Hessian gives the curvature of the sphere
BOOST_AUTO_TEST_CASE(a_surface_has_normals_and_curvatures)
{
  const double radius = 5;
  const Sphere sphere(200, radius, Point_3(-1, 0, 4));
  const auto error = [&](const auto& phi)
  {
    const SC::Rbf_interpolant f(sphere.points, sphere.normals, phi);
    BOOST_TEST(f.is_valid());
    double worst = 0;
    for(std::size_t i = 0; i < sphere.points.size(); ++i)
    {
      const Vector_3 g = f.gradient(sphere.points[i]);
      const double length = std::sqrt(g.squared_length());
      test_support::raise_to(worst, 1 - g * sphere.normals[i] / length);
      // mean curvature, 4.11
      const Eigen::Vector3d n(g.x() / length, g.y() / length, g.z() / length);
      const auto h = f.hessian(sphere.points[i]);
      test_support::raise_to(worst, std::abs((h.trace() - n.dot(h * n)) / (2 * length) * radius - 1));
    }
    return worst;
  };
  BOOST_TEST(error(SC::Gaussian()) < 1e-3);
  BOOST_TEST(error(SC::Polyharmonic<5>()) < 1e-2);
  BOOST_TEST(error(SC::Matern_9_2()) < 2e-2);
  BOOST_TEST(error(SC::Inverse_multiquadric()) < 2e-2);
}

BOOST_AUTO_TEST_CASE(independent_of_unit_and_position)
{
  const Sphere reference(80, 1, CGAL::ORIGIN);
  const SC::Rbf_interpolant f(reference.points, reference.normals, SC::Inverse_multiquadric());
  for(double scale : {1e-150, 1e-6, 1e6, 1e150})
  {
    const Point_3 center(3 * scale, -5 * scale, scale);
    std::vector<Point_3> points;
    for(const Point_3& p : reference.points)
      points.push_back(center + scale * (p - CGAL::ORIGIN));
    // the length of the normals doesn't matter either
    std::vector<Vector_3> normals;
    for(const Vector_3& n : reference.normals)
      normals.push_back(1 / scale * n);
    const SC::Rbf_interpolant g(points, normals, SC::Inverse_multiquadric());
    BOOST_REQUIRE(g.is_valid());
    for(const Point_3& p : random_points(10, 6, 1.2))
    {
      const Point_3 q = center + scale * (p - CGAL::ORIGIN);
      BOOST_TEST(std::abs(f(p) - g(q)) < 1e-7 * (1 + std::abs(f(p))));
      for(int k = 0; k < 3; ++k)
        BOOST_TEST(std::abs(f.gradient(p)[k] - g.gradient(q)[k] * scale) <
                   1e-7 * (1 + std::abs(f.gradient(p)[k])));
      if(scale < 1e100 && scale > 1e-100) // else second derivatives are out of range
        BOOST_TEST((f.hessian(p) - g.hessian(q) * scale * scale).norm() < 1e-7 * (1 + f.hessian(p).norm()));
    }
  }
}

BOOST_AUTO_TEST_CASE(shape_parameter_is_used_or_chosen)
{
  const auto points = random_points(50, 7);
  const auto values = values_at(points);
  const SC::Rbf_interpolant set(points, values, SC::Gaussian(2.25));
  BOOST_TEST(set.basis_function().shape_parameter() == 2.25);

  double square = 0, spacing = 0;
  Vector_3 mean(0, 0, 0);
  for(const auto& p : points)
    mean = mean + (p - CGAL::ORIGIN) / points.size();
  for(const auto& p : points)
  {
    square += (p - CGAL::ORIGIN - mean).squared_length() / points.size();
    double nearest = infinity;
    for(const auto& q : points)
      if(&p != &q)
        nearest = std::min(nearest, std::sqrt((p - q).squared_length()));
    spacing += nearest / points.size();
  }
  spacing /= std::sqrt(square);
  const SC::Rbf_interpolant chosen(points, values, SC::Gaussian());
  BOOST_TEST(chosen.basis_function().is_shape_parameter_set());
  BOOST_TEST(std::abs(chosen.basis_function()(2 * spacing) - 0.5) < 1e-8);
  const SC::Rbf_interpolant growing(points, values, SC::Multiquadric());
  BOOST_TEST(std::abs(growing.basis_function()(2 * spacing) - 2) < 1e-8);
  const SC::Rbf_interpolant cubic(points, values, SC::Exponential_cubic());
  BOOST_TEST(std::abs(cubic.basis_function()(2 * spacing) - 0.5) < 1e-8);
}

BOOST_AUTO_TEST_CASE(any_range_and_kernel)
{
  using Float_kernel = CGAL::Simple_cartesian<float>;
  const std::list<Float_kernel::Point_3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const int values[] = {1, 2, 3, 4};
  const SC::Rbf_interpolant f(points, values);
  static_assert(std::is_same_v<decltype(f), const SC::Rbf_interpolant<Float_kernel, SC::Polyharmonic<3>>>);
  BOOST_REQUIRE(f.is_valid());
  int i = 0;
  for(const auto& p : points)
    BOOST_TEST(std::abs(f(p) - values[i++]) < 1e-6f);

  const SC::Rbf_interpolant<Kernel> one(std::vector<Point_3>{{1, 2, 3}}, std::vector<Vector_3>{{0, 0, 2}}, {},
                                        0.5);
  BOOST_REQUIRE(one.is_valid());
  BOOST_TEST(std::abs(one(Point_3(1, 2, 3.5)) - 1) < 1e-12);
  BOOST_TEST(std::abs(one(Point_3(1, 2, 2.5)) + 1) < 1e-12);
}

BOOST_AUTO_TEST_CASE(singular_systems_are_announced)
{
  auto points = random_points(20, 8);
  auto values = values_at(points);
  points.push_back(points[3]);
  values.push_back(values[3]); // even though it agrees
  const auto check = [](const auto& f)
  {
    BOOST_TEST(!f.is_valid());
    BOOST_TEST(std::isnan(f(Point_3(0.1, 0.2, 0.3))));
    BOOST_TEST(std::isnan(f.gradient(Point_3(0.1, 0.2, 0.3)).x()));
    BOOST_TEST(f.hessian(Point_3(0.1, 0.2, 0.3)).array().isNaN().all());
  };
  check(SC::Rbf_interpolant(points, values, SC::Polyharmonic<3>()));
  check(SC::Rbf_interpolant(points, values, SC::Gaussian()));
  check(SC::Rbf_interpolant(points, values, SC::Wendland_3_2()));
  check(SC::Rbf_interpolant(points, values, SC::Multiquadric()));
  values.back() += 1; // contradiction
  check(SC::Rbf_interpolant(points, values, SC::Inverse_multiquadric()));
  // all the same
  check(SC::Rbf_interpolant(std::vector<Point_3>(5, Point_3(1, 1, 1)), std::vector<double>(5, 1.)));
  // a single point: the function is 0 there
  check(SC::Rbf_interpolant(std::vector<Point_3>{{1, 1, 1}}, std::vector<double>{1.}));
  // too flat
  points.pop_back();
  values.pop_back();
  check(SC::Rbf_interpolant(points, values, SC::Gaussian(1e-3)));
  // near duplicates are not singular, and fine for interpolation
  points.push_back(points[3] + Vector_3(1e-6, 0, 0));
  values.push_back(smooth_function(points.back()));
  const SC::Rbf_interpolant near(points, values, SC::Polyharmonic<1>());
  BOOST_REQUIRE(near.is_valid());
  BOOST_TEST(std::abs(near(points.back()) - values.back()) < 1e-8);
}

BOOST_AUTO_TEST_CASE(wrong_arguments_throw)
{
  using Points = std::vector<Point_3>;
  using Values = std::vector<double>;
  using Vectors = std::vector<Vector_3>;
  using Interpolant = SC::Rbf_interpolant<Kernel>;
  const Points points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Vectors normals(3, Vector_3(0, 0, 1));
  const SC::Polyharmonic<3> phi;

  using test_support::says;
  BOOST_CHECK_EXCEPTION(Interpolant(Points(), Values()), std::invalid_argument, says("`points`"));
  BOOST_CHECK_EXCEPTION(Interpolant(points, Values(2)), std::invalid_argument, says("`values`"));
  BOOST_CHECK_EXCEPTION(Interpolant(points, Values(4)), std::invalid_argument, says("`values`"));
  BOOST_CHECK_EXCEPTION(Interpolant(points, Values{1, quiet_nan, 2}), std::invalid_argument,
                        says("`values`"));
  BOOST_CHECK_EXCEPTION(Interpolant(Points{{0, infinity, 0}}, Values{1}), std::invalid_argument,
                        says("`points`"));
  BOOST_CHECK_EXCEPTION(Interpolant(points, Vectors(2, Vector_3(0, 0, 1))), std::invalid_argument,
                        says("`normals`"));
  BOOST_CHECK_EXCEPTION(Interpolant(points, Vectors(3, Vector_3(0, 0, 0))), std::invalid_argument,
                        says("`normals`"));
  BOOST_CHECK_EXCEPTION(Interpolant(points, Vectors(3, Vector_3(0, quiet_nan, 0))), std::invalid_argument,
                        says("`normals`"));
  for(double offset : {-1., quiet_nan, infinity})
    BOOST_CHECK_EXCEPTION(Interpolant(points, normals, phi, offset), std::invalid_argument, says("`offset`"));
  BOOST_CHECK_EXCEPTION(Interpolant(Points(3, Point_3(1, 1, 1)), normals), std::invalid_argument,
                        says("`offset`"));
  BOOST_CHECK_EXCEPTION(SC::Rbf_interpolant(points, normals, SC::Polyharmonic<2>()), std::invalid_argument,
                        says("`basis_function`"));
  BOOST_CHECK_EXCEPTION(SC::Rbf_interpolant(points, Values(3), SC::Polyharmonic_logarithmic<3>()),
                        std::invalid_argument, says("`basis_function`"));
}

BOOST_AUTO_TEST_SUITE_END()
