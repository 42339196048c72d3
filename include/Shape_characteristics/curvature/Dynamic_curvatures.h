#ifndef SHAPE_CHARACTERISTICS_CURVATURE_DYNAMIC_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_DYNAMIC_CURVATURES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/internal/write_curvatures.h>
#include <Shape_characteristics/sampling/for_each_sample.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// a map that notes which vertices are asked for
template <typename Map>
struct Noting_map
{
  using key_type = typename boost::property_traits<Map>::key_type;
  using value_type = typename boost::property_traits<Map>::value_type;
  using reference = typename boost::property_traits<Map>::reference;
  using category = boost::readable_property_map_tag;

  Map map;
  std::vector<key_type>* notes;

  friend reference get(const Noting_map& m, const key_type& v)
  {
    m.notes->push_back(v);
    return get(m.map, v);
  }
};

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  keeps the curvatures of a mesh whose vertices move up to date, by any estimator that looks at the surroundings of a vertex
  (thesis, section 5.4): only where something moved are they estimated again.

  While the estimator is at work on a vertex, it is noted which points (and normals) it asks for. The estimate can change only
  if one of them does. So after vertices have moved, those are estimated again that asked for them, and all others have
  the bits that they would get again: exactly, whatever the neighborhoods are, and however they depend on the points.

  An estimator is a function that calls the overload for one vertex, with the named parameters that it is given and those that
  it adds:

  \code
    [](auto v, const auto& mesh, const auto& np)
    { return Shape_characteristics::jet_fitting_curvatures(v, mesh, np.degree_fitting(3)); }
  \endcode

  All estimators of this library that have that overload will do: the overload gives what the one for the whole
  mesh gives, bit for bit, with these exceptions: `hrbf_curvatures()` needs `fits_are_shared(false)` for that on the whole
  mesh, and, with inexact normals, `noise_level`, which comes from the surroundings otherwise, as does the radius over which the
  thesis's method averages derivatives; so does the noise level of `adaptive_curvatures()`, where normals aren't exact;
  `interpolated_corrected_curvatures()` needs triangles that are shorter than its ball; the
  status `DUPLICATE` is not told; of two fans of faces that share a vertex (a bow tie), only one is seen.

  The overload for one vertex copies the surroundings of the vertex, which takes longer than most estimators do with
  them: some ten to a hundred times as long as the share of a vertex in an estimate of the whole mesh. So an update is
  worth its while where the vertices that moved are next to each other and a small part of the mesh, or the estimator is
  costly, as those with large balls are; `benchmark/speed/moving_mesh.cpp` measures it. For Rusinkiewicz's there is
  `Dynamic_rusinkiewicz_curvatures`, which copies nothing.

  The mesh must outlive the object. Its faces and edges must not change; after a change, construct anew. The memory is 4 bytes
  for each vertex that a vertex asked for, some hundred bytes a vertex.

  \tparam FaceGraph a model of `FaceListGraph`
  \tparam Estimator a function, see above. It is called by several threads at once.
  \tparam NamedParameters the type of the named parameters
  \scConcurrencyTag

  \cgalExample{curvature/dynamic_curvatures.cpp}
*/
template <typename FaceGraph,
          typename Estimator,
          typename NamedParameters = parameters::Default_named_parameters,
          typename ConcurrencyTag = CGAL::Parallel_if_available_tag>
class Dynamic_curvatures
{
  using Index = std::uint32_t;
  using Kernel = CGAL::Simple_cartesian<double>;

public:
  /// a vertex of the mesh
  using vertex_descriptor = typename boost::graph_traits<FaceGraph>::vertex_descriptor;

