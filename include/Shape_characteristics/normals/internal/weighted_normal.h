#ifndef SHAPE_CHARACTERISTICS_NORMALS_INTERNAL_WEIGHTED_NORMAL_H
#define SHAPE_CHARACTERISTICS_NORMALS_INTERNAL_WEIGHTED_NORMAL_H

#include <Shape_characteristics/internal/length.h>
#include <Shape_characteristics/normals/Normal_weighting.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// A vector, and a bound of the error that it has because coordinates are rounded: a vector no longer than that says
// nothing.
struct Rounded_vector
{
  Eigen::Vector3d value = Eigen::Vector3d::Zero();
  double error = 0.;

  bool is_significant() const { return value.allFinite() && length(value) > error; }
};

// twice the area vector of a polygon, which need not be planar
inline Rounded_vector doubled_area_vector(const Face_graph_samples& samples, std::size_t face)
{
  constexpr double rounding = 4. * std::numeric_limits<double>::epsilon();
  const Eigen::Vector3d& origin = samples.point(samples.vertex(face, 0));
  const double magnitude = origin.lpNorm<Eigen::Infinity>();
  Rounded_vector area;
  for(std::size_t k = 1; k + 1 < samples.degree(face); ++k)
  {
    const Eigen::Vector3d a = samples.point(samples.vertex(face, k)) - origin;
    const Eigen::Vector3d b = samples.point(samples.vertex(face, k + 1)) - origin;
    const double a_length = length(a), b_length = length(b);
    area.value += a.cross(b);
    area.error += rounding * (a_length * b_length + magnitude * (a_length + b_length));
  }
  return area;
}

// The sum of the weighted face normals at a vertex: zero where none of its faces has a normal, or they cancel.
// Faces with points that are not finite count for nothing.
inline Eigen::Vector3d
weighted_normal(const Face_graph_samples& samples, std::size_t vertex, Normal_weighting weighting)
{
  constexpr double rounding = 4. * std::numeric_limits<double>::epsilon();
  const Eigen::Vector3d& p = samples.point(vertex);
  const double magnitude = p.lpNorm<Eigen::Infinity>();
  Rounded_vector sum;
  const auto [begin, end] = samples.incident_faces(vertex);
  for(const auto* f = begin; f != end; ++f)
  {
    const std::size_t n = samples.degree(*f);
    std::size_t corner = 0;
    while(samples.vertex(*f, corner) != vertex)
      ++corner;
    const Eigen::Vector3d to_next = samples.point(samples.vertex(*f, (corner + 1) % n)) - p;
    const Eigen::Vector3d to_previous = samples.point(samples.vertex(*f, (corner + n - 1) % n)) - p;
    const double next_length = length(to_next), previous_length = length(to_previous);

    // Of unit edges: squared lengths of tiny or huge ones would under- or overflow.
    const Eigen::Vector3d cross = (to_next / next_length).cross(to_previous / previous_length);
    Rounded_vector term;
    switch(weighting)
    {
    case Normal_weighting::MAX:
    {
      // the same bits whichever side the face shows
      const double shorter = (std::min)(next_length, previous_length);
      const double longer = (std::max)(next_length, previous_length);
      term.value = cross / longer / shorter;
      term.error = rounding * (1. + magnitude / longer + magnitude / shorter) / longer / shorter;
      break;
    }
    case Normal_weighting::AREA:
      term = doubled_area_vector(samples, *f);
      break;
    default:
    {
      term = doubled_area_vector(samples, *f);
      double weight = 1. / length(term.value);
      if(weighting == Normal_weighting::ANGLE)
        weight *= std::atan2(cross.norm(), (to_next / next_length).dot(to_previous / previous_length));
      term.value *= weight;
      term.error *= weight;
    }
    }
    if(!term.is_significant())
      continue;
    sum.value += term.value;
    sum.error += term.error;
  }
  return sum.is_significant() ? sum.value : Eigen::Vector3d::Zero();
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_NORMALS_INTERNAL_WEIGHTED_NORMAL_H
