// Curvatures of a terrain that is given by heights on a grid, with a lake where nothing was measured: ridges and valleys.
#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/height_field_curvatures.h>
#include <Shape_characteristics/curvature/height_grid_curvatures.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <vector>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Curvatures = SC::Principal_curvatures_and_directions<Kernel>;

int main()
{
  // 241 x 161 heights in meters, every 25 m to the east and every 30 m to the north: h = 80 sin(x / 500) cos(y / 600)
  const std::size_t columns = 241, rows = 161;
  const double east = 25., north = 30., a = 1. / 500., b = 1. / 600., height = 80.;
  std::vector<double> heights;
  for(std::size_t j = 0; j < rows; ++j)
    for(std::size_t i = 0; i < columns; ++i)
    {
      const double x = double(i) * east, y = double(j) * north;
      const bool is_lake = std::hypot(x - 2400., y - 3700.) < 500.;
      heights.push_back(is_lake ? std::numeric_limits<double>::quiet_NaN()
                                : height * std::sin(a * x) * std::cos(b * y));
    }

  std::vector<Curvatures> curvatures(heights.size());
  std::vector<SC::Estimation_status> statuses(heights.size());
  const std::size_t failures = SC::height_grid_curvatures(
      heights, columns, east, north,
      SC::parameters::principal_curvatures_and_directions_map(CGAL::make_property_map(curvatures))
          .status_map(CGAL::make_property_map(statuses)));

  // compared with the formula, and what kind of place it is
  std::size_t ridges = 0, valleys = 0, shores = 0, lake = 0;
  double largest_error = 0., largest = 0.;
  for(std::size_t k = 0; k < heights.size(); ++k)
  {
    lake += statuses[k] == SC::Estimation_status::NON_FINITE_INPUT;
    if(!SC::is_estimated(statuses[k]))
      continue;
    shores += statuses[k] == SC::Estimation_status::BORDER;
    const double x = double(k % columns) * east, y = double(k / columns) * north;
    const double sx = std::sin(a * x), cx = std::cos(a * x), sy = std::sin(b * y), cy = std::cos(b * y);
    const Curvatures exact = SC::height_field_curvatures<Kernel>(
        height * a * cx * cy, -height * b * sx * sy, -height * a * a * sx * cy, -height * a * b * cx * sy,
        -height * b * b * sx * cy, SC::Height_field_normal::UPWARD);
    const Curvatures& c = curvatures[k];
    largest = std::max({largest, std::abs(exact.min_curvature), std::abs(exact.max_curvature)});
    largest_error = std::max({largest_error, std::abs(c.min_curvature - exact.min_curvature),
                              std::abs(c.max_curvature - exact.max_curvature)});
    ridges += c.max_curvature > 1e-4 && c.max_curvature > -c.min_curvature;
    valleys += c.min_curvature < -1e-4 && c.max_curvature < -c.min_curvature;
  }
  std::cout << heights.size() << " heights: " << ridges << " on ridges, " << valleys << " in valleys, "
            << lake << " in the lake, " << shores << " on a shore or at the border\n"
            << "largest error " << largest_error << " of " << largest << " (per meter)\n";
  const bool is_right = failures == lake && ridges > 1000 && valleys > 1000 && largest_error < .02 * largest;
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
