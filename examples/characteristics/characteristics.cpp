// The characteristics of typical shapes, all from their principal curvatures.
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/characteristics/Gaussian_curvature.h>
#include <Shape_characteristics/characteristics/Willmore_energy.h>
#include <Shape_characteristics/characteristics/curvedness.h>
#include <Shape_characteristics/characteristics/is_planar.h>
#include <Shape_characteristics/characteristics/is_umbilic.h>
#include <Shape_characteristics/characteristics/mean_curvature.h>
#include <Shape_characteristics/characteristics/shape_index.h>

#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <tuple>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;

int main()
{
  bool is_right = true;
  // the smaller and the larger curvature of some shapes, and the shape index to be expected
  for(const auto& [name, k_min, k_max, expected] :
      {std::make_tuple("cap", 2., 2., 1.), std::make_tuple("ridge", 0., 2., 0.5),
       std::make_tuple("saddle", -2., 2., 0.), std::make_tuple("rut", -2., 0., -0.5),
       std::make_tuple("cup", -2., -2., -1.)})
  {
    SC::Principal_curvatures_and_directions<Kernel> curvatures;
    curvatures.min_curvature = k_min;
    curvatures.max_curvature = k_max;
    const double index = SC::shape_index(curvatures);
    std::cout << name << ": H " << SC::mean_curvature(curvatures) << ", K "
              << SC::Gaussian_curvature(curvatures) << ", shape index " << index << ", curvedness "
              << SC::curvedness(curvatures) << ", Willmore energy " << SC::Willmore_energy(curvatures)
              << (SC::is_umbilic(curvatures) ? ", umbilic" : "") << '\n';
    is_right = is_right && std::abs(index - expected) < 1e-15 &&
               SC::is_umbilic(curvatures) == (std::abs(expected) == 1) && !SC::is_planar(curvatures);
  }

  // a plane has no shape index
  const SC::Principal_curvatures_and_directions<Kernel> plane;
  std::cout << "plane: shape index " << SC::shape_index(plane) << ", curvedness " << SC::curvedness(plane)
            << '\n';
  is_right =
      is_right && SC::is_planar(plane) && std::isnan(SC::shape_index(plane)) && SC::curvedness(plane) == 0;
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
