#include <boost/test/unit_test.hpp>

#include <Shape_characteristics/interpolation/Exponential_cubic.h>
#include <Shape_characteristics/interpolation/Gaussian.h>
#include <Shape_characteristics/interpolation/Inverse_multiquadric.h>
#include <Shape_characteristics/interpolation/Inverse_multiquadric_cubic.h>
#include <Shape_characteristics/interpolation/Inverse_quadratic.h>
#include <Shape_characteristics/interpolation/Matern_9_2.h>
#include <Shape_characteristics/interpolation/Multiquadric.h>
#include <Shape_characteristics/interpolation/Polyharmonic.h>
#include <Shape_characteristics/interpolation/Polyharmonic_logarithmic.h>
#include <Shape_characteristics/interpolation/Wendland_1_1.h>
#include <Shape_characteristics/interpolation/Wendland_3_2.h>

#include <boost/multiprecision/mpfr.hpp>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

BOOST_AUTO_TEST_SUITE(radial_basis_functions)

namespace SC = Shape_characteristics;

namespace {

// The oracle: the formulas of the tables as printed, in 300 digits, and their difference quotients, which are
// right to 25 digits and more.
using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<300>,
                                           boost::multiprecision::et_off>;

Real plus(const Real& x)
{
  return x > 0 ? x : Real(0);
}

// A radial basis function without its type: what the tests do with each is compiled once.
struct Basis
{
  std::string name;
  Real (*formula)(const Real& epsilon, const Real& r); // the printed one
  int constant_from; // the order of the first derivative by distance that is a constant, if there is one below 4
  bool has_shape_parameter, is_positive_definite;
  double (*derivative)(double epsilon, int k, double r); // by distance
  std::array<double, 4> (*radial_derivatives)(double epsilon, double q);
};

template <typename Function>
Function make(double epsilon)
{
  if constexpr(Function::has_shape_parameter)
    return Function(epsilon);
  else
    return Function();
}

template <typename Function>
Basis basis(const std::string& name, Real (*formula)(const Real&, const Real&), int constant_from = 4)
{
  return {name,
          formula,
          constant_from,
          Function::has_shape_parameter,
          Function::is_positive_definite,
          [](const double epsilon, const int k, const double r)
          {
            const Function f = make<Function>(epsilon);
            return k == 0   ? f(r)
                   : k == 1 ? f.first_derivative(r)
                   : k == 2 ? f.second_derivative(r)
                            : f.third_derivative(r);
          },
          [](const double epsilon, const double q) { return make<Function>(epsilon).radial_derivatives(q); }};
}

template <int t>
Basis polyharmonic()
{
  return basis<SC::Polyharmonic<t>>(
      "Polyharmonic<" + std::to_string(t) + ">", [](const Real&, const Real& r) { return Real(pow(r, t)); },
      t);
}

template <int t>
Basis polyharmonic_logarithmic()
{
  return basis<SC::Polyharmonic_logarithmic<t>>("Polyharmonic_logarithmic<" + std::to_string(t) + ">",
                                                [](const Real&, const Real& r)
                                                { return Real(pow(r, t) * log(r)); });
}

const Basis gaussian =
    basis<SC::Gaussian>("Gaussian", [](const Real& e, const Real& r) { return Real(exp(-e * r * e * r)); });
const Basis multiquadric =
    basis<SC::Multiquadric>("Multiquadric",
                            [](const Real& e, const Real& r) { return Real(sqrt(1 + e * r * e * r)); });
const Basis inverse_quadratic =
    basis<SC::Inverse_quadratic>("Inverse_quadratic",
                                 [](const Real& e, const Real& r) { return Real(1 / (1 + e * r * e * r)); });
const Basis inverse_multiquadric = basis<SC::Inverse_multiquadric>(
    "Inverse_multiquadric",
    [](const Real& e, const Real& r) { return Real(1 / sqrt(1 + e * r * e * r)); });
const Basis wendland_1_1 = basis<SC::Wendland_1_1>("Wendland_1_1",
                                                   [](const Real& e, const Real& r)
                                                   {
                                                     const Real b = plus(Real(1 - e * r));
                                                     return Real(b * b * b * (3 * e * r + 1));
                                                   });
const Basis matern_9_2 = basis<SC::Matern_9_2>(
    "Matern_9_2",
    [](const Real& e, const Real& r)
    {
      const Real a = e * r;
      return Real((1 + a + 3 * a * a / 7 + 2 * a * a * a / 21 + a * a * a * a / 105) * exp(-a));
    });

const std::vector<Basis> bases = {
    gaussian,
    multiquadric,
    inverse_quadratic,
    inverse_multiquadric,
    basis<SC::Inverse_multiquadric_cubic>("Inverse_multiquadric_cubic",
                                          [](const Real& e, const Real& r)
                                          { return Real(1 / sqrt(1 + e * r * e * r * e * r)); }),
    basis<SC::Exponential_cubic>("Exponential_cubic",
                                 [](const Real& e, const Real& r) { return Real(exp(-e * r * r * r)); }),
    wendland_1_1,
    basis<SC::Wendland_3_2>("Wendland_3_2",
                            [](const Real& e, const Real& r)
                            {
                              const Real a = e * r, b = plus(Real(1 - a));
                              return Real(b * b * b * b * b * b * (35 * a * a + 18 * a + 3) / 3);
                            }),
    matern_9_2,
    polyharmonic<1>(),
    polyharmonic<2>(),
    polyharmonic<3>(),
    polyharmonic<4>(),
    polyharmonic<5>(),
    polyharmonic<7>(),
    polyharmonic<9>(),
    polyharmonic_logarithmic<2>(),
    polyharmonic_logarithmic<3>(),
    polyharmonic_logarithmic<4>(),
    polyharmonic_logarithmic<6>(),
    polyharmonic_logarithmic<8>()};

using Functions_with_shape_parameter = std::tuple<SC::Gaussian,
                                                  SC::Multiquadric,
                                                  SC::Inverse_quadratic,
                                                  SC::Inverse_multiquadric,
                                                  SC::Inverse_multiquadric_cubic,
                                                  SC::Exponential_cubic,
                                                  SC::Wendland_1_1,
                                                  SC::Wendland_3_2,
                                                  SC::Matern_9_2>;

const std::vector<double> shape_parameters = {0.08, 0.7, 1, 3.1};
const std::vector<double> distances = {1e-30, 1e-12, 1e-6, 1e-3, 0.03, 0.11, 0.2, 0.31, 0.4, 0.55,
                                       0.77,  0.9,   0.99, 1.01, 1.3,  1.9,  2.5, 4.,   7.,  12.};

// one is enough for a function without a shape parameter
std::vector<double> shape_parameters_of(const Basis& basis)
{
  return basis.has_shape_parameter ? shape_parameters : std::vector<double>{shape_parameters[0]};
}

// k-th derivative of f at x > 0 by central differences, relative step 1e-14: truncation 1e-28
template <typename F>
Real derivative(const F& f, int k, Real x)
{
  const Real h = x * Real("1e-14");
  switch(k)
  {
  case 0:
    return f(x);
  case 1:
    return (f(x + h) - f(x - h)) / (2 * h);
  case 2:
    return (f(x + h) - 2 * f(x) + f(x - h)) / (h * h);
  default:
    return (f(x + 2 * h) - 2 * f(x + h) + 2 * f(x - h) - f(x - 2 * h)) / (2 * h * h * h);
  }
}

Real by_distance(const Basis& basis, double epsilon, int k, Real r)
{
  return derivative([&](const Real& x) { return basis.formula(epsilon, x); }, k, r);
}

// (2 d/dq)^k
Real by_square(const Basis& basis, double epsilon, int k, Real q)
{
  return (1 << k) * derivative([&](const Real& x) { return basis.formula(epsilon, sqrt(x)); }, k, q);
}

// The relative error, except that near a zero the rounding of the terms that cancel there remains: they are of the
// size of the k-th derivative elsewhere, epsilon^k times the value.
double error(double computed, Real expected, double scale)
{
  const Real noise_of_oracle = 1e-120;
  return static_cast<double>(Real(abs(computed - expected) / (abs(expected) + scale + noise_of_oracle)));
}

} // namespace

