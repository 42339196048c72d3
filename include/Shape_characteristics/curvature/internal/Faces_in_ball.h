#ifndef SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_FACES_IN_BALL_H
#define SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_FACES_IN_BALL_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/curvature/internal/estimate_curvatures.h>
#include <Shape_characteristics/curvature/internal/write_curvatures.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/internal/length.h>
#include <Shape_characteristics/internal/lexicographically_smaller.h>
#include <Shape_characteristics/internal/scale_to_range.h>
#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// The triangles around a vertex that reach into a ball: those of the vertices that are connected with it by edges inside of
// the ball, and those of their neighbors. The order depends on the points alone, and not on which side the triangles show.
//
// Points are seen from the vertex, in units of the radius.
class Faces_in_ball
{
public:
  using Index = Face_graph_samples::Index;

  class Workspace
  {
    friend class Faces_in_ball;
    std::vector<Index> m_vertices, m_outer, m_faces;
    std::vector<Index> m_visited_vertices, m_visited_faces; // the number of the last query that came by
    std::vector<Index> m_ranks;                             // of the faces, in the order of `m_faces`
    Index m_query = 0;
  };

  // A side of a triangle. `p` comes lexicographically before `q`.
  struct Edge
  {
    Index p, q, opposite; // the third vertex
    Index face, other;    // the face beyond; `no_face` on a border
    bool is_forward;      // the triangle runs from `p` to `q`
  };
  static constexpr Index no_face = (std::numeric_limits<Index>::max)();

  Faces_in_ball(const Face_graph_samples& samples, std::size_t i, double radius, Workspace& workspace)
    : m_samples(samples),
      m_workspace(workspace),
      m_center(samples.point(i)),
      m_radius(radius),
      m_scale(scale_to_range(radius))
  {
    Workspace& w = workspace;
    if(w.m_visited_vertices.size() != samples.size() ||
       w.m_visited_faces.size() != samples.number_of_faces() || w.m_query == no_face)
    {
      w.m_visited_vertices.assign(samples.size(), 0);
      w.m_visited_faces.assign(samples.number_of_faces(), 0);
      w.m_ranks.resize(samples.number_of_faces());
      w.m_query = 0;
    }
    ++w.m_query;
    w.m_vertices.assign(1, Index(i));
    w.m_outer.clear();
    w.m_faces.clear();
    w.m_visited_vertices[i] = w.m_query;
    for(std::size_t k = 0; k < w.m_vertices.size(); ++k)
      add_faces(w.m_vertices[k], true);
    for(std::size_t k = 0, end = w.m_outer.size(); k < end; ++k)
      add_faces(w.m_outer[k], false);
  }

  // those with finite points and normals; they may be without an area
  const std::vector<Index>& faces() const { return m_workspace.m_faces; }
  // vertices in the ball, the one in the middle included, and their neighbors
  std::size_t number_of_vertices() const
  {
    return m_workspace.m_vertices.size() + m_workspace.m_outer.size();
  }

  Eigen::Vector3d point(Index v) const { return (m_samples.point(v) - m_center) / m_radius; }

  // the vertices of a triangle, lexicographically: in an order that doesn't depend on the side it shows
  std::array<Index, 3> corners(Index face) const
  {
    std::array<Index, 3> c = {m_samples.vertex(face, 0), m_samples.vertex(face, 1),
                              m_samples.vertex(face, 2)};
    std::sort(c.begin(), c.end(),
              [&](const Index a, const Index b)
              { return lexicographically_smaller(m_samples.point(a), m_samples.point(b)); });
    return c;
  }

  // twice the area vector of a triangle, on the side from which it is counterclockwise; zero if there is no area, compared
  // to the sides
  Eigen::Vector3d doubled_area(Index face) const
  {
    const std::array<Index, 3> c = corners(face);
    const Eigen::Vector3d p = point(c[0]), a = point(c[1]) - p, b = point(c[2]) - p;
    const Eigen::Vector3d cross = a.cross(b);
    constexpr double rounding = 4. * std::numeric_limits<double>::epsilon();
    if(!(cross.norm() > rounding * (std::max)(a.squaredNorm(), b.squaredNorm())) || !cross.allFinite())
      return Eigen::Vector3d::Zero();
    return runs_forward(face, c[0], c[1]) ? cross : Eigen::Vector3d(-cross);
  }

  // the three sides of a triangle
  std::array<Edge, 3> edges(Index face) const
  {
    const std::array<Index, 3> c = corners(face);
    return {edge(face, c[0], c[1], c[2]), edge(face, c[0], c[2], c[1]), edge(face, c[1], c[2], c[0])};
  }

  // whether the face is one of these
  bool contains(Index face) const { return m_workspace.m_visited_faces[face] == m_workspace.m_query; }

  // whether the face is one of these, and comes after another one
  bool comes_after(Index face, Index other) const
  {
    return m_workspace.m_visited_faces[face] == m_workspace.m_query &&
           m_workspace.m_ranks[face] > m_workspace.m_ranks[other];
  }

