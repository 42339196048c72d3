#include "fuzzed_data.h"

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/height_grid_curvatures.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace {

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Curvatures = SC::Principal_curvatures_and_directions<Kernel>;

void require(bool holds, const char* complaint)
{
  fuzz::require(holds, "height_grid_curvatures", complaint);
}

} // namespace

// Grids with holes and heights of all sizes; rows that are not full, and spacings that are none.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  FuzzedDataProvider data(bytes, size);
  const std::size_t columns = data.ConsumeIntegralInRange<std::size_t>(0, 9);
  const double spacing_u = fuzz::number(data), spacing_v = fuzz::number(data);
  std::vector<double> heights;
  for(std::size_t n = columns * data.ConsumeIntegralInRange<std::size_t>(0, 9) + data.ConsumeBool(); n > 0;
      --n)
    heights.push_back(fuzz::number(data));

  std::vector<Curvatures> curvatures(heights.size());
  std::vector<SC::Estimation_status> statuses(heights.size(), SC::Estimation_status::CANCELLED);
  std::size_t failures = 0;
  try
  {
    failures = SC::height_grid_curvatures(
        heights, columns, spacing_u, spacing_v,
        SC::parameters::principal_curvatures_and_directions_map(CGAL::make_property_map(curvatures))
            .status_map(CGAL::make_property_map(statuses)));
  }
  catch(const std::invalid_argument&)
  {
    const bool fills_rows = heights.empty() || (columns != 0 && heights.size() % columns == 0);
    const bool has_spacings =
        spacing_u > 0. && std::isfinite(spacing_u) && spacing_v > 0. && std::isfinite(spacing_v);
    require(!fills_rows || !has_spacings, "refuses a grid");
    return 0;
  }
  for(std::size_t k = 0; k < heights.size(); ++k)
  {
    const Curvatures& c = curvatures[k];
    require(statuses[k] != SC::Estimation_status::CANCELLED, "there is no status");
    const bool is_estimated = SC::is_estimated(statuses[k]);
    require(is_estimated || std::isnan(c.min_curvature), "a value without an estimate");
    require(!is_estimated || (std::isfinite(c.min_curvature) && c.min_curvature <= c.max_curvature),
            "an estimate without a value");
    require(!is_estimated || std::abs(c.min_direction.squared_length() - 1.) < 1e-9,
            "a direction without a unit");
    failures -= !is_estimated;
  }
  require(failures == 0, "a wrong count");
  return 0;
}
