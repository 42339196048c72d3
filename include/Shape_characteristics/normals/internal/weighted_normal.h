#ifndef SHAPE_CHARACTERISTICS_NORMALS_INTERNAL_WEIGHTED_NORMAL_H
#define SHAPE_CHARACTERISTICS_NORMALS_INTERNAL_WEIGHTED_NORMAL_H

#include <Shape_characteristics/internal/length.h>
#include <Shape_characteristics/normals/Normal_weighting.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// twice the area vector of a polygon, which need not be planar
inline Eigen::Vector3d doubled_area_vector(const Face_graph_samples& samples, std::size_t face)
{
  const Eigen::Vector3d& origin = samples.point(samples.vertex(face, 0));
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for(std::size_t k = 1; k + 1 < samples.degree(face); ++k)
    sum += (samples.point(samples.vertex(face, k)) - origin)
               .cross(samples.point(samples.vertex(face, k + 1)) - origin);
  return sum;
}

// The sum of the weighted face normals at a vertex: zero where none of its faces has a normal.
// Faces with points that are not finite count for nothing.
inline Eigen::Vector3d
weighted_normal(const Face_graph_samples& samples, std::size_t vertex, Normal_weighting weighting)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const auto [begin, end] = samples.incident_faces(vertex);
  for(const auto* f = begin; f != end; ++f)
  {
    const std::size_t n = samples.degree(*f);
    std::size_t corner = 0;
    while(samples.vertex(*f, corner) != vertex)
      ++corner;
    const Eigen::Vector3d& p = samples.point(vertex);
    const Eigen::Vector3d to_next = samples.point(samples.vertex(*f, (corner + 1) % n)) - p;
    const Eigen::Vector3d to_previous = samples.point(samples.vertex(*f, (corner + n - 1) % n)) - p;
    const double next_length = length(to_next), previous_length = length(to_previous);

    // Of unit edges: squared lengths of tiny or huge ones would under- or overflow.
    const Eigen::Vector3d cross = (to_next / next_length).cross(to_previous / previous_length);
    Eigen::Vector3d term;
    switch(weighting)
    {
    case Normal_weighting::MAX:
      term = cross / next_length / previous_length;
      break;
    case Normal_weighting::AREA:
      term = doubled_area_vector(samples, *f);
      break;
    default:
    {
      const Eigen::Vector3d area = doubled_area_vector(samples, *f);
      term = area / length(area);
      if(weighting == Normal_weighting::ANGLE)
        term *= std::atan2(cross.norm(), (to_next / next_length).dot(to_previous / previous_length));
    }
    }
    if(term.allFinite())
      sum += term;
  }
  return sum;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_NORMALS_INTERNAL_WEIGHTED_NORMAL_H
