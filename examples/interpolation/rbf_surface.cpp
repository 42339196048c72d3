// An implicit surface through points with normals, and its curvature anywhere.
#include <Shape_characteristics/curvature/implicit_surface_curvatures.h>
#include <Shape_characteristics/interpolation/Polyharmonic.h>
#include <Shape_characteristics/interpolation/Rbf_interpolant.h>

#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;

int main()
{
  // points spread evenly over a sphere of radius 5
  const double radius = 5;
  const Kernel::Point_3 center(1, 2, 3);
  std::vector<Kernel::Point_3> points;
  std::vector<Kernel::Vector_3> normals;
  const int n = 200;
  for(int i = 0; i < n; ++i)
  {
    const double z = 1 - (2 * i + 1.) / n, s = std::sqrt(1 - z * z), angle = 2.399963229728653 * i;
    normals.emplace_back(s * std::cos(angle), s * std::sin(angle), z);
    points.push_back(center + radius * normals.back());
  }

  const SC::Rbf_interpolant surface(points, normals, SC::Polyharmonic<5>());
  if(!surface.is_valid())
    return EXIT_FAILURE;

  // a point between the samples: a few steps to the surface along the gradient, and the curvatures there
  Kernel::Point_3 p = center + 1.02 * radius * Kernel::Vector_3(0.6, 0, 0.8);
  for(int step = 0; step < 3; ++step)
  {
    const Kernel::Vector_3 gradient = surface.gradient(p);
    p = p - surface(p) / gradient.squared_length() * gradient;
  }
  const auto curvatures = SC::implicit_surface_curvatures(surface.gradient(p), surface.hessian(p));
  const double distance = std::sqrt(CGAL::squared_distance(p, center));
  std::cout << "inside " << surface(center) << ", outside " << surface(center + 1.2 * radius * normals[0])
            << '\n'
            << "distance to the center " << distance << ", curvatures " << curvatures.min_curvature << " and "
            << curvatures.max_curvature << ", expected " << 1 / radius << '\n';
  const bool is_right = std::abs(distance - radius) < 0.01 &&
                        std::abs(curvatures.min_curvature * radius - 1) < 0.05 &&
                        std::abs(curvatures.max_curvature * radius - 1) < 0.05;
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
