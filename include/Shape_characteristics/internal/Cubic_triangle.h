#ifndef SHAPE_CHARACTERISTICS_INTERNAL_CUBIC_TRIANGLE_H
#define SHAPE_CHARACTERISTICS_INTERNAL_CUBIC_TRIANGLE_H

#include <Eigen/Core>

#include <array>

namespace Shape_characteristics {
namespace internal {

// a point of a patch and its derivatives by the barycentric coordinates of the corners 1 and 2, at the expense of that of
// corner 0
template <typename T>
struct Patch_jet
{
  using Vector = Eigen::Matrix<T, 3, 1>;
  Vector point, u, v, uu, uv, vv;
};

// The cubic Bezier triangle that follows from the points and unit normals at its corners: a PN triangle (A. Vlachos, J. Peters,
// C. Boyd, J. L. Mitchell, Curved PN Triangles, 2001).
//
// Nothing changes when the normals are negated, not even the last bit.
template <typename T>
class Cubic_triangle
{
public:
  using Vector = Eigen::Matrix<T, 3, 1>;
  using Corners = std::array<Vector, 3>;

  Cubic_triangle() = default;

  Cubic_triangle(const Corners& points, const Corners& normals) : m_corner(points)
  {
    Vector of_edges = Vector::Zero();
    for(int i = 0; i < 3; ++i)
      for(int k = 1; k < 3; ++k)
      {
        // a third of the edge, projected onto the tangent plane
        const int j = (i + k) % 3;
        const Vector edge = points[j] - points[i];
        m_edge[i][j] = points[i] + (edge - edge.dot(normals[i]) * normals[i]) / T(3);
        of_edges += m_edge[i][j];
      }
    const Vector of_corners = points[0] + points[1] + points[2];
    m_center = of_edges / T(4) - of_corners / T(6);
  }

  const Vector& corner(int i) const { return m_corner[i]; }
  // the control point next to corner i on the way to corner j
  const Vector& edge(int i, int j) const { return m_edge[i][j]; }
  const Vector& center() const { return m_center; }

  // at barycentric coordinates that sum to 1
  Patch_jet<T> operator()(const std::array<T, 3>& c) const
  {
    // as a homogeneous polynomial in three variables: its gradient and Hessian matrix
    std::array<Vector, 3> gradient;
    std::array<std::array<Vector, 3>, 3> hessian;
    for(int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      hessian[i][i] = T(6) * (c[i] * m_corner[i] + c[j] * m_edge[i][j] + c[k] * m_edge[i][k]);
      hessian[i][j] = hessian[j][i] = T(6) * (c[i] * m_edge[i][j] + c[j] * m_edge[j][i] + c[k] * m_center);
    }
    Patch_jet<T> jet;
    jet.point = Vector::Zero();
    for(int i = 0; i < 3; ++i)
    {
      gradient[i] = (c[0] * hessian[i][0] + c[1] * hessian[i][1] + c[2] * hessian[i][2]) / T(2); // Euler
      jet.point += c[i] * gradient[i] / T(3);
    }
    jet.u = gradient[1] - gradient[0];
    jet.v = gradient[2] - gradient[0];
    jet.uu = hessian[1][1] - T(2) * hessian[0][1] + hessian[0][0];
    jet.uv = hessian[1][2] - hessian[0][1] - hessian[0][2] + hessian[0][0];
    jet.vv = hessian[2][2] - T(2) * hessian[0][2] + hessian[0][0];
    return jet;
  }

private:
  Corners m_corner;
  std::array<std::array<Vector, 3>, 3> m_edge; // nothing on the diagonal
  Vector m_center;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_CUBIC_TRIANGLE_H
