#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_BASIS_FUNCTION_ON_LANES_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_BASIS_FUNCTION_ON_LANES_H

#include <Shape_characteristics/interpolation/Inverse_multiquadric.h>
#include <Shape_characteristics/interpolation/Matern_9_2.h>
#include <Shape_characteristics/interpolation/internal/Lanes.h>
#include <Shape_characteristics/interpolation/internal/Pair_on_lanes.h>

#include <array>
#include <cstddef>
#include <cstring>

namespace Shape_characteristics {
namespace internal {

/*
  A positive definite basis function and its radial derivatives, divided by -A(0), on lanes, without what the first two are
  at the origin: psi = phi - phi(0) + q / 2, P = A + 1, B, C at q = r^2. They are found without cancellation, so that small
  ones have as many digits as others. `C` is left alone unless `with_third`. `is_near` says that no q is larger than
  `near`, which saves time; `has_more_digits` that all but C are found as Pair_on_lanes, too. Functions with a shape parameter have
  that of 1: the points were scaled instead.

  This one serves any basis function, by its scalar member, from which it has to subtract; those below are those of the
  defaults.
*/
template <typename RadialBasisFunction>
class Basis_function_on_lanes
{
public:
  static constexpr double near = 0.;
  static constexpr bool has_more_digits = false;

  explicit Basis_function_on_lanes(const RadialBasisFunction& phi)
    : m_phi(phi),
      m_factor(-1. / phi.radial_derivatives(0.)[1]),
      m_origin(m_factor * phi.radial_derivatives(0.)[0])
  {}

  // phi(0)
  double at_origin() const { return m_origin; }

  template <bool with_third, typename V>
  [[gnu::always_inline]] void operator()(const V& q, bool, V& psi, V& P, V& B, V& C) const
  {
    constexpr int n = number_of_lanes<V>;
    std::array<double, n> argument, value, first, second, third;
    std::memcpy(argument.data(), &q, sizeof(V));
    for(int lane = 0; lane < n; ++lane)
    {
      const std::array<double, 4> radial = m_phi.radial_derivatives(argument[lane]);
      value[lane] = m_factor * radial[0] - m_origin + 0.5 * argument[lane];
      first[lane] = m_factor * radial[1] + 1.;
      second[lane] = m_factor * radial[2];
      third[lane] = m_factor * radial[3];
    }
    std::memcpy(&psi, value.data(), sizeof(V));
    std::memcpy(&P, first.data(), sizeof(V));
    std::memcpy(&B, second.data(), sizeof(V));
    if constexpr(with_third)
      std::memcpy(&C, third.data(), sizeof(V));
  }

private:
  RadialBasisFunction m_phi;
  double m_factor, m_origin;
};

template <>
class Basis_function_on_lanes<Inverse_multiquadric>
{
public:
  static constexpr double near = 0.;
  static constexpr bool has_more_digits = true;

  explicit Basis_function_on_lanes(const Inverse_multiquadric&) {}

  double at_origin() const { return 1.; }

  template <bool with_third, typename V>
  [[gnu::always_inline]] void operator()(const V& q, bool, V& psi, V& P, V& B, V& C) const
  {
    const V inverse_square = 1. + q;
    V phi;
    inverse_sqrt(inverse_square, phi);
    const V square = phi * phi;
    const V difference = q * square / (1. + phi); // 1 - phi
    psi = 0.5 * (difference * difference) * ((1. + 2. * phi) * inverse_square);
    P = difference * (1. + phi + square);
    B = 3. * (square * square) * phi;
    if constexpr(with_third)
      C = -5. * square * B;
  }

