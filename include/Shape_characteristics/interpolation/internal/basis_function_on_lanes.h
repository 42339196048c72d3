#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_BASIS_FUNCTION_ON_LANES_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_BASIS_FUNCTION_ON_LANES_H

#include <Shape_characteristics/interpolation/Inverse_multiquadric.h>
#include <Shape_characteristics/interpolation/Matern_9_2.h>
#include <Shape_characteristics/interpolation/internal/Lanes.h>

#include <array>
#include <cstring>

namespace Shape_characteristics {
namespace internal {

// The radial derivatives phi, A, B, C of a positive definite basis function, divided by -A(0), on lanes. `C` is left
// alone unless `with_third`. Functions with a shape parameter have that of 1: the points were scaled instead.
//
// This one serves any basis function, by its scalar member; those below are those of the defaults.
template <typename RadialBasisFunction>
class Basis_function_on_lanes
{
public:
  explicit Basis_function_on_lanes(const RadialBasisFunction& phi)
    : m_phi(phi),
      m_factor(-1. / phi.radial_derivatives(0.)[1])
  {}

  template <bool with_third, typename V>
  [[gnu::always_inline]] void operator()(const V& q, V& phi, V& A, V& B, V& C) const
  {
    constexpr int n = number_of_lanes<V>;
    std::array<double, n> argument, value, first, second, third;
    std::memcpy(argument.data(), &q, sizeof(V));
    for(int lane = 0; lane < n; ++lane)
    {
      const std::array<double, 4> radial = m_phi.radial_derivatives(argument[lane]);
      value[lane] = m_factor * radial[0];
      first[lane] = m_factor * radial[1];
      second[lane] = m_factor * radial[2];
      third[lane] = m_factor * radial[3];
    }
    std::memcpy(&phi, value.data(), sizeof(V));
    std::memcpy(&A, first.data(), sizeof(V));
    std::memcpy(&B, second.data(), sizeof(V));
    if constexpr(with_third)
      std::memcpy(&C, third.data(), sizeof(V));
  }

private:
  RadialBasisFunction m_phi;
  double m_factor;
};

template <>
class Basis_function_on_lanes<Inverse_multiquadric>
{
public:
  explicit Basis_function_on_lanes(const Inverse_multiquadric&) {}

  template <bool with_third, typename V>
  [[gnu::always_inline]] void operator()(const V& q, V& phi, V& A, V& B, V& C) const
  {
    inverse_sqrt(V(1. + q), phi);
    const V square = phi * phi;
    A = -(square * phi);
    B = -3. * square * A;
    if constexpr(with_third)
      C = -5. * square * B;
  }
};

template <>
class Basis_function_on_lanes<Matern_9_2>
{
public:
  explicit Basis_function_on_lanes(const Matern_9_2&) {}

  template <bool with_third, typename V>
  [[gnu::always_inline]] void operator()(const V& q, V& phi, V& A, V& B, V& C) const
  {
    const V positive = q + 1e-300; // the root of 0 is 1e-150
    V a, e;
    inverse_sqrt(positive, a);
    a = positive * a;
    exp_of_negative(V(-a), e);
    phi = (7. + a * (7. + a * (3. + a * (2. / 3. + a * (1. / 15.))))) * e;
    A = -(1. + a * (1. + a * (2. / 5. + a * (1. / 15.)))) * e;
    B = (1. / 5. + a * (1. / 5. + a * (1. / 15.))) * e;
    if constexpr(with_third)
      C = (-1. / 15. + a * (-1. / 15.)) * e;
  }
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_BASIS_FUNCTION_ON_LANES_H
