#ifndef SHAPE_CHARACTERISTICS_TEST_BAD_INPUTS_KNOWN_SHAPES_H
#define SHAPE_CHARACTERISTICS_TEST_BAD_INPUTS_KNOWN_SHAPES_H

#include "estimators.h"
#include "raise_to.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

// What an estimator has to say of shapes that are no bad input, for meshes and point sets alike.
namespace bad_inputs {

// Of samples of a closed sphere: both curvatures are 1 / `radius`.
template <typename Input>
void check_sphere(const Estimator<Input>& estimator, const Results& results, double radius)
{
  double worst = 0.;
  for(const Estimate& e : results.samples)
  {
    BOOST_TEST((e.status == Estimation_status::ESTIMATED));
    test_support::raise_to(worst, std::abs(e.k_min() * radius - 1.), std::abs(e.k_max() * radius - 1.));
  }
  BOOST_TEST_MESSAGE("sphere, " << estimator.name << ": " << worst);
  BOOST_TEST(worst <= estimator.accuracy);
}

// Of these samples of a cylinder of radius 1 around the z axis: k_min is zero, and has a direction all the same.
template <typename Input>
void check_cylinder(const Estimator<Input>& estimator,
                    const Results& results,
                    const std::vector<std::size_t>& samples)
{
  BOOST_REQUIRE(!samples.empty());
  double worst = 0.;
  for(const std::size_t i : samples)
  {
    const Estimate& e = results.samples[i];
    BOOST_TEST((e.status == Estimation_status::ESTIMATED));
    test_support::raise_to(worst, std::abs(e.k_min()), std::abs(e.k_max() - 1.));
    if(estimator.accuracy < 1.)
      BOOST_TEST(std::abs(e.values[6]) > 1. - 2. * estimator.accuracy, "sample " << i);
  }
  BOOST_TEST_MESSAGE("cylinder, " << estimator.name << ": " << worst);
  BOOST_TEST(worst <= estimator.accuracy);
}

} // namespace bad_inputs

#endif // SHAPE_CHARACTERISTICS_TEST_BAD_INPUTS_KNOWN_SHAPES_H
