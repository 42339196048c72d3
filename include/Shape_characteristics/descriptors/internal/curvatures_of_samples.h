#ifndef SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_CURVATURES_OF_SAMPLES_H
#define SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_CURVATURES_OF_SAMPLES_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/characteristics/curvedness.h>
#include <Shape_characteristics/curvature/hrbf_curvatures.h>
#include <Shape_characteristics/curvature/rusinkiewicz_curvatures.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>
#include <Shape_characteristics/sampling/Point_set_samples.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// curvature measures of all samples of a surface, NaN where they could not be estimated
struct Sample_curvatures
{
  std::vector<double> mean, Gaussian, curvedness;

  explicit Sample_curvatures(std::size_t size)
  {
    for(std::vector<double>* v : {&mean, &Gaussian, &curvedness})
      v->reserve(size);
  }

  template <typename PrincipalCurvatures>
  void add(const PrincipalCurvatures& c)
  {
    const double k_min = CGAL::to_double(c.min_curvature), k_max = CGAL::to_double(c.max_curvature);
    mean.push_back(k_min / 2. + k_max / 2.);
    Gaussian.push_back(k_min * k_max);
    curvedness.push_back(CGAL::to_double(Shape_characteristics::curvedness(c)));
  }
};

// The kernel in which curvatures are estimated, whatever that of the surface is: what the samples hold.
using Sample_kernel = CGAL::Simple_cartesian<double>;
using Sample_principal_curvatures = Principal_curvatures_and_directions<Sample_kernel>;

// from the map of the named parameters, or estimated from the triangles
template <typename ConcurrencyTag, typename FaceGraph, typename NamedParameters>
Sample_curvatures
curvatures_of_samples(const FaceGraph& mesh, const Face_graph_samples& samples, const NamedParameters& np)
{
  using parameters::get_parameter;
  using parameters::is_default_parameter;
  using Map_tag = internal_np::vertex_principal_curvatures_and_directions_map_t;

  Sample_curvatures result(samples.size());
  if constexpr(!is_default_parameter<NamedParameters, Map_tag>::value)
  {
    const auto map = get_parameter(np, internal_np::vertex_principal_curvatures_and_directions_map);
    for(const auto v : vertices(mesh))
      result.add(get(map, v));
  }
  else
  {
    auto points = get(CGAL::dynamic_vertex_property_t<Sample_kernel::Point_3>(), mesh);
    auto normals = get(CGAL::dynamic_vertex_property_t<Sample_kernel::Vector_3>(), mesh);
    auto curvatures = get(CGAL::dynamic_vertex_property_t<Sample_principal_curvatures>(), mesh);
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
    for(const auto v : vertices(mesh))
      result.add(get(curvatures, v));
  }
  return result;
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
  using value_type = Sample_principal_curvatures;
  using reference = value_type&;
  using category = boost::writable_property_map_tag;
  std::vector<value_type>* values;
  friend void put(const Map_of_sample_curvatures& map, const key_type i, const value_type& value)
  {
    (*map.values)[i] = value;
  }
};

// from the map of the named parameters, or estimated from the points, each by itself: the order of the points doesn't matter
template <typename ConcurrencyTag, typename PointRange, typename NamedParameters>
Sample_curvatures
curvatures_of_samples(const PointRange& points, const Point_set_samples& samples, const NamedParameters& np)
{
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  Sample_curvatures result(samples.size());
  if constexpr(!is_default_parameter<NamedParameters,
                                     internal_np::principal_curvatures_and_directions_map_t>::value)
  {
    const auto map = get_parameter(np, internal_np::principal_curvatures_and_directions_map);
    for(const auto& item : points)
      result.add(get(map, item));
  }
  else
  {
    std::vector<std::uint32_t> numbers(samples.size());
    std::iota(numbers.begin(), numbers.end(), std::uint32_t(0));
    std::vector<Sample_principal_curvatures> curvatures(samples.size());
    hrbf_curvatures<ConcurrencyTag>(
        numbers, parameters::point_map(Map_of_sample_points{&samples})
                     .normal_map(Map_of_sample_normals{&samples})
                     .principal_curvatures_and_directions_map(Map_of_sample_curvatures{&curvatures})
                     .fits_are_shared(false));
    for(const Sample_principal_curvatures& c : curvatures)
      result.add(c);
  }
  return result;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_CURVATURES_OF_SAMPLES_H
