#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_DEFORM_SURFACE_DISTANCES_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_DEFORM_SURFACE_DISTANCES_H

#include <Shape_characteristics/internal/length.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// The distances over a surface from a point of it, up to a given one.
//
// Dijkstra's algorithm, but not along the edges alone (whose paths are longer by up to a tenth or more, by how the surface is
// tessellated): from the distances of two corners of a face, the source is unfolded into its plane, and gives the distance of the
// others if the straight way there goes through between the two. That is exact on what can be unfolded altogether, and where the
// way passes no corner of a border. A vertex whose distance becomes shorter later is taken up again, so that obtuse angles do no
// harm; but only so often, since on surfaces that are nowhere smooth (Schwarz's lantern) this wouldn't come to an end soon. No
// distance is shorter than the straight one through space. What isn't connected by faces is not reached.
class Deform_surface_distances
{
public:
  using Index = Face_graph_samples::Index;

  // a vertex that is within reach, and how far it is
  struct Entry
  {
    Index vertex;
    double distance;
  };

  // `surface` with its faces; faces are taken for flat and convex
  explicit Deform_surface_distances(const Face_graph_samples& surface)
    : m_surface(surface),
      m_distances(surface.size(), unreached),
      m_visits(surface.size(), 0)
  {}

  // from `position`, which lies in a face of vertex `nearest` or is it; by the vertices' numbers
  std::vector<Entry> from(Index nearest, const Eigen::Vector3d& position, double reach)
  {
    m_source = position;
    offer(nearest, 0., reach);
    if(m_surface.point(nearest) != position)
    {
      const auto [begin, end] = m_surface.incident_faces(nearest);
      for(const Index* f = begin; f != end; ++f)
        for(std::size_t k = 0; k < m_surface.degree(*f); ++k)
          offer(m_surface.vertex(*f, k), 0., reach);
    }

    while(!m_front.empty())
    {
      const Item item = m_front.top();
      m_front.pop();
      if(item.first > m_distances[item.second]) // reached on a shorter way since
        continue;
      if(m_visits[item.second] == most_visits)
        continue;
      ++m_visits[item.second];
      const auto [begin, end] = m_surface.incident_faces(item.second);
      for(const Index* f = begin; f != end; ++f)
        cross(*f, item.second, reach);
    }

    std::vector<Entry> result;
    result.reserve(m_reached.size());
    std::sort(m_reached.begin(), m_reached.end());
    for(const Index v : m_reached)
    {
      result.push_back({v, m_distances[v]});
      m_distances[v] = unreached;
      m_visits[v] = 0;
    }
    m_reached.clear();
    return result;
  }

private:
  using Item = std::pair<double, Index>;
  static constexpr double unreached = std::numeric_limits<double>::infinity();
  static constexpr double improvement = 1e-12; // relative; without it, rounding could go around in circles
  static constexpr unsigned char most_visits = 16;

  // a way to `v` of some length, or, if it is shorter than possible, the straight one
  void offer(Index v, double distance, double reach)
  {
    double& best = m_distances[v];
    if(!(distance <= reach) || !(distance < best * (1. - improvement)) ||
       !m_surface.is_usable(v)) // NaN as well
      return;
    distance = (std::max)(distance, length((m_surface.point(v) - m_source).eval()));
    if(!(distance <= reach) || !(distance < best * (1. - improvement)))
      return;
    if(best == unreached)
      m_reached.push_back(v);
    best = distance;
    m_front.push({distance, v});
  }

  // brings the distances of the corners of face `f` up to date with that of its corner `v`
  void cross(Index f, Index v, double reach)
  {
    const std::size_t degree = m_surface.degree(f), at = m_surface.corner(f, v);
    const Index neighbors[2] = {m_surface.vertex(f, (at + 1) % degree),
                                m_surface.vertex(f, (at + degree - 1) % degree)};
    for(std::size_t k = 0; k < degree; ++k)
    {
      const Index w = m_surface.vertex(f, k);
      if(w == v || !m_surface.is_usable(w))
        continue;
      offer(w, m_distances[v] + length((m_surface.point(w) - m_surface.point(v)).eval()), reach);
      for(const Index u : neighbors)
        if(u != w && m_distances[u] != unreached)
          offer(w, across(v, u, w), reach);
    }
  }

  // the distance of `c` by way of the inside of the edge from `a` to `b`, NaN if the straight way passes it by
  double across(Index a, Index b, Index c) const
  {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const Eigen::Vector3d edge = m_surface.point(b) - m_surface.point(a),
                          side = m_surface.point(c) - m_surface.point(a);
    const double e = length(edge), p = m_distances[a], q = m_distances[b];
    if(!(e > 0.))
      return none;
    // in the plane of the face: `a` in the origin, `b` on the x-axis, `c` above, the source below it
    const double cx = side.dot(edge) / e, cy = length((side - cx / e * edge).eval());
    const double sx = ((p - q) * (p + q) / e + e) / 2., squared = (p - sx) * (p + sx);
    const double sy = squared > 0. ? std::sqrt(squared) : 0.;
    if(!(cy > 0.) || squared < -1e-9 * (p * p + e * e))
      return none;
    const double crossing = sx + (cx - sx) * sy / (sy + cy);
    return crossing >= 0. && crossing <= e ? std::hypot(cx - sx, cy + sy) : none;
  }

  const Face_graph_samples& m_surface;
  Eigen::Vector3d m_source = Eigen::Vector3d::Zero();
  std::vector<double> m_distances;     // `unreached` between calls
  std::vector<unsigned char> m_visits; // 0 between calls
  std::vector<Index> m_reached;
  std::priority_queue<Item, std::vector<Item>, std::greater<Item>> m_front;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_DEFORM_SURFACE_DISTANCES_H
