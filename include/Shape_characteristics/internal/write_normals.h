#ifndef SHAPE_CHARACTERISTICS_INTERNAL_WRITE_NORMALS_H
#define SHAPE_CHARACTERISTICS_INTERNAL_WRITE_NORMALS_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/internal/to_vector.h>

#include <boost/property_map/property_map.hpp>

#include <Eigen/Core>

#include <cstddef>
#include <limits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

struct Normal_estimate
{
  Estimation_status status = Estimation_status::CANCELLED;
  Eigen::Vector3d normal = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
};

// Writes the estimates of all vertices of a mesh to the map, and their statuses to that of the named parameters. Returns the
// number of those without one.
template <typename FaceGraph, typename VertexNormalMap, typename NamedParameters>
std::size_t write_normals_to_mesh(const FaceGraph& mesh,
                                  VertexNormalMap normals,
                                  const std::vector<Normal_estimate>& estimates,
                                  const NamedParameters& np)
{
  using Vector_3 = typename boost::property_traits<VertexNormalMap>::value_type;
  std::size_t failures = 0, i = 0;
  for(const auto v : vertices(mesh))
  {
    const Normal_estimate& estimate = estimates[i++];
    put(normals, v, to_vector<Vector_3>(estimate.normal));
    if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::vertex_status_map_t>::value)
      put(parameters::get_parameter(np, internal_np::vertex_status_map), v, estimate.status);
    failures += !is_estimated(estimate.status);
  }
  return failures;
}

// the same of the points of a range
template <typename PointRange, typename NormalMap, typename NamedParameters>
std::size_t write_normals_to_points(PointRange& points,
                                    NormalMap normals,
                                    const std::vector<Normal_estimate>& estimates,
                                    const NamedParameters& np)
{
  using Vector_3 = typename boost::property_traits<NormalMap>::value_type;
  std::size_t failures = 0, i = 0;
  for(auto&& item : points)
  {
    const Normal_estimate& estimate = estimates[i++];
    put(normals, item, to_vector<Vector_3>(estimate.normal));
    if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::status_map_t>::value)
      put(parameters::get_parameter(np, internal_np::status_map), item, estimate.status);
    failures += !is_estimated(estimate.status);
  }
  return failures;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_WRITE_NORMALS_H
