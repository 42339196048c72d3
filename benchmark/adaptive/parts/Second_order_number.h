#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_ADAPTIVE_SECOND_ORDER_NUMBER_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_ADAPTIVE_SECOND_ORDER_NUMBER_H

#include "exact_curvature.h"

#include <cmath>
#include <cstddef>

namespace adaptive {

/// A function of x, y, z at a point, with its first and second derivatives: formulas that are written with it
/// differentiate themselves.
struct Second_order_number
{
  double value = 0.;
  benchmark_support::Vector gradient{};
  benchmark_support::Symmetric_matrix hessian{};

  Second_order_number() = default;
  Second_order_number(double constant) : value(constant) {} // NOLINT: formulas have constants

  /// the coordinate of this number at a point
  static Second_order_number coordinate(double value, std::size_t axis)
  {
    Second_order_number result(value);
    result.gradient[axis] = 1.;
    return result;
  }

  /// f(*this), with f and its first two derivatives at the value
  Second_order_number composed(double f, double df, double ddf) const
  {
    Second_order_number result(f);
    for(std::size_t i = 0; i < 3; ++i)
    {
      result.gradient[i] = df * gradient[i];
      for(std::size_t j = 0; j < 3; ++j)
        result.hessian[i][j] = df * hessian[i][j] + ddf * gradient[i] * gradient[j];
    }
    return result;
  }
};

using Number = Second_order_number;

inline Number operator+(const Number& a, const Number& b)
{
  Number result(a.value + b.value);
  result.gradient = a.gradient + b.gradient;
  for(std::size_t i = 0; i < 3; ++i)
    result.hessian[i] = a.hessian[i] + b.hessian[i];
  return result;
}

inline Number operator*(const Number& a, const Number& b)
{
  Number result(a.value * b.value);
  result.gradient = b.value * a.gradient + a.value * b.gradient;
  for(std::size_t i = 0; i < 3; ++i)
    result.hessian[i] = b.value * a.hessian[i] + a.value * b.hessian[i] + a.gradient[i] * b.gradient +
                        b.gradient[i] * a.gradient;
  return result;
}

inline Number operator-(const Number& a)
{
  return a * Number(-1.);
}
inline Number operator-(const Number& a, const Number& b)
{
  return a + -b;
}
inline Number sin(const Number& a)
{
  return a.composed(std::sin(a.value), std::cos(a.value), -std::sin(a.value));
}
inline Number cos(const Number& a)
{
  return a.composed(std::cos(a.value), -std::sin(a.value), -std::cos(a.value));
}
inline Number exp(const Number& a)
{
  const double e = std::exp(a.value);
  return a.composed(e, e, e);
}
inline Number sqrt(const Number& a)
{
  const double r = std::sqrt(a.value);
  return a.composed(r, .5 / r, -.25 / (r * a.value));
}
inline Number inverse(const Number& a)
{
  const double r = 1. / a.value;
  return a.composed(r, -r * r, 2. * r * r * r);
}
inline Number square(const Number& a)
{
  return a * a;
}

} // namespace adaptive

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_ADAPTIVE_SECOND_ORDER_NUMBER_H