BOOST_AUTO_TEST_CASE(derivatives_by_distance)
{
  for(const Basis& f : bases)
    for(const double epsilon : shape_parameters_of(f))
      for(const double r : distances)
        for(int k = 0; k < 4; ++k)
        {
          const Real expected = by_distance(f, epsilon, k, r);
          const double computed = f.derivative(epsilon, k, r),
                       scale = f.has_shape_parameter
                                   ? 0.1 * static_cast<double>(f.formula(epsilon, r)) * std::pow(epsilon, k)
                                   : 0;
          BOOST_TEST(error(computed, expected, scale) < 2e-13,
                     f.name << ", epsilon " << epsilon << ", r " << r << ", derivative " << k << ": "
                            << computed << ", expected " << static_cast<double>(expected));
        }
}

BOOST_AUTO_TEST_CASE(derivatives_by_squared_distance)
{
  for(const Basis& f : bases)
    for(const double epsilon : shape_parameters_of(f))
      for(const double r : distances)
      {
        const double q = r * r;
        const auto computed = f.radial_derivatives(epsilon, q);
        for(int k = 0; k < 4; ++k)
        {
          const Real expected = by_square(f, epsilon, k, q);
          const double scale = f.has_shape_parameter ? 0.1 * static_cast<double>(f.formula(epsilon, r)) *
                                                           std::pow(epsilon, 2 * k)
                                                     : 0;
          BOOST_TEST(error(computed[k], expected, scale) < 2e-13,
                     f.name << ", epsilon " << epsilon << ", q " << q << ", derivative " << k << ": "
                            << computed[k] << ", expected " << static_cast<double>(expected));
        }
      }
}

