#ifndef SHAPE_CHARACTERISTICS_TEST_SUPPORT_ORIENTED_POINT_MAPS_H
#define SHAPE_CHARACTERISTICS_TEST_SUPPORT_ORIENTED_POINT_MAPS_H

#include <Shape_characteristics/Named_function_parameters.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <utility>

namespace test_support {

/// A point and its normal, as CGAL's functions for point sets have them in their examples.
using Oriented_point =
    std::pair<CGAL::Simple_cartesian<double>::Point_3, CGAL::Simple_cartesian<double>::Vector_3>;

/// The named parameters that say so.
inline auto oriented_point_maps()
{
  return Shape_characteristics::parameters::point_map(CGAL::First_of_pair_property_map<Oriented_point>())
      .normal_map(CGAL::Second_of_pair_property_map<Oriented_point>());
}

} // namespace test_support

#endif // SHAPE_CHARACTERISTICS_TEST_SUPPORT_ORIENTED_POINT_MAPS_H