  /*!
    estimates the curvatures at all vertices.

    \param mesh the mesh
    \param estimator the function that estimates the curvatures at a vertex
    \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below. Maps are kept,
           and read from or written to by each update. Parameters of the method are added by `estimator`.

    \cgalNamedParamsBegin
      \scMeshOutputParameters
      \cgalParamNBegin{vertex_point_map}
        \cgalParamDescription{the points of the vertices}
        \cgalParamType{a model of `ReadablePropertyMap` with value type `%Point_3`}
        \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
      \cgalParamNEnd
      \cgalParamNBegin{vertex_normal_map}
        \cgalParamDescription{the outward normals of the vertices, of any length}
        \cgalParamType{a model of `ReadablePropertyMap` with value type `%Vector_3`}
        \cgalParamDefault{not given to the estimator}
      \cgalParamNEnd
    \cgalNamedParamsEnd

    \throws std::length_error if there are more than \f$ 2^{32} - 2 \f$ vertices, and what the estimator throws
  */
  Dynamic_curvatures(const FaceGraph& mesh,
                     const Estimator& estimator,
                     const NamedParameters& np = parameters::default_values())
    : m_mesh(mesh),
      m_estimator(estimator),
      m_np(np)
  {
    for(const vertex_descriptor v : vertices(mesh))
    {
      if(m_vertices.size() >= (std::numeric_limits<Index>::max)() - 1)
        throw std::length_error("Shape_characteristics: the mesh has too many vertices or faces");
      m_index_of.emplace(v, Index(m_vertices.size()));
      m_vertices.push_back(v);
    }
    m_askers.resize(m_vertices.size());
    m_is_estimated.assign(m_vertices.size(), false);
    m_failures = m_vertices.size();
    for(std::size_t i = 0; i < m_vertices.size(); ++i)
      m_updated.push_back(Index(i));
    estimate();
  }

  Dynamic_curvatures(const Dynamic_curvatures&) = delete;
  Dynamic_curvatures& operator=(const Dynamic_curvatures&) = delete;

  /*!
    estimates the curvatures again where they may have changed because some vertices have.

    \tparam VertexRange a range of `vertex_descriptor`
    \param moved all vertices whose points have changed since the last update, or whose normals have where there is a map of
           them; each may come several times
    \return the number of vertices of the mesh that have no estimate
    \throws std::invalid_argument if one isn't of the mesh, and what the estimator throws: then some of the vertices may be up to date, and all
            are after another update with the same `moved`

    Complexity: that of the estimator, for those vertices that asked for one that has moved, and a bit for each vertex of the mesh.
  */
  template <typename VertexRange>
  std::size_t update(const VertexRange& moved)
  {
    std::vector<Index> updated;
    std::vector<bool> is_updated(m_vertices.size(), false);
    for(const vertex_descriptor v : moved)
    {
      const auto found = m_index_of.find(v);
      if(found == m_index_of.end())
        throw std::invalid_argument("Shape_characteristics: Dynamic_curvatures: a vertex is not of the mesh");
      for(const Index i : m_askers[found->second])
        if(!is_updated[i])
        {
          is_updated[i] = true;
          updated.push_back(i);
        }
    }
    std::sort(updated.begin(), updated.end());
    m_updated = std::move(updated);
    estimate();
    return m_failures;
  }

  /// the number of vertices of the mesh that have no estimate
  std::size_t number_of_failures() const noexcept { return m_failures; }

  /// the vertices that were estimated by the last update, or by the constructor, in the order of the mesh
  std::vector<vertex_descriptor> updated_vertices() const
  {
    std::vector<vertex_descriptor> result;
    result.reserve(m_updated.size());
    for(const Index i : m_updated)
      result.push_back(m_vertices[i]);
    return result;
  }

private:
  struct Answer
  {
    Estimation_status status = Estimation_status::CANCELLED;
    Principal_curvatures_and_directions<Kernel> curvatures;
    double mean = 0., Gaussian = 0.;
    std::vector<Index> asked; // in ascending order
  };

  struct Workspace
  {
    std::vector<vertex_descriptor> notes;
  };

  void estimate()
  {
    constexpr std::size_t most_at_a_time = 16384, block = 64;
    std::vector<Answer> answers((std::min)(m_updated.size(), most_at_a_time));
    for(std::size_t begin = 0; begin < m_updated.size(); begin += most_at_a_time)
    {
      const std::size_t end = (std::min)(begin + most_at_a_time, m_updated.size());
      for_each_sample<ConcurrencyTag, Workspace>(
          end - begin,
          [&](const std::size_t k, Workspace& workspace)
          { estimate(m_updated[begin + k], workspace, answers[k]); },
          {}, block);
      for(std::size_t k = begin; k < end; ++k)
        take(m_updated[k], answers[k - begin]);
    }
  }