// the infinitely smooth ones and Matern keep their relative accuracy in q however far away
BOOST_AUTO_TEST_CASE(relative_accuracy_without_cancellation)
{
  const auto check = [](const Basis& f, std::initializer_list<double> rs)
  {
    for(const double r : rs)
      for(int k = 0; k < 4; ++k)
        BOOST_TEST(error(f.radial_derivatives(0.25, r * r)[k], by_square(f, 0.25, k, r * r), 0) < 1e-13,
                   f.name << ", r " << r << ", derivative " << k);
  };
  check(gaussian, {0.001, 0.5, 3., 20.});
  check(inverse_quadratic, {0.001, 0.5, 3., 1e4, 1e12});
  check(inverse_multiquadric, {0.001, 0.5, 3., 1e4, 1e12});
  check(multiquadric, {0.001, 0.5, 3., 1e4, 1e12});
  check(matern_9_2, {0.001, 0.5, 3., 50.});
}

BOOST_AUTO_TEST_CASE(limits_at_the_origin)
{
  for(const Basis& f : bases)
    for(const double epsilon : shape_parameters)
      for(int k = 0; k < 4; ++k)
      {
        BOOST_TEST_CONTEXT(f.name << ", epsilon " << epsilon << ", derivative " << k)
        {
          const double near = static_cast<double>(by_distance(f, epsilon, k, Real("1e-16")));
          const double nearer = static_cast<double>(by_distance(f, epsilon, k, Real("1e-20")));
          const bool converges = std::abs(near - nearer) < 1e-9 * (1 + std::abs(nearer));
          const double limit = f.derivative(epsilon, k, 0);
          if(converges)
            BOOST_TEST(std::abs(limit - nearer) < 1e-12 * (1 + std::abs(nearer)));
          else
            BOOST_TEST(limit == std::copysign(std::numeric_limits<double>::infinity(), nearer));

          const double near_q = static_cast<double>(by_square(f, epsilon, k, Real("1e-32")));
          const double nearer_q = static_cast<double>(by_square(f, epsilon, k, Real("1e-40")));
          const bool converges_q = std::abs(near_q - nearer_q) < 1e-9 * (1 + std::abs(nearer_q));
          const double expected = converges_q ? nearer_q : 0;
          const double limit_q = f.radial_derivatives(epsilon, 0)[k];
          BOOST_TEST(std::abs(limit_q - expected) < 1e-9 * (1 + std::abs(expected)), limit_q);
        }
      }
}

// value, gradient, Hessian by r and by q are the same functions
BOOST_AUTO_TEST_CASE(both_forms_agree)
{
  for(const Basis& f : bases)
  {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> logarithm(-8, 1.2);
    for(int i = 0; i < 1000; ++i)
    {
      const double r = std::pow(10, logarithm(random)), q = r * r;
      const auto d = f.radial_derivatives(0.6, q);
      const double terms[] = {d[0], r * d[1], d[1] + q * d[2], 3 * r * d[2] + r * q * d[3]};
      const double sizes[] = {std::abs(d[0]), r * std::abs(d[1]), std::abs(d[1]) + q * std::abs(d[2]),
                              3 * r * std::abs(d[2]) + r * q * std::abs(d[3])};
      for(int k = 0; k < 4; ++k)
        BOOST_TEST(std::abs(f.derivative(0.6, k, r) - terms[k]) <= 1e-12 * sizes[k],
                   f.name << ", r " << r << ", derivative " << k);
    }
  }
}

