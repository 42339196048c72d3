#ifndef SHAPE_CHARACTERISTICS_INTERNAL_POINT_SET_PARAMETERS_H
#define SHAPE_CHARACTERISTICS_INTERNAL_POINT_SET_PARAMETERS_H

#include <Shape_characteristics/Named_function_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <stdexcept>
#include <type_traits>
#include <utility>

namespace Shape_characteristics {
namespace internal {

// CGAL::Point_set_3 brings its own maps, for points and, if it was asked to, for normals
template <typename PointRange, typename = void>
struct Has_own_normal_map : std::false_type
{};

template <typename PointRange>
struct Has_own_normal_map<PointRange,
                          std::void_t<decltype(std::declval<const PointRange&>().has_normal_map())> >
  : std::true_type
{};

template <typename PointRange, typename NamedParameters>
using Point_set_helper = CGAL::Point_set_processing_3_np_helper<PointRange, NamedParameters>;

template <typename PointRange, typename NamedParameters>
inline constexpr bool may_have_normal_map =
    Has_own_normal_map<PointRange>::value ||
    !parameters::is_default_parameter<NamedParameters, internal_np::normal_t>::value;

template <typename PointRange, typename NamedParameters>
void require_normal_map(const PointRange& points, const NamedParameters&)
{
  bool found = !parameters::is_default_parameter<NamedParameters, internal_np::normal_t>::value;
  if constexpr(Has_own_normal_map<PointRange>::value)
    found = found || points.has_normal_map();
  if(!found)
    throw std::invalid_argument("Shape_characteristics: a point set needs normals: normal_map is missing");
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_POINT_SET_PARAMETERS_H
