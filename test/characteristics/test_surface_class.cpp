#include <boost/test/unit_test.hpp>

#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/characteristics/surface_class.h>

#include <CGAL/Simple_cartesian.h>

#include "check_names.h"

#include <limits>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(surface_class)

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Curvatures = SC::Principal_curvatures_and_directions<Kernel>;

namespace {

Curvatures curvatures(double k_min, double k_max)
{
  Curvatures result;
  result.min_curvature = k_min;
  result.max_curvature = k_max;
  return result;
}

} // namespace

// Table 4.1, all nine entries
BOOST_AUTO_TEST_CASE(classes_of_the_table)
{
  using C = SC::Surface_class;
  const C table[3][3] = {{C::CONCAVE_ELLIPSOID, C::CONCAVE_CYLINDER, C::HYPERBOLOID},
                         {C::CONCAVE_CYLINDER, C::PLANE, C::CONVEX_CYLINDER},
                         {C::HYPERBOLOID, C::CONVEX_CYLINDER, C::CONVEX_ELLIPSOID}};
  for(double scale : {1e-300, 1e-10, 1., 1e300})
    for(int i = -1; i <= 1; ++i)
      for(int j = -1; j <= 1; ++j)
        BOOST_TEST((SC::surface_class(curvatures(i * scale, j * 0.5 * scale)) == table[i + 1][j + 1]));
}

BOOST_AUTO_TEST_CASE(class_tolerances)
{
  using C = SC::Surface_class;
  BOOST_TEST((SC::surface_class(curvatures(-0.0009, 1)) == C::CONVEX_CYLINDER));
  BOOST_TEST((SC::surface_class(curvatures(-0.0011, 1)) == C::HYPERBOLOID));
  BOOST_TEST((SC::surface_class(curvatures(-0.0009, 1), 0) == C::HYPERBOLOID));
  BOOST_TEST((SC::surface_class(curvatures(-0.09, 1), 0.1) == C::CONVEX_CYLINDER));
  BOOST_TEST((SC::surface_class(curvatures(-1, 0.0005)) == C::CONCAVE_CYLINDER));
  BOOST_TEST((SC::surface_class(curvatures(-1e-9, 1e-8)) == C::HYPERBOLOID));
  BOOST_TEST((SC::surface_class(curvatures(-1e-9, 1e-8), 0, 1e-8) == C::PLANE));
  BOOST_TEST((SC::surface_class(curvatures(-1e-9, 1.1e-8), 0, 1e-8) == C::CONVEX_CYLINDER));

  const double quiet_nan = std::numeric_limits<double>::quiet_NaN(),
               inf = std::numeric_limits<double>::infinity();
  for(double wrong : {quiet_nan, inf, -inf})
  {
    BOOST_TEST((SC::surface_class(curvatures(wrong, 1)) == C::UNDEFINED));
    BOOST_TEST((SC::surface_class(curvatures(-1, wrong)) == C::UNDEFINED));
  }
  for(double wrong : {-0.1, 1., quiet_nan})
    BOOST_CHECK_THROW(SC::surface_class(curvatures(0, 1), wrong), std::invalid_argument);
  for(double wrong : {-0.1, quiet_nan})
    BOOST_CHECK_THROW(SC::surface_class(curvatures(0, 1), 0, wrong), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(every_class_has_its_name)
{
  test_support::check_names<SC::Surface_class>({"CONCAVE_ELLIPSOID", "CONCAVE_CYLINDER", "PLANE",
                                                "HYPERBOLOID", "CONVEX_CYLINDER", "CONVEX_ELLIPSOID",
                                                "UNDEFINED"});
}

BOOST_AUTO_TEST_SUITE_END()
