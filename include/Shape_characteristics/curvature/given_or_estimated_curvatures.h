#ifndef SHAPE_CHARACTERISTICS_CURVATURE_GIVEN_OR_ESTIMATED_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_GIVEN_OR_ESTIMATED_CURVATURES_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/hrbf_curvatures.h>
#include <Shape_characteristics/curvature/rusinkiewicz_curvatures.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>
#include <Shape_characteristics/sampling/Point_set_samples.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace Shape_characteristics {

/// \ingroup PkgShapeCharacteristicsCurvature
/// holds the principal curvatures of a sample, NaN where they could not be estimated.
struct Sample_principal_curvatures
{
  double min_curvature = 0.; ///< smaller principal curvature
  double max_curvature = 0.; ///< larger principal curvature
};

namespace internal {

// The kernel in which curvatures are estimated, whatever that of the surface is: what the samples hold.
using Sample_kernel = CGAL::Simple_cartesian<double>;

template <typename PrincipalCurvatures>
Sample_principal_curvatures to_sample_principal_curvatures(const PrincipalCurvatures& c)
{
  return {CGAL::to_double(c.min_curvature), CGAL::to_double(c.max_curvature)};
}

// property maps of the numbers of samples

struct Map_of_sample_points
{
  using key_type = std::uint32_t;
  using value_type = Sample_kernel::Point_3;
  using reference = value_type;
  using category = boost::readable_property_map_tag;
  const Point_set_samples* samples;
  friend value_type get(const Map_of_sample_points& map, const key_type i)
  {
    const Eigen::Vector3d& p = map.samples->point(i);
    return {p.x(), p.y(), p.z()};
  }
};

struct Map_of_sample_normals
{
  using key_type = std::uint32_t;
  using value_type = Sample_kernel::Vector_3;
  using reference = value_type;
  using category = boost::readable_property_map_tag;
  const Point_set_samples* samples;
  friend value_type get(const Map_of_sample_normals& map, const key_type i)
  {
    const Eigen::Vector3d& n = map.samples->normal(i);
    return {n.x(), n.y(), n.z()};
  }
};

struct Map_of_sample_curvatures
{
  using key_type = std::uint32_t;
  using value_type = Principal_curvatures_and_directions<Sample_kernel>;
  using reference = value_type&;
  using category = boost::writable_property_map_tag;
  std::vector<Sample_principal_curvatures>* values;
  friend void put(const Map_of_sample_curvatures& map, const key_type i, const value_type& value)
  {
    (*map.values)[i] = to_sample_principal_curvatures(value);
  }
};

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  returns the principal curvatures of the vertices of a mesh, in the order of `vertices(mesh)`: those of
  `vertex_principal_curvatures_and_directions_map` if `np` has one, else those that `rusinkiewicz_curvatures()` estimates from
  the points and normals of `samples`. A curvature that is given is taken as it is; one that could not be estimated is NaN.

  \tparam ConcurrencyTag as in `rusinkiewicz_curvatures()`

  \param mesh the surface
  \param samples the samples of its vertices
  \param np named parameters: `vertex_principal_curvatures_and_directions_map`, all others are ignored

  \throws std::invalid_argument if they are to be estimated and a face is not a triangle
*/
template <typename ConcurrencyTag, typename FaceGraph, typename NamedParameters>
std::vector<Sample_principal_curvatures> given_or_estimated_curvatures(const FaceGraph& mesh,
                                                                       const Face_graph_samples& samples,
                                                                       const NamedParameters& np)
{
  using internal::Sample_kernel;
  using parameters::get_parameter;
  using parameters::is_default_parameter;
  using Map_tag = internal_np::vertex_principal_curvatures_and_directions_map_t;

  std::vector<Sample_principal_curvatures> result;
  result.reserve(samples.size());
  const auto read = [&](const auto& map)
  {
    for(const auto v : vertices(mesh))
      result.push_back(internal::to_sample_principal_curvatures(get(map, v)));
  };
  if constexpr(!is_default_parameter<NamedParameters, Map_tag>::value)
    read(get_parameter(np, internal_np::vertex_principal_curvatures_and_directions_map));
  else
  {
    auto points = get(CGAL::dynamic_vertex_property_t<Sample_kernel::Point_3>(), mesh);
    auto normals = get(CGAL::dynamic_vertex_property_t<Sample_kernel::Vector_3>(), mesh);
    auto curvatures =
        get(CGAL::dynamic_vertex_property_t<Principal_curvatures_and_directions<Sample_kernel> >(), mesh);
    std::size_t i = 0;
    for(const auto v : vertices(mesh))
    {
      const Eigen::Vector3d &p = samples.point(i), &n = samples.normal(i);
      put(points, v, Sample_kernel::Point_3(p.x(), p.y(), p.z()));
      put(normals, v, Sample_kernel::Vector_3(n.x(), n.y(), n.z()));
      ++i;
    }
    rusinkiewicz_curvatures<ConcurrencyTag>(mesh,
                                            parameters::vertex_point_map(points)
                                                .vertex_normal_map(normals)
                                                .vertex_principal_curvatures_and_directions_map(curvatures));
    read(curvatures);
  }
  return result;
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  returns the principal curvatures of the points of a point set, in its order: those of
  `principal_curvatures_and_directions_map` if `np` has one, else those that `hrbf_curvatures()` with its default neighborhood
  estimates from the points and normals of `samples`. A curvature that is given is taken as it is; one that could not be
  estimated is NaN.

  \tparam ConcurrencyTag as in `hrbf_curvatures()`

  \param points the points
  \param samples their samples
  \param np named parameters: `principal_curvatures_and_directions_map`, all others are ignored
  \param fits_are_shared see `hrbf_curvatures()`. If not, the order of the points doesn't matter.
*/
template <typename ConcurrencyTag, typename PointRange, typename NamedParameters>
std::vector<Sample_principal_curvatures> given_or_estimated_curvatures(const PointRange& points,
                                                                       const Point_set_samples& samples,
                                                                       const NamedParameters& np,
                                                                       bool fits_are_shared)
{
  using parameters::get_parameter;
  using parameters::is_default_parameter;
  using Map_tag = internal_np::principal_curvatures_and_directions_map_t;

  std::vector<Sample_principal_curvatures> result;
  if constexpr(!is_default_parameter<NamedParameters, Map_tag>::value)
  {
    const auto map = get_parameter(np, internal_np::principal_curvatures_and_directions_map);
    for(const auto& item : points)
      result.push_back(internal::to_sample_principal_curvatures(get(map, item)));
  }
  else
  {
    std::vector<std::uint32_t> numbers(samples.size());
    std::iota(numbers.begin(), numbers.end(), std::uint32_t(0));
    result.resize(samples.size());
    hrbf_curvatures<ConcurrencyTag>(
        numbers, parameters::point_map(internal::Map_of_sample_points{&samples})
                     .normal_map(internal::Map_of_sample_normals{&samples})
                     .principal_curvatures_and_directions_map(internal::Map_of_sample_curvatures{&result})
                     .fits_are_shared(fits_are_shared));
  }
  return result;
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_GIVEN_OR_ESTIMATED_CURVATURES_H
