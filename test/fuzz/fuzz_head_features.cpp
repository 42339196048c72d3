#include "fuzzed_mesh.h"

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/head_features/Head_descriptor.h>
#include <Shape_characteristics/head_features/Surface_handle.h>
#include <Shape_characteristics/head_features/Symmetry_detection.h>
#include <Shape_characteristics/head_features/deform_as_rigid_as_possible.h>
#include <Shape_characteristics/head_features/deform_by_handles.h>
#include <Shape_characteristics/head_features/detect_head_features.h>
#include <Shape_characteristics/head_features/detect_symmetry_plane.h>
#include <Shape_characteristics/head_features/head_descriptors.h>

#include <CGAL/boost/graph/helpers.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace SC = Shape_characteristics;
using fuzz::Mesh;
using fuzz::Point_3;
using fuzz::Vector_3;
using Handle = SC::Surface_handle<Mesh, fuzz::Kernel>;

void detect_plane(const Mesh& mesh)
{
  const auto symmetry = SC::detect_symmetry_plane(mesh);
  const auto& best = symmetry.best;
  fuzz::require(std::isfinite(best.plane.a()) && std::isfinite(best.plane.b()) &&
                    std::isfinite(best.plane.c()) && std::isfinite(best.plane.d()),
                "detect_symmetry_plane", "the plane isn't finite");
  fuzz::require(best.support >= 0. && best.support <= 1. && symmetry.confidence >= 0. &&
                    symmetry.confidence <= 1.,
                "detect_symmetry_plane", "a share isn't in [0, 1]");
  fuzz::require(symmetry.verdict != SC::Symmetry_verdict::NONE || symmetry.confidence == 0.,
                "detect_symmetry_plane", "confident of nothing");
}

void detect_features(const Mesh& mesh)
{
  const auto head = SC::detect_head_features(mesh, SC::parameters::head_is_aligned(true));
  for(const auto& f : head.points)
    fuzz::require(!f.is_found || (fuzz::is_finite(f.position) && mesh.is_valid(f.vertex) &&
                                  f.confidence >= 0. && f.confidence <= 1.),
                  "detect_head_features", "a feature without a place");
  for(const auto& r : head.regions)
    for(const auto v : r.vertices)
      fuzz::require(mesh.is_valid(v), "detect_head_features", "a region without its vertex");
}

void describe(const Mesh& mesh)
{
  Mesh copy = mesh;
  const auto descriptors =
      copy.add_property_map<Mesh::Vertex_index, SC::Head_descriptor>("v:descriptor").first;
  const auto statuses =
      copy.add_property_map<Mesh::Vertex_index>("v:status", SC::Estimation_status::CANCELLED).first;
  std::size_t failures = SC::head_descriptors(
      copy, SC::parameters::vertex_head_descriptor_map(descriptors).vertex_status_map(statuses));
  for(const auto v : copy.vertices())
  {
    const SC::Head_descriptor& d = descriptors[v];
    const auto is_in_unit_interval = [](double x) { return x >= 0. && x <= 1.; };
    const bool is_known = SC::is_estimated(statuses[v]);
    fuzz::require(is_known
                      ? !(std::abs(d.shape_index) > 1.) && is_in_unit_interval(d.curvedness) &&
                            is_in_unit_interval(d.mean_curvature) && is_in_unit_interval(d.Willmore_energy)
                      : std::isnan(d.shape_index) && std::isnan(d.Willmore_energy),
                  "head_descriptors",
                  (std::string(SC::to_string(statuses[v])) + ", " + std::to_string(d.shape_index) + ", " +
                   std::to_string(d.curvedness) + ", " + std::to_string(d.mean_curvature) + ", " +
                   std::to_string(d.Willmore_energy))
                      .c_str());
    failures -= !is_known;
  }
  fuzz::require(failures == 0, "head_descriptors", "a wrong count");
}

void deform(FuzzedDataProvider& data, Mesh& mesh)
{
  if(mesh.num_vertices() == 0)
    return;
  std::vector<Handle> handles(data.ConsumeIntegralInRange<std::size_t>(0, 3));
  for(Handle& h : handles)
  {
    for(int k = data.ConsumeIntegralInRange<int>(0, 3); k > 0; --k)
      h.points.emplace_back(
          Mesh::Vertex_index(data.ConsumeIntegralInRange<unsigned>(0, mesh.num_vertices() - 1)));
    const auto vector = [&] { return Vector_3(fuzz::number(data), fuzz::number(data), fuzz::number(data)); };
    h.radius = fuzz::number(data);
    if(data.ConsumeBool())
      h.displacement = vector();
    if(data.ConsumeBool())
    {
      h.center = CGAL::ORIGIN + vector();
      h.factor = fuzz::number(data);
      h.axis = vector();
      h.angle = fuzz::number(data);
    }
  }
  std::vector<Point_3> before;
  for(const auto v : mesh.vertices())
    before.push_back(mesh.point(v));
  std::size_t moved = 0;
  try
  {
    moved = data.ConsumeBool() ? SC::deform_by_handles(mesh, handles)
                               : SC::deform_as_rigid_as_possible(mesh, handles);
  }
  catch(const std::invalid_argument&) // the mesh stays as it is
  {}
  std::size_t changed = 0, k = 0;
  for(const auto v : mesh.vertices())
  {
    const Point_3 &p = before[k++], &q = mesh.point(v);
    if(!fuzz::is_finite(p) || p == q)
      continue;
    fuzz::require(fuzz::is_finite(q), "deformation", "a vertex is nowhere");
    ++changed;
  }
  fuzz::require(moved == changed, "deformation", "a wrong count");
}

} // namespace

// Meshes that are no heads, through what looks for features of heads, and through what deforms them.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  FuzzedDataProvider data(bytes, size);
  const int kind = data.ConsumeIntegralInRange<int>(0, 3);
  Mesh mesh = fuzz::mesh(data, 16);
  const bool has_triangles = CGAL::is_triangle_mesh(mesh);
  try
  {
    if(kind == 0)
      detect_plane(mesh);
    else if(kind == 1)
      detect_features(mesh);
    else if(kind == 2)
      describe(mesh);
    else
      deform(data, mesh);
  }
  catch(const std::invalid_argument& e) // of meshes with other faces
  {
    fuzz::require(!has_triangles, "head_features", e.what());
  }
  return 0;
}
