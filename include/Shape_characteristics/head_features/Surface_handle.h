#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_SURFACE_HANDLE_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_SURFACE_HANDLE_H

#include <CGAL/Kernel_traits.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <CGAL/boost/graph/properties.h>

#include <optional>
#include <utility>
#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsHeadFeatures

  is a set of points of a surface by which it is deformed, with the motion of these points and how far around them it is felt.

  The motion scales by `factor` and turns by `angle` about `center`, then displaces: a point \f$ p \f$ goes to
  \f[ M_1(p) = c + R_\alpha f (p - c) + d, \f]
  and a part \f$ t \in [0, 1] \f$ of the motion, which is what the surroundings of the points get, is
  \f[ M_t(p) = c + R_{t\alpha} (1 + t (f - 1)) (p - c) + t d. \f]
  A handle whose motion is none holds its points where they are, against the handles around it.

  A neighborhood is Gaussian, as in the thesis's chapter 9: at the distance \f$ s \f$ over the surface from a point, the part of the
  motion is \f$ \exp(-s^2 / 2 \sigma^2) \f$ with \f$ \sigma \f$ = `radius`. `deform_by_handles()` says how several go together.

  \tparam FaceGraph a model of `FaceListGraph`
  \tparam GeomTraits a \cgal kernel
*/
template <typename FaceGraph,
          typename GeomTraits = typename CGAL::Kernel_traits<typename boost::property_traits<
              typename boost::property_map<FaceGraph, CGAL::vertex_point_t>::const_type>::value_type>::Kernel>
struct Surface_handle
{
  using Vertex_descriptor = typename boost::graph_traits<FaceGraph>::vertex_descriptor;
  using FT = typename GeomTraits::FT;
  using Point_3 = typename GeomTraits::Point_3;
  using Vector_3 = typename GeomTraits::Vector_3;

  /// a point of the surface
  struct Surface_point
  {
    /// \param vertex see below
    Surface_point(Vertex_descriptor vertex) : vertex(vertex) {}
    /// \param vertex see below
    /// \param position see below
    Surface_point(Vertex_descriptor vertex, const Point_3& position) : vertex(vertex), position(position) {}

    Vertex_descriptor vertex;        ///< the vertex that it is, or the nearest one
    std::optional<Point_3> position; ///< where it is in a face of `vertex`, if it isn't the vertex itself
  };

  std::vector<Surface_point> points; ///< the points of the set, at least one
  double radius = 0.;                ///< \f$ \sigma \f$, the unit being that of the mesh; positive
  Vector_3 displacement = {0, 0, 0}; ///< \f$ d \f$
  Point_3 center = {0, 0, 0};        ///< \f$ c \f$
  double factor = 1.;                ///< \f$ f \f$, positive
  Vector_3 axis = {0, 0, 1};         ///< around which is turned, of any length
  double angle = 0.;                 ///< \f$ \alpha \f$, in radians, counterclockwise seen against `axis`

  /// a handle that displaces its points
  static Surface_handle
  displacing(std::vector<Surface_point> points, double radius, const Vector_3& displacement)
  {
    Surface_handle handle = holding(std::move(points), radius);
    handle.displacement = displacement;
    return handle;
  }

  /// a handle that scales the set of its points about `center`
  static Surface_handle
  scaling(std::vector<Surface_point> points, double radius, const Point_3& center, double factor)
  {
    Surface_handle handle = holding(std::move(points), radius);
    handle.center = center;
    handle.factor = factor;
    return handle;
  }

  /// a handle that turns the set of its points around the line through `center` along `axis`
  static Surface_handle rotating(std::vector<Surface_point> points,
                                 double radius,
                                 const Point_3& center,
                                 const Vector_3& axis,
                                 double angle)
  {
    Surface_handle handle = holding(std::move(points), radius);
    handle.center = center;
    handle.axis = axis;
    handle.angle = angle;
    return handle;
  }

  /// a handle that holds its points where they are
  static Surface_handle holding(std::vector<Surface_point> points, double radius)
  {
    Surface_handle handle;
    handle.points = std::move(points);
    handle.radius = radius;
    return handle;
  }
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_SURFACE_HANDLE_H
