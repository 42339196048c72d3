#ifndef SHAPE_CHARACTERISTICS_INTERNAL_BLENDED_TRIANGLE_H
#define SHAPE_CHARACTERISTICS_INTERNAL_BLENDED_TRIANGLE_H

#include <Shape_characteristics/internal/Cubic_triangle.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <limits>

namespace Shape_characteristics {
namespace internal {

// a number and its derivatives by two variables
template <typename T>
struct Bivariate_jet
{
  T value, u, v, uu, uv, vv;

  friend Bivariate_jet operator+(const Bivariate_jet& a, const Bivariate_jet& b)
  {
    return {a.value + b.value, a.u + b.u, a.v + b.v, a.uu + b.uu, a.uv + b.uv, a.vv + b.vv};
  }
  friend Bivariate_jet operator*(const Bivariate_jet& a, const Bivariate_jet& b)
  {
    return {a.value * b.value,
            a.u * b.value + a.value * b.u,
            a.v * b.value + a.value * b.v,
            a.uu * b.value + T(2) * a.u * b.u + a.value * b.uu,
            a.uv * b.value + a.u * b.v + a.v * b.u + a.value * b.uv,
            a.vv * b.value + T(2) * a.v * b.v + a.value * b.vv};
  }
  friend Bivariate_jet operator/(const Bivariate_jet& a, const Bivariate_jet& b)
  {
    Bivariate_jet q;
    q.value = a.value / b.value;
    q.u = (a.u - q.value * b.u) / b.value;
    q.v = (a.v - q.value * b.v) / b.value;
    q.uu = (a.uu - T(2) * q.u * b.u - q.value * b.uu) / b.value;
    q.uv = (a.uv - q.u * b.v - q.v * b.u - q.value * b.uv) / b.value;
    q.vv = (a.vv - T(2) * q.v * b.v - q.value * b.vv) / b.value;
    return q;
  }
};

// How the middle control point of a cubic triangle is to be moved along one of its edges, so that there the tangent plane is
// the one that it shares with the triangle on the other side: with the sum of the normals of both.
//
// The edge from corner j to corner k is x(t), t in [0, 1], and d(t) is the derivative across it towards the third corner.
// With n = x' x d of this triangle and o = x' x d of the other one (in this one's sense of rotation), the sum is m = n + o.
// The derivative becomes tangential if m . (d + 6 t (1 - t) e) = 0: e = -q m / (6 m . m), where
// q = o . d / (t (1 - t)). Both factors are orthogonal at the ends, so q is a polynomial, of degree 4.
template <typename T>
class Edge_correction
{
public:
  using Vector = Eigen::Matrix<T, 3, 1>;

  struct Jet
  {
    Vector value, first, second;
  };

  Edge_correction() = default;

  // of the edge of `triangle` opposite of its corner i; `other` has this edge opposite of its corner 0, and its corner 1 is this
  // one's corner i + 2
  Edge_correction(const Cubic_triangle<T>& triangle, int i, const Cubic_triangle<T>& other) : m_is_zero(false)
  {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    // control vectors of the derivatives, over 3
    const std::array<Vector, 3> along = {triangle.edge(j, k) - triangle.corner(j),
                                         triangle.edge(k, j) - triangle.edge(j, k),
                                         triangle.corner(k) - triangle.edge(k, j)};
    const std::array<Vector, 3> across = {triangle.edge(j, i) - triangle.corner(j),
                                          triangle.center() - triangle.edge(j, k),
                                          triangle.edge(k, i) - triangle.edge(k, j)};
    // of the other triangle, in the same direction of t
    const std::array<Vector, 3> across_other = {other.edge(2, 0) - other.corner(2),
                                                other.center() - triangle.edge(j, k),
                                                other.edge(1, 0) - triangle.edge(k, j)};
    const std::array<Vector, 5> normal = cross(along, across), normal_other = cross(across_other, along);
    for(int a = 0; a < 5; ++a)
    {
      m_normal[a] = s_binomial_4[a] * (normal[a] + normal_other[a]);
      m_quotient[a] = T(0);
    }
    // a product of Bernstein polynomials of degrees 4 and 2; without the first and the last of degree 6, which are zero
    for(int a = 0; a < 5; ++a)
      for(int b = 0; b < 3; ++b)
        if(a + b > 0 && a + b < 6)
          m_quotient[a + b - 1] += s_binomial_4[a] * s_binomial_2[b] * normal_other[a].dot(across[b]);
  }

  bool is_zero() const { return m_is_zero; }

  // e(t) and its derivatives
  Jet operator()(const T& t) const
  {
    Vector m, m_1, m_2;
    powers(m_normal, t, m, m_1, m_2);
    T q, q_1, q_2;
    powers(m_quotient, t, q, q_1, q_2);
    const T s = m.squaredNorm(), s_1 = T(2) * m.dot(m_1), s_2 = T(2) * (m_1.squaredNorm() + m.dot(m_2));
    if(!(s > T(0))) // neither triangle has an area there
      return {Vector::Zero(), Vector::Zero(), Vector::Zero()};
    // The control vectors are thirds: a factor of 3 of each of d, n and m, which cancels but for one.
    const T g = -q / (T(2) * s);
    const T g_1 = (-q_1 / T(2) - g * s_1) / s;
    const T g_2 = (-q_2 / T(2) - T(2) * g_1 * s_1 - g * s_2) / s;
    return {g * m, g_1 * m + g * m_1, g_2 * m + T(2) * g_1 * m_1 + g * m_2};
  }