  void estimate(Index i, Workspace& workspace, Answer& answer) const
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    using parameters::is_default_parameter;

    const vertex_descriptor v = m_vertices[i];
    workspace.notes.clear();
    const auto vpm = choose_parameter(get_parameter(m_np, internal_np::vertex_point),
                                      CGAL::get_const_property_map(CGAL::vertex_point, m_mesh));
    using Point_map = std::remove_cv_t<std::remove_reference_t<decltype(vpm)> >;
    const auto np = parameters::vertex_point_map(internal::Noting_map<Point_map>{vpm, &workspace.notes})
                        .vertex_principal_curvatures_and_directions(std::ref(answer.curvatures))
                        .vertex_mean_curvature(std::ref(answer.mean))
                        .vertex_Gaussian_curvature(std::ref(answer.Gaussian));
    if constexpr(is_default_parameter<NamedParameters, internal_np::vertex_normal_map_t>::value)
      answer.status = m_estimator(v, m_mesh, np);
    else
    {
      const auto normal_map = get_parameter(m_np, internal_np::vertex_normal_map);
      using Normal_map = std::remove_cv_t<std::remove_reference_t<decltype(normal_map)> >;
      answer.status = m_estimator(
          v, m_mesh, np.vertex_normal_map(internal::Noting_map<Normal_map>{normal_map, &workspace.notes}));
    }
    answer.asked.clear();
    for(const vertex_descriptor u : workspace.notes)
      answer.asked.push_back(m_index_of.at(u));
    std::sort(answer.asked.begin(), answer.asked.end());
    answer.asked.erase(std::unique(answer.asked.begin(), answer.asked.end()), answer.asked.end());
  }

  void take(Index i, const Answer& answer)
  {
    using parameters::get_parameter;
    using parameters::is_default_parameter;

    for(const Index j : answer.asked)
    {
      // Who doesn't ask any more stays: it costs an estimate that changes nothing.
      std::vector<Index>& askers = m_askers[j];
      const auto place = std::lower_bound(askers.begin(), askers.end(), i);
      if(place == askers.end() || *place != i)
        askers.insert(place, i);
    }
    m_failures -= !m_is_estimated[i];
    m_is_estimated[i] = is_estimated(answer.status);
    m_failures += !m_is_estimated[i];

    const vertex_descriptor v = m_vertices[i];
    internal::Curvature_estimate estimate(answer.status);
    const auto vector = [](const Kernel::Vector_3& d) { return Eigen::Vector3d(d.x(), d.y(), d.z()); };
    estimate.curvatures.min_curvature = answer.curvatures.min_curvature;
    estimate.curvatures.max_curvature = answer.curvatures.max_curvature;
    estimate.curvatures.min_direction = vector(answer.curvatures.min_direction);
    estimate.curvatures.max_direction = vector(answer.curvatures.max_direction);
    internal::write_to_vertex(v, estimate, m_np);
    // They may be measured by themselves.
    if constexpr(!is_default_parameter<NamedParameters, internal_np::vertex_mean_curvature_map_t>::value)
      internal::put_number(get_parameter(m_np, internal_np::vertex_mean_curvature_map), v, answer.mean);
    if constexpr(!is_default_parameter<NamedParameters, internal_np::vertex_Gaussian_curvature_map_t>::value)
      internal::put_number(get_parameter(m_np, internal_np::vertex_Gaussian_curvature_map), v,
                           answer.Gaussian);
  }

  const FaceGraph& m_mesh;
  Estimator m_estimator;
  NamedParameters m_np;
  std::vector<vertex_descriptor> m_vertices;
  std::unordered_map<vertex_descriptor, Index> m_index_of;
  std::vector<std::vector<Index> >
      m_askers; // by vertex: those that asked for its point or normal, in ascending order
  std::vector<bool> m_is_estimated;
  std::size_t m_failures = 0;
  std::vector<Index> m_updated;
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_DYNAMIC_CURVATURES_H
