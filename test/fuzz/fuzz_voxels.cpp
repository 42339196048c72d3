#include "fuzzed_mesh.h"

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/curvature/Voxel_octree.h>
#include <Shape_characteristics/curvature/voxel_curvatures.h>
#include <Shape_characteristics/curvature/voxelize.h>

#include <CGAL/property_map.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <tuple>
#include <vector>

namespace {

namespace SC = Shape_characteristics;
using fuzz::Point_3;

void estimate(FuzzedDataProvider& data, const SC::Voxel_octree& octree)
{
  using Sample = std::tuple<Point_3, double, double, SC::Estimation_status>;
  std::vector<Sample> samples;
  for(const Point_3& p : octree.surface_points<fuzz::Kernel>())
    samples.emplace_back(p, 1e300, 1e300, SC::Estimation_status::CANCELLED);
  for(int k = data.ConsumeIntegralInRange<int>(0, 3); k > 0; --k)
    samples.emplace_back(Point_3(fuzz::number(data), fuzz::number(data), fuzz::number(data)), 1e300, 1e300,
                         SC::Estimation_status::CANCELLED);
  const auto maps = SC::parameters::point_map(CGAL::Nth_of_tuple_property_map<0, Sample>())
                        .mean_curvature_map(CGAL::Nth_of_tuple_property_map<1, Sample>())
                        .Gaussian_curvature_map(CGAL::Nth_of_tuple_property_map<2, Sample>())
                        .status_map(CGAL::Nth_of_tuple_property_map<3, Sample>());
  std::size_t failures =
      data.ConsumeBool() ? SC::voxel_curvatures(octree, samples, maps)
                         : SC::voxel_curvatures(octree, samples, maps.neighbor_radius(fuzz::number(data)));
  for(const auto& [p, mean, Gaussian, status] : samples)
  {
    const bool is_estimated = SC::is_estimated(status);
    fuzz::require(status != SC::Estimation_status::CANCELLED, "voxel_curvatures", "there is no status");
    fuzz::require(is_estimated ? std::isfinite(mean) : std::isnan(mean) && std::isnan(Gaussian),
                  "voxel_curvatures", "a value isn't announced");
    failures -= !is_estimated;
  }
  fuzz::require(failures == 0, "voxel_curvatures", "a wrong count");
}

} // namespace

// Voxels with values of all kinds, or made of meshes, and the curvatures of what they show.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  FuzzedDataProvider data(bytes, size);
  try
  {
    if(data.ConsumeBool())
    {
      const fuzz::Mesh mesh = fuzz::mesh(data);
      double low = 0., high = 0.;
      for(const auto v : mesh.vertices())
        for(const double x : {mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()})
        {
          low = x < low ? x : low;
          high = x > high ? x : high;
        }
      estimate(data, SC::voxelize(mesh, (high - low) / data.ConsumeIntegralInRange<int>(1, 12)));
      return 0;
    }
    const SC::Voxel_octree::Voxel count = {data.ConsumeIntegralInRange<std::size_t>(0, 9),
                                           data.ConsumeIntegralInRange<std::size_t>(0, 9),
                                           data.ConsumeIntegralInRange<std::size_t>(0, 9)};
    const double factor = fuzz::scale(data);
    estimate(data, SC::Voxel_octree(count, Point_3(fuzz::number(data), 0., fuzz::number(data)),
                                    {factor, factor, factor * (data.ConsumeBool() ? 1. : 3.)},
                                    [&](std::size_t, std::size_t, std::size_t)
                                    {
                                      const int kind = data.ConsumeIntegralInRange<int>(0, 15);
                                      return kind == 0 ? fuzz::number(data) : kind < 8 ? 0. : 1.;
                                    }));
  }
  catch(const std::invalid_argument&)
  {}
  return 0;
}
