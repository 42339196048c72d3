#ifndef SHAPE_CHARACTERISTICS_CURVATURE_INTEGRAL_INVARIANT_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_INTEGRAL_INVARIANT_CURVATURES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/internal/Ball_section.h>
#include <Shape_characteristics/curvature/internal/Faces_in_ball.h>
#include <Shape_characteristics/curvature/internal/Triangle_shape_operator.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

class Integral_invariant_estimator
{
  using Index = Faces_in_ball::Index;
  using Vector = Eigen::Vector3d;

public:
  using Workspace = Faces_in_ball::Workspace;

  Integral_invariant_estimator(const Face_graph_samples& samples, const Neighborhood& neighborhood)
    : m_samples(samples),
      m_neighborhood(neighborhood)
  {
    require_triangles(samples, "integral_invariant_curvatures");
  }

  Curvature_estimate operator()(std::size_t i, Workspace& workspace) const
  {
    const Estimation_status status = m_samples.status(i);
    if(!is_estimated(status))
      return Curvature_estimate(status);
    const double radius = radius_of_ball(m_samples, i, m_neighborhood);
    if(!(radius > 0. && std::isfinite(radius)))
      return Curvature_estimate(Estimation_status::DEGENERATE);
    const Faces_in_ball ball(m_samples, i, radius, workspace);
    if(ball.number_of_vertices() < 4)
      return Curvature_estimate(Estimation_status::FEW_NEIGHBOURS);
    const double side = ball.side(i);
    if(side == 0.)
      return Curvature_estimate(Estimation_status::DEGENERATE);

    const Tangent_frame frame(m_samples.normal(i));
    const Vector outward = side * frame.normal; // of the solid of which the triangles are the surface
    Ball_section section;
    Fan fan;
    for(const Index f : ball.faces())
      add_face(ball, f, Index(i), outward, section, fan);
    if(!close(fan, outward, section))
      return Curvature_estimate(Estimation_status::DEGENERATE);

    const std::array<double, 3> s = surface_of_moments(section.moments(), frame.t1, frame.t2).shape_operator;
    const double factor = side / radius;
    return Curvature_estimate(status, eigen_of_shape_operator(frame.normal, factor * s[0], factor * s[1],
                                                              factor * s[2], frame.t1, frame.t2));
  }

private:
  // the cone of the solid at the vertex: where its border has gaps, there is the border of the mesh
  struct Fan
  {
    double solid_angle = 0.;
    Vector faces = Vector::Zero();                // the sum of unit vectors towards them
    std::vector<std::pair<Vector, double> > gaps; // unit vectors; 1 at the end of a fan, -1 at its beginning
  };

  static void add_face(const Faces_in_ball& ball,
                       Index f,
                       Index center,
                       const Vector& outward,
                       Ball_section& section,
                       Fan& fan)
  {
    const auto [a, b, c] = ball.corners(f);
    const std::array<Vector, 3> corners = {ball.point(a), ball.point(b), ball.point(c)};
    const Vector doubled_area = ball.doubled_area(f);
    const double doubled = doubled_area.norm();
    if(!(doubled > 0.))
      return;
    // counterclockwise seen from the normal, whichever side is outward
    Vector normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const double sign = normal.dot(doubled_area) < 0. ? -1. : 1.;
    normal = sign * doubled_area / doubled;
    const bool is_at_center = a == center || b == center || c == center;
    // from the nearest corner: it is the least inexact
    const auto nearest =
        std::min_element(corners.begin(), corners.end(),
                         [](const Vector& p, const Vector& q) { return p.squaredNorm() < q.squaredNorm(); });
    section.add_face(corners, normal, is_at_center ? 0. : normal.dot(*nearest), sign);

    for(const Faces_in_ball::Edge& e : ball.edges(f))
    {
      const bool is_border = e.other == Faces_in_ball::no_face || !ball.contains(e.other);
      const double direction = e.is_forward ? 1. : -1.;
      if(e.p != center && e.q != center)
      {
        Vector p = ball.point(e.p), q = ball.point(e.q);
        if(is_at_center) // the angle at the vertex
        {
          const Vector d = p.normalized(), g = q.normalized();
          fan.solid_angle += direction * Ball_section::solid_angle(-outward, g, d);
          fan.faces += (d + g).normalized();
        }
        if(is_border && Ball_section::clip(p, q))
          section.add_great_arc(p, q, direction * sign * normal, direction);
      }
      else if(is_border)
      {
        // The face runs into the vertex along the last edge of a fan.
        const bool is_last = (e.q == center) == e.is_forward;
        fan.gaps.emplace_back(ball.point(e.q == center ? e.p : e.q).normalized(), is_last ? 1. : -1.);
      }
    }
  }

  // Adds the cone at the vertex. At a border, the surface goes on in the tangent plane.
  static bool close(Fan& fan, const Vector& outward, Ball_section& section)
  {
    if(!fan.gaps.empty())
    {
      Vector beyond = -(fan.faces - fan.faces.dot(outward) * outward);
      const double length = beyond.norm();
      if(!(length > 1e-9))
        return false;
      beyond /= length;
      for(const auto& [edge, side] : fan.gaps)
      {
        fan.solid_angle += side * Ball_section::solid_angle(-outward, beyond, edge);
        section.add_great_arc(edge, beyond, side * outward, side);
      }
    }
    if(fan.solid_angle < 0.)
      fan.solid_angle += 4. * CGAL_PI;
    section.add_solid_angle(fan.solid_angle);
    return true;
  }

