#ifndef SHAPE_CHARACTERISTICS_SAMPLING_FACE_GRAPH_SAMPLES_H
#define SHAPE_CHARACTERISTICS_SAMPLING_FACE_GRAPH_SAMPLES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/internal/length.h>
#include <Shape_characteristics/internal/lexicographically_smaller.h>
#include <Shape_characteristics/sampling/Neighborhood.h>
#include <Shape_characteristics/sampling/internal/mean_of.h>
#include <Shape_characteristics/sampling/internal/neighbor_order.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsSampling

  holds the vertices of a mesh as samples of a surface: points, normals, edges, faces, and the neighbors of
  each vertex within some rings of edges or within a ball.

  All is copied into arrays at construction, in the order of `vertices(mesh)` and `faces(mesh)`: what follows
  doesn't depend on the type of the mesh, needs no lock to run in parallel, and is compiled once.

  A vertex that two fans of faces share at a point (a bow tie) has both of them as its neighborhood.

  \cgalModels{SampledSurface}
*/
class Face_graph_samples
{
public:
  using Index = std::uint32_t; ///< number of a vertex or of a face

  /// scratch memory of `neighbors()`, for one thread at a time
  class Workspace
  {
    friend class Face_graph_samples;
    std::vector<Index> m_neighbors;
    std::vector<Index> m_visited; // by vertex: the number of the last query that came by
    Index m_query = 0;
    internal::Neighbor_order m_order;
  };

  /*!
    copies all the vertices of a mesh.

    \tparam FaceGraph a model of `FaceListGraph`
    \tparam VertexPointMap a model of `ReadablePropertyMap` from vertices to 3D points
    \param mesh the mesh
    \param vpm its points
    \param neighborhood what the neighbors of a vertex are: `Neighborhood::rings()` or `Neighborhood::ball()`
    \throws std::length_error if there are more than \f$ 2^{32} - 2 \f$ vertices or faces

    Complexity: linear in the size of the mesh.
  */
  template <typename FaceGraph, typename VertexPointMap>
  Face_graph_samples(const FaceGraph& mesh, const VertexPointMap& vpm, const Neighborhood& neighborhood)
    : m_neighborhood(neighborhood)
  {
    check_neighborhood();
    auto index_map = get(CGAL::dynamic_vertex_property_t<Index>(), mesh);
    m_points.reserve(num_vertices(mesh));
    for(const auto v : vertices(mesh))
    {
      check_size(m_points.size());
      put(index_map, v, Index(m_points.size()));
      add_point(get(vpm, v));
    }
    const auto index = [&](const auto v) { return get(index_map, v); };
    copy_edges(mesh, edges(mesh), index);
    for(const auto f : faces(mesh))
      add_face(mesh, f, index);
    find_status();
  }

