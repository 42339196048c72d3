#ifndef SHAPE_CHARACTERISTICS_CURVATURE_DYNAMIC_RUSINKIEWICZ_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_DYNAMIC_RUSINKIEWICZ_CURVATURES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/curvature/internal/write_curvatures.h>
#include <Shape_characteristics/curvature/rusinkiewicz_curvatures.h>
#include <Shape_characteristics/internal/to_eigen.h>
#include <Shape_characteristics/normals/Normal_weighting.h>
#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/normals/vertex_normals.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>
#include <Shape_characteristics/sampling/Neighborhood.h>
#include <Shape_characteristics/sampling/for_each_sample.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures of a triangle mesh whose vertices move, by Rusinkiewicz's method, frame by frame, in parallel
  \cgalCite{griffin} (thesis, section 5.4).

  What depends on the connectivity alone is set up once, at construction. A frame then takes the normals, the areas and
  the shape operators of the triangles at the vertices, each vertex by itself: instead of adding to sums that vertices
  share, as on a GPU, each vertex gathers from its triangles, so that no thread waits for another one. Where only some vertices
  have moved, only those are looked at whose values may change: two rings around them.

  All results have the bits of `rusinkiewicz_curvatures()` of the mesh as it is.

  The mesh must outlive the object. Its faces and edges must not change; after a change, construct anew.

  \tparam FaceGraph a model of `FaceListGraph`
  \tparam NamedParameters the type of the named parameters
  \scConcurrencyTag

  \cgalExample{curvature/dynamic_curvatures.cpp}
*/
template <typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename ConcurrencyTag = CGAL::Parallel_if_available_tag>
class Dynamic_rusinkiewicz_curvatures
{
  using Index = Face_graph_samples::Index;
  using Estimator = internal::Rusinkiewicz_estimator;
  using Workspace = Estimator::Workspace;

  static constexpr bool s_computes_normals =
      parameters::is_default_parameter<NamedParameters, internal_np::vertex_normal_map_t>::value;

public:
  /// a vertex of the mesh
  using vertex_descriptor = typename boost::graph_traits<FaceGraph>::vertex_descriptor;

  /*!
    sets up what depends on the connectivity, and estimates the curvatures at all vertices.

    \param mesh the mesh. All its faces must be triangles.
    \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below. Maps are kept,
           and read from or written to by each update.

    \cgalNamedParamsBegin
      \scMeshOutputParameters
      \scMeshInputParameters
    \cgalNamedParamsEnd

    \throws std::invalid_argument if a face is not a triangle
  */
  explicit Dynamic_rusinkiewicz_curvatures(const FaceGraph& mesh,
                                           const NamedParameters& np = parameters::default_values())
    : m_mesh(mesh),
      m_np(np),
      m_samples(sampled_surface<ConcurrencyTag>(mesh,
                                                Neighborhood::rings(1),
                                                np,
                                                Face_graph_samples::Connectivity::FACES)),
      m_status(m_samples.size(), Estimation_status::CANCELLED),
      m_failures(m_samples.size())
  {
    m_vertices.reserve(m_samples.size());
    m_index_of.reserve(m_samples.size());
    for(const vertex_descriptor v : vertices(mesh))
    {
      m_index_of.emplace(v, Index(m_vertices.size()));
      m_vertices.push_back(v);
    }
    m_is_usable.resize(m_samples.size());
    for(std::size_t i = 0; i < m_samples.size(); ++i)
    {
      m_is_usable[i] = m_samples.is_usable(i);
      const auto [begin, end] = m_samples.incident_faces(i);
      if(end - begin == 1)
        m_ears.push_back(Index(i));
    }
    estimate(all());
  }

  Dynamic_rusinkiewicz_curvatures(const Dynamic_rusinkiewicz_curvatures&) = delete;
  Dynamic_rusinkiewicz_curvatures& operator=(const Dynamic_rusinkiewicz_curvatures&) = delete;

  /*!
    reads all points again (and the normals, where there is a map), and estimates the curvatures at all vertices: a frame.

    \return the number of vertices of the mesh that have no estimate

    Complexity: linear in the size of the mesh.
  */
  std::size_t update() { return move(all()); }

  /*!
    estimates the curvatures where they may have changed because some vertices have.

    \tparam VertexRange a range of `vertex_descriptor`
    \param moved all vertices whose points have changed since the last update, or whose normals have where there is a map of
           them; each may come several times
    \return the number of vertices of the mesh that have no estimate
    \throws std::invalid_argument if one isn't of the mesh

    Complexity: linear in the number of faces at the vertices two rings around them, and a bit for each vertex and face of
    the mesh; where points or normals become finite, or cease to be, all vertices of one face are looked at as well.
  */
  template <typename VertexRange>
  std::size_t update(const VertexRange& moved)
  {
    std::vector<Index> indices;
    for(const vertex_descriptor v : moved)
    {
      const auto found = m_index_of.find(v);
      if(found == m_index_of.end())
        throw std::invalid_argument(
            "Shape_characteristics: Dynamic_rusinkiewicz_curvatures: a vertex is not of the mesh");
      indices.push_back(found->second);
    }
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    return move(indices);
  }

  /// the number of vertices of the mesh that have no estimate
  std::size_t number_of_failures() const noexcept { return m_failures; }

  /// the vertices that the last update, or the constructor, wrote to: in the order of the mesh
  std::vector<vertex_descriptor> updated_vertices() const
  {
    std::vector<vertex_descriptor> result;
    result.reserve(m_updated.size());
    for(const Index i : m_updated)
      result.push_back(m_vertices[i]);
    return result;
  }

private:
  std::vector<Index> all() const
  {
    std::vector<Index> indices(m_samples.size());
    std::iota(indices.begin(), indices.end(), Index(0));
    return indices;
  }