  const Face_graph_samples& m_samples;
  Neighborhood m_neighborhood;
};

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at the vertices of a triangle mesh by integral invariants \cgalCite{pottmann_invariants} (thesis,
  section 5.3.3): how much of a ball around the vertex is inside of the surface, and how that is distributed.

  For a ball of radius \f$ r \f$ around a point of a smooth solid \f$ D \f$, the volume of their intersection and its second moments
  \f$ J \f$ in the tangent plane are

  \f[ V = \frac{2 \pi}{3} r^3 - \frac{\pi}{8} (\kappa_1 + \kappa_2) \, r^4 + O(r^6), \quad
      J_{11} = \frac{2 \pi}{15} r^5 - \frac{\pi}{48} (3 \kappa_1 + \kappa_2) \, r^6 + O(r^8), \f]

  and the same with 1 and 2 exchanged; there are no terms of the powers 5 and 7, because what is odd in the tangent plane
  cancels (the paper gives \f$ O(r^5) \f$ and \f$ O(r^7) \f$). So the principal directions are the eigenvectors of
  \f$ J \f$ in the tangent plane, and its eigenvalues give the curvatures with an error of the order \f$ r^2 \f$. The moments are taken
  with respect to the vertex: then those of half of a ball are equal in all directions, and a normal that is off by a small angle
  \f$ \varepsilon \f$ changes the curvatures by a share of \f$ \varepsilon^2 \f$ only.

  A mesh whose vertices are on a curved surface is everywhere beside it else, and noise moves a vertex out of
  its surroundings. Either way the surface lies at some height over the vertex. The difference of the curvatures is
  taken from \f$ J \f$; their sum, from both \f$ V \f$ and \f$ J \f$, so that the height cancels:
  \f$ \kappa_1 + \kappa_2 = \frac{48}{\pi r^6} (\frac{1}{2} r^2 \Delta V - \Delta J_{11} - \Delta J_{22}) \f$ for the
  differences \f$ \Delta \f$ from half of a ball.

  The moments of the solid that the mesh bounds are exact, but for rounding: triangles are clipped by the ball in closed form,
  arcs and all.

  What counts is the part of the mesh around the vertex: triangles at vertices that are reached by edges inside of the ball, and
  at their neighbors. Another sheet that passes through the ball doesn't count. A mesh that isn't closed bounds no solid; where the
  ball reaches across a border, the surface goes on along rays from the vertex, and, from a vertex on the border, in the tangent plane.
  Across the border, the estimate is smaller in magnitude then: by some percent where the border is three quarters of the
  radius away, by half at the border itself. As everywhere in the library, the status is `BORDER` at vertices on the border.

  Of the normals nothing is used but the tangent plane and the side. The estimates are means over the ball, which must be small
  compared to the details and larger than the edges; a larger one is steadier where there is noise. In contrast to fits and
  derivatives, no quotient of small differences occurs.

  Triangles without an area, or with points or normals that are not finite, count for nothing.

  \scConcurrencyTag
  \tparam FaceGraph a model of `FaceListGraph`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh. All its faces must be triangles.
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scMeshOutputParameters
    \scMeshInputParameters
    \scBallParameters
    \scCallbackParameter
  \cgalNamedParamsEnd

  \return the number of vertices that could not be estimated. Their values are quiet NaN, their status says why.

  \throws std::invalid_argument if a face is not a triangle, or `number_of_rings` or `neighbor_radius` is out of its range

  Complexity: \f$ O(n m) \f$ for \f$ n \f$ vertices with \f$ m \f$ triangles in a ball.

  \cgalExample{curvature/integral_invariant_curvatures.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
std::size_t integral_invariant_curvatures(const FaceGraph& mesh,
                                          const NamedParameters& np = parameters::default_values())
{
  return internal::estimate_from_ball<ConcurrencyTag, internal::Integral_invariant_estimator>(mesh, np);
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at one vertex of a triangle mesh: those that `integral_invariant_curvatures()` of the whole
  mesh gives, bit for bit.

  \param v the vertex
  \param mesh the mesh. Its faces near the vertex must be triangles.
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters": `number_of_rings` and `neighbor_radius`
         as for the whole mesh, and the ones listed below

  \cgalNamedParamsBegin
    \scVertexOutputParameters
    \scMeshInputParameters
  \cgalNamedParamsEnd

  \return whether the curvatures were estimated, or why not

  \throws std::invalid_argument as for the whole mesh, if a face near the vertex is not a triangle

  Complexity: that of the neighborhood, whatever the size of the mesh.
*/
template <typename FaceGraph, typename NamedParameters = parameters::Default_named_parameters>
Estimation_status integral_invariant_curvatures(typename internal::Vertex_descriptor<FaceGraph>::type v,
                                                const FaceGraph& mesh,
                                                const NamedParameters& np = parameters::default_values())
{
  return internal::estimate_from_ball<internal::Integral_invariant_estimator>(v, mesh, np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTEGRAL_INVARIANT_CURVATURES_H
