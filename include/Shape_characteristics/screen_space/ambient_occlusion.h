#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_AMBIENT_OCCLUSION_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_AMBIENT_OCCLUSION_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/screen_space/Screen_space_curvature.h>
#include <Shape_characteristics/screen_space/Two_part_ambient_occlusion.h>
#include <Shape_characteristics/screen_space/internal/Screen_space_estimator.h>
#include <Shape_characteristics/screen_space/internal/Screen_space_options.h>
#include <Shape_characteristics/screen_space/internal/for_each_pixel.h>
#include <Shape_characteristics/screen_space/mean_curvature_extreme.h>

#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsScreenSpace

  guesses from the curvature of what a picture shows how much of the ambient light arrives at each pixel (the thesis's section 7.4).

  What a pixel gets depends on its own curvature alone: it is quick, but does not know of what stands opposite, and a plane
  in a deep shaft is lit. `ray_cast_ambient_occlusion()` tells how far that is from the truth, and `Ambient_occlusion_pass` does
  the same as this function on the GPU. For curvatures from elsewhere, such as those of the vertices of a mesh, call the mapping itself.

  \scConcurrencyTag
  \tparam GBuffer a model of the concept `GBuffer`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param g_buffer depths, normals and the camera. Without pixels nothing is done.
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below, and those that tell
         `screen_space_curvatures()` how to estimate

  \cgalNamedParamsBegin
    \cgalParamNBegin{ambient_occlusion_map}
      \cgalParamDescription{a property map in which the share of the ambient light that arrives is written, in [0, 1]: 1 is fully lit, 0 is
                            dark, quiet NaN is for the background, and for pixels without curvature}
      \cgalParamType{a model of `WritablePropertyMap` with the pixel's index, a `std::size_t`, as key type and `float` as value type}
      \cgalParamDefault{not written}
    \cgalParamNEnd
    \cgalParamNBegin{status_map}
      \cgalParamDescription{a property map in which is written whether each pixel has a curvature and if not why. Background is `UNREFERENCED`.}
      \cgalParamType{a model of `WritablePropertyMap` with value type `Estimation_status`}
      \cgalParamDefault{not written}
    \cgalParamNEnd
    \cgalParamNBegin{ambient_occlusion_mapping}
      \cgalParamDescription{what makes light of curvature}
      \cgalParamType{a model of `AmbientOcclusionMapping`}
      \cgalParamDefault{`Two_part_ambient_occlusion` with the `mean_curvature_extreme()` of the picture}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_triangles}
      \cgalParamDescription{how many triangles of neighboring pixels are taken, 1 to 4}
      \cgalParamType{`int`}
      \cgalParamDefault{`4`}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_edges}
      \cgalParamDescription{from how many edges the shape operator of a triangle is fitted, 2 or 3}
      \cgalParamType{`int`}
      \cgalParamDefault{`2`}
    \cgalParamNEnd
    \cgalParamNBegin{level_of_detail}
      \cgalParamDescription{how many pixels away the neighbors are. Wider hollows are seen from farther away.}
      \cgalParamType{`Level_of_detail`}
      \cgalParamDefault{`Level_of_detail::none()`: one pixel}
    \cgalParamNEnd
    \cgalParamNBegin{depth_discontinuity_rule}
      \cgalParamDescription{how neighbors on other surfaces are told apart}
      \cgalParamType{`Depth_discontinuity_rule`}
      \cgalParamDefault{`Depth_discontinuity_rule::TANGENT_PLANES`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return the number of pixels that show a surface whose curvature could not be estimated

  \throws std::invalid_argument if a parameter is out of its range

  Complexity: linear in the number of pixels.

  \cgalExample{screen_space/ambient_occlusion.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename GBuffer,
          typename NamedParameters = parameters::Default_named_parameters>
std::size_t ambient_occlusion(const GBuffer& g_buffer,
                              const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  const internal::Screen_space_options options(np);
  if(g_buffer.width() <= 0 || g_buffer.height() <= 0)
    return 0;
  const internal::Screen_space_pass pass(options, g_buffer.camera(), g_buffer.normal_space(),
                                         g_buffer.width(), g_buffer.height());
  const std::size_t size = g_buffer.size();
  std::vector<float> k_min(size), k_max(size);
  const auto output = parameters::min_curvature_map(CGAL::make_property_map(k_min))
                          .max_curvature_map(CGAL::make_property_map(k_max));
  const auto estimate = [&](const auto& maps)
  {
    return internal::for_each_pixel<ConcurrencyTag>(
        g_buffer, internal::Screen_space_estimator<GBuffer>(g_buffer, pass), maps);
  };
  std::size_t failed = 0;
  if constexpr(is_default_parameter<NamedParameters, internal_np::status_map_t>::value)
    failed = estimate(output);
  else
    failed = estimate(output.status_map(get_parameter(np, internal_np::status_map)));
  if constexpr(!is_default_parameter<NamedParameters, internal_np::ambient_occlusion_map_t>::value)
  {
    const auto map = get_parameter(np, internal_np::ambient_occlusion_map);
    const auto write = [&](const auto& mapping)
    {
      for(std::size_t i = 0; i < size; ++i)
      {
        Screen_space_curvature c;
        c.min_curvature = k_min[i];
        c.max_curvature = k_max[i];
        const bool is_known = std::isfinite(k_min[i]) && std::isfinite(k_max[i]);
        put(map, i, is_known ? float(mapping(c)) : std::numeric_limits<float>::quiet_NaN());
      }
    };
    if constexpr(is_default_parameter<NamedParameters, internal_np::ambient_occlusion_mapping_t>::value)
    {
      std::vector<float> mean(size);
      for(std::size_t i = 0; i < size; ++i)
        mean[i] = 0.5f * k_min[i] + 0.5f * k_max[i];
      const double extreme = mean_curvature_extreme(mean);
      write(Two_part_ambient_occlusion(extreme > 0 ? extreme : 1));
    }
    else
      write(get_parameter(np, internal_np::ambient_occlusion_mapping));
  }
  return failed;
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_AMBIENT_OCCLUSION_H