  // e(0) and e(1)
  Vector at_first() const { return at(0); }
  Vector at_second() const { return at(4); }

private:
  static constexpr T s_binomial_4[5] = {T(1), T(4), T(6), T(4), T(1)};
  static constexpr T s_binomial_2[3] = {T(1), T(2), T(1)};

  Vector at(int end) const
  {
    const T s = m_normal[end].squaredNorm();
    return s > T(0) ? Vector(-(m_quotient[end] / (T(2) * s)) * m_normal[end]) : Vector(Vector::Zero());
  }

  // control vectors, in Bernstein's basis of degree 4, of the product of two in that of degree 2
  static std::array<Vector, 5> cross(const std::array<Vector, 3>& a, const std::array<Vector, 3>& b)
  {
    return {a[0].cross(b[0]), (a[0].cross(b[1]) + a[1].cross(b[0])) / T(2),
            (a[0].cross(b[2]) + T(4) * a[1].cross(b[1]) + a[2].cross(b[0])) / T(6),
            (a[1].cross(b[2]) + a[2].cross(b[1])) / T(2), a[2].cross(b[2])};
  }

  // the sum of c[k] t^k (1 - t)^(4 - k), and its derivatives
  template <typename Value>
  static void powers(const std::array<Value, 5>& c, const T& t, Value& value, Value& first, Value& second)
  {
    const T s = T(1) - t;
    value = s * s * s * s * c[0] + s * s * s * t * c[1] + s * s * t * t * c[2] + s * t * t * t * c[3] +
            t * t * t * t * c[4];
    first = T(-4) * s * s * s * c[0] + s * s * (s - T(3) * t) * c[1] + T(2) * s * t * (s - t) * c[2] +
            t * t * (T(3) * s - t) * c[3] + T(4) * t * t * t * c[4];
    second = T(12) * s * s * c[0] + T(6) * s * (t - s) * c[1] + T(2) * (s * s - T(4) * s * t + t * t) * c[2] +
             T(6) * t * (s - t) * c[3] + T(12) * t * t * c[4];
  }

  bool m_is_zero = true;
  std::array<Vector, 5> m_normal;
  std::array<T, 5> m_quotient;
};

// A cubic triangle whose middle control point is blended between those that its edges ask for: with the weights of the edges
// c_j c_k / (c_0 c_1 + c_1 c_2 + c_2 c_0), which are 1 on an edge and 0 on the other two.
template <typename T>
class Blended_triangle
{
public:
  using Vector = Eigen::Matrix<T, 3, 1>;
  using Corners = std::array<Vector, 3>;

  Blended_triangle() = default;
  explicit Blended_triangle(const Cubic_triangle<T>& triangle) : m_triangle(triangle) {}

  // what is on the other side of the edge opposite of corner i
  void set_neighbor(int i, const Cubic_triangle<T>& other)
  {
    m_corrections[i] = Edge_correction<T>(m_triangle, i, other);
  }

  const Cubic_triangle<T>& triangle() const { return m_triangle; }
  const Edge_correction<T>& correction(int i) const { return m_corrections[i]; }

  Patch_jet<T> operator()(const std::array<T, 3>& c) const
  {
    Patch_jet<T> jet = m_triangle(c);
    if(is_corner(c))
    {
      // the second derivatives depend on the direction of approach
      if(!(m_corrections[0].is_zero() && m_corrections[1].is_zero() && m_corrections[2].is_zero()))
        jet.uu = jet.uv = jet.vv = Vector::Constant(std::numeric_limits<T>::quiet_NaN());
      return jet;
    }
    const T zero(0), one(1);
    const std::array<Bivariate_jet<T>, 3> b = {Bivariate_jet<T>{c[0], -one, -one, zero, zero, zero},
                                               Bivariate_jet<T>{c[1], one, zero, zero, zero, zero},
                                               Bivariate_jet<T>{c[2], zero, one, zero, zero, zero}};
    const Bivariate_jet<T> sum = b[0] * b[1] + b[1] * b[2] + b[2] * b[0];
    for(int i = 0; i < 3; ++i)
    {
      if(m_corrections[i].is_zero())
        continue;
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      const Bivariate_jet<T> product = b[j] * b[k];
      const Bivariate_jet<T> w = b[i] * product * product / sum;
      const auto e = m_corrections[i]((one + c[k] - c[j]) / T(2));
      const T t_u = (b[k].u - b[j].u) / T(2), t_v = (b[k].v - b[j].v) / T(2);
      jet.point += T(6) * w.value * e.value;
      jet.u += T(6) * (w.u * e.value + (w.value * t_u) * e.first);
      jet.v += T(6) * (w.v * e.value + (w.value * t_v) * e.first);
      jet.uu += T(6) * (w.uu * e.value + (T(2) * w.u * t_u) * e.first + (w.value * t_u * t_u) * e.second);
      jet.uv +=
          T(6) * (w.uv * e.value + (w.u * t_v + w.v * t_u) * e.first + (w.value * t_u * t_v) * e.second);
      jet.vv += T(6) * (w.vv * e.value + (T(2) * w.v * t_v) * e.first + (w.value * t_v * t_v) * e.second);
    }
    return jet;
  }

private:
  static bool is_corner(const std::array<T, 3>& c)
  {
    return (c[0] == T(0)) + (c[1] == T(0)) + (c[2] == T(0)) == 2;
  }

  Cubic_triangle<T> m_triangle;
  std::array<Edge_correction<T>, 3> m_corrections;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_BLENDED_TRIANGLE_H
