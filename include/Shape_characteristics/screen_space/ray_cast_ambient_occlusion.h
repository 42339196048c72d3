#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_RAY_CAST_AMBIENT_OCCLUSION_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_RAY_CAST_AMBIENT_OCCLUSION_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/internal/callback_of.h>
#include <Shape_characteristics/internal/whole_number.h>
#include <Shape_characteristics/sampling/for_each_sample.h>
#include <Shape_characteristics/screen_space/internal/Ambient_ray_caster.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsScreenSpace

  finds by rays how much of the ambient light arrives at what each pixel shows: the truth that the mappings from curvature to ambient occlusion are
  measured by, and far slower.

  From the point of the mesh that a pixel shows, rays leave in a fixed pattern, evenly spread over the hemisphere above the pixel's normal and the
  denser the nearer they are to it (by the cosine, as light counts); each pixel turns the pattern by another angle, so that what is left of it is noise. The light is
  the share of the rays that meet nothing. Rays into the face that they start from don't count: the smooth surface that the normals stand for isn't in its own way.

  Faces hide from both sides. Faces with more than three vertices are cut into triangles; those without an area or with coordinates that are not finite
  are left out.

  \scConcurrencyTag
  \tparam FaceGraph a model of `FaceListGraph`
  \tparam GBuffer a model of `GBuffer`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh what the picture shows
  \param g_buffer depths and normals of the picture, and its camera
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{ambient_occlusion_map}
      \cgalParamDescription{a property map in which the share of the ambient light that arrives is written, in [0, 1]: 1 is fully lit, 0 is
                            dark, quiet NaN is for the background, and where the mesh isn't where the picture shows a surface (farther away
                            than a hundredth of the diagonal of its bounding box)}
      \cgalParamType{a model of `WritablePropertyMap` with the pixel's index, a `std::size_t`, as key type and `float` as value type}
      \cgalParamDefault{not written}
    \cgalParamNEnd
    \cgalParamNBegin{vertex_point_map}
      \cgalParamDescription{the points of the vertices, in the coordinates of the scene}
      \cgalParamType{a model of `ReadablePropertyMap`}
      \cgalParamDefault{`get(CGAL::vertex_point, mesh)`}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_rays}
      \cgalParamDescription{the number of rays of a pixel. The error falls as its inverse, or its square root where what hides is intricate.}
      \cgalParamType{`int`}
      \cgalParamDefault{`64`}
    \cgalParamNEnd
    \cgalParamNBegin{maximum_ray_length}
      \cgalParamDescription{how far away something may be and still hide the light, in the unit of the scene}
      \cgalParamType{`double`}
      \cgalParamDefault{infinity}
    \cgalParamNEnd
    \cgalParamNBegin{callback}
      \cgalParamDescription{called with the advancement in [0, 1], by one thread at a time; `false` stops the computation, and
                            pixels not yet reached get quiet NaN}
      \cgalParamType{convertible to `std::function<bool(double)>`}
      \cgalParamDefault{unused}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return the number of pixels that show a surface but not that of the mesh, or that were left out because `callback` returned `false`

  \throws std::invalid_argument if `number_of_rays` is less than 1 or `maximum_ray_length` is not positive

  Complexity: \f$ O(n \log n + m r \log n) \f$ in practice for \f$ n \f$ faces and \f$ m \f$ pixels with \f$ r \f$ rays each.

  \cgalExample{screen_space/ambient_occlusion.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename GBuffer,
          typename NamedParameters = parameters::Default_named_parameters>
std::size_t ray_cast_ambient_occlusion(const FaceGraph& mesh,
                                       const GBuffer& g_buffer,
                                       const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::is_default_parameter;
  const std::int64_t number_of_rays =
      internal::whole_number(np, internal_np::number_of_rays, std::int64_t(64), "number_of_rays");
  if(number_of_rays < 1)
    throw std::invalid_argument("ray_cast_ambient_occlusion: `number_of_rays` must be at least 1");
  const double reach = choose_parameter(get_parameter(np, internal_np::maximum_ray_length),
                                        std::numeric_limits<double>::infinity());
  if(!(reach > 0))
    throw std::invalid_argument("ray_cast_ambient_occlusion: `maximum_ray_length` must be positive");
  const auto point_map = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                          CGAL::get_const_property_map(CGAL::vertex_point, mesh));
  const std::function<bool(double)> callback = internal::callback_of(np);

  const internal::Ambient_ray_caster caster(mesh, point_map);
  const Eigen::Matrix3d to_world = g_buffer.camera().view().template topLeftCorner<3, 3>().transpose();
  const std::size_t size = g_buffer.size();
  std::vector<float> light(size, std::numeric_limits<float>::quiet_NaN());
  for_each_sample<ConcurrencyTag, No_workspace>(
      size,
      [&](const std::size_t i, No_workspace&)
      {
        if(!g_buffer.is_valid(i))
          return;
        const Eigen::Vector3d point = g_buffer.camera().world_point(g_buffer.view_point(i)),
                              normal = (to_world * g_buffer.view_normal(i)).normalized();
        if(const std::optional<double> value = caster.light(point, normal, std::size_t(number_of_rays), reach,
                                                            0.01 * caster.size(), internal::turn_of_pixel(i)))
          light[i] = float(*value);
      },
      callback);
  std::size_t failed = 0;
  for(std::size_t i = 0; i < size; ++i)
    failed += std::isnan(light[i]) && g_buffer.is_valid(i) ? 1 : 0;
  if constexpr(!is_default_parameter<NamedParameters, internal_np::ambient_occlusion_map_t>::value)
  {
    const auto map = get_parameter(np, internal_np::ambient_occlusion_map);
    for(std::size_t i = 0; i < size; ++i)
      put(map, i, light[i]);
  }
  return failed;
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_RAY_CAST_AMBIENT_OCCLUSION_H
