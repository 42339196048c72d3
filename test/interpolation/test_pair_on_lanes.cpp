// Numbers with more digits on lanes, against numbers with twice as many: arithmetic, and basis functions.
#include <boost/test/unit_test.hpp>

#include "raise_to.h"

#include <Shape_characteristics/interpolation/Inverse_multiquadric.h>
#include <Shape_characteristics/interpolation/Matern_9_2.h>
#include <Shape_characteristics/interpolation/internal/Lanes.h>
#include <Shape_characteristics/interpolation/internal/Pair_on_lanes.h>
#include <Shape_characteristics/interpolation/internal/Split_on_lanes.h>
#include <Shape_characteristics/interpolation/internal/basis_function_on_lanes.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <random>

BOOST_AUTO_TEST_SUITE(pair_on_lanes)

namespace internal = Shape_characteristics::internal;
namespace SC = Shape_characteristics;
using Number = boost::multiprecision::cpp_bin_float_50;

namespace {

// Four lanes and more need a processor that fuses multiplication and addition: functions compiled for it have them, tested as
// fits by test_batched_hermite_rbf.
#if defined(__GNUC__)
constexpr int most_lanes = 2;
#else
constexpr int most_lanes = 1;
#endif

template <int n>
using Pair = internal::Pair_on_lanes<internal::Lanes<n> >;

template <int n>
internal::Lanes<n> lanes(const std::array<double, std::size_t(n)>& numbers)
{
  internal::Lanes<n> result;
  std::memcpy(&result, numbers.data(), sizeof(result));
  return result;
}

template <int n>
std::array<double, std::size_t(n)> numbers(const internal::Lanes<n>& v)
{
  std::array<double, std::size_t(n)> result;
  std::memcpy(result.data(), &v, sizeof(v));
  return result;
}

// `number` in the last lane; the others have another one
template <int n>
Pair<n> pair(const Number& number)
{
  std::array<double, std::size_t(n)> high, low;
  high.fill(.7);
  low.fill(1e-17);
  high.back() = double(number);
  low.back() = double(number - high.back());
  return {lanes<n>(high), lanes<n>(low)};
}

template <int n>
Number value(const Pair<n>& pair)
{
  return Number(numbers<n>(pair.high).back()) + Number(numbers<n>(pair.low).back());
}

double relative_error(const Number& found, const Number& expected)
{
  return double(abs(found - expected) / abs(expected));
}

template <int n>
double error_of_arithmetic()
{
  std::mt19937 random(1);
  const auto number = [&]
  {
    std::uniform_real_distribution<double> uniform(.1, 3.);
    const Number high = uniform(random), low = uniform(random);
    return Number(high + low * 0x1p-54);
  };
  double largest = 0.;
  for(int k = 0; k < 1000; ++k)
  {
    const Number a = number(), b = number();
    const Pair<n> x = pair<n>(a), y = pair<n>(b);
    const auto take = [&](const Pair<n>& found, const Number& expected)
    { test_support::raise_to(largest, relative_error(value<n>(found), expected)); };
    take(x + y, a + b);
    take(x * y, a * b);
    take(-x, -a);
    take(internal::magnify(x, .5), a / 2);
    take(internal::sqrt(x), sqrt(a));
    const bool is_ordered = a > b;
    take(internal::sum_of_ordered(is_ordered ? x : y, (is_ordered ? y : x).high),
         is_ordered ? a + double(b) : b + double(a));
    take(internal::sum_of_ordered((is_ordered ? x : y).high, is_ordered ? y : x),
         is_ordered ? double(a) + b : double(b) + a);
    take(internal::normalized(Pair<n>(x.high, 0x1p-20 * y.high)),
         Number(double(a)) + Number(0x1p-20 * double(b)));
    take(x + y.high, a + Number(numbers<n>(y.high).back()));
    take(x * y.high, a * Number(numbers<n>(y.high).back()));
    take(internal::difference(x.high, y.high),
         Number(numbers<n>(x.high).back()) - Number(numbers<n>(y.high).back()));
    // of nearly equal ones, what is left has fewer digits: those of both
    const Number c = a + a * 0x1p-20;
    test_support::raise_to(largest, double(abs(value<n>(pair<n>(c) - x) - (c - a)) / a));
  }
  return largest;
}

// of sums of products, in units of the largest product there may be
template <int n>
double error_of_split_products()
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  internal::Lanes<n> shift;
  internal::set_lanes(shift, 0x1.8p32); // units of 2^-20
  double largest = 0.;
  for(int k = 0; k < 200; ++k)
  {
    internal::Sum_of_splits_on_lanes<internal::Lanes<n> > sum;
    Number expected = 0, first_parts = 0;
    for(int term = 0; term < 50; ++term)
    {
      const Number a = uniform(random) + uniform(random) * 0x1p-54, b = uniform(random);
      const auto x = internal::split(pair<n>(a), shift), y = internal::split(pair<n>(b), shift);
      const auto part = [](const internal::Lanes<n>& v) { return Number(numbers<n>(v).back()); };
      if(term % 3 == 0)
      {
        sum.add_square(x);
        expected += a * a;
        first_parts += part(x.first) * part(x.first);
      }
      else if(term % 3 == 1)
      {
        sum.template add_product<1>(x, y);
        expected += a * b;
        first_parts += part(x.first) * part(y.first);
      }
      else
      {
        sum.template add_product<-1>(x, y);
        expected -= a * b;
        first_parts -= part(x.first) * part(y.first);
      }
    }
    BOOST_TEST_REQUIRE(Number(numbers<n>(sum.first).back()) == first_parts);
    internal::Lanes<n> coarse;
    internal::set_lanes(coarse, 0x1.8p38);
    const auto again = sum.split(coarse);
    test_support::raise_to(largest, double(abs(value<n>(sum.pair()) - expected)),
                           double(abs(value<n>(Pair<n>(again.first, again.rest)) - expected)));
  }
  return largest;
}

