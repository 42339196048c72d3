#include <boost/test/unit_test.hpp>

#include "height_field.h"
#include "oriented_cloud.h"

#include <Shape_characteristics/descriptors/Chirality_descriptor.h>
#include <Shape_characteristics/descriptors/Fpfh_descriptor.h>
#include <Shape_characteristics/descriptors/Pfh_descriptor.h>
#include <Shape_characteristics/descriptors/Shot_descriptor.h>
#include <Shape_characteristics/descriptors/Signed_volume_descriptor.h>
#include <Shape_characteristics/descriptors/Spin_image_descriptor.h>
#include <Shape_characteristics/descriptors/Symmetry_flux_descriptor.h>
#include <Shape_characteristics/descriptors/compute_descriptors.h>
#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/normals/vertex_normals.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(extraordinary_units)

// Lengths whose squares are out of the range of numbers. A unit that is a power of two leaves all digits of descriptors without a unit
// as they are.
using namespace oriented_cloud;
using Kernel = height_field_test::Kernel;
using Named_matrices = std::vector<std::pair<std::string, SC::Descriptor_matrix>>;

namespace {

constexpr int exponents[] = {-1000, -560, -500, -400, 400, 500, 560, 1000};

template <typename Surface, typename Descriptor>
SC::Descriptor_matrix compute(const Surface& surface, const Descriptor& descriptor)
{
  return SC::compute_descriptors<CGAL::Sequential_tag>(descriptor, surface.size());
}

// some measure per sample, with the unit of a curvature
template <typename Surface>
std::vector<double> measure(const Surface& surface, double factor, double unit)
{
  std::vector<double> values;
  for(std::size_t i = 0; i < surface.size(); ++i)
    values.push_back(std::sin(factor * double(i)) / unit);
  return values;
}

// those that need no curvature, and those that do
template <typename Surface>
Named_matrices descriptors_of(const Surface& surface, double unit)
{
  using SC::Signed_volume_method;
  Named_matrices result = {
      {"FPFH", compute(surface, SC::Fpfh_descriptor<Surface>(surface))},
      {"PFH", compute(surface, SC::Pfh_descriptor<Surface>(surface))},
      {"SHOT", compute(surface, SC::Shot_descriptor<Surface>(surface))},
      {"spin image", compute(surface, SC::Spin_image_descriptor<Surface>(surface))},
      {"flux", compute(surface, SC::Symmetry_flux_descriptor<Surface>(surface))},
      {"chirality", compute(surface, SC::Chirality_descriptor<Surface>(surface, measure(surface, 1., unit),
                                                                       measure(surface, 2., unit)))}};
  for(const auto method : {Signed_volume_method::EXTREMA, Signed_volume_method::BINS})
    result.emplace_back("volumes", compute(surface, SC::Signed_volume_descriptor<Surface>(
                                                        surface, measure(surface, 3., unit),
                                                        measure(surface, 4., unit * unit), method)));
  return result;
}

// Gaussian curvatures may be out of the range of numbers: then there are no volumes.
void check(const Named_matrices& a, const Named_matrices& b, bool is_in_range)
{
  for(std::size_t k = 0; k < a.size(); ++k)
    BOOST_TEST_CONTEXT(a[k].first)
    {
      const bool differs = !is_in_range && a[k].first == "volumes";
      BOOST_TEST((differs ? is_consistent(b[k].second) : same_bits(a[k].second, b[k].second)));
      BOOST_TEST(is_consistent(a[k].second));
    }
}

} // namespace

BOOST_AUTO_TEST_CASE(point_sets)
{
  const Cloud cloud = wavy_cloud(250, 4);
  for(const bool is_ball : {true, false})
  {
    const auto neighborhood = [&](double unit)
    { return is_ball ? SC::Neighborhood::ball(.4 * unit) : SC::Neighborhood::nearest(20); };
    const Named_matrices expected = descriptors_of(samples_of(cloud, neighborhood(1.)), 1.);
    for(const int e : exponents)
      BOOST_TEST_CONTEXT("2^" << e << (is_ball ? ", ball" : ", nearest"))
      {
        const double unit = std::ldexp(1., e);
        Cloud scaled = cloud;
        for(Vector3d& p : scaled.points)
          p *= unit;
        check(expected, descriptors_of(samples_of(scaled, neighborhood(unit)), unit), std::abs(e) < 510);
      }
  }
}

BOOST_AUTO_TEST_CASE(meshes)
{
  height_field_test::Mesh mesh = height_field_test::height_field(1., .8, 12, height_field_test::wave);
  const auto normals =
      mesh.add_property_map<height_field_test::Mesh::Vertex_index, Kernel::Vector_3>("n").first;
  SC::vertex_normals(mesh, normals);
  for(const bool is_ball : {true, false})
  {
    const auto fluxes_of = [&](const height_field_test::Mesh& m, double unit)
    {
      const SC::Face_graph_samples samples = SC::sampled_surface<CGAL::Sequential_tag>(
          m, is_ball ? SC::Neighborhood::ball(.4 * unit) : SC::Neighborhood::rings(2),
          SC::parameters::vertex_normal_map(normals), SC::Face_graph_samples::Connectivity::FACES);
      Named_matrices result = descriptors_of(samples, unit);
      for(const auto method : {SC::Flux_method::CLIPPED_TRIANGLES, SC::Flux_method::BOUNDARY})
        result.emplace_back(
            "flux of faces",
            compute(samples, SC::Symmetry_flux_descriptor<SC::Face_graph_samples>(samples, method)));
      return result;
    };
    const Named_matrices expected = fluxes_of(mesh, 1.);
    for(const int e : exponents)
      BOOST_TEST_CONTEXT("2^" << e << (is_ball ? ", ball" : ", rings"))
      {
        const double unit = std::ldexp(1., e);
        height_field_test::Mesh scaled = mesh;
        for(const auto v : scaled.vertices())
        {
          const Kernel::Point_3 p = scaled.point(v);
          scaled.point(v) = Kernel::Point_3(unit * p.x(), unit * p.y(), unit * p.z());
        }
        check(expected, fluxes_of(scaled, unit), std::abs(e) < 510);
      }
  }
}

BOOST_AUTO_TEST_SUITE_END()
