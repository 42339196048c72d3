// An implicit surface through a few points with normals, and its curvature between them.
#include <Shape_characteristics/curvature/implicit_surface_curvatures.h>
#include <Shape_characteristics/interpolation/Hermite_rbf_interpolant.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;

int main()
{
  // 288 points of a torus around the z axis: a tube of radius 1 around a circle of radius 3
  const double ring = 3, tube = 1, two_pi = 6.283185307179586;
  std::vector<Kernel::Point_3> points;
  std::vector<Kernel::Vector_3> normals;
  for(int i = 0; i < 24; ++i)
    for(int j = 0; j < 12; ++j)
    {
      const double a = two_pi * i / 24, b = two_pi * j / 12;
      const Kernel::Vector_3 outward(std::cos(a), std::sin(a), 0);
      normals.push_back(std::cos(b) * outward + std::sin(b) * Kernel::Vector_3(0, 0, 1));
      points.push_back(CGAL::ORIGIN + ring * outward + tube * normals.back());
    }

  const SC::Hermite_rbf_interpolant surface(points, normals);
  if(!surface.is_valid())
    return EXIT_FAILURE;
  std::cout << "at the center " << surface(CGAL::ORIGIN) << ", within the tube "
            << surface(Kernel::Point_3(ring, 0, 0)) << '\n';

  // between the points, once around the tube: two steps along the gradient to the surface, and the curvatures there
  double largest_error = 0;
  for(int j = 0; j < 12; ++j)
  {
    const double a = two_pi * 0.5 / 24, b = two_pi * (j + 0.5) / 12;
    const Kernel::Vector_3 outward(std::cos(a), std::sin(a), 0);
    Kernel::Point_3 p = CGAL::ORIGIN + ring * outward +
                        tube * (std::cos(b) * outward + std::sin(b) * Kernel::Vector_3(0, 0, 1));
    for(int step = 0; step < 2; ++step)
    {
      const Kernel::Vector_3 gradient = surface.gradient(p);
      p = p - surface(p) / gradient.squared_length() * gradient;
    }
    const auto curvatures = SC::implicit_surface_curvatures(surface.gradient(p), surface.hessian(p));
    const double exact_min = std::cos(b) / (ring + tube * std::cos(b)), exact_max = 1 / tube;
    std::cout << "curvatures " << curvatures.min_curvature << " (" << exact_min << ") and "
              << curvatures.max_curvature << " (" << exact_max << ")\n";
    largest_error = std::max({largest_error, std::abs(curvatures.min_curvature - exact_min),
                              std::abs(curvatures.max_curvature - exact_max)});
  }
  return largest_error < 0.02 ? EXIT_SUCCESS : EXIT_FAILURE;
}
