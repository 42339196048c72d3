// Curvatures of a hill, its directions, the curvature in any other direction, and the class of its shape.
#include <Shape_characteristics/characteristics/surface_class.h>
#include <Shape_characteristics/curvature/height_field_curvatures.h>
#include <Shape_characteristics/curvature/normal_curvature.h>

#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;

int main()
{
  // h(u, v) = exp(-u^2 - 2 v^2) at its top and at its foot
  bool is_right = true;
  for(double u : {0., 2.})
  {
    const double v = 0, h = std::exp(-u * u - 2 * v * v);
    const auto curvatures =
        SC::height_field_curvatures<Kernel>(-2 * u * h, -4 * v * h, (4 * u * u - 2) * h, 8 * u * v * h,
                                            (16 * v * v - 4) * h, SC::Height_field_normal::UPWARD);
    const SC::Surface_class surface_class = SC::surface_class(curvatures);
    const double diagonal = SC::normal_curvature(curvatures, Kernel::Vector_3(1, 1, -2 * u * h));
    std::cout << "u = " << u << ": " << SC::to_string(surface_class) << " with " << curvatures.min_curvature
              << " along " << curvatures.min_direction << ", " << curvatures.max_curvature << " along "
              << curvatures.max_direction << ", and " << diagonal << " along the diagonal\n";

    if(u == 0) // no slope: the curvatures are minus the second derivatives
      is_right = is_right && surface_class == SC::Surface_class::CONVEX_ELLIPSOID &&
                 std::abs(curvatures.min_curvature - 2) < 1e-12 &&
                 std::abs(curvatures.max_curvature - 4) < 1e-12 && std::abs(diagonal - 3) < 1e-12;
    else // the foot is hollow along the slope and still convex across it
      is_right = is_right && surface_class == SC::Surface_class::HYPERBOLOID;
  }
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
