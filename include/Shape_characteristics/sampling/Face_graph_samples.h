#ifndef SHAPE_CHARACTERISTICS_SAMPLING_FACE_GRAPH_SAMPLES_H
#define SHAPE_CHARACTERISTICS_SAMPLING_FACE_GRAPH_SAMPLES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/internal/large_pages.h>
#include <Shape_characteristics/internal/lexicographically_smaller.h>
#include <Shape_characteristics/internal/scale_to_range.h>
#include <Shape_characteristics/sampling/Neighborhood.h>
#include <Shape_characteristics/sampling/for_each_sample.h>
#include <Shape_characteristics/sampling/internal/make_unit.h>
#include <Shape_characteristics/sampling/internal/mean_of.h>
#include <Shape_characteristics/sampling/internal/neighbor_order.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
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
  using Index = std::uint32_t; ///< number of a vertex, of a face, or of a corner of one

  /// what is known beside the points, 28 bytes a vertex for the neighbors, 52 for the faces
  enum class Connectivity : unsigned char
  {
    NEIGHBORS, ///< neighbors alone; `number_of_faces()` is 0
    FACES,     ///< faces alone; `neighbors()` is found by way of them, at twice the cost, and so are spacings
    NEIGHBORS_AND_FACES ///< both
  };

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
    \tparam ConcurrencyTag `CGAL::Sequential_tag` (default), `CGAL::Parallel_tag`, or `CGAL::Parallel_if_available_tag`: in
            parallel, one thread reads the faces of the mesh while another one reads its vertices and their points
    \param mesh the mesh
    \param vpm its points
    \param neighborhood what the neighbors of a vertex are: `Neighborhood::rings()` or `Neighborhood::ball()`
    \param connectivity what is to be known beside the points
    \throws std::length_error if there are more than \f$ 2^{32} - 2 \f$ vertices or corners of faces; of faces that aren't triangles,
            half as many corners
    \throws std::invalid_argument if the neighborhood is one of point sets

    Complexity: linear in the size of the mesh.
  */
  template <typename FaceGraph, typename VertexPointMap, typename ConcurrencyTag = CGAL::Sequential_tag>
  Face_graph_samples(const FaceGraph& mesh,
                     const VertexPointMap& vpm,
                     const Neighborhood& neighborhood,
                     Connectivity connectivity = Connectivity::NEIGHBORS_AND_FACES,
                     ConcurrencyTag = ConcurrencyTag())
    : m_neighborhood(neighborhood)
  {
    check_neighborhood();
    if constexpr(CGAL::graph_has_property<FaceGraph, boost::vertex_index_t>::value)
    {
      // The mesh's own numbers, where they are in order: they cost nothing.
      const auto index_map = get(boost::vertex_index, mesh);
      std::size_t i = 0;
      bool is_in_order = true;
      for(const auto v : vertices(mesh))
        is_in_order = is_in_order && std::size_t(get(index_map, v)) == i++;
      if(is_in_order)
      {
        copy_mesh<ConcurrencyTag>(
            mesh, vpm, [&](const auto v) { return Index(get(index_map, v)); }, connectivity);
        return;
      }
    }
    auto index_map = get(CGAL::dynamic_vertex_property_t<Index>(), mesh);
    Index i = 0;
    for(const auto v : vertices(mesh))
      put(index_map, v, i++);
    copy_mesh<ConcurrencyTag>(
        mesh, vpm, [&](const auto v) { return get(index_map, v); }, connectivity);
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

    \throws std::invalid_argument as for the whole mesh
    \throws std::length_error as for the whole mesh

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
      const double radius = reach * m_neighborhood.reach(), scale = internal::scale_to_range(radius);
      for(; begin != copied.size(); ++begin)
        if((scale * (m_points[begin] - m_points[0])).norm() <= scale * radius)
          copy_neighbors(copied[begin]);
    }
    // All the faces of all of them, whole: the neighbors of the inner vertices have their normals. Those who look at
    // the faces in a ball also see the vertices of the faces at neighbors.
    for(int layer = m_neighborhood.kind() == Neighborhood::Kind::BALL ? 0 : 1; layer < 2; ++layer)
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
    m_status.assign(size(), Estimation_status::ESTIMATED);
    for(const vertex_descriptor v : copied)
    {
      const auto start = halfedge(v, mesh);
      if(start == Graph_traits::null_halfedge())
        continue;
      for(const auto h : CGAL::halfedges_around_target(start, mesh))
      {
        if(CGAL::is_border_edge(h, mesh))
          m_status[index_of.at(v)] = Estimation_status::BORDER;
        if(!CGAL::is_border(h, mesh) && owns_face(mesh, h, index_of))
          add_face(mesh, face(h, mesh), index);
      }
    }
    reorder_all_faces<CGAL::Sequential_tag>();
    find_incidence<CGAL::Sequential_tag>(true);
    find_adjacency<CGAL::Sequential_tag>();
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
    returns the neighbors of vertex `i`, without `i` itself, the nearest first; those that are equally far, to
    seven digits, in the lexicographic order of their points, to six digits. Vertices whose points or normals are
    not finite are left out.

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
    std::vector<double> lengths;
    for_each_edge(i,
                  [&](const Index j)
                  {
                    if(const double length = (m_points[j] - m_points[i]).norm(); std::isfinite(length))
                      lengths.push_back(length);
                  });
    return internal::mean_of(lengths);
  }

  /// mean length of all edges with finite ends (0 if there is none)
  ///
  /// Complexity: \f$ O(n \log n) \f$: they are added up in the order of their lengths, whatever the order of the vertices.
  double mean_spacing() const
  {
    std::vector<double> lengths;
    lengths.reserve(m_adjacency.size() / 2);
    for(std::size_t i = 0; i < size(); ++i)
      for_each_edge(i,
                    [&](const Index j)
                    {
                      if(j > i)
                        if(const double length = (m_points[j] - m_points[i]).norm(); std::isfinite(length))
                          lengths.push_back(length);
                    });
    return internal::mean_of(lengths);
  }

  /// what the neighbors are
  const Neighborhood& neighborhood() const noexcept { return m_neighborhood; }

  /*!
    returns all vertices in an order in which neighbors are mostly close to each other: each block of `patch_size` in a
    row is a compact patch. Only the edges and the order of the vertices determine it, so it doesn't change
    when the mesh is moved or scaled.

    Complexity: linear in the size of the mesh.
  */
  std::vector<Index> traversal_order(std::size_t patch_size = 2000) const
  {
    std::vector<Index> order, patch;
    order.reserve(size());
    Traversal traversal(*this, patch_size);
    while(order.size() < size())
    {
      traversal.next(patch);
      order.insert(order.end(), patch.begin(), patch.end());
    }
    return order;
  }

  /// the patches of `traversal_order()`, one after the other
  class Traversal
  {
  public:
    /// begins a traversal of `samples`, which must outlive it
    Traversal(const Face_graph_samples& samples, std::size_t patch_size);

    /// replaces `patch` by the next `patch_size` vertices, or by what is left.
    void next(std::vector<Index>& patch);

  private:
    static constexpr Index s_not_reached = 0, s_placed = (std::numeric_limits<Index>::max)();

    void reach(Index i);
    Index next_start();

    const Face_graph_samples* m_samples;
    std::size_t m_patch_size;
    Index m_patch = 0;
    std::size_t m_left = 0;               // of the vertices that faces refer to; the others come last
    std::size_t m_unreferenced = 0;       // where to look for the next one of the others
    std::vector<Index> m_number_of_patch; // which reached a vertex last
    std::vector<Index> m_reached;         // by the patch at hand
    std::vector<Index> m_front;           // what patches have reached and left over
    std::size_t m_front_begin = 0, m_first = 0;
  };

  /// @}

  /// \name Faces
  /// @{

  /// number of faces
  std::size_t number_of_faces() const noexcept
  {
    return m_face_begin.empty() ? m_face_vertices.size() / 3 : m_face_begin.size() - 1;
  }
  /// number of vertices of face `f`
  std::size_t degree(std::size_t f) const
  {
    return m_face_begin.empty() ? 3 : m_face_begin[f + 1] - m_face_begin[f];
  }
  /// the `k`-th vertex of face `f`, counterclockwise seen from outside
  Index vertex(std::size_t f, std::size_t k) const { return m_face_vertices[first_corner(f) + k]; }
  /// the place of vertex `i` among those of face `f`
  std::size_t corner(std::size_t f, std::size_t i) const
  {
    const Index* const v = m_face_vertices.data() + first_corner(f);
    if(m_face_begin.empty())
      return std::size_t(v[1] == i) +
             2 * std::size_t(v[2] == i); // no branch that is foreseen once in three times
    return std::size_t(std::find(v, v + degree(f), Index(i)) - v);
  }
  /// whether all faces are triangles
  bool is_triangle_mesh() const noexcept { return m_is_triangle_mesh; }
  /// the faces at vertex `i` as the range `[first, second)`, in an order that the surface alone determines
  std::pair<const Index*, const Index*> incident_faces(std::size_t i) const
  {
    return {m_incidence.data() + m_incidence_begin[i], m_incidence.data() + m_incidence_begin[i + 1]};
  }
  /// gives the memory of the faces back: there are none from now on
  /// \pre the neighbors are known without them
  void forget_faces()
  {
    for(std::vector<Index>* v : {&m_face_begin, &m_face_vertices, &m_incidence_begin, &m_incidence})
      std::vector<Index>().swap(*v);
  }

  /// @}

  /*!
    sets the normals.

    \param normals a normal per vertex, of any length. Those that are of unit length, up to rounding, keep their bits.
    \param failure what becomes of a sample whose normal is zero or not finite, if nothing else was wrong with it. It is
           nobody's neighbor any more.
  */
  void set_normals(std::vector<Eigen::Vector3d> normals,
                   Estimation_status failure = Estimation_status::NON_FINITE_INPUT)
  {
    m_normals = std::move(normals);
    internal::make_unit(m_normals, m_status, failure);
  }

  /*!
    sets the normals of some vertices.

    \param vertices the vertices
    \param normals their normals, as above
    \param failure as above
    \pre `has_normals()`
  */
  void set_normals(const std::vector<Index>& vertices,
                   std::vector<Eigen::Vector3d> normals,
                   Estimation_status failure = Estimation_status::NON_FINITE_INPUT)
  {
    std::vector<Estimation_status> status;
    status.reserve(vertices.size());
    for(const Index i : vertices)
      status.push_back(m_status[i]);
    internal::make_unit(normals, status, failure);
    for(std::size_t k = 0; k < vertices.size(); ++k)
    {
      m_normals[vertices[k]] = normals[k];
      m_status[vertices[k]] = status[k];
    }
  }

  /*!
    moves vertices: afterwards all is as if the mesh had been copied with these points, but for the normals of the vertices
    that are returned, which must be set again.

    \tparam ConcurrencyTag `CGAL::Sequential_tag` (default), `CGAL::Parallel_tag`, or `CGAL::Parallel_if_available_tag`
    \param vertices the vertices, each of them once
    \param points their new points
    \return the vertices of the faces at them, and themselves, in ascending order
    \pre all vertices of a mesh were copied, and the faces are known

    Complexity: linear in the number of faces at the vertices, and a bit for each vertex and face of the mesh.
  */
  template <typename ConcurrencyTag = CGAL::Sequential_tag>
  std::vector<Index> move_points(const std::vector<Index>& vertices,
                                 const std::vector<Eigen::Vector3d>& points)
  {
    for(std::size_t k = 0; k < vertices.size(); ++k)
      m_points[vertices[k]] = points[k];
    std::vector<Index> near;
    if(vertices.size() == size())
    {
      reorder_all_faces<ConcurrencyTag>();
      near.resize(size());
      std::iota(near.begin(), near.end(), Index(0));
    }
    else
      near = reorder_faces_at(vertices);
    for_each_sample<ConcurrencyTag, std::vector<Corner> >(
        near.size(),
        [&](const std::size_t k, std::vector<Corner>& corners)
        {
          const Index i = near[k];
          sort_incidence(i, corners);
          m_status[i] = m_is_border[i] ? Estimation_status::BORDER : Estimation_status::ESTIMATED;
          check_status(i);
        },
        {}, s_block);
    return near;
  }

  /// replaces the point of vertex `i`. Rings stay as they are; balls have other vertices then.
  void set_point(std::size_t i, const Eigen::Vector3d& point) { m_points[i] = point; }