  /*!
    copies a vertex (which becomes sample 0) and its surroundings: all vertices that are reached by going from
    neighbors to neighbors `reach` times. Those that are reached in less than `reach` times have the same
    neighbors, faces and normals as if the whole mesh was copied. Of two fans of faces that share `center` at
    a point alone (a bow tie), only that of `halfedge(center, mesh)` is seen.

    \param center the vertex
    \param mesh the mesh
    \param vpm its points
    \param neighborhood what the neighbors of a vertex are: `Neighborhood::rings()` or `Neighborhood::ball()`
    \param reach see above
    \param[out] copied the vertices of the samples

    Complexity: linear in the number of vertices copied.
  */
  template <typename FaceGraph, typename VertexPointMap>
  Face_graph_samples(typename boost::graph_traits<FaceGraph>::vertex_descriptor center,
                     const FaceGraph& mesh,
                     const VertexPointMap& vpm,
                     const Neighborhood& neighborhood,
                     unsigned int reach,
                     std::vector<typename boost::graph_traits<FaceGraph>::vertex_descriptor>& copied)
    : m_neighborhood(neighborhood)
  {
    using Graph_traits = boost::graph_traits<FaceGraph>;
    using vertex_descriptor = typename Graph_traits::vertex_descriptor;

    check_neighborhood();
    std::unordered_map<vertex_descriptor, Index> index_of;
    copied.clear();
    const auto copy = [&](const vertex_descriptor v)
    {
      if(!index_of.emplace(v, Index(copied.size())).second)
        return;
      check_size(copied.size());
      copied.push_back(v);
      add_point(get(vpm, v));
    };
    const auto copy_neighbors = [&](const vertex_descriptor v)
    {
      const auto h = halfedge(v, mesh);
      if(h != Graph_traits::null_halfedge())
        for(const vertex_descriptor w : CGAL::vertices_around_target(h, mesh))
          copy(w);
    };

    copy(center);
    std::size_t begin = 0;
    if(m_neighborhood.kind() == Neighborhood::Kind::RINGS)
    {
      const std::size_t rings = reach * (m_neighborhood.count() + s_further_rings);
      for(std::size_t ring = 0; ring < rings; ++ring)
        for(const std::size_t end = copied.size(); begin != end; ++begin)
          copy_neighbors(copied[begin]);
    }
    else
    {
      const double radius = reach * m_neighborhood.radius();
      for(; begin != copied.size(); ++begin)
        if((m_points[begin] - m_points[0]).norm() <= radius)
          copy_neighbors(copied[begin]);
    }
    // All the faces of all of them, whole: the neighbors of the inner vertices have their normals.
    for(std::size_t i = 0, end = copied.size(); i != end; ++i)
    {
      copy_neighbors(copied[i]);
      const auto start = halfedge(copied[i], mesh);
      if(start != Graph_traits::null_halfedge())
        for(const auto h : CGAL::halfedges_around_target(start, mesh))
          if(!CGAL::is_border(h, mesh))
            for(const vertex_descriptor w : CGAL::vertices_around_face(h, mesh))
              copy(w);
    }

    const auto index = [&](const vertex_descriptor v) { return index_of.at(v); };
    std::vector<typename Graph_traits::edge_descriptor> copied_edges;
    std::vector<typename Graph_traits::face_descriptor> copied_faces;
    for(const vertex_descriptor v : copied)
    {
      const auto start = halfedge(v, mesh);
      if(start == Graph_traits::null_halfedge())
        continue;
      for(const auto h : CGAL::halfedges_around_target(start, mesh))
      {
        const auto w = index_of.find(source(h, mesh));
        if(w == index_of.end())
          continue;
        if(w->second < index_of.at(v))
          copied_edges.push_back(edge(h, mesh));
        if(!CGAL::is_border(h, mesh) && owns_face(mesh, h, index_of))
          copied_faces.push_back(face(h, mesh));
      }
    }
    copy_edges(mesh, copied_edges, index);
    for(const auto f : copied_faces)
      add_face(mesh, f, index);
    find_status();
  }

  /// \name Samples
  /// @{

  /// number of vertices
  std::size_t size() const noexcept { return m_points.size(); }
  /// the point of vertex `i`
  const Eigen::Vector3d& point(std::size_t i) const { return m_points[i]; }
  /// the unit normal of vertex `i`
  /// \pre `has_normals()`
  const Eigen::Vector3d& normal(std::size_t i) const { return m_normals[i]; }
  /// whether normals were set
  bool has_normals() const noexcept { return !m_normals.empty() || m_points.empty(); }
  /// `ESTIMATED` or `BORDER`, or why nothing can be estimated at vertex `i`
  Estimation_status status(std::size_t i) const { return m_status[i]; }
  /// whether vertex `i` may serve as somebody's neighbor
  bool is_usable(std::size_t i) const { return is_estimated(m_status[i]); }

  /*!
    returns the neighbors of vertex `i`, without `i` itself, the nearest first; equally far ones in the
    lexicographic order of their points. Vertices whose points or normals are not finite are left out.

    If rings give less than `minimum` neighbors (on a border, say), up to two further rings are added. A ball
    isn't enlarged.

    The reference is valid until the next call with the same workspace.
  */
  const std::vector<Index>& neighbors(std::size_t i, std::size_t minimum, Workspace& workspace) const
  {
    if(m_neighborhood.kind() == Neighborhood::Kind::BALL)
      collect_ball(i, workspace);
    else
      collect_rings(i, minimum, workspace);
    workspace.m_order.sort(*this, i, workspace.m_neighbors);
    return workspace.m_neighbors;
  }