  // 1 if the normal of the vertex in the middle looks to the side from which its triangles are counterclockwise, -1 if to the
  // other, 0 if that can't be said
  double side(std::size_t i) const
  {
    double sum = 0., size = 0.;
    const auto [begin, end] = m_samples.incident_faces(i);
    for(const Index* f = begin; f != end; ++f)
      if(m_workspace.m_visited_faces[*f] == m_workspace.m_query && is_usable(*f))
      {
        const Eigen::Vector3d area = doubled_area(*f);
        sum += area.dot(m_samples.normal(i));
        size += area.norm();
      }
    if(!(std::abs(sum) > std::sqrt(std::numeric_limits<double>::epsilon()) * size))
      return 0.;
    return sum > 0. ? 1. : -1.;
  }

private:
  bool is_usable(Index face) const
  {
    return m_samples.is_usable(m_samples.vertex(face, 0)) && m_samples.is_usable(m_samples.vertex(face, 1)) &&
           m_samples.is_usable(m_samples.vertex(face, 2));
  }

  void add_faces(Index v, bool goes_on)
  {
    Workspace& w = m_workspace;
    const auto [begin, end] = m_samples.incident_faces(v);
    for(const Index* f = begin; f != end; ++f)
    {
      if(w.m_visited_faces[*f] == w.m_query || !is_usable(*f))
        continue;
      w.m_visited_faces[*f] = w.m_query;
      w.m_ranks[*f] = Index(w.m_faces.size());
      w.m_faces.push_back(*f);
      if(!goes_on)
        continue;
      for(const Index u : corners(*f))
      {
        if(w.m_visited_vertices[u] == w.m_query)
          continue;
        w.m_visited_vertices[u] = w.m_query;
        const bool is_inside = (m_scale * (m_samples.point(u) - m_center)).norm() <= m_scale * m_radius;
        (is_inside ? w.m_vertices : w.m_outer).push_back(u);
      }
    }
  }

  bool runs_forward(Index face, Index p, Index q) const
  {
    const std::size_t k = m_samples.corner(face, p);
    return m_samples.vertex(face, k == 2 ? 0 : k + 1) == q;
  }

  Edge edge(Index face, Index p, Index q, Index opposite) const
  {
    Edge e{p, q, opposite, face, no_face, runs_forward(face, p, q)};
    const auto [begin, end] = m_samples.incident_faces(p);
    for(const Index* g = begin; g != end && e.other == no_face; ++g)
    {
      const Index a = m_samples.vertex(*g, 0), b = m_samples.vertex(*g, 1), c = m_samples.vertex(*g, 2);
      if(*g != face && (a == q || b == q || c == q) && runs_forward(*g, p, q) != e.is_forward &&
         is_usable(*g))
        e.other = *g;
    }
    return e;
  }

  const Face_graph_samples& m_samples;
  Workspace& m_workspace;
  Eigen::Vector3d m_center;
  double m_radius, m_scale;
};

// The radius of the ball at vertex `i`: that of the neighborhood, or as many times the mean length of the sides of its
// triangles at the vertex as there are rings. 0 or not finite if there is none.
inline double
radius_of_ball(const Face_graph_samples& samples, std::size_t i, const Neighborhood& neighborhood)
{
  if(neighborhood.kind() == Neighborhood::Kind::BALL)
    return neighborhood.radius();
  double sum = 0.;
  std::size_t count = 0;
  const auto [begin, end] = samples.incident_faces(i);
  for(const auto* f = begin; f != end; ++f)
  {
    const std::size_t k = samples.corner(*f, i);
    const std::size_t a = samples.vertex(*f, k == 2 ? 0 : k + 1), b = samples.vertex(*f, k == 0 ? 2 : k - 1);
    if(!samples.is_usable(a) || !samples.is_usable(b))
      continue;
    sum += length(samples.point(a) - samples.point(i)) + length(samples.point(b) - samples.point(i));
    count += 2;
  }
  return count > 0 ? double(neighborhood.count()) * (sum / double(count)) : 0.;
}

// What an estimator that looks at the triangles in a ball says of all vertices of a mesh, and of one. Its constructor takes
// samples and neighborhood.

template <typename ConcurrencyTag, typename Estimator, typename FaceGraph, typename NamedParameters>
std::size_t estimate_from_ball(const FaceGraph& mesh, const NamedParameters& np)
{
  const Neighborhood neighborhood = mesh_neighborhood(np);
  const Face_graph_samples samples = sampled_surface<ConcurrencyTag>(mesh, Neighborhood::rings(1), np,
                                                                     Face_graph_samples::Connectivity::FACES);
  const Estimator estimator(samples, neighborhood);
  return estimate_vertices<ConcurrencyTag>(mesh, samples, estimator, np);
}

template <typename Estimator, typename FaceGraph, typename NamedParameters>
Estimation_status estimate_from_ball(typename Vertex_descriptor<FaceGraph>::type v,
                                     const FaceGraph& mesh,
                                     const NamedParameters& np)
{
  const Neighborhood neighborhood = mesh_neighborhood(np);
  typename Estimator::Workspace workspace;
  const auto estimate = [&](const Face_graph_samples& samples)
  {
    const Estimator estimator(samples, neighborhood);
    return write_to_references(estimator(0, workspace), np);
  };
  if(neighborhood.kind() == Neighborhood::Kind::BALL)
    return estimate(sampled_surface(v, mesh, neighborhood, 1, np));
  const Face_graph_samples nearest = sampled_surface(v, mesh, Neighborhood::rings(1), 1, np);
  const double radius = nearest.is_triangle_mesh() ? radius_of_ball(nearest, 0, neighborhood) : 0.;
  if(!(radius > 0. && std::isfinite(radius)))
    return estimate(nearest);
  return estimate(sampled_surface(v, mesh, Neighborhood::ball(radius), 1, np));
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_FACES_IN_BALL_H
