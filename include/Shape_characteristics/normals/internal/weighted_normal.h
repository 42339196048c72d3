#ifndef SHAPE_CHARACTERISTICS_NORMALS_INTERNAL_WEIGHTED_NORMAL_H
#define SHAPE_CHARACTERISTICS_NORMALS_INTERNAL_WEIGHTED_NORMAL_H

#include <Shape_characteristics/internal/length.h>
#include <Shape_characteristics/internal/lexicographically_smaller.h>
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

// a x b, to the last bit the opposite of b x a: one product of each difference may be fused with it, and then it matters which.
inline Eigen::Vector3d antisymmetric_cross(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  const bool swaps = lexicographically_smaller(b, a);
  const Eigen::Vector3d &p = swaps ? b : a, &q = swaps ? a : b;
  return (swaps ? -1. : 1.) * p.cross(q);
}

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
    area.value += antisymmetric_cross(a, b);
    area.error += rounding * (a_length * b_length + magnitude * (a_length + b_length));
  }
  return area;
}

// Whether the corner of a face with these edges' product turns the other way than the face, as some of a concave polygon do.
inline bool is_reflex(const Face_graph_samples& samples, std::size_t face, const Eigen::Vector3d& cross)
{
  return samples.degree(face) > 3 && cross.dot(doubled_area_vector(samples, face).value) < 0.;
}

// The same as `weighted_normal()` with Max's weights, without a square root, where it is plain that all the faces at the
// vertex and their sum are far from rounding errors, and that no product leaves the range of numbers. False elsewhere.
inline bool plain_max_normal(const Face_graph_samples& samples, std::size_t vertex, Eigen::Vector3d& normal)
{
  // Bounds of squares: (a + b)^2 <= 2 a^2 + 2 b^2, and the square of a sum of n errors <= n times that of their squares.
  constexpr double rounding = 4. * std::numeric_limits<double>::epsilon();
  constexpr double smallest = 1e-140, largest = 1e140;
  const Eigen::Vector3d& p = samples.point(vertex);
  const double magnitude = p.lpNorm<Eigen::Infinity>();
  const double factor = 2. * rounding * rounding, position = 2. * magnitude * magnitude;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double error = 0.;
  const auto [begin, end] = samples.incident_faces(vertex);
  for(const auto* f = begin; f != end; ++f)
  {
    const std::size_t n = samples.degree(*f), corner = samples.corner(*f, vertex);
    const Eigen::Vector3d to_next = samples.point(samples.vertex(*f, corner + 1 == n ? 0 : corner + 1)) - p;
    const Eigen::Vector3d to_previous =
        samples.point(samples.vertex(*f, corner == 0 ? n - 1 : corner - 1)) - p;
    const double next_square = to_next.squaredNorm(), previous_square = to_previous.squaredNorm();
    const double product = next_square * previous_square;
    const Eigen::Vector3d cross = antisymmetric_cross(to_next, to_previous);
    const double bound = factor * (product + position * (next_square + previous_square));
    if(!(cross.squaredNorm() > bound && product > smallest && product < largest))
      return false;
    const double weight = (is_reflex(samples, *f, cross) ? -1. : 1.) / product;
    sum += weight * cross;
    error += weight * weight * bound;
  }
  normal = sum;
  return sum.squaredNorm() > double(end - begin) * error;
}

// The sum of the weighted face normals at a vertex: zero where none of its faces has a normal, or they cancel.
// Faces with points that are not finite count for nothing.
inline Eigen::Vector3d
weighted_normal(const Face_graph_samples& samples, std::size_t vertex, Normal_weighting weighting)
{
  if(Eigen::Vector3d normal; weighting == Normal_weighting::MAX && plain_max_normal(samples, vertex, normal))
    return normal;

  constexpr double rounding = 4. * std::numeric_limits<double>::epsilon();
  const Eigen::Vector3d& p = samples.point(vertex);
  const double magnitude = p.lpNorm<Eigen::Infinity>();
  Rounded_vector sum;
  const auto [begin, end] = samples.incident_faces(vertex);
  for(const auto* f = begin; f != end; ++f)
  {
    const std::size_t n = samples.degree(*f), corner = samples.corner(*f, vertex);
    const Eigen::Vector3d to_next = samples.point(samples.vertex(*f, (corner + 1) % n)) - p;
    const Eigen::Vector3d to_previous = samples.point(samples.vertex(*f, (corner + n - 1) % n)) - p;
    const double next_length = length(to_next), previous_length = length(to_previous);

    // Of unit edges: squared lengths of tiny or huge ones would under- or overflow.
    const Eigen::Vector3d cross = antisymmetric_cross(to_next / next_length, to_previous / previous_length);
    Rounded_vector term;
    switch(weighting)
    {
    case Normal_weighting::MAX:
    {
      // the same bits whichever side the face shows
      const double shorter = (std::min)(next_length, previous_length);
      const double longer = (std::max)(next_length, previous_length);
      term.value = (is_reflex(samples, *f, cross) ? -1. : 1.) * cross / longer / shorter;
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
      {
        const double angle =
            std::atan2(cross.norm(), (to_next / next_length).dot(to_previous / previous_length));
        weight *= is_reflex(samples, *f, cross) ? 2. * CGAL_PI - angle : angle;
      }
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