  /// mean length of the edges at vertex `i` (0 if there is none)
  double spacing(std::size_t i) const
  {
    double sum = 0.;
    std::size_t count = 0;
    for(std::size_t k = m_adjacency_begin[i]; k < m_adjacency_begin[i + 1]; ++k)
    {
      const double length = (m_points[m_adjacency[k]] - m_points[i]).norm();
      if(std::isfinite(length))
      {
        sum += length;
        ++count;
      }
    }
    return count == 0 ? 0. : sum / double(count);
  }

  /// mean length of all edges with finite ends (0 if there is none)
  double mean_spacing() const noexcept { return m_mean_edge_length; }

  /// what the neighbors are
  const Neighborhood& neighborhood() const noexcept { return m_neighborhood; }

  /// @}

  /// \name Faces
  /// @{

  /// number of faces
  std::size_t number_of_faces() const noexcept { return m_face_begin.size() - 1; }
  /// number of vertices of face `f`
  std::size_t degree(std::size_t f) const { return m_face_begin[f + 1] - m_face_begin[f]; }
  /// the `k`-th vertex of face `f`, counterclockwise seen from outside
  Index vertex(std::size_t f, std::size_t k) const { return m_face_vertices[m_face_begin[f] + k]; }
  /// whether all faces are triangles
  bool is_triangle_mesh() const noexcept { return m_is_triangle_mesh; }
  /// the faces at vertex `i` as the range `[first, second)`, in an order that the surface alone determines
  std::pair<const Index*, const Index*> incident_faces(std::size_t i) const
  {
    return {m_incidence.data() + m_incidence_begin[i], m_incidence.data() + m_incidence_begin[i + 1]};
  }

  /// @}

  /*!
    sets the normals.

    \param normals a normal per vertex, of any length.
    \param failure what becomes of a sample whose normal is zero or not finite, if nothing else was wrong with it. It is
           nobody's neighbor any more.
  */
  void set_normals(std::vector<Eigen::Vector3d> normals,
                   Estimation_status failure = Estimation_status::NON_FINITE_INPUT)
  {
    m_normals = std::move(normals);
    for(std::size_t i = 0; i < size(); ++i)
    {
      const double length = internal::length(m_normals[i]);
      if(length > 0. && std::isfinite(length))
        m_normals[i] = (m_normals[i] / length).normalized();
      else if(is_estimated(m_status[i]))
        m_status[i] = failure;
    }
  }

  /// replaces the point of vertex `i`, which keeps its neighbors
  void set_point(std::size_t i, const Eigen::Vector3d& point) { m_points[i] = point; }

private:
  static constexpr std::size_t s_further_rings = 2; // where the given ones have too few vertices

  static void check_size(std::size_t n)
  {
    if(n >= (std::numeric_limits<Index>::max)() - 1)
      throw std::length_error("Shape_characteristics: the mesh has too many vertices or faces");
  }

  void check_neighborhood() const
  {
    if(m_neighborhood.kind() == Neighborhood::Kind::NEAREST)
      throw std::invalid_argument("Shape_characteristics: number_of_neighbors is for point sets; on a mesh "
                                  "give number_of_rings or neighbor_radius");
  }

  template <typename Point>
  void add_point(const Point& p)
  {
    m_points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }

  template <typename FaceGraph, typename EdgeRange, typename VertexIndex>
  void copy_edges(const FaceGraph& mesh, const EdgeRange& edge_range, const VertexIndex& index)
  {
    m_is_border.assign(size(), false);
    m_adjacency_begin.assign(size() + 1, 0);
    for(const auto e : edge_range)
    {
      const Index a = index(source(e, mesh)), b = index(target(e, mesh));
      ++m_adjacency_begin[a + 1];
      ++m_adjacency_begin[b + 1];
      const auto h = halfedge(e, mesh);
      if(CGAL::is_border(h, mesh) || CGAL::is_border(opposite(h, mesh), mesh))
        m_is_border[a] = m_is_border[b] = true;
    }
    for(std::size_t i = 0; i < size(); ++i)
      m_adjacency_begin[i + 1] += m_adjacency_begin[i];

    m_adjacency.resize(m_adjacency_begin.back());
    std::vector<std::size_t> end(m_adjacency_begin.begin(), m_adjacency_begin.end() - 1);
    for(const auto e : edge_range)
    {
      const Index a = index(source(e, mesh)), b = index(target(e, mesh));
      m_adjacency[end[a]++] = b;
      m_adjacency[end[b]++] = a;
    }
    // sums over the edges of a vertex don't depend on where the mesh starts to count either
    for(std::size_t i = 0; i < size(); ++i)
      std::sort(m_adjacency.begin() + std::ptrdiff_t(m_adjacency_begin[i]),
                m_adjacency.begin() + std::ptrdiff_t(m_adjacency_begin[i + 1]),
                [&](const Index a, const Index b)
                { return internal::lexicographically_smaller(m_points[a], m_points[b]); });
  }

