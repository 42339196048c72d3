#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_PNG1_TRIANGLE_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_PNG1_TRIANGLE_H

#include <Shape_characteristics/internal/Blended_triangle.h>
#include <Shape_characteristics/internal/Cubic_triangle.h>
#include <Shape_characteristics/interpolation/Surface_derivatives.h>
#include <Shape_characteristics/interpolation/internal/patch_input.h>

#include <Eigen/Core>

#include <array>
#include <stdexcept>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsInterpolation

  is a PNG1 triangle \cgalCite{png1_triangles} (thesis, section 3.1.1): a PN triangle that is blended with those of the three
  neighboring triangles, such that the surface has a continuous tangent plane across the edges.

  The patch is the `Pn_triangle` with another middle control point,
  \f[ b_{111}(c) = b_{111} + \sum_i \frac{c_j c_k}{c_0 c_1 + c_1 c_2 + c_2 c_0}\, e_i(t_i), \qquad
      t_i = \frac{1 + c_k - c_j}{2}, \f]
  where \f$ j \f$ and \f$ k \f$ are the corners at the edge \f$ i \f$, the one opposite of corner \f$ i \f$. On an edge, its own weight is 1
  and the others are 0. With the edge's curve \f$ x_i(t) \f$, the derivatives across it \f$ d \f$ of the triangle's PN patch
  and \f$ \bar d \f$ of the neighbor's, each towards the third corner, the two patches have the normals \f$ n = x_i' \times d \f$ and
  \f$ \bar n = \bar d \times x_i' \f$. Both are to have the direction of the sum \f$ m = n + \bar n \f$, and so
  \f[ e_i(t) = -\frac{m \cdot d}{6 t (1 - t)\, m \cdot m}\, m. \f]
  At the ends the numerator is zero, since there all patches are tangential to the plane of the corner: \f$ e_i \f$ is a rational function
  without poles, and the tangent planes of neighboring patches are the same all along the edge. Where there is no neighbor,
  \f$ e_i = 0 \f$.

  The thesis and the paper's abstract say which patches are blended, and what for; the blend above is this library's. Its weights
  are those of hybrid cubic patches (T. A. Foley and K. Opitz, Hybrid cubic Bézier triangle patches, 1992).

  Inside and on the edges, first and second derivatives are exact. At a corner the first ones exist, while the second ones depend
  on the direction from which it is approached: they are quiet NaN there. See `boschiroli_curvatures()` for what can be said of the
  curvature at a corner. Parameters are those of `Pn_triangle`. Coordinates must not be negative.

  Where two neighboring patches are folded onto each other, with opposite normals, they have no common tangent plane: there
  points and derivatives may be quiet NaN. Patches without area don't bend others.

  All functions take constant time. Coordinates are converted to `double`.

  \tparam GeomTraits a model of `Kernel`, whose number type must have a quiet NaN

  \cgalExample{interpolation/curved_triangles.cpp}

  \sa `parametric_surface_curvatures()`
*/
template <typename GeomTraits>
class Png1_triangle
{
public:
  using FT = typename GeomTraits::FT;             ///< number type
  using Point_3 = typename GeomTraits::Point_3;   ///< point type
  using Vector_3 = typename GeomTraits::Vector_3; ///< vector type
  using Barycentric = std::array<FT, 3>;          ///< barycentric coordinates, which sum to 1

  /*!
    makes the patch of a triangle without neighbors: a PN triangle.

    \param points the corners
    \param normals the normals there, of any length

    \throws std::invalid_argument if a coordinate is not finite, a normal is zero, or an edge is longer than
    the largest number
  */
  Png1_triangle(const std::array<Point_3, 3>& points, const std::array<Vector_3, 3>& normals)
  {
    for(int i = 0; i < 3; ++i)
    {
      m_points[i] = internal::finite_point("Png1_triangle", points[i]);
      m_normals[i] = internal::unit_normal("Png1_triangle", normals[i]);
    }
    m_frame = internal::Patch_frame("Png1_triangle", m_points);
    for(Eigen::Vector3d& p : m_points)
      p = m_frame.apply(p);
    m_patch = internal::Blended_triangle<double>(internal::Cubic_triangle<double>(m_points, m_normals));
  }

  /*!
    blends the patch with that of a neighboring triangle.

    \param i the edge: the one opposite of corner `i`
    \param point the corner of the neighboring triangle that is not on the edge
    \param normal the normal there, of any length

    \throws std::invalid_argument if `i` is larger than 2, a coordinate is not finite, the normal is zero, or the neighbor is
    \f$ 10^{60} \f$ times as large as the triangle
  */
  void set_neighbor(unsigned int i, const Point_3& point, const Vector_3& normal)
  {
    if(i > 2)
      throw std::invalid_argument("Shape_characteristics: Png1_triangle: an edge has the number 0, 1 or 2");
    const unsigned int j = (i + 1) % 3, k = (i + 2) % 3;
    const Eigen::Vector3d p = m_frame.apply(internal::finite_point("Png1_triangle", point));
    if(!(p.cwiseAbs().maxCoeff() < 1e60)) // of the triangle's size
      throw std::invalid_argument("Shape_characteristics: Png1_triangle: the neighbor is too large");
    const internal::Cubic_triangle<double> other(
        {p, m_points[k], m_points[j]},
        {internal::unit_normal("Png1_triangle", normal), m_normals[k], m_normals[j]});
    m_patch.set_neighbor(int(i), other);
  }

  /// returns the point of the surface at the barycentric coordinates `c`.
  /// \param c the barycentric coordinates, none of them negative
  Point_3 point(const Barycentric& c) const
  {
    return m_frame.point<GeomTraits>(m_patch(internal::barycentric(c)).point);
  }

  /// returns the point of the surface and its derivatives at the barycentric coordinates `c`.
  /// \param c the barycentric coordinates, none of them negative
  Surface_derivatives<GeomTraits> derivatives(const Barycentric& c) const
  {
    return m_frame.derivatives<GeomTraits>(m_patch(internal::barycentric(c)));
  }

private:
  internal::Patch_frame m_frame;
  std::array<Eigen::Vector3d, 3> m_points, m_normals;
  internal::Blended_triangle<double> m_patch;
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_PNG1_TRIANGLE_H
