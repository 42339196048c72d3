#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_INTERNAL_FOR_EACH_PIXEL_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_INTERNAL_FOR_EACH_PIXEL_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/characteristics/Gaussian_curvature.h>
#include <Shape_characteristics/characteristics/mean_curvature.h>
#include <Shape_characteristics/characteristics/shape_index.h>
#include <Shape_characteristics/sampling/for_each_sample.h>
#include <Shape_characteristics/screen_space/Screen_space_curvature.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// Writes what `value` makes of the results to the map that is called `tag`, if there is one.
template <typename Tag, typename NamedParameters, typename Value>
void write_map(const NamedParameters& np,
               Tag tag,
               const std::vector<Screen_space_curvature>& results,
               std::size_t first,
               std::size_t count,
               const Value& value)
{
  using parameters::get_parameter;
  using parameters::is_default_parameter;
  if constexpr(!is_default_parameter<NamedParameters, Tag>::value)
  {
    auto map = get_parameter(np, tag);
    for(std::size_t i = 0; i < count; ++i)
      put(map, first + i, value(results[i]));
  }
  else
  {
    (void)np, (void)tag, (void)results, (void)first, (void)count, (void)value;
  }
}

// Writes all maps and returns the number of pixels with a surface and without an estimate.
template <typename NamedParameters>
std::size_t write_pixels(const NamedParameters& np,
                         const std::vector<Screen_space_curvature>& results,
                         std::size_t first,
                         std::size_t count)
{
  using Curvature = Screen_space_curvature;
  const auto write = [&](auto tag, const auto& value) { write_map(np, tag, results, first, count, value); };
  write(internal_np::min_curvature_map, [](const Curvature& c) { return c.min_curvature; });
  write(internal_np::max_curvature_map, [](const Curvature& c) { return c.max_curvature; });
  write(internal_np::mean_curvature_map, [](const Curvature& c) { return mean_curvature(c); });
  write(internal_np::Gaussian_curvature_map, [](const Curvature& c) { return Gaussian_curvature(c); });
  write(internal_np::shape_index_map, [](const Curvature& c) { return shape_index(c); });
  write(internal_np::status_map, [](const Curvature& c) { return c.status; });
  std::size_t failures = 0;
  for(std::size_t i = 0; i < count; ++i)
    failures += !is_estimated(results[i].status) && results[i].status != Estimation_status::UNREFERENCED;
  return failures;
}

// Asks `estimator(x, y)` for each pixel and writes the maps, from one thread: bands of rows, so that memory doesn't grow with the picture.
// Returns the number of pixels with a surface and without an estimate.
template <typename ConcurrencyTag, typename GBuffer, typename Estimator, typename NamedParameters>
std::size_t for_each_pixel(const GBuffer& g_buffer, const Estimator& estimator, const NamedParameters& np)
{
  const std::size_t width = std::size_t(g_buffer.width()), size = width * std::size_t(g_buffer.height());
  const std::size_t band = (std::min)(size, (std::max)(width, std::size_t(1) << 17));
  std::vector<Screen_space_curvature> results(band);
  std::size_t failures = 0;
  for(std::size_t first = 0; first < size; first += band)
  {
    const std::size_t count = (std::min)(band, size - first);
    for_each_sample<ConcurrencyTag, No_workspace>(
        count,
        [&](std::size_t i, No_workspace&)
        { results[i] = estimator(int((first + i) % width), int((first + i) / width)); },
        std::function<bool(double)>(), 1024);
    failures += write_pixels(np, results, first, count);
  }
  return failures;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_INTERNAL_FOR_EACH_PIXEL_H
