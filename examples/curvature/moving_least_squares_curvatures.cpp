// Curvatures of a point set with normals as those of its moving least squares surface, with neighborhoods of several sizes.
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/moving_least_squares_curvatures.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Point_set = CGAL::Point_set_3<Kernel::Point_3>;
using Curvatures = SC::Principal_curvatures_and_directions<Kernel>;

int main()
{
  // points of a sphere of radius 2, spread evenly along a spiral
  const double radius = 2.;
  const unsigned int n = 4000;
  Point_set points(true);
  for(unsigned int i = 0; i < n; ++i)
  {
    const double z = 1. - (2. * i + 1.) / n, angle = i * CGAL_PI * (3. - std::sqrt(5.)),
                 r = std::sqrt(1. - z * z);
    const Kernel::Vector_3 normal(r * std::cos(angle), r * std::sin(angle), z);
    points.insert(CGAL::ORIGIN + radius * normal, normal);
  }

  auto curvatures = points.add_property_map<Curvatures>("curvatures").first;
  double largest = 0.;
  for(const unsigned int neighbors : {18u, 36u, 60u})
  {
    const std::size_t failures = SC::moving_least_squares_curvatures(
        points,
        SC::parameters::principal_curvatures_and_directions_map(curvatures).number_of_neighbors(neighbors));
    largest = 0.;
    for(const auto& i : points)
      largest = std::max({largest, std::abs(curvatures[i].min_curvature - 1. / radius),
                          std::abs(curvatures[i].max_curvature - 1. / radius)});
    std::cout << neighbors << " neighbors: largest error " << largest << " of " << 1. / radius << ", "
              << failures << " failures\n";
    if(failures > 0)
      return EXIT_FAILURE;
  }
  return largest < .1 ? EXIT_SUCCESS : EXIT_FAILURE;
}
