#ifndef SHAPE_CHARACTERISTICS_CURVATURE_NORMAL_CYCLE_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_NORMAL_CYCLE_CURVATURES_H

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
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace Shape_characteristics {
namespace internal {

// the parameters between which the segment from `p` to `p + d` is inside of the ball around the origin with the square `rr`
// of its radius; false if nowhere
template <typename Vector>
bool clip_to_ball(const Vector& p, const Vector& d, double rr, double& begin, double& end)
{
  const double a = d.squaredNorm(), b = p.dot(d), c = p.squaredNorm() - rr;
  const double discriminant = b * b - a * c;
  if(!(discriminant > 0. && a > 0.))
    return false;
  // neither root is the result of a cancellation
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  const double t = q / a, u = q != 0. ? c / q : 0.;
  begin = (std::max)((std::min)(t, u), 0.);
  end = (std::min)((std::max)(t, u), 1.);
  return begin < end;
}

// The signed area between the origin, the segment from `p` to `q`, and the disk around the origin with the square `rr` of
// its radius: what a side of a polygon adds to the area of the polygon inside of the disk. `normal` is that of the plane.
inline double
area_in_disk(const Eigen::Vector3d& p, const Eigen::Vector3d& q, double rr, const Eigen::Vector3d& normal)
{
  const auto sector = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b)
  { return .5 * rr * std::atan2(normal.dot(a.cross(b)), a.dot(b)); };
  const Eigen::Vector3d d = q - p;
  double begin, end;
  if(!clip_to_ball(p, d, rr, begin, end))
    return sector(p, q);
  const Eigen::Vector3d a = p + begin * d, b = end < 1. ? Eigen::Vector3d(p + end * d) : q;
  double area = .5 * normal.dot(a.cross(b));
  if(begin > 0.)
    area += sector(p, a);
  if(end < 1.)
    area += sector(b, q);
  return area;
}

// the area of the triangle inside of the unit ball; `normal` is its unit normal, on either side
inline double area_in_unit_ball(const Eigen::Vector3d& p,
                                const Eigen::Vector3d& q,
                                const Eigen::Vector3d& r,
                                const Eigen::Vector3d& normal)
{
  if(p.squaredNorm() <= 1. && q.squaredNorm() <= 1. && r.squaredNorm() <= 1.)
    return .5 * (q - p).cross(r - p).norm();
  const double height = normal.dot(p), rr = 1. - height * height;
  if(!(rr > 0.))
    return 0.;
  const Eigen::Vector3d center = height * normal, a = p - center, b = q - center, c = r - center;
  return std::abs(area_in_disk(a, b, rr, normal) + area_in_disk(b, c, rr, normal) +
                  area_in_disk(c, a, rr, normal));
}

class Normal_cycle_estimator
{
  using Index = Faces_in_ball::Index;
  using Vector = Eigen::Vector3d;

public:
  using Workspace = Faces_in_ball::Workspace;

  Normal_cycle_estimator(const Face_graph_samples& samples, const Neighborhood& neighborhood)
    : m_samples(samples),
      m_neighborhood(neighborhood)
  {
    require_triangles(samples, "normal_cycle_curvatures");
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
    double t_11 = 0., t_12 = 0., t_22 = 0., area = 0.;
    for(const Index f : ball.faces())
    {
      const Vector doubled_area = ball.doubled_area(f);
      const double doubled = doubled_area.norm();
      if(!(doubled > 0.))
        continue;
      const Vector normal = doubled_area / doubled;
      const auto [a, b, c] = ball.corners(f);
      area += area_in_unit_ball(ball.point(a), ball.point(b), ball.point(c), normal);
      for(const Faces_in_ball::Edge& e : ball.edges(f))
      {
        if(e.other == Faces_in_ball::no_face || !ball.comes_after(e.other, f))
          continue;
        const Vector p = ball.point(e.p), d = ball.point(e.q) - p;
        double begin, end;
        if(!clip_to_ball(p, d, 1., begin, end))
          continue;
        const double length = d.norm();
        const Vector direction = d / length, beyond = ball.doubled_area(e.other);
        if(!(beyond.squaredNorm() > 0.))
          continue;
        // Positive where the normals spread: the triangle that runs along the edge is on its left. (Fused multiplications don't
        // negate a product of vectors that are exchanged.)
        const double sine = direction.dot(doubled_area.cross(beyond)) * (e.is_forward ? 1. : -1.);
        const double angle = std::atan2(sine, doubled_area.dot(beyond));
        const double weight = angle * length * (end - begin);
        const double u = direction.dot(frame.t1), v = direction.dot(frame.t2);
        t_11 += weight * u * u;
        t_12 += weight * u * v;
        t_22 += weight * v * v;
      }
    }
    if(!(area > 0.))
      return Curvature_estimate(Estimation_status::DEGENERATE);
    // An edge is long in the direction in which the surface doesn't bend: the tensor has the directions exchanged.
    const double factor = side / area / radius;
    return Curvature_estimate(status, eigen_of_shape_operator(frame.normal, factor * t_22, -factor * t_12,
                                                              factor * t_11, frame.t1, frame.t2));
  }

private:
  const Face_graph_samples& m_samples;
  Neighborhood m_neighborhood;
};

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at the vertices of a triangle mesh by the normal cycle \cgalCite{normal_cycle} (thesis, section
  5.3.1).

  Within a ball \f$ R \f$ around the vertex, the curvature of the mesh lies in its edges:

  \f[ S = \frac{1}{\lvert R \rvert} \sum_e \beta(e) \, \lvert e \cap R \rvert \, \bar{e} \bar{e}^T, \f]

  where \f$ \lvert R \rvert \f$ is the area of the mesh in the ball, \f$ \beta \f$ is the angle between the normals of the two triangles
  at an edge, positive where it is convex, \f$ \lvert e \cap R \rvert \f$ is the length of the edge in the ball, and \f$ \bar{e} \f$ is its
  unit direction (5.2). Edges and triangles are clipped at the sphere exactly. The principal curvatures are the
  eigenvalues of \f$ S \f$ in the tangent plane, and each belongs to the direction of the other.

  What counts is the part of the mesh around the vertex: triangles at vertices that are reached by edges inside of the ball, and
  at their neighbors. Another sheet that passes through the ball doesn't count.

  Of the normals nothing is used but the tangent plane and the side: positions alone determine the curvatures. It is the mean
  curvature over the ball that is estimated, so the ball must be small compared to the details, and it must hold many edges. With a ball of two edges, the error
  of a torus fell linearly with the edge length, on a moderately irregular mesh, too. On a border, the half of the ball where
  there is a surface counts.

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

  \cgalExample{curvature/normal_cycle_curvatures.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
std::size_t normal_cycle_curvatures(const FaceGraph& mesh,
                                    const NamedParameters& np = parameters::default_values())
{
  return internal::estimate_from_ball<ConcurrencyTag, internal::Normal_cycle_estimator>(mesh, np);
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at one vertex of a triangle mesh: those that `normal_cycle_curvatures()` of the whole mesh gives,
  bit for bit.

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
Estimation_status normal_cycle_curvatures(typename internal::Vertex_descriptor<FaceGraph>::type v,
                                          const FaceGraph& mesh,
                                          const NamedParameters& np = parameters::default_values())
{
  return internal::estimate_from_ball<internal::Normal_cycle_estimator>(v, mesh, np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_NORMAL_CYCLE_CURVATURES_H
