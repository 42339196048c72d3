#include "fuzzed_mesh.h"
#include "fuzzed_points.h"
#include "oriented_point_maps.h"

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/descriptors/Descriptor_matrix.h>
#include <Shape_characteristics/descriptors/chiralities.h>
#include <Shape_characteristics/descriptors/fpfh_descriptors.h>
#include <Shape_characteristics/descriptors/pfh_descriptors.h>
#include <Shape_characteristics/descriptors/shot_descriptors.h>
#include <Shape_characteristics/descriptors/signed_volumes.h>
#include <Shape_characteristics/descriptors/spin_image_descriptors.h>
#include <Shape_characteristics/descriptors/symmetry_fluxes.h>

#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace SC = Shape_characteristics;
using SC::Descriptor_matrix;

enum class Kind
{
  FPFH,
  PFH,
  SHOT,
  SPIN_IMAGES,
  CHIRALITIES,
  SIGNED_VOLUMES,
  SYMMETRY_FLUXES,
  kMaxValue = SYMMETRY_FLUXES
};

template <typename Input, typename NamedParameters>
Descriptor_matrix describe(Kind kind, FuzzedDataProvider& data, const Input& input, const NamedParameters& np)
{
  switch(kind)
  {
  case Kind::FPFH:
    return SC::fpfh_descriptors(
        input, np.fpfh_variant(data.PickValueInArray(
                   {SC::Fpfh_variant::PCL, SC::Fpfh_variant::PAPER, SC::Fpfh_variant::OPEN3D})));
  case Kind::PFH:
    return SC::pfh_descriptors(input, np);
  case Kind::SHOT:
    return SC::shot_descriptors(
        input, np.shot_variant(data.PickValueInArray({SC::Shot_variant::PAPER, SC::Shot_variant::PCL})));
  case Kind::SPIN_IMAGES:
    return SC::spin_image_descriptors(input, np);
  case Kind::CHIRALITIES:
    return SC::chiralities(input, np);
  case Kind::SIGNED_VOLUMES:
    return SC::signed_volumes(input, np);
  case Kind::SYMMETRY_FLUXES:
    return SC::symmetry_fluxes(input, np);
  }
  return {};
}

// what is wrong with descriptors of so many samples; empty if nothing is
std::string complaint(const Descriptor_matrix& matrix, std::size_t size)
{
  if(std::size_t(matrix.values.rows()) != size || matrix.status.size() != size)
    return "there isn't a row and a status for each sample";
  for(std::size_t i = 0; i < size; ++i)
  {
    const auto row = matrix.values.row(Eigen::Index(i));
    if(matrix.status[i] == SC::Estimation_status::CANCELLED)
      return "nobody cancelled anything";
    if(SC::is_estimated(matrix.status[i]) ? !row.allFinite() : !row.array().isNaN().all())
      return "sample " + std::to_string(i) + " is " + SC::to_string(matrix.status[i]) +
             ", and its row says otherwise";
  }
  return "";
}

} // namespace

// Meshes and point sets through one of the descriptors.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  FuzzedDataProvider data(bytes, size);
  const Kind kind = data.ConsumeEnum<Kind>();
  const std::string name = "descriptor " + std::to_string(int(kind));
  const bool has_radius = data.ConsumeBool();
  const double radius = fuzz::number(data);
  const unsigned int count = data.ConsumeIntegralInRange<unsigned int>(1, 30);
  namespace np = SC::parameters;
  try
  {
    if(data.ConsumeBool())
    {
      const fuzz::Mesh mesh = fuzz::mesh(data);
      if(!CGAL::is_triangle_mesh(mesh) && (kind == Kind::CHIRALITIES || kind == Kind::SIGNED_VOLUMES))
        return 0;
      fuzz::require(name,
                    complaint(has_radius ? describe(kind, data, mesh, np::neighbor_radius(radius))
                                         : describe(kind, data, mesh, np::number_of_rings(1u + count % 3u)),
                              mesh.number_of_vertices()));
    }
    else
    {
      const auto points = fuzz::points<test_support::Oriented_point>(data);
      const auto maps = test_support::oriented_point_maps();
      fuzz::require(name,
                    complaint(has_radius ? describe(kind, data, points, maps.neighbor_radius(radius))
                                         : describe(kind, data, points, maps.number_of_neighbors(count)),
                              points.size()));
    }
  }
  catch(const std::invalid_argument&)
  {
    fuzz::require(has_radius && !(radius > 0. && std::isfinite(radius)), name, "refuses what is usual");
  }
  return 0;
}