struct Radial
{
  Number psi, P, B;
};

Radial inverse_multiquadric(const Number& q)
{
  const Number phi = 1 / sqrt(1 + q);
  return {phi - 1 + q / 2, 1 - phi * phi * phi, 3 * pow(phi, 5)};
}

Radial matern(const Number& q)
{
  const Number a = sqrt(q), e = exp(-a);
  return {(7 + a * (7 + a * (3 + a * (Number(2) / 3 + a / 15)))) * e - 7 + q / 2,
          1 - (1 + a * (1 + a * (Number(2) / 5 + a / 15))) * e, (1 + a * (1 + a / 3)) / 5 * e};
}

template <int n, typename RadialBasisFunction>
Radial found_at(const RadialBasisFunction& phi, const Number& q, double reach)
{
  const internal::Basis_function_on_lanes<RadialBasisFunction> on_lanes(phi);
  Pair<n> psi, P, B;
  on_lanes(pair<n>(q), reach * reach <= on_lanes.near, psi, P, B);
  return {value<n>(psi), value<n>(P), value<n>(B)};
}

// The largest relative error for roots of q up to `reach`. Constants of a Matern function are doubles, whose rounding is seen.
template <int n, typename RadialBasisFunction, typename Exact>
double error_of_basis_function(const RadialBasisFunction& phi, const Exact& exact, double reach)
{
  double largest = 0.;
  for(int k = 1; k <= 200; ++k)
  {
    const Number q = pow(Number(reach * k / 200.), 2);
    const Radial found = found_at<n>(phi, q, reach), expected = exact(q);
    for(Number Radial::*const part : {&Radial::psi, &Radial::P, &Radial::B})
      test_support::raise_to(largest, relative_error(found.*part, expected.*part));
  }
  return largest;
}

// how much the difference of two neighbors differs from the exact one: rounding without that of constants
template <int n, typename RadialBasisFunction, typename Exact>
double roughness_of_basis_function(const RadialBasisFunction& phi, const Exact& exact, double reach)
{
  double largest = 0.;
  for(int k = 20; k <= 200; ++k)
  {
    const Number q = pow(Number(reach * k / 200.), 2), next = q * (1 + 0x1p-40);
    const Radial found = found_at<n>(phi, q, reach), found_next = found_at<n>(phi, next, reach);
    const Radial expected = exact(q), expected_next = exact(next);
    for(Number Radial::*const part : {&Radial::psi, &Radial::P, &Radial::B})
    {
      const Number step = found_next.*part - found.*part, exact_step = expected_next.*part - expected.*part;
      test_support::raise_to(largest, double(abs(step - exact_step) / abs(expected.*part)));
    }
  }
  return largest;
}

template <int n>
void check()
{
  const double arithmetic = error_of_arithmetic<n>();
  BOOST_TEST_MESSAGE(n << " lanes: relative error of arithmetic " << arithmetic);
  BOOST_TEST(arithmetic < 1e-30);

  const double split = error_of_split_products<n>();
  BOOST_TEST_MESSAGE(n << " lanes: error of sums of 50 products in two parts " << split);
  BOOST_TEST(split < 1e-20);

  const double of_multiquadric =
      error_of_basis_function<n>(SC::Inverse_multiquadric(), inverse_multiquadric, 3.);
  const double of_matern = error_of_basis_function<n>(SC::Matern_9_2(), matern, 1.9);
  const double far = error_of_basis_function<n>(SC::Matern_9_2(), matern, 8.);
  BOOST_TEST_MESSAGE(n << " lanes: relative error of the inverse multiquadric " << of_multiquadric
                       << ", of the Matern function " << of_matern << ", beyond " << far);
  BOOST_TEST(of_multiquadric < 1e-24); // psi of close points is the square of a difference
  BOOST_TEST(of_matern < 1e-15);
  BOOST_TEST(far < 1e-13);

  const double rough_multiquadric =
      roughness_of_basis_function<n>(SC::Inverse_multiquadric(), inverse_multiquadric, 3.);
  const double rough_matern = roughness_of_basis_function<n>(SC::Matern_9_2(), matern, 1.);
  BOOST_TEST_MESSAGE(n << " lanes: rounding of the inverse multiquadric " << rough_multiquadric
                       << ", of the Matern function " << rough_matern);
  BOOST_TEST(rough_multiquadric < 1e-26);
  BOOST_TEST(rough_matern < 1e-17);
}

} // namespace

BOOST_AUTO_TEST_CASE(one_lane)
{
  check<1>();
}

BOOST_AUTO_TEST_CASE(lanes_that_every_processor_has)
{
  check<most_lanes>();
}

BOOST_AUTO_TEST_SUITE_END()
