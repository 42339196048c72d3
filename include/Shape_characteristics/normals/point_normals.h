#ifndef SHAPE_CHARACTERISTICS_NORMALS_POINT_NORMALS_H
#define SHAPE_CHARACTERISTICS_NORMALS_POINT_NORMALS_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/internal/point_set_parameters.h>
#include <Shape_characteristics/internal/to_eigen.h>
#include <Shape_characteristics/internal/to_vector.h>
#include <Shape_characteristics/normals/Point_normal_method.h>
#include <Shape_characteristics/normals/internal/estimate_point_normals.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsNormals

  computes the unit normals of a point set from its points alone, by \cgal's estimators, and orients them consistently
  and outward.

  Directions propagate along a minimum spanning tree from neighbor to neighbor (`CGAL::mst_orient_normals()`), in each
  connected part of the point set from a point that lies farthest out along one of the axes: there a closed surface's outward
  side is known. An open surface gets the side that looks outward at that point.

  Points with the same coordinates count once, and get the same normal. The result depends neither on the order of the points
  nor on the number of threads, and the range isn't reordered.

  \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or `CGAL::Parallel_if_available_tag` (default).
          The orientation is sequential.
  \tparam PointRange a model of `ConstRange`
  \tparam NormalMap a model of `WritablePropertyMap` with the value type of the range as key type and `%Vector_3` as
          value type
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param points the point set
  \param normals the property map in which the normals are written, by one thread and after the computation
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{point_normal_method}
      \cgalParamDescription{how a normal is estimated}
      \cgalParamType{`Point_normal_method`}
      \cgalParamDefault{`Point_normal_method::PCA`}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_neighbors}
      \cgalParamDescription{the size of the neighborhood: as many nearest points}
      \cgalParamType{`unsigned int`}
      \cgalParamDefault{`18`}
    \cgalParamNEnd
    \cgalParamNBegin{neighbor_radius}
      \cgalParamDescription{the radius of the neighborhood, in the unit of the points, instead of a number of neighbors}
      \cgalParamType{`FT`}
      \cgalParamDefault{not used}
    \cgalParamNEnd
    \cgalParamNBegin{status_map}
      \cgalParamDescription{a property map in which is written whether each point has a normal: `ESTIMATED`,
                            `FEW_NEIGHBOURS`, `NON_FINITE_INPUT`, or `DEGENERATE` (its neighborhood is a line, or as thick as it
                            is wide, or the normal couldn't be oriented)}
      \cgalParamType{a model of `WritablePropertyMap` with value type `Estimation_status`}
      \cgalParamDefault{not written}
    \cgalParamNEnd
    \cgalParamNBegin{point_map}
      \cgalParamDescription{the points of the elements of the range}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `%Point_3`}
      \cgalParamDefault{`CGAL::Identity_property_map`, or the map of a `CGAL::Point_set_3`}
    \cgalParamNEnd
    \cgalParamNBegin{geom_traits}
      \cgalParamDescription{an instance of a geometric traits class}
      \cgalParamType{a model of `Kernel`}
      \cgalParamDefault{deduced from the point type}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return the number of points without a normal; quiet NaN is written for them.

  \throws std::invalid_argument if a parameter has a value without meaning (no neighbors, a radius that isn't positive)

  Complexity: \f$ O(n (\log n + m)) \f$ for \f$ n \f$ points with neighborhoods of \f$ m \f$ on average.

  \sa `hrbf_normals()`, which makes such normals better by orders of magnitude
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename PointRange,
          typename NormalMap,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_point_range<PointRange> > >
std::size_t point_normals(PointRange&& points,
                          NormalMap normals,
                          const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::is_default_parameter;
  using Range = std::remove_cv_t<std::remove_reference_t<PointRange> >;
  using Vector_3 = typename boost::property_traits<NormalMap>::value_type;

  const Neighborhood neighborhood = internal::point_set_neighborhood(np);
  const Point_normal_method method =
      choose_parameter(get_parameter(np, internal_np::point_normal_method), Point_normal_method::PCA);
  const auto point_map = internal::Point_set_helper<Range, NamedParameters>::get_const_point_map(points, np);
  std::vector<Eigen::Vector3d> coordinates;
  for(const auto& item : points)
    coordinates.push_back(internal::to_eigen(get(point_map, item)));

  const internal::Point_normals estimate =
      internal::estimate_point_normals<ConcurrencyTag>(coordinates, neighborhood, method);
  std::size_t failures = 0, i = 0;
  for(auto&& item : points)
  {
    const Eigen::Vector3d& n = estimate.normals[i];
    put(normals, item, internal::to_vector<Vector_3>(n));
    if constexpr(!is_default_parameter<NamedParameters, internal_np::status_map_t>::value)
      put(get_parameter(np, internal_np::status_map), item, estimate.status[i]);
    failures += !is_estimated(estimate.status[i]);
    ++i;
  }
  return failures;
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_NORMALS_POINT_NORMALS_H
