#include <boost/test/unit_test.hpp>

#include "Random.h"
#include "test_functions.h"

#include <cmath>

BOOST_AUTO_TEST_SUITE(functions)

using namespace benchmark_support;

// The derivatives typed in are checked against central differences of the functions, of second order, at step h.

BOOST_AUTO_TEST_CASE(derivatives_of_explicit_functions)
{
  Random random(1);
  for(const Explicit_function& f : explicit_functions())
    BOOST_TEST_CONTEXT(f.name)
  for(int i = 0; i < 500; ++i)
  {
    // every tenth sample close to the origin, where f1e is summed as a series
    const double range = i % 10 == 0 ? .05 * f.half : f.half, h = 1e-4 * f.half;
    const double x = random.uniform(-range, range), y = random.uniform(-range, range);
    const auto g = f.gradient(x, y);
    const auto hessian = f.hessian(x, y);
    const double scale = 10. / f.half;
    BOOST_TEST(std::abs((f.value(x + h, y) - f.value(x - h, y)) / (2. * h) - g[0]) < 3e-5 * scale);
    BOOST_TEST(std::abs((f.value(x, y + h) - f.value(x, y - h)) / (2. * h) - g[1]) < 3e-5 * scale);
    BOOST_TEST(std::abs((f.gradient(x + h, y)[0] - f.gradient(x - h, y)[0]) / (2. * h) - hessian[0]) <
               3e-5 * scale * scale);
    BOOST_TEST(std::abs((f.gradient(x, y + h)[0] - f.gradient(x, y - h)[0]) / (2. * h) - hessian[1]) <
               3e-5 * scale * scale);
    BOOST_TEST(std::abs((f.gradient(x + h, y)[1] - f.gradient(x - h, y)[1]) / (2. * h) - hessian[1]) <
               3e-5 * scale * scale);
    BOOST_TEST(std::abs((f.gradient(x, y + h)[1] - f.gradient(x, y - h)[1]) / (2. * h) - hessian[2]) <
               3e-5 * scale * scale);
  }
}

BOOST_AUTO_TEST_CASE(f1e_is_continued_to_the_origin)
{
  const Explicit_function& f = explicit_function("f1e");
  BOOST_TEST(f.value(0., 0.) == 10.);
  // sinc = 1 - r^2 / 6 + ...: a peak of curvature 10 / 3 in all directions, convex
  const Exact_curvature e = f.exact(0., 0.);
  BOOST_TEST(std::abs(e.k_min - 10. / 3.) < 1e-14);
  BOOST_TEST(std::abs(e.k_max - 10. / 3.) < 1e-14);
  BOOST_TEST((e.normal == Vector{0., 0., 1.}));
  // series and closed form meet at r = 1
  const auto below = f.hessian(1. - 1e-12, 0.), above = f.hessian(1. + 1e-12, 0.);
  for(int i = 0; i < 3; ++i)
    BOOST_TEST(std::abs(below[i] - above[i]) < 1e-10);
}

BOOST_AUTO_TEST_CASE(derivatives_of_implicit_functions)
{
  Random random(2);
  for(const Implicit_function& f : implicit_functions())
    BOOST_TEST_CONTEXT(f.name)
  for(int i = 0; i < 500; ++i)
  {
    const double h = 1e-5;
    const Vector p{random.uniform(-f.half, f.half), random.uniform(-f.half, f.half),
                   random.uniform(-f.half, f.half)};
    const Vector g = f.gradient(p);
    const Symmetric_matrix hessian = f.hessian(p);
    for(int a = 0; a < 3; ++a)
    {
      Vector lower = p, upper = p;
      lower[a] -= h;
      upper[a] += h;
      BOOST_TEST(std::abs((f.value(upper) - f.value(lower)) / (2. * h) - g[a]) < 1e-6);
      const Vector turn = (.5 / h) * (f.gradient(upper) - f.gradient(lower));
      BOOST_TEST(length(turn - hessian[a]) < 1e-5);
    }
  }
}

// along a principal direction the unit normal turns by k d (Rodrigues)
BOOST_AUTO_TEST_CASE(curvatures_are_those_of_the_normals)
{
  Random random(3);
  for(const Implicit_function& f : implicit_functions())
    BOOST_TEST_CONTEXT(f.name)
  for(int i = 0; i < 200; ++i)
  {
    const Vector p{random.uniform(-f.half, f.half), random.uniform(-f.half, f.half),
                   random.uniform(-f.half, f.half)};
    const double g = length(f.gradient(p));
    if(g < .5)
      continue;
    const Exact_curvature e = f.exact(p);
    BOOST_TEST(e.k_min <= e.k_max);
    BOOST_TEST(length(e.normal - (1. / g) * f.gradient(p)) < 1e-14);
    const double h = 1e-5;
    for(const auto& [k, d] : {std::make_pair(e.k_min, e.d_min), std::make_pair(e.k_max, e.d_max)})
    {
      BOOST_TEST(std::abs(dot(d, e.normal)) < 1e-12);
      const Vector turn = (.5 / h) * (normalized(f.gradient(p + h * d)) - normalized(f.gradient(p - h * d)));
      BOOST_TEST(length(turn - k * d) < 1e-4);
    }
    BOOST_TEST(std::abs(dot(e.d_min, e.d_max)) < 1e-12);
    BOOST_TEST(e.mean() == .5 * (e.k_min + e.k_max));
    BOOST_TEST(e.gaussian() == e.k_min * e.k_max);
  }
}

BOOST_AUTO_TEST_CASE(convex_is_positive)
{
  // the bottom of a bowl seen from above is concave, f4i's outside is convex
  const Exact_curvature bowl = explicit_function("f3e").exact(0., 0.);
  BOOST_TEST((std::abs(bowl.k_min + 10.) < 1e-12 && std::abs(bowl.k_max + 10.) < 1e-12));
  const double s = std::pow(1. / 3., .25);
  BOOST_TEST(implicit_function("f4i").exact({s, s, s}).k_min > .5);
}

BOOST_AUTO_TEST_CASE(unknown_names_are_refused)
{
  BOOST_CHECK_THROW(explicit_function("f1i"), std::invalid_argument);
  BOOST_CHECK_THROW(implicit_function("f1e"), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
