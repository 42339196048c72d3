// Curvatures of a torus from the derivatives of its parametrization.
#include <Shape_characteristics/curvature/Fundamental_forms.h>
#include <Shape_characteristics/curvature/parametric_surface_curvatures.h>

#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Vector_3 = Kernel::Vector_3;

int main()
{
  // x(u, v) = ((R + r cos v) cos u, (R + r cos v) sin u, r sin v); T_u x T_v points outward
  const double R = 3, r = 1;
  bool is_right = true;
  for(double v = 0; v < 6.2; v += 0.5)
  {
    const double u = 0.3;
    const double cu = std::cos(u), su = std::sin(u), cv = std::cos(v), sv = std::sin(v), d = R + r * cv;
    const Vector_3 Tu(-d * su, d * cu, 0), Tv(-r * sv * cu, -r * sv * su, r * cv);
    const Vector_3 Tuu(-d * cu, -d * su, 0), Tuv(r * sv * su, -r * sv * cu, 0),
        Tvv(-r * cv * cu, -r * cv * su, -r * sv);

    const auto curvatures = SC::parametric_surface_curvatures(Tu, Tv, Tuu, Tuv, Tvv);
    const SC::Fundamental_forms forms(Tu, Tv, Tuu, Tuv, Tvv);
    std::cout << "v = " << v << ": curvatures " << curvatures.min_curvature << ", "
              << curvatures.max_curvature << "; first form " << forms.E() << ' ' << forms.F() << ' '
              << forms.G() << ", second form " << forms.L() << ' ' << forms.M() << ' ' << forms.N() << '\n';

    // around the tube 1/r, along the ring cos v / d
    is_right = is_right && std::abs(curvatures.max_curvature - 1 / r) < 1e-12 &&
               std::abs(curvatures.min_curvature - cv / d) < 1e-12 &&
               std::abs(forms.Gaussian_curvature() - cv / (r * d)) < 1e-12;
  }
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
