// The table of radial basis functions, and how their derivatives in space follow from those by the squared distance.
#include <Shape_characteristics/interpolation/Gaussian.h>
#include <Shape_characteristics/interpolation/Inverse_multiquadric.h>
#include <Shape_characteristics/interpolation/Matern_9_2.h>
#include <Shape_characteristics/interpolation/Multiquadric.h>
#include <Shape_characteristics/interpolation/Polyharmonic.h>
#include <Shape_characteristics/interpolation/Wendland_3_2.h>

#include <Eigen/Core>

#include <cstdlib>
#include <iostream>

namespace SC = Shape_characteristics;

// Prints a row of the table, and returns whether the Hessian matrix is the derivative of the gradient.
template <typename RadialBasisFunction>
bool show(const char* name, const RadialBasisFunction& phi)
{
  std::cout << name << (RadialBasisFunction::is_positive_definite ? " (positive definite):" : ":");
  for(double r : {0., 0.25, 0.5, 0.75})
    std::cout << ' ' << phi(r);
  std::cout << '\n';

  const auto gradient = [&phi](const Eigen::Vector3d& d) -> Eigen::Vector3d
  { return phi.radial_derivatives(d.squaredNorm())[1] * d; };
  const Eigen::Vector3d d(0.2, -0.3, 0.4);
  const auto a = phi.radial_derivatives(d.squaredNorm());
  const Eigen::Matrix3d hessian = a[1] * Eigen::Matrix3d::Identity() + a[2] * d * d.transpose();

  const double h = 1e-5;
  Eigen::Matrix3d quotients;
  for(int i = 0; i < 3; ++i)
    quotients.col(i) =
        (gradient(d + h * Eigen::Vector3d::Unit(i)) - gradient(d - h * Eigen::Vector3d::Unit(i))) / (2 * h);
  return (hessian - quotients).norm() < 1e-7 * (1 + hessian.norm());
}

int main()
{
  bool is_right = show("Gaussian", SC::Gaussian(1.5));
  is_right = show("Multiquadric", SC::Multiquadric(1.5)) && is_right;
  is_right = show("Inverse multiquadric", SC::Inverse_multiquadric(1.5)) && is_right;
  is_right = show("Polyharmonic spline r^3", SC::Polyharmonic<3>()) && is_right;
  is_right = show("Wendland 3,2", SC::Wendland_3_2(1)) && is_right;
  is_right = show("Matern 9/2", SC::Matern_9_2(3)) && is_right;
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
