#ifndef SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_CLIPPED_PATCH_H
#define SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_CLIPPED_PATCH_H

#include <Shape_characteristics/sampling/Face_graph_samples.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// The part of a triangle mesh in a ball around a vertex that is connected with the vertex within the ball, and the flux of the
// field (P - X) x n through it, where P is the vertex and n its normal, in units of lengths multiplied by `scale`.
class Clipped_patch
{
public:
  using Index = Face_graph_samples::Index;
  using Vector = Eigen::Vector3d;

  struct Workspace
  {
    std::vector<Index> visited; // by face: the number of the last patch that came by
    std::vector<Index> faces;   // of the patch
    Index query = 0;
  };

  Clipped_patch(const Face_graph_samples& mesh,
                std::size_t vertex,
                double radius,
                double scale,
                Workspace& workspace)
    : m_mesh(mesh),
      m_center(mesh.point(vertex)),
      m_normal(mesh.normal(vertex)),
      m_scale(scale),
      m_squared_radius(scale * radius * (scale * radius)),
      m_faces(workspace.faces)
  {
    begin(workspace);
    const auto [first, last] = mesh.incident_faces(vertex);
    for(const Index* f = first; f != last; ++f)
      add(*f, workspace);
    for(std::size_t k = 0; k < m_faces.size(); ++k)
      for(std::size_t e = 0; e < 3; ++e)
        if(const Part part = part_of_edge(m_faces[k], e); !part.is_empty())
          if(const Index g = opposite(m_faces[k], e); g != s_none)
            add(g, workspace);
  }

  // over the triangles: (10.11), and what the arcs of circles at the rim cut off beside the chords
  double flux_through_triangles() const
  {
    double flux = 0.;
    for(const Index f : m_faces)
    {
      const Outline outline(*this, f);
      for(std::size_t k = 1; k + 1 < outline.size; ++k)
      {
        const Vector &a = outline.points[0], &b = outline.points[k], &c = outline.points[k + 1];
        flux -= .5 * ((a + b + c) / 3.).cross(m_normal).dot((b - a).cross(c - a));
      }
      // The first moment of the area between an arc and its chord d, about the center of the circle, is d x n_f d^2 / 12,
      // be the arc longer or shorter than half the circle.
      for(std::size_t k = 0; k < outline.number_of_arcs; ++k)
      {
        const Vector chord = outline.arcs[k].second - outline.arcs[k].first;
        flux -= chord.squaredNorm() / 12. * m_normal.dot(chord);
      }
    }
    return flux;
  }

  // The field is the curl of -|X - P|^2 n / 2, so all is in that function's integral along the boundary, arcs on the sphere and
  // edges of the border. Of an arc only the ends matter, for there the function is constant.
  double flux_by_boundary() const
  {
    double flux = 0.;
    for(const Index f : m_faces)
    {
      const Outline outline(*this, f);
      for(std::size_t k = 0; k < outline.number_of_arcs; ++k)
        flux -= .5 * m_squared_radius * m_normal.dot(outline.arcs[k].second - outline.arcs[k].first);
      for(std::size_t e = 0; e < 3; ++e)
        if(const Part part = part_of_edge(f, e); !part.is_empty() && opposite(f, e) == s_none)
        {
          const Vector &a = part.begin, &b = part.end;
          flux -= (a.squaredNorm() + a.dot(b) + b.squaredNorm()) / 6. * m_normal.dot(b - a);
        }
    }
    return flux;
  }

private:
  static constexpr Index s_none = (std::numeric_limits<Index>::max)();

  // the part of an edge in the ball; points are relative to its center
  struct Part
  {
    Vector begin, end;
    bool cuts_begin, cuts_end; // whether the edge's own ends are outside
    bool is_empty() const { return cuts_begin && cuts_end && begin == end; }
  };

  // Of a triangle in the ball: the corners, where arcs are replaced by their chords, and the arcs. All counterclockwise.
  struct Outline
  {
    std::array<Vector, 6> points;
    std::size_t size = 0;
    std::array<std::pair<Vector, Vector>, 3> arcs;
    std::size_t number_of_arcs = 0;

    Outline(const Clipped_patch& patch, Index face)
    {
      std::array<Part, 3> parts;
      std::size_t number = 0;
      for(std::size_t e = 0; e < 3; ++e)
        if(const Part part = patch.part_of_edge(face, e); !part.is_empty())
          parts[number++] = part;
      for(std::size_t k = 0; k < number; ++k)
      {
        const Part &part = parts[k], &next = parts[k + 1 < number ? k + 1 : 0];
        points[size++] = part.begin;
        if(!part.cuts_end)
          continue; // it is where the next begins
        points[size++] = part.end;
        arcs[number_of_arcs++] = {part.end, next.begin};
      }
    }
  };

  void begin(Workspace& workspace) const
  {
    workspace.faces.clear();
    if(workspace.visited.size() != m_mesh.number_of_faces() || workspace.query == s_none)
    {
      workspace.visited.assign(m_mesh.number_of_faces(), 0);
      workspace.query = 0;
    }
    ++workspace.query;
  }

  void add(Index face, Workspace& workspace)
  {
    if(workspace.visited[face] == workspace.query)
      return;
    workspace.visited[face] = workspace.query;
    if(is_finite(face))
      m_faces.push_back(face);
  }

  // others are as if they weren't there
  bool is_finite(Index face) const
  {
    for(std::size_t k = 0; k < 3; ++k)
      if(!m_mesh.point(m_mesh.vertex(face, k)).allFinite())
        return false;
    return true;
  }

  // the face on the other side of the edge from corner `e` of a face to the next
  Index opposite(Index face, std::size_t e) const
  {
    const Index a = m_mesh.vertex(face, e), b = m_mesh.vertex(face, (e + 1) % 3);
    const auto [first, last] = m_mesh.incident_faces(a);
    for(const Index* g = first; g != last; ++g)
      if(m_mesh.vertex(*g, (m_mesh.corner(*g, a) + 2) % 3) == b && is_finite(*g))
        return *g;
    return s_none;
  }

  Part part_of_edge(Index face, std::size_t e) const
  {
    const Index i = m_mesh.vertex(face, e), j = m_mesh.vertex(face, (e + 1) % 3);
    if(i > j) // the two triangles at an edge get the same part
    {
      const Part part = part_between(j, i);
      return {part.end, part.begin, part.cuts_end, part.cuts_begin};
    }
    return part_between(i, j);
  }

  Part part_between(Index i, Index j) const
  {
    const Vector a = m_scale * (m_mesh.point(i) - m_center), b = m_scale * (m_mesh.point(j) - m_center);
    const Vector d = b - a;
    const bool cuts_begin = a.squaredNorm() > m_squared_radius, cuts_end = b.squaredNorm() > m_squared_radius;
    if(!cuts_begin && !cuts_end)
      return {a, b, false, false};
    // from the point of the line that is nearest to the center
    const double squared_length = d.squaredNorm();
    const double middle = -a.dot(d) / squared_length;
    const double rest = m_squared_radius - (a + middle * d).squaredNorm();
    const double half = rest > 0. ? std::sqrt(rest / squared_length) : 0.;
    if(cuts_begin && cuts_end && !(half > 0. && middle > 0. && middle < 1.))
      return {a, a, true, true};
    return {cuts_begin ? Vector(a + (middle - half) * d) : a, cuts_end ? Vector(a + (middle + half) * d) : b,
            cuts_begin, cuts_end};
  }

  const Face_graph_samples& m_mesh;
  Vector m_center, m_normal;
  double m_scale, m_squared_radius;
  std::vector<Index>& m_faces;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_CLIPPED_PATCH_H