  std::size_t move(const std::vector<Index>& moved)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;

    const auto vpm = choose_parameter(get_parameter(m_np, internal_np::vertex_point),
                                      CGAL::get_const_property_map(CGAL::vertex_point, m_mesh));
    std::vector<Eigen::Vector3d> points;
    points.reserve(moved.size());
    for(const Index i : moved)
      points.push_back(internal::to_eigen(get(vpm, m_vertices[i])));
    const std::vector<Index> near = m_samples.move_points<ConcurrencyTag>(moved, points);
    std::vector<Eigen::Vector3d> normals(near.size());
    if constexpr(s_computes_normals)
    {
      const Normal_weighting weighting =
          choose_parameter(get_parameter(m_np, internal_np::normal_weighting), Normal_weighting::MAX);
      for_each_sample<ConcurrencyTag, No_workspace>(
          near.size(),
          [&](const std::size_t k, No_workspace&)
          { normals[k] = internal::vertex_normal(m_samples, near[k], weighting); },
          {}, s_block);
      m_samples.set_normals(near, std::move(normals), Estimation_status::DEGENERATE);
    }
    else
    {
      const auto normal_map = get_parameter(m_np, internal_np::vertex_normal_map);
      for(std::size_t k = 0; k < near.size(); ++k)
        normals[k] = internal::to_eigen(get(normal_map, m_vertices[near[k]]));
      m_samples.set_normals(near, std::move(normals));
    }
    // a vertex of one face asks for other vertices, in further rings as well, whose points and normals can be used
    bool is_other_usable = false;
    for(const Index i : near)
    {
      is_other_usable = is_other_usable || m_is_usable[i] != m_samples.is_usable(i);
      m_is_usable[i] = m_samples.is_usable(i);
    }
    if(near.size() == m_samples.size())
      return estimate(near);
    std::vector<Index> seen = with_neighbors(near);
    if(is_other_usable)
    {
      std::vector<Index> both;
      std::set_union(seen.begin(), seen.end(), m_ears.begin(), m_ears.end(), std::back_inserter(both));
      seen.swap(both);
    }
    return estimate(std::move(seen));
  }

  // their points, normals and statuses are seen by the vertices of the faces at them
  std::vector<Index> with_neighbors(const std::vector<Index>& vertices) const
  {
    std::vector<bool> is_seen(m_samples.size(), false);
    std::vector<Index> result = vertices;
    for(const Index i : vertices)
      is_seen[i] = true;
    for(const Index i : vertices)
    {
      const auto [begin, end] = m_samples.incident_faces(i);
      for(const Index* f = begin; f != end; ++f)
        for(std::size_t k = 0; k < 3; ++k)
          if(const Index j = m_samples.vertex(*f, k); !is_seen[j])
          {
            is_seen[j] = true;
            result.push_back(j);
          }
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  std::size_t estimate(std::vector<Index> updated)
  {
    m_updated = std::move(updated);
    const Estimator estimator(m_samples, m_np);
    m_estimates.resize(m_updated.size());
    for_each_sample<ConcurrencyTag, Workspace>(
        m_updated.size(),
        [&](const std::size_t k, Workspace& w) { m_estimates[k] = estimator(m_updated[k], w); }, {}, s_block);
    for(std::size_t k = 0; k < m_updated.size(); ++k)
    {
      Estimation_status& status = m_status[m_updated[k]];
      m_failures -= !is_estimated(status);
      m_few -= is_few(status);
      status = m_estimates[k].status;
      m_failures += !is_estimated(status);
      m_few += is_few(status);
      internal::write_to_vertex(m_vertices[m_updated[k]], m_estimates[k], m_np);
    }
    if(m_few > 0)
      mark_duplicates();
    return m_failures;
  }

  static bool is_few(Estimation_status status)
  {
    return status == Estimation_status::FEW_NEIGHBOURS || status == Estimation_status::DUPLICATE;
  }

  // which vertices with too few neighbors are duplicates depends on all points
  void mark_duplicates()
  {
    internal::Duplicates duplicates(m_samples);
    std::vector<Index> changed;
    for(std::size_t i = 0; i < m_samples.size(); ++i)
      if(is_few(m_status[i]))
      {
        internal::Curvature_estimate few(Estimation_status::FEW_NEIGHBOURS);
        duplicates.mark(i, few);
        if(few.status == m_status[i])
          continue;
        m_status[i] = few.status;
        internal::write_to_vertex(m_vertices[i], few, m_np);
        changed.push_back(Index(i));
      }
    std::vector<Index> both;
    std::set_union(m_updated.begin(), m_updated.end(), changed.begin(), changed.end(),
                   std::back_inserter(both));
    m_updated.swap(both);
  }

  static constexpr std::size_t s_block = 1024; // of vertices that one thread takes

  const FaceGraph& m_mesh;
  NamedParameters m_np;
  Face_graph_samples m_samples;
  std::vector<vertex_descriptor> m_vertices;
  std::unordered_map<vertex_descriptor, Index> m_index_of;
  std::vector<bool> m_is_usable; // as neighbors
  std::vector<Index> m_ears;     // vertices of one face
  std::vector<Estimation_status> m_status;
  std::size_t m_failures, m_few = 0;
  std::vector<Index> m_updated;
  std::vector<internal::Curvature_estimate> m_estimates; // of them
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_DYNAMIC_RUSINKIEWICZ_CURVATURES_H
