#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_TREND_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_TREND_H

#include <Shape_characteristics/interpolation/internal/Height_polynomial.h>
#include <Shape_characteristics/interpolation/internal/Hermite_jet.h>

#include <Eigen/Core>

namespace Shape_characteristics {
namespace internal {

// The function w . x - h(u . x, v . x) with a polynomial h: how high x is above a surface, seen along w. Radial basis
// functions are fitted to what it leaves.
struct Hermite_trend
{
  Hermite_trend() = default;
  explicit Hermite_trend(const Eigen::Vector3d& linear) : w(linear) {}

  // A template, so that its long expressions are compiled where they are used alone.
  template <typename Vector>
  Hermite_jet operator()(const Vector& x) const
  {
    const double a = u.dot(x), b = v.dot(x);
    double h = 0., ha = 0., hb = 0., haa = 0., hab = 0., hbb = 0.;
    height.value(a, b, h);
    height.gradient(a, b, ha, hb);
    height.hessian(a, b, haa, hab, hbb);
    Hermite_jet jet;
    jet.value = w.dot(x) - h;
    jet.gradient = w - ha * u - hb * v;
    jet.hessian = -(haa * (u * u.transpose()) + hab * (u * v.transpose() + v * u.transpose()) +
                    hbb * (v * v.transpose()));
    return jet;
  }

  Eigen::Vector3d u = Eigen::Vector3d::Zero(), v = Eigen::Vector3d::Zero(), w = Eigen::Vector3d::Zero();
  Height_polynomial<double> height;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_TREND_H
