// Curvatures of an ellipsoid from the derivatives of its equation.
#include <Shape_characteristics/curvature/implicit_surface_Gaussian_curvature.h>
#include <Shape_characteristics/curvature/implicit_surface_curvatures.h>
#include <Shape_characteristics/curvature/implicit_surface_mean_curvature.h>

#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;

int main()
{
  // F(x, y, z) = x^2/a^2 + y^2/b^2 + z^2/c^2 - 1, negative inside
  const double a = 3, b = 2, c = 1;
  const Kernel::Point_3 p(a, 0, 0); // the tip of the longest axis

  const Kernel::Vector_3 gradient(2 * p.x() / (a * a), 2 * p.y() / (b * b), 2 * p.z() / (c * c));
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
  hessian.diagonal() << 2 / (a * a), 2 / (b * b), 2 / (c * c);

  const auto curvatures = SC::implicit_surface_curvatures(gradient, hessian);
  std::cout << "minimal curvature " << curvatures.min_curvature << " along " << curvatures.min_direction
            << '\n'
            << "maximal curvature " << curvatures.max_curvature << " along " << curvatures.max_direction
            << '\n'
            << "mean curvature " << SC::implicit_surface_mean_curvature(gradient, hessian) << '\n'
            << "Gaussian curvature " << SC::implicit_surface_Gaussian_curvature(gradient, hessian) << '\n';

  // at this tip the curvatures are a/b^2 and a/c^2
  const bool is_right = std::abs(curvatures.min_curvature - a / (b * b)) < 1e-12 &&
                        std::abs(curvatures.max_curvature - a / (c * c)) < 1e-12 &&
                        std::abs(curvatures.min_direction.y()) > 1 - 1e-12;
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
