#ifndef SHAPE_CHARACTERISTICS_CURVATURE_HILDEBRANDT_POLTHIER_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_HILDEBRANDT_POLTHIER_CURVATURES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/internal/Faces_in_ball.h>
#include <Shape_characteristics/curvature/internal/Triangle_shape_operator.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace Shape_characteristics {
namespace internal {

class Hildebrandt_polthier_estimator
{
  using Index = Faces_in_ball::Index;
  using Vector = Eigen::Vector3d;

public:
  using Workspace = Faces_in_ball::Workspace;

  Hildebrandt_polthier_estimator(const Face_graph_samples& samples, const Neighborhood& neighborhood)
    : m_samples(samples),
      m_neighborhood(neighborhood)
  {
    require_triangles(samples, "hildebrandt_polthier_curvatures");
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
    Sum sum;
    for(const Index f : ball.faces())
    {
      const Vector doubled_area = ball.doubled_area(f);
      const double doubled = doubled_area.norm();
      if(!(doubled > 0.))
        continue;
      const Vector normal = doubled_area / doubled;
      const auto [a, b, c] = ball.corners(f);
      add_face({vertex(ball.point(a)), vertex(ball.point(b)), vertex(ball.point(c))}, normal, frame, sum);
      for(const Faces_in_ball::Edge& e : ball.edges(f))
        if(e.other == Faces_in_ball::no_face)
          add_border(vertex(ball.point(e.p)), vertex(ball.point(e.q)), normal, e.is_forward ? 1. : -1., frame,
                     sum);
    }
    if(!(sum.weight > 0.))
      return Curvature_estimate(Estimation_status::DEGENERATE);
    const double factor = side / sum.weight / radius;
    return Curvature_estimate(status, eigen_of_shape_operator(frame.normal, factor * sum.l, factor * sum.m,
                                                              factor * sum.n, frame.t1, frame.t2));
  }

private:
  // a point, and the value there of the function that falls from 1 in the middle to 0 on the sphere
  struct Vertex
  {
    Vector point;
    double value;
  };

  struct Sum
  {
    double l = 0., m = 0., n = 0.; // of the symmetric part, in the tangent plane
    double weight = 0.;            // the integral of the function
  };

  static Vertex vertex(const Vector& p) { return {p, 1. - p.norm()}; }
  static bool is_inside(const Vertex& v) { return v.value > 0.; }

  // where the segment between a vertex inside of the ball and one that isn't meets the sphere
  static Vertex cut(const Vertex& inside, const Vertex& outside)
  {
    const Vector d = outside.point - inside.point;
    const double a = d.squaredNorm(), b = inside.point.dot(d), c = inside.point.squaredNorm() - 1.;
    const double root = std::sqrt((std::max)(b * b - a * c, 0.));
    const double t = b > 0. ? -c / (b + root) : (root - b) / a; // c <= 0
    return {inside.point + (std::min)(t, 1.) * d, 0.};
  }

  static void
  add_face(const std::array<Vertex, 3>& corners, const Vector& normal, const Tangent_frame& frame, Sum& sum)
  {
    std::size_t number = 0;
    for(const Vertex& v : corners)
      number += is_inside(v);
    if(number == 3)
      add_triangle(corners[0], corners[1], corners[2], normal, frame, sum);
    if(number == 0 || number == 3)
      return;
    std::size_t odd = 0; // the only one inside, or outside
    while(is_inside(corners[odd]) != (number == 1))
      ++odd;
    const Vertex &a = corners[odd], &b = corners[(odd + 1) % 3], &c = corners[(odd + 2) % 3];
    if(number == 1)
    {
      add_triangle(a, cut(a, b), cut(a, c), normal, frame, sum);
      return;
    }
    // along both diagonals, each for one half: on which one is split would depend on the axes of coordinates
    const Vertex of_b = cut(b, a), of_c = cut(c, a);
    add_triangle(b, c, of_c, normal, frame, sum, .5);
    add_triangle(b, of_c, of_b, normal, frame, sum, .5);
    add_triangle(c, of_b, b, normal, frame, sum, .5);
    add_triangle(c, of_c, of_b, normal, frame, sum, .5);
  }