  template <typename V>
  [[gnu::always_inline]] void operator()(const Pair_on_lanes<V>& q,
                                         bool,
                                         Pair_on_lanes<V>& psi,
                                         Pair_on_lanes<V>& P,
                                         Pair_on_lanes<V>& B) const
  {
    // phi = root (1 + r / 2), r = 1 - (1 + q) root^2: r is tiny, and known to half its digits in numbers without more. Powers of phi are so
    // many times r / 2 larger than those of the root; all but that is found while r is.
    V one, three;
    set_lanes(one, 1.);
    set_lanes(three, 3.);
    const V x = 1. + q.high, rest_of_x = (q.high - (x - 1.)) + q.low;
    V root;
    inverse_sqrt(x, root);
    V square, rest_of_square, unity, rest_of_unity, cube, rest_of_cube, thrice, rest_of_thrice, B_high,
        rest_of_B;
    multiply(root, root, square, rest_of_square);
    multiply(x, square, unity, rest_of_unity);
    multiply(square, root, cube, rest_of_cube);
    multiply(square, three, thrice, rest_of_thrice);
    multiply(thrice, cube, B_high, rest_of_B);
    rest_of_thrice = rest_of_thrice + 3. * rest_of_square;
    rest_of_cube = rest_of_cube + rest_of_square * root;
    rest_of_B = rest_of_B + (thrice * rest_of_cube + rest_of_thrice * cube);
    const V r = ((1. - unity) - rest_of_unity) - (x * rest_of_square + rest_of_x * square);

    const V fall = 1. - root;
    psi = difference(V(0.5 * q.high), fall);
    psi.low = psi.low + (0.5 * q.low - ((one - fall) - root)) + (0.5 * root) * r;
    P.high = 1. - cube;
    P.low = ((one - P.high) - cube) - rest_of_cube - (1.5 * cube) * r;
    B.high = B_high;
    B.low = rest_of_B + (2.5 * B_high) * r;
  }
};

template <>
class Basis_function_on_lanes<Matern_9_2>
{
public:
  static constexpr double near = 4.;
  static constexpr bool has_more_digits = true;

  explicit Basis_function_on_lanes(const Matern_9_2&) {}

  double at_origin() const { return 7.; }

  template <bool with_third, typename V>
  [[gnu::always_inline]] void operator()(const V& q, bool is_near, V& psi, V& P, V& B, V& C) const
  {
    const V positive = q + 1e-300; // the root of 0 is 1e-150
    V a;
    inverse_sqrt(positive, a);
    a = positive * a;
    V r, of_phi, of_A, last_of_psi, last_of_P;
    find_remainder_of_exp(a, r);
    find_last_terms(q, a, r, of_phi, of_A, last_of_psi, last_of_P);
    const V qq = q * q, a5 = qq * a;
    V e;
    set_lanes(e, 1. / 40320.);
    e = e * a - 1. / 5040.;
    e = e * a + 1. / 720.;
    e = e * a - 1. / 120.;
    e = e * a + 1. / 24.;
    e = e * a - 1. / 6.;
    e = e * a + 0.5;
    e = e * a - 1.;
    e = e * a + 1.;
    e = e + (a5 * qq) * r;
    psi = qq * ((1. / 40. + q * (-1. / 720. + q * (1. / 5760.))) + a5 * last_of_psi);
    P = q * ((1. / 10. + q * (-1. / 120. + q * (1. / 720.))) + a5 * last_of_P);
    if(!is_near)
    {
      V far;
      exp_of_negative(V(-a), far);
      psi = q > near ? of_phi * far + (0.5 * q - 7.) : psi;
      P = q > near ? 1. - of_A * far : P;
      e = q > near ? far : e;
    }
    B = (1. / 5. + a * (1. / 5. + a * (1. / 15.))) * e;
    if constexpr(with_third)
      C = (-1. / 15. + a * (-1. / 15.)) * e;
  }