private:
  static constexpr std::size_t s_further_rings = 2; // where the given ones have too few vertices
  static constexpr std::size_t s_block = 1024;      // of vertices that one thread takes
  static constexpr std::array<unsigned char, 4> s_next = {1, 2, 0, 1}; // corners of a triangle

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

  // points, statuses, faces, and what is wanted of the neighbors; `index` numbers the vertices
  template <typename ConcurrencyTag, typename FaceGraph, typename VertexPointMap, typename VertexIndex>
  void copy_mesh(const FaceGraph& mesh,
                 const VertexPointMap& vpm,
                 const VertexIndex& index,
                 Connectivity connectivity)
  {
    // Elements of meshes are read one after the other, but those of faces while those of vertices are.
    for_each_sample<ConcurrencyTag, No_workspace>(
        2,
        [&](const std::size_t task, No_workspace&)
        {
          if(task == 0)
            copy_vertices(mesh, vpm, index);
          else
            copy_faces(mesh, index);
        },
        {}, 1);
    const bool faces_are_seen = connectivity != Connectivity::NEIGHBORS;
    if(faces_are_seen)
      reorder_all_faces<ConcurrencyTag>();
    find_incidence<ConcurrencyTag>(faces_are_seen);
    if(connectivity != Connectivity::FACES)
      find_adjacency<ConcurrencyTag>();
    if(!faces_are_seen)
      forget_faces();
  }

  template <typename FaceGraph, typename VertexPointMap, typename VertexIndex>
  void copy_vertices(const FaceGraph& mesh, const VertexPointMap& vpm, const VertexIndex& index)
  {
    internal::reserve_large_pages(m_points, num_vertices(mesh));
    for(const auto v : vertices(mesh))
    {
      check_size(m_points.size());
      add_point(get(vpm, v));
    }
    internal::resize_in_large_pages(m_status, size(), Estimation_status::ESTIMATED);
    for(const auto h : halfedges(mesh))
      if(CGAL::is_border(h, mesh))
        m_status[index(target(h, mesh))] = m_status[index(source(h, mesh))] = Estimation_status::BORDER;
    m_is_border.reserve(size());
    for(const Estimation_status status : m_status)
      m_is_border.push_back(status == Estimation_status::BORDER);
  }

  template <typename FaceGraph, typename VertexIndex>
  void copy_faces(const FaceGraph& mesh, const VertexIndex& index)
  {
    internal::reserve_large_pages(m_face_vertices, 3 * num_faces(mesh));
    for(const auto f : faces(mesh))
      add_face(mesh, f, index);
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
    const std::size_t begin = m_face_vertices.size();
    const auto start = halfedge(f, mesh);
    auto h = start;
    do
    {
      m_face_vertices.push_back(index(target(h, mesh)));
      h = next(h, mesh);
    } while(h != start);
    const std::size_t end = m_face_vertices.size();
    check_size(end);
    if(end - begin != 3 && m_face_begin.empty())
    {
      m_is_triangle_mesh = false;
      for(std::size_t k = 0; k <= begin; k += 3)
        m_face_begin.push_back(Index(k));
    }
    if(!m_face_begin.empty())
      m_face_begin.push_back(Index(end));
  }

  std::size_t first_corner(std::size_t f) const { return m_face_begin.empty() ? 3 * f : m_face_begin[f]; }

  // The first vertex of a face doesn't depend on where the mesh starts to count.
  void begin_with_smallest(std::size_t f)
  {
    const auto first = m_face_vertices.begin() + std::ptrdiff_t(first_corner(f));
    const auto last = first + std::ptrdiff_t(degree(f));
    std::rotate(first,
                std::min_element(first, last,
                                 [&](const Index a, const Index b)
                                 { return internal::lexicographically_smaller(m_points[a], m_points[b]); }),
                last);
  }

  template <typename ConcurrencyTag>
  void reorder_all_faces()
  {
    for_each_sample<ConcurrencyTag, No_workspace>(
        number_of_faces(), [&](const std::size_t f, No_workspace&) { begin_with_smallest(f); }, {}, s_block);
  }

  // returns the vertices of the faces at some vertices, and these vertices themselves, in ascending order
  std::vector<Index> reorder_faces_at(const std::vector<Index>& vertices)
  {
    std::vector<bool> is_near(size(), false), is_visited(number_of_faces(), false);
    std::vector<Index> near = vertices;
    for(const Index i : vertices)
      is_near[i] = true;
    for(const Index i : vertices)
      for(std::size_t k = m_incidence_begin[i]; k < m_incidence_begin[i + 1]; ++k)
      {
        const Index f = m_incidence[k];
        if(is_visited[f])
          continue;
        is_visited[f] = true;
        begin_with_smallest(f);
        for(std::size_t c = 0; c < degree(f); ++c)
          if(const Index j = vertex(f, c); !is_near[j])
          {
            is_near[j] = true;
            near.push_back(j);
          }
      }
    std::sort(near.begin(), near.end());
    return near;
  }

  // the faces at the vertices, sorted if anybody is going to see them, and the statuses that follow
  template <typename ConcurrencyTag>
  void find_incidence(bool sorts)
  {
    // While faces are entered, the entry after that of vertex `v` is where its next face comes: in the end, where those of
    // the next vertex begin.
    internal::resize_in_large_pages(m_incidence_begin, size() + 2);
    for(const Index v : m_face_vertices)
      ++m_incidence_begin[v + 2];
    for(std::size_t i = 0; i < size(); ++i)
      m_incidence_begin[i + 2] += m_incidence_begin[i + 1];
    internal::resize_in_large_pages(m_incidence, m_face_vertices.size());
    for(std::size_t f = 0, faces = number_of_faces(); f < faces; ++f)
      for(std::size_t k = first_corner(f), end = k + degree(f); k < end; ++k)
        m_incidence[m_incidence_begin[m_face_vertices[k] + 1]++] = Index(f);
    m_incidence_begin.pop_back();

    for_each_sample<ConcurrencyTag, std::vector<Corner> >(
        size(),
        [&](const std::size_t i, std::vector<Corner>& corners)
        {
          if(sorts)
            sort_incidence(i, corners);
          check_status(i);
        },
        {}, s_block);
  }

  void check_status(std::size_t i)
  {
    if(m_incidence_begin[i] == m_incidence_begin[i + 1])
      m_status[i] = Estimation_status::UNREFERENCED;
    else if(!m_points[i].allFinite())
      m_status[i] = Estimation_status::NON_FINITE_INPUT;
  }

  // A triangle as it is seen from one of its vertices: the other two, by their x coordinates first.
  struct Corner
  {
    std::array<double, 2> x;
    std::array<Index, 2> vertices;
    Index face;
    bool is_forward; // the smaller vertex comes first, counterclockwise
  };

  void sort_incidence(std::size_t i, std::vector<Corner>& corners)
  {
    const auto begin = m_incidence.begin() + std::ptrdiff_t(m_incidence_begin[i]);
    const auto end = m_incidence.begin() + std::ptrdiff_t(m_incidence_begin[i + 1]);
    if(!m_is_triangle_mesh)
    {
      std::sort(begin, end, [&](const Index f, const Index g) { return comes_before(f, g); });
      return;
    }
    corners.clear();
    for(auto f = begin; f != end; ++f)
    {
      const std::size_t k = corner(*f, i);
      Index a = vertex(*f, s_next[k]), b = vertex(*f, s_next[k + 1]);
      // A point that isn't finite is somewhere at the end. Its faces count for nothing.
      const auto x = [&](const Index v)
      { return std::isnan(m_points[v].x()) ? std::numeric_limits<double>::infinity() : m_points[v].x(); };
      const bool is_forward =
          x(a) < x(b) || (x(a) == x(b) && !internal::lexicographically_smaller(m_points[b], m_points[a]));
      if(!is_forward)
        std::swap(a, b);
      corners.push_back({{x(a), x(b)}, {a, b}, *f, is_forward});
    }
    const auto is_before = [&](const Corner& a, const Corner& b)
    {
      if(a.x != b.x)
        return a.x < b.x;
      for(std::size_t k = 0; k < 2; ++k)
      {
        if(a.vertices[k] == b.vertices[k])
          continue;
        const Eigen::Vector3d &p = m_points[a.vertices[k]], &q = m_points[b.vertices[k]];
        if(internal::lexicographically_smaller(p, q))
          return true;
        if(internal::lexicographically_smaller(q, p))
          return false;
      }
      return a.is_forward && !b.is_forward;
    };
    std::sort(corners.begin(), corners.end(), is_before);
    for(std::size_t k = 0; k < corners.size(); ++k)
      begin[std::ptrdiff_t(k)] = corners[k].face;
  }

  // the vertices next to each vertex, in no order to rely on
  template <typename ConcurrencyTag>
  void find_adjacency()
  {
    // Each block of vertices has room for all that it might find.
    const std::size_t number_of_blocks = (size() + s_block - 1) / s_block;
    internal::resize_in_large_pages(m_adjacency_begin, size() + number_of_blocks);
    std::size_t room = 0;
    for(std::size_t b = 0; b < number_of_blocks; ++b)
    {
      const std::size_t first = b * s_block, last = (std::min)(first + s_block, size());
      m_adjacency_begin[place_of_adjacency(first)] = Index(room);
      for(std::size_t i = first; i < last; ++i)
        room += (is_inside_of_triangles(i) ? 1 : 2) * (m_incidence_begin[i + 1] - m_incidence_begin[i]);
      check_size(room);
    }
    internal::resize_in_large_pages(m_adjacency, room);
    for_each_sample<ConcurrencyTag, No_workspace>(
        number_of_blocks,
        [&](const std::size_t b, No_workspace&)
        {
          const std::size_t first = b * s_block, last = (std::min)(first + s_block, size());
          Index* const begin = m_adjacency_begin.data() + place_of_adjacency(first);
          for(std::size_t i = first; i < last; ++i)
            begin[i - first + 1] =
                begin[i - first] + write_adjacent(i, m_adjacency.data() + begin[i - first]);
        },
        {}, 1);
  }

  // Where the neighbors of vertex `i` begin is at this place of `m_adjacency_begin`, and where they end is at the next one: that is
  // where those of the next vertex begin, but at the end of a block.
  static std::size_t place_of_adjacency(std::size_t i) { return i + i / s_block; }

  // the vertices next to vertex `i`, if they are known
  std::pair<const Index*, const Index*> adjacent(std::size_t i) const
  {
    const Index* const begin = m_adjacency_begin.data() + place_of_adjacency(i);
    return {m_adjacency.data() + begin[0], m_adjacency.data() + begin[1]};
  }

  // Inside of a surface of triangles, what comes before the vertex in one of them comes after it in another.
  bool is_inside_of_triangles(std::size_t i) const
  {
    return m_is_triangle_mesh && !m_is_border.empty() && !m_is_border[i];
  }

  // returns how many there are
  Index write_adjacent(std::size_t i, Index* const first) const
  {
    Index* end = first;
    if(is_inside_of_triangles(i))
      for_each_incident_face(i, [&](const Index f, const std::size_t c) { *end++ = vertex(f, s_next[c]); });
    else
      for_each_vertex_next_to(i, [&](const Index j) { *end++ = j; });
    return Index(remove_duplicates(first, end) - first);
  }

  // returns the new end
  static Index* remove_duplicates(Index* const first, Index* const last)
  {
    constexpr std::ptrdiff_t few = 32;
    if(last - first > few)
    {
      std::sort(first, last);
      return std::unique(first, last);
    }
    Index* end = first;
    for(const Index* k = first; k != last; ++k)
      if(std::find(first, end, *k) == end)
        *end++ = *k;
    return end;
  }

  // `function(f, c)` for each face at vertex `i`, which is its corner `c`
  template <typename Function>
  void for_each_incident_face(std::size_t i, const Function& function) const
  {
    for(std::size_t k = m_incidence_begin[i]; k < m_incidence_begin[i + 1]; ++k)
      function(m_incidence[k], corner(m_incidence[k], i));
  }

  // before and after it in each of its faces: twice, but for those on a border
  template <typename Function>
  void for_each_vertex_next_to(std::size_t i, const Function& function) const
  {
    for_each_incident_face(i,
                           [&](const Index f, const std::size_t c)
                           {
                             const std::size_t n = degree(f);
                             function(vertex(f, c + 1 == n ? 0 : c + 1));
                             function(vertex(f, c == 0 ? n - 1 : c - 1));
                           });
  }

  // may come twice
  template <typename Function>
  void for_each_adjacent(std::size_t i, const Function& function) const
  {
    if(m_adjacency_begin.empty())
      for_each_vertex_next_to(i, function);
    else
      for(auto [j, end] = adjacent(i); j != end; ++j)
        function(*j);
  }

  // once for each vertex at the other end of an edge
  template <typename Function>
  void for_each_edge(std::size_t i, const Function& function) const
  {
    if(!m_adjacency_begin.empty())
    {
      for_each_adjacent(i, function);
      return;
    }
    std::vector<Index> ends;
    for_each_adjacent(i, [&](const Index j) { ends.push_back(j); });
    std::sort(ends.begin(), ends.end());
    std::for_each(ends.begin(), std::unique(ends.begin(), ends.end()), function);
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
      workspace.m_visited.clear();
      internal::resize_in_large_pages(workspace.m_visited, size());
      workspace.m_query = 0;
    }
    workspace.m_visited[i] = ++workspace.m_query;
  }

  template <typename Predicate>
  void add_adjacent(std::size_t i, Workspace& workspace, const Predicate& accept) const
  {
    for_each_adjacent(i,
                      [&](const Index j)
                      {
                        if(workspace.m_visited[j] == workspace.m_query)
                          return;
                        workspace.m_visited[j] = workspace.m_query;
                        if(accept(j))
                          workspace.m_neighbors.push_back(j);
                      });
  }

  // Whether a vertex has been visited can't be foreseen: it is written in any case, and stays if it hasn't been.
  void add_all_adjacent(std::size_t i, Workspace& workspace) const
  {
    if(m_adjacency_begin.empty())
    {
      add_adjacent(i, workspace, [](const Index) { return true; });
      return;
    }
    const auto [first, last] = adjacent(i);
    std::vector<Index>& neighbors = workspace.m_neighbors;
    std::size_t size = neighbors.size();
    neighbors.resize(size + std::size_t(last - first));
    for(const Index* j = first; j != last; ++j)
    {
      neighbors[size] = *j;
      size += workspace.m_visited[*j] != workspace.m_query;
      workspace.m_visited[*j] = workspace.m_query;
    }
    neighbors.resize(size);
  }

  void drop_unusable(std::vector<Index>& neighbors) const
  {
    neighbors.erase(
        std::remove_if(neighbors.begin(), neighbors.end(), [&](const Index j) { return !is_usable(j); }),
        neighbors.end());
  }

  void collect_rings(std::size_t i, std::size_t minimum, Workspace& workspace) const
  {
    begin_query(i, workspace);
    std::vector<Index>& neighbors = workspace.m_neighbors;
    const std::size_t rings = m_neighborhood.count();
    std::size_t begin = 0;
    add_all_adjacent(i, workspace);
    for(std::size_t ring = 1; ring < rings + s_further_rings; ++ring)
    {
      if(ring >= rings && count_usable(neighbors) >= minimum)
        break;
      const std::size_t end = neighbors.size();
      for(; begin != end; ++begin)
        add_all_adjacent(neighbors[begin], workspace);
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
    const double scale = internal::scale_to_range(m_neighborhood.reach());
    const double reach = scale * m_neighborhood.reach();
    const auto in_ball = [&](const Index j)
    { return (scale * (m_points[j] - m_points[i])).squaredNorm() <= reach * reach; };

    begin_query(i, workspace);
    add_adjacent(i, workspace, in_ball);
    for(std::size_t k = 0; k < workspace.m_neighbors.size(); ++k)
      add_adjacent(workspace.m_neighbors[k], workspace, in_ball);
    drop_unusable(workspace.m_neighbors);
  }

  Neighborhood m_neighborhood;
  std::vector<Eigen::Vector3d> m_points, m_normals;
  std::vector<Estimation_status> m_status;
  std::vector<bool> m_is_border;                           // of a whole mesh: by vertex
  std::vector<Index> m_adjacency_begin, m_incidence_begin; // by vertex; the first may be empty
  std::vector<Index> m_adjacency, m_incidence;             // neighbors and faces of the vertices
  std::vector<Index> m_face_begin;                         // empty if all faces are triangles
  std::vector<Index> m_face_vertices;
  bool m_is_triangle_mesh = true;
};