  // whether the halfedge `h` of a copied vertex is the one of its face that lists the face: all the vertices of the
  // face are copied, and its target is the first of them
  template <typename FaceGraph, typename Halfedge, typename Indices>
  static bool owns_face(const FaceGraph& mesh, const Halfedge h, const Indices& index_of)
  {
    const Index mine = index_of.at(target(h, mesh));
    for(const auto v : CGAL::vertices_around_face(h, mesh))
    {
      const auto found = index_of.find(v);
      if(found == index_of.end() || found->second < mine)
        return false;
    }
    return true;
  }

  template <typename FaceGraph, typename Face, typename VertexIndex>
  void add_face(const FaceGraph& mesh, const Face f, const VertexIndex& index)
  {
    check_size(number_of_faces());
    for(const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      m_face_vertices.push_back(index(v));
    m_face_begin.push_back(m_face_vertices.size());
    if(degree(number_of_faces() - 1) != 3)
      m_is_triangle_mesh = false;
    // The first vertex doesn't depend on where the mesh starts to count.
    const auto first = m_face_vertices.end() - std::ptrdiff_t(degree(number_of_faces() - 1));
    std::rotate(first,
                std::min_element(first, m_face_vertices.end(),
                                 [&](const Index a, const Index b)
                                 { return internal::lexicographically_smaller(m_points[a], m_points[b]); }),
                m_face_vertices.end());
  }

  void find_status()
  {
    m_incidence_begin.assign(size() + 1, 0);
    for(const Index v : m_face_vertices)
      ++m_incidence_begin[v + 1];
    for(std::size_t i = 0; i < size(); ++i)
      m_incidence_begin[i + 1] += m_incidence_begin[i];
    m_incidence.resize(m_face_vertices.size());
    std::vector<std::size_t> end(m_incidence_begin.begin(), m_incidence_begin.end() - 1);
    for(std::size_t f = 0; f < number_of_faces(); ++f)
      for(std::size_t k = 0; k < degree(f); ++k)
        m_incidence[end[vertex(f, k)]++] = Index(f);
    for(std::size_t i = 0; i < size(); ++i)
      std::sort(m_incidence.begin() + std::ptrdiff_t(m_incidence_begin[i]),
                m_incidence.begin() + std::ptrdiff_t(m_incidence_begin[i + 1]),
                [&](const Index f, const Index g) { return comes_before(f, g); });

    m_status.assign(size(), Estimation_status::ESTIMATED);
    std::vector<double> lengths;
    for(std::size_t i = 0; i < size(); ++i)
    {
      if(m_incidence_begin[i] == m_incidence_begin[i + 1])
        m_status[i] = Estimation_status::UNREFERENCED;
      else if(!m_points[i].allFinite())
        m_status[i] = Estimation_status::NON_FINITE_INPUT;
      else if(m_is_border[i])
        m_status[i] = Estimation_status::BORDER;

      for(std::size_t k = m_adjacency_begin[i]; k < m_adjacency_begin[i + 1]; ++k)
        if(m_adjacency[k] > i)
        {
          const double length = (m_points[m_adjacency[k]] - m_points[i]).norm();
          if(std::isfinite(length))
            lengths.push_back(length);
        }
    }
    m_mean_edge_length = internal::mean_of(lengths);
  }

  bool comes_before(const Index f, const Index g) const
  {
    // Faces are read from their first vertex towards the smaller of its two neighbors: in the same way whichever side
    // they show, so that sums over flipped faces have the same bits.
    const auto is_read_forward = [&](const Index face)
    {
      return !internal::lexicographically_smaller(m_points[vertex(face, degree(face) - 1)],
                                                  m_points[vertex(face, 1)]);
    };
    const bool f_forward = is_read_forward(f), g_forward = is_read_forward(g);
    const std::size_t n = (std::min)(degree(f), degree(g));
    for(std::size_t k = 0; k < n; ++k)
    {
      const Eigen::Vector3d& p = m_points[vertex(f, f_forward || k == 0 ? k : degree(f) - k)];
      const Eigen::Vector3d& q = m_points[vertex(g, g_forward || k == 0 ? k : degree(g) - k)];
      if(internal::lexicographically_smaller(p, q))
        return true;
      if(internal::lexicographically_smaller(q, p))
        return false;
    }
    return degree(f) != degree(g) ? degree(f) < degree(g) : f_forward && !g_forward;
  }

  void begin_query(std::size_t i, Workspace& workspace) const
  {
    workspace.m_neighbors.clear();
    if(workspace.m_visited.size() != size() || workspace.m_query == (std::numeric_limits<Index>::max)())
    {
      workspace.m_visited.assign(size(), 0);
      workspace.m_query = 0;
    }
    workspace.m_visited[i] = ++workspace.m_query;
  }

  template <typename Predicate>
  void add_adjacent(std::size_t i, Workspace& workspace, const Predicate& accept) const
  {
    for(std::size_t k = m_adjacency_begin[i]; k < m_adjacency_begin[i + 1]; ++k)
    {
      const Index j = m_adjacency[k];
      if(workspace.m_visited[j] == workspace.m_query)
        continue;
      workspace.m_visited[j] = workspace.m_query;
      if(accept(j))
        workspace.m_neighbors.push_back(j);
    }
  }

  void drop_unusable(std::vector<Index>& neighbors) const
  {
    neighbors.erase(
        std::remove_if(neighbors.begin(), neighbors.end(), [&](const Index j) { return !is_usable(j); }),
        neighbors.end());
  }

  void collect_rings(std::size_t i, std::size_t minimum, Workspace& workspace) const
  {
    const auto all = [](const Index) { return true; };

    begin_query(i, workspace);
    std::vector<Index>& neighbors = workspace.m_neighbors;
    const std::size_t rings = m_neighborhood.count();
    std::size_t begin = 0;
    add_adjacent(i, workspace, all);
    for(std::size_t ring = 1; ring < rings + s_further_rings; ++ring)
    {
      if(ring >= rings && count_usable(neighbors) >= minimum)
        break;
      const std::size_t end = neighbors.size();
      for(; begin != end; ++begin)
        add_adjacent(neighbors[begin], workspace, all);
    }
    drop_unusable(neighbors);
  }

  std::size_t count_usable(const std::vector<Index>& neighbors) const
  {
    return std::size_t(
        std::count_if(neighbors.begin(), neighbors.end(), [&](const Index j) { return is_usable(j); }));
  }

  void collect_ball(std::size_t i, Workspace& workspace) const
  {
    const double squared_radius = m_neighborhood.radius() * m_neighborhood.radius();
    const auto in_ball = [&](const Index j)
    { return (m_points[j] - m_points[i]).squaredNorm() <= squared_radius; };

    begin_query(i, workspace);
    add_adjacent(i, workspace, in_ball);
    for(std::size_t k = 0; k < workspace.m_neighbors.size(); ++k)
      add_adjacent(workspace.m_neighbors[k], workspace, in_ball);
    drop_unusable(workspace.m_neighbors);
  }

  Neighborhood m_neighborhood;
  std::vector<Eigen::Vector3d> m_points, m_normals;
  std::vector<Estimation_status> m_status;
  std::vector<bool> m_is_border;
  std::vector<std::size_t> m_adjacency_begin, m_incidence_begin; // by vertex
  std::vector<Index> m_adjacency, m_incidence;                   // neighbors and faces of the vertices
  std::vector<std::size_t> m_face_begin = std::vector<std::size_t>(1, 0);
  std::vector<Index> m_face_vertices;
  bool m_is_triangle_mesh = true;
  double m_mean_edge_length = 0.;
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SAMPLING_FACE_GRAPH_SAMPLES_H
