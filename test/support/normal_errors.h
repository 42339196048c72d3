#ifndef SHAPE_CHARACTERISTICS_TEST_SUPPORT_NORMAL_ERRORS_H
#define SHAPE_CHARACTERISTICS_TEST_SUPPORT_NORMAL_ERRORS_H

#include "../../benchmark/support/Random.h"
#include "../../benchmark/support/Triangle_arrays.h"

#include <CGAL/Simple_cartesian.h>

#include <cmath>

// Normals next to the exact ones.
namespace test_support {

using Normal = CGAL::Simple_cartesian<double>::Vector_3;

inline Normal normal_of(const benchmark_support::Vector& v)
{
  return Normal(v[0], v[1], v[2]);
}

/// |a - b|^2 / 2: 1 - a . b of unit vectors, without its rounding
inline double normal_error(const Normal& a, const Normal& b)
{
  return (a - b).squared_length() / 2;
}

/// a unit normal with Gaussian noise on its components
inline Normal disturbed(const Normal& n, double deviation, benchmark_support::Random& random)
{
  const Normal d = n + deviation * Normal(random.gaussian(), random.gaussian(), random.gaussian());
  return d / std::sqrt(d.squared_length());
}

} // namespace test_support

#endif // SHAPE_CHARACTERISTICS_TEST_SUPPORT_NORMAL_ERRORS_H
