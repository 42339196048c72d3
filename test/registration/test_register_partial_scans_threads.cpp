#include <boost/test/unit_test.hpp>

#include <Shape_characteristics/registration/register_partial_scans.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/tags.h>

#include "oriented_point_maps.h"

#include <cmath>
#include <cstddef>
#include <vector>

BOOST_AUTO_TEST_SUITE(register_partial_scans_threads)

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Scan = std::vector<test_support::Oriented_point>;

namespace {

// the graph of a hilly function over a rectangle from (x, 0) on, moved by `shift` of the spacing
Scan hills(double x, double shift)
{
  constexpr int n = 45;
  Scan scan;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
    {
      const double u = x + (i + shift) / n, v = (j + shift) / n;
      const double height =
          .1 * std::sin(7. * u + 2. * v) + .06 * std::sin(11. * v - 3. * u) + .05 * std::cos(13. * u * v);
      const double du = .7 * std::cos(7. * u + 2. * v) - .18 * std::cos(11. * v - 3. * u) -
                        .65 * v * std::sin(13. * u * v),
                   dv = .2 * std::cos(7. * u + 2. * v) + .66 * std::cos(11. * v - 3. * u) -
                        .65 * u * std::sin(13. * u * v);
      scan.emplace_back(Kernel::Point_3(u, v, height), Kernel::Vector_3(-du, -dv, 1));
    }
  return scan;
}

template <typename ConcurrencyTag>
SC::Registration_result<Kernel> registered(const Scan& source, const Scan& target)
{
  const auto maps = test_support::oriented_point_maps();
  return SC::register_partial_scans<ConcurrencyTag>(source, target, maps, maps);
}

} // namespace

BOOST_AUTO_TEST_CASE(any_number_of_threads)
{
  const Scan source = hills(.4, .3), target = hills(0., 0.);
  const auto one = registered<CGAL::Sequential_tag>(source, target),
             all = registered<CGAL::Parallel_if_available_tag>(source, target);
  BOOST_TEST(int(one.verdict) == int(SC::Registration_verdict::SUCCESS));
  BOOST_TEST(int(all.verdict) == int(one.verdict));
  BOOST_TEST(all.confidence == one.confidence);
  for(int row = 0; row < 3; ++row)
    for(int column = 0; column < 4; ++column)
    {
      BOOST_TEST(all.transformation.m(row, column) == one.transformation.m(row, column));
      BOOST_TEST(std::abs(one.transformation.m(row, column) - (row == column ? 1. : 0.)) <
                 .02); // they are in place
    }
}

BOOST_AUTO_TEST_SUITE_END()
