#ifndef SHAPE_CHARACTERISTICS_TEST_FUZZ_FUZZED_POINTS_H
#define SHAPE_CHARACTERISTICS_TEST_FUZZ_FUZZED_POINTS_H

#include "fuzzed_data.h"

#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <vector>

namespace fuzz {

// Up to `largest` points with normals, some of them copies of others, some on a saddle. `Oriented_point` is made of both.
template <typename Oriented_point>
std::vector<Oriented_point> points(FuzzedDataProvider& data, std::size_t largest = 24)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  const double factor = scale(data);
  const std::size_t n = data.ConsumeIntegralInRange<std::size_t>(0, largest);
  std::vector<Oriented_point> points;
  while(points.size() < n)
  {
    const int kind = data.ConsumeIntegralInRange<int>(0, 9);
    if(kind == 0 && !points.empty())
    {
      points.push_back(points[data.ConsumeIntegralInRange<std::size_t>(0, points.size() - 1)]);
      continue;
    }
    const double x = factor * number(data), y = factor * number(data);
    const double z = kind < 4 ? factor * number(data) : (x * x - y * y) / 4.;
    Kernel::Vector_3 normal(-x / 2., y / 2., 1.);
    if(kind < 3)
      normal = Kernel::Vector_3(number(data), number(data), number(data));
    points.push_back({Kernel::Point_3(x, y, z), normal});
  }
  return points;
}

} // namespace fuzz

#endif // SHAPE_CHARACTERISTICS_TEST_FUZZ_FUZZED_POINTS_H