inline Face_graph_samples::Traversal::Traversal(const Face_graph_samples& samples, std::size_t patch_size)
  : m_samples(&samples),
    m_patch_size(patch_size)
{
  internal::resize_in_large_pages(m_number_of_patch, samples.size(), s_not_reached);
  for(std::size_t i = 0; i < samples.size(); ++i)
    if(samples.m_status[i] == Estimation_status::UNREFERENCED)
      m_number_of_patch[i] = s_placed;
    else
      ++m_left;
}

// One breadth-first search over all would give rings, as long as the mesh and a few vertices wide. So each patch is a search of
// its own; it starts at the oldest vertex that those before have reached and left over, and goes on at the next one if it
// is enclosed by them.
inline void Face_graph_samples::Traversal::next(std::vector<Index>& patch)
{
  patch.clear();
  m_reached.clear();
  ++m_patch;
  std::size_t next = 0;
  for(; patch.size() < m_patch_size && m_left > 0; ++next, --m_left)
  {
    if(next == m_reached.size())
      reach(next_start());
    const Index i = m_reached[next];
    patch.push_back(i);
    m_number_of_patch[i] = s_placed;
    const std::size_t before = m_reached.size();
    m_samples->for_each_adjacent(i,
                                 [&](const Index j)
                                 {
                                   if(m_number_of_patch[j] != s_placed && m_number_of_patch[j] != m_patch)
                                     reach(j);
                                 });
    std::sort(m_reached.begin() + std::ptrdiff_t(before), m_reached.end());
  }
  m_front.insert(m_front.end(), m_reached.begin() + std::ptrdiff_t(next), m_reached.end());
  for(; patch.size() < m_patch_size && m_unreferenced < m_samples->size(); ++m_unreferenced)
    if(m_samples->m_status[m_unreferenced] == Estimation_status::UNREFERENCED)
      patch.push_back(Index(m_unreferenced));
}

inline void Face_graph_samples::Traversal::reach(Index i)
{
  m_number_of_patch[i] = m_patch;
  m_reached.push_back(i);
}

inline Face_graph_samples::Index Face_graph_samples::Traversal::next_start()
{
  while(m_front_begin < m_front.size() && m_number_of_patch[m_front[m_front_begin]] == s_placed)
    ++m_front_begin;
  if(m_front_begin < m_front.size())
    return m_front[m_front_begin];
  while(m_number_of_patch[m_first] != s_not_reached)
    ++m_first;
  return Index(m_first);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SAMPLING_FACE_GRAPH_SAMPLES_H