  // The first terms of sums have more digits, and so have the others in the sums, for they are small. Not beyond `near`, which is farther
  // than neighborhoods reach.
  template <typename V>
  [[gnu::always_inline]] void operator()(const Pair_on_lanes<V>& squared_distance,
                                         bool is_near,
                                         Pair_on_lanes<V>& psi,
                                         Pair_on_lanes<V>& P,
                                         Pair_on_lanes<V>& B) const
  {
    using Pair = Pair_on_lanes<V>;
    const Pair q = normalized(squared_distance);
    V r, of_phi, of_A, last_of_psi, last_of_P;
    const Pair root = sqrt(q), square = q * q;
    const V a = root.high, qq = square.high, a5 = qq * a;
    find_remainder_of_exp(a, r);
    find_last_terms(q.high, a, r, of_phi, of_A, last_of_psi, last_of_P);
    const V last_of_e =
        a5 * ((-1. / 120. + a * (1. / 720. + a * (-1. / 5040. + a * (1. / 40320.)))) + qq * r);
    constexpr double of_psi[] = {1. / 40., -1. / 720., 1. / 5760.},
                     of_P[] = {1. / 10., -1. / 120., 1. / 720.}, of_e[] = {1., -1., 0.5, -1. / 6., 1. / 24.},
                     of_B[] = {1. / 5., 1. / 15.};
    V fifth;
    set_lanes(fifth, 1. / 5.);
    psi = square * sum_of_ordered(first_terms(q, of_psi), V(a5 * last_of_psi));
    P = q * sum_of_ordered(first_terms(q, of_P), V(a5 * last_of_P));
    B = (first_terms(root, of_B) * root + fifth) * sum_of_ordered(first_terms(root, of_e), last_of_e);
    if(!is_near)
    {
      V far_psi, far_P, far_B, unused;
      operator()<false>(q.high, false, far_psi, far_P, far_B, unused);
      take_beyond_near(q.high, far_psi, psi);
      take_beyond_near(q.high, far_P, P);
      take_beyond_near(q.high, far_B, B);
    }
  }

private:
  // exp(-a) is Taylor's polynomial of degree 8 and a^9 times this, the best polynomial for a <= 2.
  template <typename V>
  [[gnu::always_inline]] static void find_remainder_of_exp(const V& a, V& r)
  {
    set_lanes(r, -4.8010719143213714e-18);
    r = r * a + 1.4150744708157523e-16;
    r = r * a - 2.7739758113497356e-15;
    r = r * a + 4.7734117918313206e-14;
    r = r * a - 7.646526495389217e-13;
    r = r * a + 1.1470702340463107e-11;
    r = r * a - 1.6059041999047809e-10;
    r = r * a + 2.0876756942195778e-09;
    r = r * a - 2.5052108384858402e-08;
    r = r * a + 2.755731922398298e-07;
    r = r * a - 2.755731922398589e-06;
  }

  // psi / q^2 and P / q are polynomials of q, the first terms of Taylor's, plus a^5 times what is found here; besides, what exp(-a) is
  // multiplied by in phi and A.
  template <typename V>
  [[gnu::always_inline]] static void
  find_last_terms(const V& q, const V& a, const V& r, V& of_phi, V& of_A, V& last_of_psi, V& last_of_P)
  {
    of_phi = 7. + a * (7. + a * (3. + a * (2. / 3. + a * (1. / 15.))));
    of_A = 1. + a * (1. + a * (2. / 5. + a * (1. / 15.)));
    last_of_psi = of_phi * r + (-31. / 604800. + a * (1. / 28800. + a * (1. / 302400. + a * (1. / 604800.))));
    last_of_P =
        (-1. / 1575. + a * (1. / 5760. + a * (-23. / 604800. + a * (1. / 302400. + a * (-1. / 604800.))))) -
        q * (of_A * r);
  }

  template <typename V>
  [[gnu::always_inline]] static void take_beyond_near(const V& q, const V& far, Pair_on_lanes<V>& result)
  {
    result.high = q > near ? far : result.high;
    result.low = q > near ? V{} : result.low;
  }

  // each coefficient is larger than what follows
  template <typename V, std::size_t size>
  [[gnu::always_inline]] static Pair_on_lanes<V> first_terms(const Pair_on_lanes<V>& x,
                                                             const double (&coefficients)[size])
  {
    V c;
    set_lanes(c, coefficients[size - 1]);
    Pair_on_lanes<V> sum(c);
    for(std::size_t k = size - 1; k-- > 0;)
    {
      set_lanes(c, coefficients[k]);
      sum = sum_of_ordered(c, sum * x);
    }
    return sum;
  }
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_BASIS_FUNCTION_ON_LANES_H
