#define BOOST_TEST_MODULE radial_basis_functions
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

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <Eigen/Dense>

#include <random>
#include <tuple>
#include <vector>

namespace SC = Shape_characteristics;

namespace {

// The oracle: the formulas of the tables as printed, in 300 digits, and their difference quotients, which are
// right to 25 digits and more.
using Real =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<300>, boost::multiprecision::et_off>;

template <typename T>
T plus(const T& x)
{
  return x > 0 ? x : T(0);
}

struct Gaussian_case
{
  using Function = SC::Gaussian;
  static Real formula(Real e, Real r) { return exp(-e * r * e * r); }
};
struct Multiquadric_case
{
  using Function = SC::Multiquadric;
  static Real formula(Real e, Real r) { return sqrt(1 + e * r * e * r); }
};
struct Inverse_quadratic_case
{
  using Function = SC::Inverse_quadratic;
  static Real formula(Real e, Real r) { return 1 / (1 + e * r * e * r); }
};
struct Inverse_multiquadric_case
{
  using Function = SC::Inverse_multiquadric;
  static Real formula(Real e, Real r) { return 1 / sqrt(1 + e * r * e * r); }
};
struct Inverse_multiquadric_cubic_case
{
  using Function = SC::Inverse_multiquadric_cubic;
  static Real formula(Real e, Real r) { return 1 / sqrt(1 + e * r * e * r * e * r); }
};
struct Exponential_cubic_case
{
  using Function = SC::Exponential_cubic;
  static Real formula(Real e, Real r) { return exp(-e * r * r * r); }
};
struct Wendland_1_1_case
{
  using Function = SC::Wendland_1_1;
  static Real formula(Real e, Real r)
  {
    const Real b = plus(Real(1 - e * r));
    return b * b * b * (3 * e * r + 1);
  }
};
struct Wendland_3_2_case
{
  using Function = SC::Wendland_3_2;
  static Real formula(Real e, Real r)
  {
    const Real a = e * r, b = plus(Real(1 - a));
    return b * b * b * b * b * b * (35 * a * a + 18 * a + 3) / 3;
  }
};
struct Matern_9_2_case
{
  using Function = SC::Matern_9_2;
  static Real formula(Real e, Real r)
  {
    const Real a = e * r;
    return (1 + a + 3 * a * a / 7 + 2 * a * a * a / 21 + a * a * a * a / 105) * exp(-a);
  }
};
template <int t>
struct Polyharmonic_case
{
  using Function = SC::Polyharmonic<t>;
  static Real formula(Real, Real r) { return pow(r, t); }
};
template <int t>
struct Polyharmonic_logarithmic_case
{
  using Function = SC::Polyharmonic_logarithmic<t>;
  static Real formula(Real, Real r) { return pow(r, t) * log(r); }
};

using Cases_with_shape_parameter = std::tuple<Gaussian_case,
                                              Multiquadric_case,
                                              Inverse_quadratic_case,
                                              Inverse_multiquadric_case,
                                              Inverse_multiquadric_cubic_case,
                                              Exponential_cubic_case,
                                              Wendland_1_1_case,
                                              Wendland_3_2_case,
                                              Matern_9_2_case>;
using Cases = std::tuple<Gaussian_case,
                         Multiquadric_case,
                         Inverse_quadratic_case,
                         Inverse_multiquadric_case,
                         Inverse_multiquadric_cubic_case,
                         Exponential_cubic_case,
                         Wendland_1_1_case,
                         Wendland_3_2_case,
                         Matern_9_2_case,
                         Polyharmonic_case<1>,
                         Polyharmonic_case<2>,
                         Polyharmonic_case<3>,
                         Polyharmonic_case<4>,
                         Polyharmonic_case<5>,
                         Polyharmonic_case<7>,
                         Polyharmonic_case<9>,
                         Polyharmonic_logarithmic_case<2>,
                         Polyharmonic_logarithmic_case<3>,
                         Polyharmonic_logarithmic_case<4>,
                         Polyharmonic_logarithmic_case<6>,
                         Polyharmonic_logarithmic_case<8>>;

const std::vector<double> shape_parameters = {0.08, 0.7, 1, 3.1};
const std::vector<double> distances = {1e-30, 1e-12, 1e-6, 1e-3, 0.03, 0.11, 0.2, 0.31, 0.4, 0.55,
                                       0.77,  0.9,   0.99, 1.01, 1.3,  1.9,  2.5, 4.,   7.,  12.};

template <typename Function>
Function make(double epsilon)
{
  if constexpr(Function::has_shape_parameter)
    return Function(epsilon);
  else
    return Function();
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

template <typename Case>
Real by_distance(double epsilon, int k, Real r)
{
  return derivative([&](const Real& x) { return Case::formula(epsilon, x); }, k, r);
}

// (2 d/dq)^k
template <typename Case>
Real by_square(double epsilon, int k, Real q)
{
  return (1 << k) * derivative([&](const Real& x) { return Case::formula(epsilon, sqrt(x)); }, k, q);
}

template <typename Function>
double in_distance(const Function& f, int k, double r)
{
  return k == 0   ? f(r)
         : k == 1 ? f.first_derivative(r)
         : k == 2 ? f.second_derivative(r)
                  : f.third_derivative(r);
}

// The relative error, except that near a zero the rounding of the terms that cancel there remains: they are of the
// size of the k-th derivative elsewhere, epsilon^k times the value.
double error(double computed, Real expected, double scale)
{
  const Real noise_of_oracle = 1e-120;
  return static_cast<double>(Real(abs(computed - expected) / (abs(expected) + scale + noise_of_oracle)));
}

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(derivatives_by_distance, Case, Cases)
{
  using Function = typename Case::Function;
  for(double epsilon : shape_parameters)
  {
    const Function f = make<Function>(epsilon);
    for(double r : distances)
      for(int k = 0; k < 4; ++k)
      {
        const Real expected = by_distance<Case>(epsilon, k, r);
        const double scale = Function::has_shape_parameter
                                 ? 0.1 * static_cast<double>(Case::formula(epsilon, r)) * std::pow(epsilon, k)
                                 : 0;
        BOOST_TEST(error(in_distance(f, k, r), expected, scale) < 2e-13,
                   "epsilon " << epsilon << ", r " << r << ", derivative " << k << ": "
                              << in_distance(f, k, r) << ", expected " << static_cast<double>(expected));
      }
    if(!Function::has_shape_parameter)
      break;
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(derivatives_by_squared_distance, Case, Cases)
{
  using Function = typename Case::Function;
  for(double epsilon : shape_parameters)
  {
    const Function f = make<Function>(epsilon);
    for(double r : distances)
    {
      const double q = r * r;
      const auto derivatives = f.radial_derivatives(q);
      for(int k = 0; k < 4; ++k)
      {
        const Real expected = by_square<Case>(epsilon, k, q);
        const double scale =
            Function::has_shape_parameter
                ? 0.1 * static_cast<double>(Case::formula(epsilon, r)) * std::pow(epsilon, 2 * k)
                : 0;
        BOOST_TEST(error(derivatives[k], expected, scale) < 2e-13,
                   "epsilon " << epsilon << ", q " << q << ", derivative " << k << ": " << derivatives[k]
                              << ", expected " << static_cast<double>(expected));
      }
    }
    if(!Function::has_shape_parameter)
      break;
  }
}

// the infinitely smooth ones and Matern keep their relative accuracy in q however far away
BOOST_AUTO_TEST_CASE(relative_accuracy_without_cancellation)
{
  const auto check = [](auto c, std::initializer_list<double> rs)
  {
    using Case = decltype(c);
    const typename Case::Function f(0.25);
    for(double r : rs)
    {
      const auto derivatives = f.radial_derivatives(r * r);
      for(int k = 0; k < 4; ++k)
        BOOST_TEST(error(derivatives[k], by_square<Case>(0.25, k, r * r), 0) < 1e-13);
    }
  };
  check(Gaussian_case(), {0.001, 0.5, 3., 20.});
  check(Inverse_quadratic_case(), {0.001, 0.5, 3., 1e4, 1e12});
  check(Inverse_multiquadric_case(), {0.001, 0.5, 3., 1e4, 1e12});
  check(Multiquadric_case(), {0.001, 0.5, 3., 1e4, 1e12});
  check(Matern_9_2_case(), {0.001, 0.5, 3., 50.});
}

BOOST_AUTO_TEST_CASE_TEMPLATE(limits_at_the_origin, Case, Cases)
{
  using Function = typename Case::Function;
  for(double epsilon : shape_parameters)
  {
    const Function f = make<Function>(epsilon);
    for(int k = 0; k < 4; ++k)
    {
      const double near = static_cast<double>(by_distance<Case>(epsilon, k, Real("1e-16")));
      const double nearer = static_cast<double>(by_distance<Case>(epsilon, k, Real("1e-20")));
      const bool converges = std::abs(near - nearer) < 1e-9 * (1 + std::abs(nearer));
      if(converges)
        BOOST_TEST(std::abs(in_distance(f, k, 0) - nearer) < 1e-12 * (1 + std::abs(nearer)));
      else
        BOOST_TEST(in_distance(f, k, 0) == std::copysign(std::numeric_limits<double>::infinity(), nearer));

      const double near_q = static_cast<double>(by_square<Case>(epsilon, k, Real("1e-32")));
      const double nearer_q = static_cast<double>(by_square<Case>(epsilon, k, Real("1e-40")));
      const bool converges_q = std::abs(near_q - nearer_q) < 1e-9 * (1 + std::abs(nearer_q));
      const double expected = converges_q ? nearer_q : 0;
      BOOST_TEST(std::abs(f.radial_derivatives(0)[k] - expected) < 1e-9 * (1 + std::abs(expected)),
                 "epsilon " << epsilon << ", derivative " << k << ": " << f.radial_derivatives(0)[k]);
    }
  }
}

// value, gradient, Hessian by r and by q are the same functions
BOOST_AUTO_TEST_CASE_TEMPLATE(both_forms_agree, Case, Cases)
{
  using Function = typename Case::Function;
  const Function f = make<Function>(0.6);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> logarithm(-8, 1.2);
  for(int i = 0; i < 1000; ++i)
  {
    const double r = std::pow(10, logarithm(random)), q = r * r;
    const auto d = f.radial_derivatives(q);
    const double terms[] = {d[0], r * d[1], d[1] + q * d[2], 3 * r * d[2] + r * q * d[3]};
    const double sizes[] = {std::abs(d[0]), r * std::abs(d[1]), std::abs(d[1]) + q * std::abs(d[2]),
                            3 * r * std::abs(d[2]) + r * q * std::abs(d[3])};
    for(int k = 0; k < 4; ++k)
      BOOST_TEST(std::abs(in_distance(f, k, r) - terms[k]) <= 1e-12 * sizes[k]);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(huge_and_tiny_distances_give_finite_numbers, Case, Cases)
{
  using Function = typename Case::Function;
  const Function f = make<Function>(2.5);
  // powers up to the 9th of the largest must not overflow where the function itself grows
  for(double r : {1e-140, 1e-60, 1e-40, 1e25, 1e33})
    for(int k = 0; k < 4; ++k)
    {
      BOOST_TEST(std::isfinite(in_distance(f, k, r)));
      BOOST_TEST(std::isfinite(f.radial_derivatives(r * r)[k]));
    }
  if constexpr(Function::has_shape_parameter)
    for(double r : {1e150, 1e200, 1e300})
      for(int k = 0; k < 4; ++k)
      {
        const double expected = k == 1 && std::is_same_v<Function, SC::Multiquadric>   ? 2.5
                                : k == 0 && std::is_same_v<Function, SC::Multiquadric> ? 2.5 * r
                                                                                       : 0;
        BOOST_TEST(std::abs(in_distance(f, k, r) - expected) <= 1e-12 * expected + 1e-140);
        BOOST_TEST(!std::isnan(f.radial_derivatives(r * r)[k]));
      }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(nan_is_passed_on, Case, Cases)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto f = make<typename Case::Function>(1);
  for(int k = 0; k < 4; ++k)
    if(!(k >= 2 && std::is_same_v<typename Case::Function, SC::Polyharmonic<1>>)&&!(
           k == 3 &&
           std::is_same_v<typename Case::Function,
                          SC::Polyharmonic<
                              2>>)&&!(k == 2 &&
                                      std::is_same_v<
                                          typename Case::Function,
                                          SC::Polyharmonic<
                                              2>>)&&!(k == 1 &&
                                                      std::is_same_v<
                                                          typename Case::Function,
                                                          SC::Polyharmonic<
                                                              1>>)&&!(k == 3 &&
                                                                      std::is_same_v<
                                                                          typename Case::Function,
                                                                          SC::Polyharmonic<3>>)) // constants
      BOOST_TEST(std::isnan(in_distance(f, k, nan)));
  BOOST_TEST(std::isnan(f.radial_derivatives(nan)[0]));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(shape_parameter_is_kept_and_checked, Case, Cases_with_shape_parameter)
{
  using Function = typename Case::Function;
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
template <typename Function>
double smallest_eigenvalue(const Function& f, const Eigen::Matrix3Xd& points)
{
  const Eigen::Index m = points.cols();
  Eigen::MatrixXd matrix(4 * m, 4 * m);
  for(Eigen::Index i = 0; i < m; ++i)
    for(Eigen::Index j = 0; j < m; ++j)
    {
      const Eigen::Vector3d d = points.col(i) - points.col(j);
      const auto a = f.radial_derivatives(d.squaredNorm());
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
BOOST_AUTO_TEST_CASE_TEMPLATE(positive_definiteness_for_hermite_data, Case, Cases)
{
  using Function = typename Case::Function;
  double smallest = std::numeric_limits<double>::infinity();
  for(double epsilon : {1.5, 2.5})
  {
    const Function f = make<Function>(epsilon);
    for(unsigned seed = 0; seed < 5; ++seed)
    {
      std::mt19937 random(seed);
      std::uniform_real_distribution<double> coordinate(-2, 2);
      Eigen::Matrix3Xd points(3, 20);
      for(Eigen::Index i = 0; i < points.size(); ++i)
        points.data()[i] = coordinate(random);
      smallest = std::min(smallest, smallest_eigenvalue(f, points));
    }
    for(double spacing : {0.5, 0.8})
    {
      Eigen::Matrix3Xd points(3, 64);
      for(int i = 0; i < 64; ++i)
        points.col(i) = spacing * Eigen::Vector3d(i % 4, i / 4 % 4, i / 16);
      smallest = std::min(smallest, smallest_eigenvalue(f, points));
    }
  }
  // well above the rounding errors of the eigenvalues, so that the sign is certain
  if(Function::is_positive_definite)
    BOOST_TEST(smallest > 1e-14);
  else if(!std::is_same_v<Function, SC::Wendland_1_1>)
    BOOST_TEST(smallest < -1e-14);
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