BOOST_AUTO_TEST_CASE(huge_and_tiny_distances_give_finite_numbers)
{
  const double epsilon = 2.5;
  for(const Basis& f : bases)
    for(int k = 0; k < 4; ++k)
    {
      // powers up to the 9th of the largest must not overflow where the function itself grows
      for(const double r : {1e-140, 1e-60, 1e-40, 1e25, 1e33})
      {
        BOOST_TEST(std::isfinite(f.derivative(epsilon, k, r)), f.name << ", r " << r << ", derivative " << k);
        BOOST_TEST(std::isfinite(f.radial_derivatives(epsilon, r * r)[k]),
                   f.name << ", r " << r << ", derivative " << k);
      }
      if(f.has_shape_parameter)
        for(const double r : {1e150, 1e200, 1e300})
        {
          const bool grows = f.name == multiquadric.name;
          const double expected = grows && k == 0 ? epsilon * r : grows && k == 1 ? epsilon : 0;
          BOOST_TEST(std::abs(f.derivative(epsilon, k, r) - expected) <= 1e-12 * expected + 1e-140,
                     f.name << ", r " << r << ", derivative " << k);
          BOOST_TEST(!std::isnan(f.radial_derivatives(epsilon, r * r)[k]),
                     f.name << ", r " << r << ", derivative " << k);
        }
    }
}

