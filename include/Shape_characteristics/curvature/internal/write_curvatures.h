#ifndef SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_WRITE_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_WRITE_CURVATURES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/curvature/internal/shape_operator.h>
#include <Shape_characteristics/internal/lexicographically_smaller.h>
#include <Shape_characteristics/internal/put_number.h>
#include <Shape_characteristics/internal/to_number.h>
#include <Shape_characteristics/internal/to_vector.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <type_traits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// the answer of an estimator for one sample
struct Curvature_estimate
{
  Estimation_status status = Estimation_status::CANCELLED;
  Shape_operator_eigen curvatures; // NaN unless estimated

  Curvature_estimate() = default;
  explicit Curvature_estimate(Estimation_status status) : status(status) {}

  // a value that isn't finite is no estimate
  Curvature_estimate(Estimation_status if_finite, const Shape_operator_eigen& c)
    : status(if_finite),
      curvatures(c)
  {
    if(!c.is_finite())
      *this = Curvature_estimate(Estimation_status::DEGENERATE);
  }

  double mean() const { return curvatures.min_curvature / 2. + curvatures.max_curvature / 2.; }
  double Gaussian() const { return curvatures.min_curvature * curvatures.max_curvature; }
};

// Principal_curvatures_and_directions of this library, or CGAL 6's
template <typename Value>
Value to_principal_curvatures(const Curvature_estimate& estimate)
{
  using FT = decltype(Value().min_curvature);
  using Vector_3 = decltype(Value().min_direction);
  const Shape_operator_eigen& c = estimate.curvatures;
  return Value(to_number<FT>(c.min_curvature), to_number<FT>(c.max_curvature),
               to_vector<Vector_3>(c.min_direction), to_vector<Vector_3>(c.max_direction));
}

template <typename Map, typename Key>
void put_curvatures(const Map& map, Key& key, const Curvature_estimate& estimate)
{
  put(map, key, to_principal_curvatures<typename boost::property_traits<Map>::value_type>(estimate));
}

// Faces of a soup have no neighbors, for each has its own copy of the vertices: says so instead of FEW_NEIGHBOURS.
class Duplicates
{
public:
  explicit Duplicates(const Face_graph_samples& samples) : m_samples(samples) {}

  void mark(std::size_t i, Curvature_estimate& estimate)
  {
    if(estimate.status == Estimation_status::FEW_NEIGHBOURS && has_coincident_vertices(i))
      estimate.status = Estimation_status::DUPLICATE;
  }

private:
  using Index = Face_graph_samples::Index;

  bool has_coincident_vertices(std::size_t i)
  {
    const auto is_before = [&](const Index a, const Index b)
    { return lexicographically_smaller(m_samples.point(a), m_samples.point(b)); };
    if(m_order.empty()) // most meshes never need it
    {
      m_order.resize(m_samples.size());
      std::iota(m_order.begin(), m_order.end(), Index(0));
      std::sort(m_order.begin(), m_order.end(), is_before);
    }
    const auto equal = std::equal_range(m_order.begin(), m_order.end(), Index(i), is_before);
    return equal.second - equal.first > 1;
  }

  const Face_graph_samples& m_samples;
  std::vector<Index> m_order; // that of the points
};

// writes what there is a map for
template <typename Vertex, typename NamedParameters>
void write_to_vertex(const Vertex v, const Curvature_estimate& estimate, const NamedParameters& np)
{
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  if constexpr(!is_default_parameter<NamedParameters,
                                     internal_np::vertex_principal_curvatures_and_directions_map_t>::value)
    put_curvatures(get_parameter(np, internal_np::vertex_principal_curvatures_and_directions_map), v,
                   estimate);
  if constexpr(!is_default_parameter<NamedParameters, internal_np::vertex_mean_curvature_map_t>::value)
    put_number(get_parameter(np, internal_np::vertex_mean_curvature_map), v, estimate.mean());
  if constexpr(!is_default_parameter<NamedParameters, internal_np::vertex_Gaussian_curvature_map_t>::value)
    put_number(get_parameter(np, internal_np::vertex_Gaussian_curvature_map), v, estimate.Gaussian());
  if constexpr(!is_default_parameter<NamedParameters, internal_np::vertex_status_map_t>::value)
    put(get_parameter(np, internal_np::vertex_status_map), v, estimate.status);
}

