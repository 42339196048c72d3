#include "fuzzed_data.h"

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/screen_space/Camera.h>
#include <Shape_characteristics/screen_space/Depth_convention.h>
#include <Shape_characteristics/screen_space/Depth_discontinuity_rule.h>
#include <Shape_characteristics/screen_space/G_buffer.h>
#include <Shape_characteristics/screen_space/Level_of_detail.h>
#include <Shape_characteristics/screen_space/Normal_space.h>
#include <Shape_characteristics/screen_space/ambient_occlusion.h>
#include <Shape_characteristics/screen_space/screen_space_curvatures.h>
#include <Shape_characteristics/screen_space/sphere_fit_mean_curvatures.h>

#include <CGAL/property_map.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace {

namespace SC = Shape_characteristics;

// a depth of any kind, or one of a plane
float depth(FuzzedDataProvider& data)
{
  return data.ConsumeBool() ? float(.5 + data.ConsumeIntegral<std::int8_t>() / 1024.)
                            : float(fuzz::number(data));
}

SC::Camera camera(FuzzedDataProvider& data)
{
  const double aspect_ratio = fuzz::number(data), near_plane = fuzz::number(data),
               far_plane = fuzz::number(data);
  const auto convention = data.PickValueInArray({SC::Depth_convention::WINDOW_DEPTH,
                                                 SC::Depth_convention::WINDOW_DEPTH_ZERO_TO_ONE,
                                                 SC::Depth_convention::EYE_DISTANCE});
  switch(data.ConsumeIntegralInRange<int>(0, 3))
  {
  case 0:
    return SC::Camera(Eigen::Matrix4d::Identity(), SC::Camera::perspective(1., 1., .1, 100.), convention);
  case 1:
    return SC::Camera(Eigen::Matrix4d::Identity(), SC::Camera::orthographic(2., 1., .1, 100.), convention);
  case 2:
    return SC::Camera(Eigen::Matrix4d::Identity(),
                      SC::Camera::perspective(fuzz::number(data), aspect_ratio, near_plane, far_plane),
                      convention);
  default:
    return SC::Camera(Eigen::Matrix4d::Identity(),
                      SC::Camera::orthographic(fuzz::number(data), aspect_ratio, near_plane, far_plane),
                      convention);
  }
}

} // namespace

// Depths and normals of small pictures, seen by cameras of all kinds, through estimators and ambient occlusion.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  FuzzedDataProvider data(bytes, size);
  const int kind = data.ConsumeIntegralInRange<int>(0, 2), width = data.ConsumeIntegralInRange<int>(0, 6),
            height = data.ConsumeIntegralInRange<int>(0, 6);
  const std::size_t count = std::size_t(width) * std::size_t(height);
  std::vector<float> k_min(count, 1e30f), k_max(count, 1e30f), light(count, 1e30f);
  std::vector<SC::Estimation_status> statuses(count, SC::Estimation_status::CANCELLED);
  const auto map_of = [](auto& values) { return CGAL::make_property_map(values); };
  std::size_t failures = 0;
  try
  {
    const SC::Camera seen_by = camera(data);
    std::vector<float> depths, normals;
    for(std::size_t k = 0; k < count; ++k)
    {
      depths.push_back(depth(data));
      const bool is_usual = data.ConsumeBool();
      for(int c = 0; c < 3; ++c)
        normals.push_back(is_usual ? data.ConsumeIntegral<std::int8_t>() / 1024.f + float(c == 2)
                                   : float(fuzz::number(data)));
    }
    const SC::G_buffer picture(width, height, depths.data(), normals.data(), seen_by,
                               data.PickValueInArray({SC::Normal_space::VIEW, SC::Normal_space::WORLD}));
    if(kind == 0)
      failures = SC::screen_space_curvatures(picture, SC::parameters::min_curvature_map(map_of(k_min))
                                                          .max_curvature_map(map_of(k_max))
                                                          .status_map(map_of(statuses)));
    else if(kind == 1)
      failures = SC::sphere_fit_mean_curvatures(
          picture,
          SC::parameters::mean_curvature_map(map_of(k_min)).status_map(map_of(statuses)).pixel_radius(2u));
    else
      failures = SC::ambient_occlusion(
          picture, SC::parameters::ambient_occlusion_map(map_of(light)).status_map(map_of(statuses)));
  }
  catch(const std::invalid_argument&)
  {
    return 0;
  }
  const char* const name = kind == 0   ? "screen_space_curvatures"
                           : kind == 1 ? "sphere_fit_mean_curvatures"
                                       : "ambient_occlusion";
  std::size_t failed = 0;
  for(std::size_t k = 0; k < count; ++k)
  {
    const SC::Estimation_status status = statuses[k];
    const bool is_estimated = SC::is_estimated(status);
    fuzz::require(status != SC::Estimation_status::CANCELLED, name, "there is no status");
    failed += !is_estimated && status != SC::Estimation_status::UNREFERENCED;
    const float value = kind == 2 ? light[k] : k_min[k];
    fuzz::require(is_estimated ? std::isfinite(value) : std::isnan(value), name, "a value isn't announced");
    if(kind == 0)
      fuzz::require(is_estimated ? std::isfinite(k_max[k]) && k_min[k] <= k_max[k] : std::isnan(k_max[k]),
                    name, "curvatures aren't ordered");
    if(kind == 2)
      fuzz::require(!is_estimated || (value >= 0.f && value <= 1.f), name, "light isn't in [0, 1]");
  }
  fuzz::require(failed == failures, name, "a wrong count");
  return 0;
}
