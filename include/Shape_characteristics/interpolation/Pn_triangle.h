#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_PN_TRIANGLE_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_PN_TRIANGLE_H

#include <Shape_characteristics/internal/Cubic_triangle.h>
#include <Shape_characteristics/interpolation/Surface_derivatives.h>
#include <Shape_characteristics/interpolation/internal/patch_input.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <limits>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsInterpolation

  is a curved PN triangle \cgalCite{pn_triangles}: a cubic Bézier patch (thesis, section 3.1, equations 3.3 to 3.5) that follows
  from the points \f$ P_i \f$ and normals \f$ n_i \f$ at the corners of a triangle.

  \f[ x(c) = \sum_{i+j+k=3} b_{ijk} \frac{3!}{i!\,j!\,k!} c_0^i c_1^j c_2^k \f]

  at barycentric coordinates \f$ c \f$. The control points of the corners are the \f$ P_i \f$. The two on the edge between
  \f$ P_i \f$ and \f$ P_j \f$ are the points at its thirds, projected onto the tangent plane of the nearer corner:
  \f$ \frac13 (2 P_i + P_j - ((P_j - P_i) \cdot n_i) n_i) \f$. The middle one is \f$ b_{111} = E + \frac12 (E - V) \f$ with the means
  \f$ E \f$ of the six on edges and \f$ V \f$ of the three corners.

  An edge's curve depends on its two corners alone, so patches of neighboring triangles join without a gap. At a corner they
  share the tangent plane as well; along an edge they don't, see `Png1_triangle`. The paper's normals for shading are `normal()`:
  they vary quadratically and are continuous, but not the surface's own, which is along \f$ x_u \times x_v \f$.

  Parameters of the derivatives are \f$ u = c_1 \f$ and \f$ v = c_2 \f$, with \f$ c_0 = 1 - u - v \f$: for a triangle whose corners
  are counterclockwise seen from outside, \f$ x_u \times x_v \f$ points outward. Coordinates outside \f$ [0, 1] \f$ extend the
  patch as a polynomial.

  All functions take constant time. Coordinates are converted to `double`.

  \tparam GeomTraits a model of `Kernel`, whose number type must have a quiet NaN

  \cgalExample{interpolation/curved_triangles.cpp}

  \sa `parametric_surface_curvatures()`, `zhihong_curvatures()`
*/
template <typename GeomTraits>
class Pn_triangle
{
public:
  using FT = typename GeomTraits::FT;             ///< number type
  using Point_3 = typename GeomTraits::Point_3;   ///< point type
  using Vector_3 = typename GeomTraits::Vector_3; ///< vector type
  using Barycentric = std::array<FT, 3>;          ///< barycentric coordinates, which sum to 1

  /*!
    \param points the corners
    \param normals the normals there, of any length

    \throws std::invalid_argument if a coordinate is not finite, a normal is zero, or an edge is longer than
    the largest number
  */
  Pn_triangle(const std::array<Point_3, 3>& points, const std::array<Vector_3, 3>& normals)
  {
    std::array<Eigen::Vector3d, 3> p;
    for(int i = 0; i < 3; ++i)
    {
      p[i] = internal::finite_point("Pn_triangle", points[i]);
      m_normals[i] = internal::unit_normal("Pn_triangle", normals[i]);
    }
    m_frame = internal::Patch_frame("Pn_triangle", p);
    for(Eigen::Vector3d& q : p)
      q = m_frame.apply(q);
    m_patch = internal::Cubic_triangle<double>(p, m_normals);
    for(int i = 0; i < 3; ++i)
    {
      // the sum of the normals, mirrored at the plane across the edge
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      const Eigen::Vector3d edge = p[k] - p[j], sum = m_normals[j] + m_normals[k];
      const double square = edge.squaredNorm();
      const Eigen::Vector3d mirrored = square > 0. ? sum - (2. * edge.dot(sum) / square) * edge : sum;
      const double length = mirrored.norm();
      m_edge_normals[i] = length > 0. ? Eigen::Vector3d(mirrored / length) : Eigen::Vector3d::Zero();
    }
  }

  /// returns the control point \f$ b_{ijk} \f$.
  /// \param i,j,k how often the corners 0, 1 and 2 count
  /// \pre `i + j + k == 3`
  Point_3 control_point(unsigned int i, unsigned int j, unsigned int k) const
  {
    const std::array<unsigned int, 3> n = {i, j, k};
    for(int a = 0; a < 3; ++a)
      for(int b = 0; b < 3; ++b)
        if(n[a] == 3)
          return m_frame.point<GeomTraits>(m_patch.corner(a));
        else if(n[a] == 2 && n[b] == 1)
          return m_frame.point<GeomTraits>(m_patch.edge(a, b));
    return m_frame.point<GeomTraits>(m_patch.center());
  }

  /// returns the point of the surface at the barycentric coordinates `c`.
  /// \param c the barycentric coordinates
  Point_3 point(const Barycentric& c) const
  {
    return m_frame.point<GeomTraits>(m_patch(internal::barycentric(c)).point);
  }

  /// returns the point of the surface and its derivatives at the barycentric coordinates `c`.
  /// \param c the barycentric coordinates
  Surface_derivatives<GeomTraits> derivatives(const Barycentric& c) const
  {
    return m_frame.derivatives<GeomTraits>(m_patch(internal::barycentric(c)));
  }

  /// returns the paper's unit normal for shading at the barycentric coordinates `c`, quiet NaN where it is not determined (opposite
  /// normals at corners).
  /// \param c the barycentric coordinates
  Vector_3 normal(const Barycentric& c) const
  {
    const std::array<double, 3> b = internal::barycentric(c);
    Eigen::Vector3d n = Eigen::Vector3d::Zero();
    for(int i = 0; i < 3; ++i)
      n += b[i] * b[i] * m_normals[i] + b[(i + 1) % 3] * b[(i + 2) % 3] * m_edge_normals[i];
    const double length = n.norm();
    n = length > 0. ? Eigen::Vector3d(n / length)
                    : Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    return Vector_3(FT(n.x()), FT(n.y()), FT(n.z()));
  }

private:
  internal::Patch_frame m_frame;
  internal::Cubic_triangle<double> m_patch;
  std::array<Eigen::Vector3d, 3> m_normals, m_edge_normals; // the latter opposite of the corners
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_PN_TRIANGLE_H
