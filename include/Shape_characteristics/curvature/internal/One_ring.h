#ifndef SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ONE_RING_H
#define SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ONE_RING_H

#include <Shape_characteristics/curvature/internal/Triangle_shape_operator.h>
#include <Shape_characteristics/internal/lexicographically_smaller.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// A triangle seen from one of its vertices: the other two, the lexicographically smaller first whatever side the
// triangle shows, so that sums over flipped triangles have the same bits.
struct Ring_triangle
{
  Face_graph_samples::Index first = 0, second = 0;
  Eigen::Vector3d a, b;                         // from the vertex to them, in the ring's unit
  double aa = 0., bb = 0., ab = 0.;             // squares and product
  double doubled_area = 0.;                     // never zero in a ring
  double first_corner = 0., second_corner = 0.; // of the mixed area below: on the sides of the edges a and b

  // of the angles at the other two vertices
  double cotangent_at_first() const { return (aa - ab) / doubled_area; }
  double cotangent_at_second() const { return (bb - ab) / doubled_area; }
  double angle() const { return std::atan2(doubled_area, ab); }
  // the part of the area that belongs to the vertex (Meyer et al. 2003): Voronoi, unless an angle is obtuse
  double corner_area() const { return first_corner + second_corner; }
};

// The triangles at a vertex that have an area and finite points and normals. Lengths are in a unit, a power of two, in
// which their squares are in the range of numbers.
class One_ring
{
public:
  using Workspace = std::vector<Ring_triangle>;

  One_ring(const Face_graph_samples& samples, std::size_t i, Workspace& workspace) : m_triangles(workspace)
  {
    m_triangles.clear();
    const auto [begin, end] = samples.incident_faces(i);
    double size = 0.;
    for(const auto* f = begin; f != end; ++f)
    {
      const std::size_t corner = samples.corner(*f, i);
      Ring_triangle t;
      t.first = samples.vertex(*f, corner == 2 ? 0 : corner + 1);
      t.second = samples.vertex(*f, corner == 0 ? 2 : corner - 1);
      if(lexicographically_smaller(samples.point(t.second), samples.point(t.first)))
        std::swap(t.first, t.second);
      t.a = samples.point(t.first) - samples.point(i);
      t.b = samples.point(t.second) - samples.point(i);
      if(!samples.is_usable(t.first) || !samples.is_usable(t.second) || !t.a.allFinite() || !t.b.allFinite())
        continue;
      size = (std::max)({size, t.a.lpNorm<Eigen::Infinity>(), t.b.lpNorm<Eigen::Infinity>()});
      m_triangles.push_back(t);
    }
    int exponent;
    std::frexp(size, &exponent);
    m_scale = std::ldexp(1., -(std::max)(exponent, std::numeric_limits<double>::min_exponent));
    m_triangles.erase(
        std::remove_if(m_triangles.begin(), m_triangles.end(), [&](Ring_triangle& t) { return !measure(t); }),
        m_triangles.end());
    m_is_complete = m_triangles.size() == std::size_t(end - begin);
  }

  const Workspace& triangles() const { return m_triangles; }
  // no triangle is missing
  bool is_complete() const { return m_is_complete; }
  // A curvature in the ring's unit times this is one in the unit of the points.
  double scale() const { return m_scale; }

private:
  // whether there is an area, compared to the edges
  bool measure(Ring_triangle& t) const
  {
    t.a *= m_scale;
    t.b *= m_scale;
    t.aa = t.a.squaredNorm();
    t.bb = t.b.squaredNorm();
    t.ab = t.a.dot(t.b);
    t.doubled_area = t.a.cross(t.b).norm();
    constexpr double rounding = 4. * std::numeric_limits<double>::epsilon();
    if(!(t.doubled_area > rounding * (std::max)(t.aa, t.bb)))
      return false;
    if(t.ab < 0.)
      t.first_corner = t.second_corner = .125 * t.doubled_area;
    else if(t.aa < t.ab || t.bb < t.ab)
      t.first_corner = t.second_corner = .0625 * t.doubled_area;
    else
    {
      t.first_corner = .125 * t.aa * t.cotangent_at_second();
      t.second_corner = .125 * t.bb * t.cotangent_at_first();
    }
    return true;
  }

  Workspace& m_triangles;
  double m_scale = 1.;
  bool m_is_complete = false;
};

// `tangent`, orthogonal to the unit vector `from`, turned with the shortest rotation that takes `from` to the unit vector `to`
inline Eigen::Vector3d
turned_tangent(const Eigen::Vector3d& tangent, const Eigen::Vector3d& from, const Eigen::Vector3d& to)
{
  // Where they are opposite, any half turn is shortest; quadratic forms are the same for a tangent and its opposite.
  const double denominator = 1. + from.dot(to);
  if(!(denominator > std::numeric_limits<double>::epsilon()))
    return tangent;
  return tangent - (to.dot(tangent) / denominator) * (from + to);
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ONE_RING_H