// The item isn't const if it wasn't to the caller: maps may write into it.
template <typename Item, typename NamedParameters>
void write_to_item(Item& item, const Curvature_estimate& estimate, const NamedParameters& np)
{
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  if constexpr(!is_default_parameter<NamedParameters,
                                     internal_np::principal_curvatures_and_directions_map_t>::value)
    put_curvatures(get_parameter(np, internal_np::principal_curvatures_and_directions_map), item, estimate);
  if constexpr(!is_default_parameter<NamedParameters, internal_np::mean_curvature_map_t>::value)
    put_number(get_parameter(np, internal_np::mean_curvature_map), item, estimate.mean());
  if constexpr(!is_default_parameter<NamedParameters, internal_np::Gaussian_curvature_map_t>::value)
    put_number(get_parameter(np, internal_np::Gaussian_curvature_map), item, estimate.Gaussian());
  if constexpr(!is_default_parameter<NamedParameters, internal_np::status_map_t>::value)
    put(get_parameter(np, internal_np::status_map), item, estimate.status);
}

// Marks duplicates among the estimates of all vertices, writes what there is a map for, and returns the number of vertices
// without an estimate: in one go, because reading them all takes its time.
template <typename FaceGraph, typename Estimates, typename NamedParameters>
std::size_t write_to_mesh(const FaceGraph& mesh,
                          const Face_graph_samples& samples,
                          Estimates& estimates,
                          const NamedParameters& np)
{
  Duplicates duplicates(samples);
  std::size_t failures = 0, i = 0;
  for(const auto v : vertices(mesh))
  {
    Curvature_estimate& estimate = estimates[i];
    duplicates.mark(i++, estimate);
    failures += !is_estimated(estimate.status);
    write_to_vertex(v, estimate, np);
  }
  return failures;
}

// the same with points, of which none is marked
template <typename PointRange, typename Estimates, typename NamedParameters>
std::size_t write_to_points(PointRange& points, const Estimates& estimates, const NamedParameters& np)
{
  std::size_t failures = 0, i = 0;
  for(auto&& item : points)
  {
    const Curvature_estimate& estimate = estimates[i++];
    failures += !is_estimated(estimate.status);
    write_to_item(item, estimate, np);
  }
  return failures;
}

// writes what there is a reference for, and returns the status
template <typename NamedParameters>
Estimation_status write_to_references(const Curvature_estimate& estimate, const NamedParameters& np)
{
  using parameters::get_parameter_reference;
  using parameters::is_default_parameter;

  if constexpr(!is_default_parameter<NamedParameters,
                                     internal_np::vertex_principal_curvatures_and_directions_t>::value)
  {
    auto& value = get_parameter_reference(np, internal_np::vertex_principal_curvatures_and_directions);
    value = to_principal_curvatures<std::decay_t<decltype(value)> >(estimate);
  }
  if constexpr(!is_default_parameter<NamedParameters, internal_np::vertex_mean_curvature_t>::value)
  {
    auto& value = get_parameter_reference(np, internal_np::vertex_mean_curvature);
    value = to_number<std::decay_t<decltype(value)> >(estimate.mean());
  }
  if constexpr(!is_default_parameter<NamedParameters, internal_np::vertex_Gaussian_curvature_t>::value)
  {
    auto& value = get_parameter_reference(np, internal_np::vertex_Gaussian_curvature);
    value = to_number<std::decay_t<decltype(value)> >(estimate.Gaussian());
  }
  return estimate.status;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_WRITE_CURVATURES_H
