#ifndef SHAPE_CHARACTERISTICS_TEST_SUPPORT_CURVATURE_ESTIMATES_H
#define SHAPE_CHARACTERISTICS_TEST_SUPPORT_CURVATURE_ESTIMATES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>

#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <vector>

namespace test_support {

/// All that an estimator of curvatures writes, by the number of the sample, and returns.
struct Curvature_estimates
{
  using Curvatures =
      Shape_characteristics::Principal_curvatures_and_directions<CGAL::Simple_cartesian<double>>;

  std::vector<Curvatures> curvatures;
  std::vector<double> mean, Gaussian;
  std::vector<Shape_characteristics::Estimation_status> status;
  std::size_t failures = 0;
};

} // namespace test_support

#endif // SHAPE_CHARACTERISTICS_TEST_SUPPORT_CURVATURE_ESTIMATES_H
