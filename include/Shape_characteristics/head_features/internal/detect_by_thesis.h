#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_DETECT_BY_THESIS_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_DETECT_BY_THESIS_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/head_features/Head_features.h>
#include <Shape_characteristics/head_features/Head_pose.h>
#include <Shape_characteristics/head_features/head_descriptors.h>
#include <Shape_characteristics/head_features/internal/Head_of_mesh.h>
#include <Shape_characteristics/head_features/internal/Thesis_head_features.h>
#include <Shape_characteristics/internal/to_eigen.h>
#include <Shape_characteristics/internal/whole_number.h>

#include <CGAL/Cartesian_converter.h>
#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// the number of vertices that a parameter of the thesis's method gives
template <typename NamedParameters, typename Tag>
std::size_t number_of_thesis_vertices(const NamedParameters& np, Tag tag, const std::string& name)
{
  const std::int64_t number = whole_number(np, tag, std::int64_t(0), name.c_str());
  if(number < 1)
    throw std::invalid_argument("Shape_characteristics: the thesis's method needs " + name + ", at least 1");
  return static_cast<std::size_t>(number);
}

template <typename NamedParameters>
Thesis_head_features::Options thesis_options(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  Thesis_head_features::Options options;
  options.eye_vertices =
      number_of_thesis_vertices(np, internal_np::number_of_eye_vertices, "number_of_eye_vertices");
  options.nose_vertices =
      number_of_thesis_vertices(np, internal_np::number_of_nose_vertices, "number_of_nose_vertices");
  options.ear_vertices =
      number_of_thesis_vertices(np, internal_np::number_of_ear_vertices, "number_of_ear_vertices");
  options.detection_radius = choose_parameter(get_parameter(np, internal_np::detection_radius), 0.);
  if(!(options.detection_radius >= 0.))
    throw std::invalid_argument("Shape_characteristics: detection_radius must not be negative");
  return options;
}

// Finds features and regions by the thesis's method, in the frame of `head`.
template <typename ConcurrencyTag, typename FaceGraph, typename Kernel, typename NamedParameters>
void detect_by_thesis(const FaceGraph& mesh,
                      const Head_of_mesh<FaceGraph>& head,
                      const Thesis_head_features::Options& options,
                      const NamedParameters& np,
                      Head_features<FaceGraph, Kernel>& result)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  const auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                    CGAL::get_const_property_map(CGAL::vertex_point, mesh));
  auto descriptor_map = get(CGAL::dynamic_vertex_property_t<Head_descriptor>(), mesh);
  Head_pose<Kernel> box; // its size is the unit of the averaging radius
  box.size = 1. / head.scale();
  const auto common =
      parameters::vertex_point_map(vpm)
          .vertex_head_descriptor_map(descriptor_map)
          .head_pose(box)
          .averaging_radius(choose_parameter(get_parameter(np, internal_np::averaging_radius), .01));
  if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::curvature_estimator_t>::value)
    head_descriptors<ConcurrencyTag>(mesh, common);
  else
    head_descriptors<ConcurrencyTag>(
        mesh, common.curvature_estimator(get_parameter(np, internal_np::curvature_estimator)));
  std::vector<Head_descriptor> described;
  described.reserve(head.descriptors.size());
  for(const auto v : head.descriptors)
    described.push_back(get(descriptor_map, v));
  const Thesis_head_features found(head.surface.points, described, options);
  using Point = typename boost::property_traits<std::decay_t<decltype(vpm)> >::value_type;
  const CGAL::Cartesian_converter<typename CGAL::Kernel_traits<Point>::Kernel, Kernel> converted;
  for(std::size_t k = 0; k < number_of_head_features; ++k)
    if(found.points[k] != Thesis_head_features::none)
      result.points[k] = {true, converted(get(vpm, head.descriptors[found.points[k]])),
                          head.descriptors[found.points[k]], 1.};
  for(std::size_t k = 0; k < number_of_head_regions; ++k)
  {
    std::vector<std::size_t> region = found.regions[k];
    std::sort(region.begin(), region.end());
    for(const std::size_t v : region)
      result.regions[k].vertices.push_back(head.descriptors[v]);
    result.regions[k].is_found = !region.empty();
    result.regions[k].confidence = region.empty() ? 0. : 1.;
  }
  const auto &top = result[Head_feature::TOP], &chin = result[Head_feature::CHIN];
  if(top.is_found && chin.is_found)
    result.head_height = (to_eigen(top.position) - to_eigen(chin.position)).norm();
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_DETECT_BY_THESIS_H