BOOST_AUTO_TEST_CASE(nan_is_passed_on)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for(const Basis& f : bases)
  {
    for(int k = 0; k < (std::min)(4, f.constant_from); ++k)
      BOOST_TEST(std::isnan(f.derivative(1, k, nan)), f.name << ", derivative " << k);
    BOOST_TEST(std::isnan(f.radial_derivatives(1, nan)[0]), f.name);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(shape_parameter_is_kept_and_checked, Function, Functions_with_shape_parameter)
{
  const Function unset;
  BOOST_TEST(unset.shape_parameter() == 1);
  BOOST_TEST(!unset.is_shape_parameter_set());
  // not ==: the compiler may contract or fold one of the two
  BOOST_TEST(std::abs(unset(0.4) - Function(1)(0.4)) <= 4e-16 * unset(0.4));
  const Function set = unset.with_shape_parameter(0.3);
  BOOST_TEST(set.shape_parameter() == 0.3);
  BOOST_TEST(set.is_shape_parameter_set());
  BOOST_TEST(std::abs(set(0.7) - Function(0.3)(0.7)) <= 4e-16 * set(0.7));
  for(double wrong :
      {0., -1., std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
  {
    BOOST_CHECK_THROW(Function{wrong}, std::invalid_argument);
    BOOST_CHECK_THROW(unset.with_shape_parameter(wrong), std::invalid_argument);
  }
}

BOOST_AUTO_TEST_CASE(validity_depends_on_the_exponent)
{
  static_assert(SC::Polyharmonic<1>::is_valid && SC::Polyharmonic<3>::is_valid &&
                SC::Polyharmonic<9>::is_valid);
  static_assert(!SC::Polyharmonic<2>::is_valid && !SC::Polyharmonic<4>::is_valid);
  static_assert(SC::Polyharmonic_logarithmic<2>::is_valid && !SC::Polyharmonic_logarithmic<3>::is_valid);
  static_assert(SC::Gaussian::is_valid && SC::Matern_9_2::is_valid);
  static_assert(!SC::Polyharmonic<3>::has_shape_parameter && SC::Exponential_cubic::has_shape_parameter);
}

// smallest eigenvalue, relative to the largest one, of the matrix of the covariances of values and gradients at the points
double smallest_eigenvalue(const Basis& f, double epsilon, const Eigen::Matrix3Xd& points)
{
  const Eigen::Index m = points.cols();
  Eigen::MatrixXd matrix(4 * m, 4 * m);
  for(Eigen::Index i = 0; i < m; ++i)
    for(Eigen::Index j = 0; j < m; ++j)
    {
      const Eigen::Vector3d d = points.col(i) - points.col(j);
      const auto a = f.radial_derivatives(epsilon, d.squaredNorm());
      matrix(4 * i, 4 * j) = a[0];
      matrix.block<1, 3>(4 * i, 4 * j + 1) = -a[1] * d.transpose();
      matrix.block<3, 1>(4 * i + 1, 4 * j) = a[1] * d;
      matrix.block<3, 3>(4 * i + 1, 4 * j + 1) =
          -(a[1] * Eigen::Matrix3d::Identity() + a[2] * d * d.transpose());
    }
  BOOST_TEST((matrix - matrix.transpose()).norm() <= 1e-14 * matrix.norm());
  const Eigen::VectorXd eigenvalues =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
  return eigenvalues.minCoeff() / eigenvalues.cwiseAbs().maxCoeff();
}

// Just the functions that claim it have positive definite matrices of Hermite data. (With Wendland_1_1 it takes more
// points to see that it isn't: below.)
BOOST_AUTO_TEST_CASE(positive_definiteness_for_hermite_data)
{
  for(const Basis& f : bases)
  {
    double smallest = std::numeric_limits<double>::infinity();
    for(const double epsilon : {1.5, 2.5})
    {
      for(unsigned seed = 0; seed < 5; ++seed)
      {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> coordinate(-2, 2);
        Eigen::Matrix3Xd points(3, 20);
        for(Eigen::Index i = 0; i < points.size(); ++i)
          points.data()[i] = coordinate(random);
        smallest = (std::min)(smallest, smallest_eigenvalue(f, epsilon, points));
      }
      for(const double spacing : {0.5, 0.8})
      {
        Eigen::Matrix3Xd points(3, 64);
        for(int i = 0; i < 64; ++i)
          points.col(i) = spacing * Eigen::Vector3d(i % 4, i / 4 % 4, i / 16);
        smallest = (std::min)(smallest, smallest_eigenvalue(f, epsilon, points));
      }
    }
    // well above the rounding errors of the eigenvalues, so that the sign is certain
    if(f.is_positive_definite)
      BOOST_TEST(smallest > 1e-14, f.name << ": " << smallest);
    else if(f.name != wendland_1_1.name)
      BOOST_TEST(smallest < -1e-14, f.name << ": " << smallest);
  }
}

// The Fourier transform of Wendland_1_1 in space is negative for wave numbers around 10.5. Weights of that wave number on
// a fine lattice give a negative quadratic form; that of Wendland_3_2 is positive.
BOOST_AUTO_TEST_CASE(wendland_1_1_is_not_positive_definite_in_space)
{
  const auto quadratic_form = [](const auto& f)
  {
    const double spacing = 0.22, width = 1.8, wave_number = 10.5;
    const int n = 20, support = 4;
    const auto weight = [&](int i, int j, int k)
    {
      if(std::max({std::abs(i), std::abs(j), std::abs(k)}) > n)
        return 0.;
      return std::cos(wave_number * spacing * i) *
             std::exp(-0.5 * spacing * spacing * (i * i + j * j + k * k) / (width * width));
    };
    std::vector<double> table(std::pow(2 * (n + support) + 1, 3));
    const auto at = [&](int i, int j, int k) -> double&
    {
      const int size = 2 * (n + support) + 1, shift = n + support;
      return table[((i + shift) * size + (j + shift)) * size + (k + shift)];
    };
    for(int i = -n; i <= n; ++i)
      for(int j = -n; j <= n; ++j)
        for(int k = -n; k <= n; ++k)
          at(i, j, k) = weight(i, j, k);
    double sum = 0, magnitude = 0;
    for(int a = -support; a <= support; ++a)
      for(int b = -support; b <= support; ++b)
        for(int c = -support; c <= support; ++c)
        {
          const double phi = f(spacing * std::sqrt(a * a + b * b + c * c));
          if(phi == 0)
            continue;
          double correlation = 0;
          for(int i = -n; i <= n; ++i)
            for(int j = -n; j <= n; ++j)
              for(int k = -n; k <= n; ++k)
                correlation += at(i, j, k) * at(i + a, j + b, k + c);
          sum += phi * correlation;
          magnitude += std::abs(phi * correlation);
        }
    return sum / magnitude;
  };
  BOOST_TEST(quadratic_form(SC::Wendland_1_1(1)) < -1e-6);
  BOOST_TEST(quadratic_form(SC::Wendland_3_2(1)) > 1e-6);
}

BOOST_AUTO_TEST_SUITE_END()
