#include "signals.h"

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/hrbf_curvatures.h>
#include <Shape_characteristics/descriptors/Chirality_descriptor.h>
#include <Shape_characteristics/descriptors/Descriptor_matrix.h>
#include <Shape_characteristics/descriptors/Signed_volume_descriptor.h>
#include <Shape_characteristics/descriptors/Symmetry_flux_descriptor.h>
#include <Shape_characteristics/descriptors/compute_descriptors.h>
#include <Shape_characteristics/sampling/Point_set_samples.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace registration {
namespace {

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using SC::Point_set_samples;

std::vector<float> column(const SC::Descriptor_matrix& matrix, Eigen::Index k)
{
  std::vector<float> values;
  for(Eigen::Index i = 0; i < matrix.values.rows(); ++i)
    values.push_back(std::isfinite(matrix.values(i, k)) ? matrix.values(i, k) : 0.f);
  return values;
}

} // namespace

Signals signals_of(const Scan& scan, double radius, double radius_of_chirality, double scale)
{
  Scan scaled = scan;
  std::vector<Kernel::Point_3> points;
  std::vector<Kernel::Vector_3> normals;
  std::vector<std::size_t> numbers;
  for(std::size_t i = 0; i < scan.points.size(); ++i)
  {
    Eigen::Vector3d& p = scaled.points[i];
    p *= scale;
    points.emplace_back(p.x(), p.y(), p.z());
    normals.emplace_back(scan.normals[i].x(), scan.normals[i].y(), scan.normals[i].z());
    numbers.push_back(i);
  }
  std::vector<double> mean(points.size()), Gaussian(points.size()), curvedness(points.size());
  SC::hrbf_curvatures<CGAL::Sequential_tag>(numbers,
                                            SC::parameters::point_map(CGAL::make_property_map(points))
                                                .normal_map(CGAL::make_property_map(normals))
                                                .mean_curvature_map(CGAL::make_property_map(mean))
                                                .Gaussian_curvature_map(CGAL::make_property_map(Gaussian)));
  for(std::size_t i = 0; i < points.size(); ++i)
    curvedness[i] = std::sqrt((std::max)(2. * mean[i] * mean[i] - Gaussian[i], 0.)); // NaN stays NaN

  using Tag = CGAL::Sequential_tag;
  Signals result;
  const Point_set_samples small = samples_of(scaled, radius * scale);
  result.flux =
      column(SC::compute_descriptors<Tag>(SC::Symmetry_flux_descriptor<Point_set_samples>(
                                              small, SC::Flux_method::POINTS, SC::Signal_scaling::AS_PRINTED),
                                          small.size()),
             0);
  const SC::Descriptor_matrix volumes = SC::compute_descriptors<Tag>(
      SC::Signed_volume_descriptor<Point_set_samples>(
          small, mean, Gaussian, SC::Signed_volume_method::EXTREMA, SC::Signal_scaling::AS_PRINTED),
      small.size());
  result.mean_volume = column(volumes, 0);
  result.Gaussian_volume = column(volumes, 1);
  const Point_set_samples large = samples_of(scaled, radius_of_chirality * scale);
  result.chirality =
      column(SC::compute_descriptors<Tag>(
                 SC::Chirality_descriptor<Point_set_samples>(large, mean, curvedness), large.size()),
             0);
  return result;
}

} // namespace registration