  // minus the integral of <normal, s> <gradient, t>, for tangents s and t
  static void add_triangle(const Vertex& a,
                           const Vertex& b,
                           const Vertex& c,
                           const Vector& normal,
                           const Tangent_frame& frame,
                           Sum& sum,
                           double share = 1.)
  {
    // Times the area, the gradient is half of the values times the opposite sides, turned inwards. The order of the corners
    // may be either.
    const Vector cross = (b.point - a.point).cross(c.point - a.point);
    const double orientation = cross.dot(normal) < 0. ? -1. : 1.;
    const Vector turned =
        a.value * (c.point - b.point) + b.value * (a.point - c.point) + c.value * (b.point - a.point);
    add(normal, orientation * normal.cross(turned), -.5 * share, frame, sum);
    sum.weight += share * .5 * cross.norm() * (a.value + b.value + c.value) / 3.;
  }

  // What an integration by parts leaves at the border of the mesh: the integral over it of the function times
  // <normal, s> <conormal, t>
  static void
  add_border(Vertex p, Vertex q, const Vector& normal, double direction, const Tangent_frame& frame, Sum& sum)
  {
    if(!is_inside(p) && !is_inside(q))
      return;
    if(!is_inside(p))
      p = cut(q, p);
    else if(!is_inside(q))
      q = cut(p, q);
    add(normal, direction * (q.point - p.point).cross(normal), .5 * (p.value + q.value), frame, sum);
  }

  static void add(const Vector& s, const Vector& t, double factor, const Tangent_frame& frame, Sum& sum)
  {
    const double s_1 = s.dot(frame.t1), s_2 = s.dot(frame.t2), t_1 = t.dot(frame.t1), t_2 = t.dot(frame.t2);
    sum.l += factor * s_1 * t_1;
    sum.m += .5 * factor * (s_1 * t_2 + s_2 * t_1);
    sum.n += factor * s_2 * t_2;
  }

  const Face_graph_samples& m_samples;
  Neighborhood m_neighborhood;
};

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at the vertices of a triangle mesh by a generalized shape operator \cgalCite{hildebrandt_polthier}
  (thesis, section 5.3.2).

  With a function \f$ \varphi \f$ that falls from 1 at the vertex to 0 on the sphere around it, and with the normal \f$ N \f$, an
  integration by parts turns the shape operator \f$ S \f$, extended to space, into an integral that a mesh has, too:

  \f[ \frac{1}{\int \varphi} \int \varphi \, (S - (\kappa_1 + \kappa_2) N N^T) = - \frac{1}{\int \varphi} \int N \, (\nabla \varphi)^T. \f]

  Its eigenvalues are the principal curvatures and, in the direction of the normal, minus their sum. On the mesh,
  \f$ \varphi \f$ is one minus the distance from the vertex over the radius of the ball at the vertices, and linear on triangles;
  a triangle that is partly outside is split where its sides meet the sphere (thesis, figure 5.2; a quadrilateral that
  remains is split along both diagonals, and each way counts for one half). The estimates are
  eigenvalues and eigenvectors of the symmetric part in the tangent plane of the vertex. At a border, the integral over
  it that the integration by parts leaves is added; the paper is about closed surfaces.

  What counts is the part of the mesh around the vertex: triangles at vertices that are reached by edges inside of the ball, and
  at their neighbors. Another sheet that passes through the ball doesn't count.

  Of the normals nothing is used but the tangent plane and the side: positions alone determine the curvatures. They are means
  over the ball, which must be small compared to the details. The theory promises convergence if the ball shrinks with the
  square root of the edge length: the error of a torus then falls linearly. With a ball of two edges it fell with the square
  of the edge length, on a moderately irregular mesh, too.

  By default, the radius is in proportion to the triangles at the vertex. Where these differ much from vertex to vertex, while the
  shape doesn't, as on meshes of marching cubes, one `neighbor_radius` for all vertices is better.

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

  \cgalExample{curvature/hildebrandt_polthier_curvatures.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
std::size_t hildebrandt_polthier_curvatures(const FaceGraph& mesh,
                                            const NamedParameters& np = parameters::default_values())
{
  return internal::estimate_from_ball<ConcurrencyTag, internal::Hildebrandt_polthier_estimator>(mesh, np);
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at one vertex of a triangle mesh: those that `hildebrandt_polthier_curvatures()` of the whole
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
Estimation_status hildebrandt_polthier_curvatures(typename internal::Vertex_descriptor<FaceGraph>::type v,
                                                  const FaceGraph& mesh,
                                                  const NamedParameters& np = parameters::default_values())
{
  return internal::estimate_from_ball<internal::Hildebrandt_polthier_estimator>(v, mesh, np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_HILDEBRANDT_POLTHIER_CURVATURES_H
