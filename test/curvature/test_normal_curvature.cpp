#include <boost/test/unit_test.hpp>

#include <Shape_characteristics/curvature/implicit_surface_curvatures.h>
#include <Shape_characteristics/curvature/normal_curvature.h>

#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <limits>
#include <random>

BOOST_AUTO_TEST_SUITE(normal_curvature)

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Vector_3 = Kernel::Vector_3;
using Curvatures = SC::Principal_curvatures_and_directions<Kernel>;

namespace {

Curvatures curvatures(double k_min, double k_max)
{
  return {k_min, k_max, Vector_3(0, 1, 0), Vector_3(1, 0, 0)};
}

} // namespace

// the second derivative of the surface along the direction is the oracle
BOOST_AUTO_TEST_CASE(equals_the_quadratic_form_of_the_hessian)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> entry(-1, 1);
  for(int i = 0; i < 1000; ++i)
  {
    Eigen::Matrix3d h = Eigen::Matrix3d::Random();
    h = (h + h.transpose()).eval();
    const Vector_3 g(entry(random), entry(random), entry(random));
    const Vector_3 t = CGAL::cross_product(g, Vector_3(entry(random), entry(random), entry(random)));
    const Eigen::Vector3d d = Eigen::Vector3d(t.x(), t.y(), t.z()).normalized();
    const double expected = d.dot(h * d) / std::sqrt(g.squared_length());

    const Curvatures c = SC::implicit_surface_curvatures(g, h);
    const double size = 1 + h.norm() / std::sqrt(g.squared_length());
    BOOST_TEST(std::abs(SC::normal_curvature(c, t) - expected) < 1e-13 * size);
    BOOST_TEST(std::abs(SC::normal_curvature(c, -1e-200 * t) - expected) < 1e-13 * size);
    BOOST_TEST(std::abs(SC::normal_curvature(c, 1e200 * t) - expected) < 1e-13 * size);
    // nothing but rounding errors is tangential in a normal
    BOOST_TEST(std::isnan(SC::normal_curvature(c, g)));
    BOOST_TEST(std::isnan(SC::normal_curvature(c, -1e9 * g)));
    // its tangential part counts
    BOOST_TEST(std::abs(SC::normal_curvature(c, t + 0.5 * g) - expected) < 1e-12 * size);
  }
}

BOOST_AUTO_TEST_CASE(by_angle_and_by_direction)
{
  const Curvatures c = curvatures(-1, 3);
  for(double alpha : {0., 0.3, 0.7853981633974483, 1.5707963267948966, 2., -0.3})
  {
    const double expected = 3 * std::pow(std::cos(alpha), 2) - std::pow(std::sin(alpha), 2);
    BOOST_TEST(std::abs(SC::normal_curvature(c, alpha) - expected) < 1e-14);
    BOOST_TEST(std::abs(SC::normal_curvature(c, Vector_3(std::cos(alpha), std::sin(alpha), 0)) - expected) <
               1e-14);
  }
  BOOST_TEST(SC::normal_curvature(c, Vector_3(5, 0, 0)) == 3);
  BOOST_TEST(SC::normal_curvature(c, Vector_3(0, -5, 0)) == -1);
  BOOST_TEST(SC::normal_curvature(c, 0) == 3);
}

BOOST_AUTO_TEST_CASE(no_tangent_direction)
{
  const Curvatures c = curvatures(-1, 3);
  const double quiet_nan = std::numeric_limits<double>::quiet_NaN(),
               inf = std::numeric_limits<double>::infinity();
  for(const Vector_3& d :
      {Vector_3(0, 0, 0), Vector_3(0, 0, 4), Vector_3(0, quiet_nan, 1), Vector_3(inf, 0, 0)})
    BOOST_TEST(std::isnan(SC::normal_curvature(c, d)));
  BOOST_TEST(std::isnan(SC::normal_curvature(Curvatures(), Vector_3(1, 0, 0)))); // no directions
  BOOST_TEST(std::isnan(SC::normal_curvature(curvatures(quiet_nan, quiet_nan), Vector_3(1, 0, 0))));
}

BOOST_AUTO_TEST_SUITE_END()
