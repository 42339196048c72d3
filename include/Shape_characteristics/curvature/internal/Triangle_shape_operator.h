#ifndef SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_TRIANGLE_SHAPE_OPERATOR_H
#define SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_TRIANGLE_SHAPE_OPERATOR_H

#include <Shape_characteristics/curvature/internal/shape_operator.h>
#include <Shape_characteristics/internal/is_tip.h>
#include <Shape_characteristics/internal/tangent_basis.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

namespace Shape_characteristics {
namespace internal {

// A unit normal and two tangents that complete it to a right-handed basis.
struct Tangent_frame
{
  Eigen::Vector3d normal, t1, t2;

  explicit Tangent_frame(const Eigen::Vector3d& n) : normal(n) { tangent_basis(n, t1, t2); }
};

// The shape operator of a triangle, from the differences of the normals along its edges (Rusinkiewicz 2004; thesis,
// equations 5.1 and 7.1 to 7.9), in the tangent plane of one of its vertices: turned there with the shortest rotation
// (not projected, which would shrink it). Convex positive.
//
// It is computed in the tangents that this rotation takes to those of the vertex. So it comes for each vertex anew, and
// nothing is kept of the triangles: reading that back would take as long.
//
// The side of the triangle that is outside is the one to which the normals point, whatever the order of its vertices:
// flipping all the normals flips the signs of the operator and of nothing else, bit for bit.
class Triangle_shape_operator
{
public:
  // of a triangle at vertex `i`; `number_of_edges`: all three, or the two at the second vertex
  Triangle_shape_operator(const Face_graph_samples& samples,
                          const Tangent_frame& frame,
                          std::size_t i,
                          std::size_t face,
                          unsigned int number_of_edges)
  {
    const std::size_t corner = samples.corner(face, i);
    const std::size_t next = samples.vertex(face, corner == 2 ? 0 : corner + 1),
                      previous = samples.vertex(face, corner == 0 ? 2 : corner - 1);
    if(!samples.is_usable(next) || !samples.is_usable(previous))
      return;

    // the edges from the vertex, and the one opposite of it
    Eigen::Vector3d a = samples.point(next) - samples.point(i),
                    b = samples.point(previous) - samples.point(i),
                    c = samples.point(previous) - samples.point(next);
    double aa = a.squaredNorm(), bb = b.squaredNorm(), cc = c.squaredNorm();
    double largest = (std::max)((std::max)(aa, bb), cc), scale = 1., unit_area = 1.;
    if(!(largest > 1e-40 && largest < 1e40))
    {
      // Neither products of tiny nor of huge edges are in the range of numbers. A power of two scales without rounding.
      const double size =
          (std::max)({a.lpNorm<Eigen::Infinity>(), b.lpNorm<Eigen::Infinity>(), c.lpNorm<Eigen::Infinity>()});
      if(!(size > 0. && std::isfinite(size)))
        return;
      int exponent;
      std::frexp(size, &exponent);
      exponent = (std::max)(exponent, std::numeric_limits<double>::min_exponent);
      scale = std::ldexp(1., -exponent);
      unit_area = 1. / scale / scale;
      for(Eigen::Vector3d* edge : {&a, &b, &c})
        *edge *= scale;
      aa = a.squaredNorm(), bb = b.squaredNorm(), cc = c.squaredNorm();
      largest = (std::max)((std::max)(aa, bb), cc);
    }

    const Eigen::Vector3d cross = a.cross(b);
    const double squared_area = cross.squaredNorm(); // of the parallelogram
    constexpr double rounding = 4. * std::numeric_limits<double>::epsilon();
    if(!(squared_area > rounding * rounding * largest * largest))
      return;
    const double doubled_area = std::sqrt(squared_area), inverse_area = 1. / doubled_area;
    const Eigen::Vector3d &n_i = samples.normal(i), &n_next = samples.normal(next),
                          &n_previous = samples.normal(previous);
    const double side = cross.dot(n_i + (n_next + n_previous)) < 0. ? -1. : 1.;
    const Eigen::Vector3d normal = cross * (side * inverse_area);

    // Where the normals are opposite, any half turn is shortest, and the operator, being quadratic, is the same whether the
    // tangents are negated or not.
    const double cosine = frame.normal.dot(normal);
    const double factor = 1. + cosine > std::numeric_limits<double>::epsilon() ? 1. / (1. + cosine) : 0.;
    const Eigen::Vector3d sum = frame.normal + normal;
    const Eigen::Vector3d u = frame.t1 - (normal.dot(frame.t1) * factor) * sum,
                          v = frame.t2 - (normal.dot(frame.t2) * factor) * sum;

    // The normal equations of (7.5). Their determinant is a square of the area: computed as such, nothing cancels.
    const double a_u = a.dot(u), a_v = a.dot(v), b_u = b.dot(u), b_v = b.dot(v);
    const Eigen::Vector3d of_a = n_next - n_i, of_b = n_previous - n_i;
    const double da_u = of_a.dot(u), da_v = of_a.dot(v), db_u = of_b.dot(u), db_v = of_b.dot(v);
    const double c_u = b_u - a_u, c_v = b_v - a_v, dc_u = db_u - da_u, dc_v = db_v - da_v;
    double p, q, r, s_l, s_m, s_n, d;
    if(number_of_edges == 3)
    {
      p = a_u * a_u + b_u * b_u + c_u * c_u;
      q = a_u * a_v + b_u * b_v + c_u * c_v;
      r = a_v * a_v + b_v * b_v + c_v * c_v;
      s_l = a_u * da_u + b_u * db_u + c_u * dc_u;
      s_m = a_v * da_u + b_v * db_u + c_v * dc_u + a_u * da_v + b_u * db_v + c_u * dc_v;
      s_n = a_v * da_v + b_v * db_v + c_v * dc_v;
      d = 3. * squared_area; // p r - q^2
    }
    else
    {
      const double w_a = corner == 2 ? 0. : 1., w_b = corner == 0 ? 0. : 1., w_c = corner == 1 ? 0. : 1.;
      p = w_a * a_u * a_u + w_b * b_u * b_u + w_c * c_u * c_u;
      q = w_a * a_u * a_v + w_b * b_u * b_v + w_c * c_u * c_v;
      r = w_a * a_v * a_v + w_b * b_v * b_v + w_c * c_v * c_v;
      s_l = w_a * a_u * da_u + w_b * b_u * db_u + w_c * c_u * dc_u;
      s_m =
          w_a * (a_v * da_u + a_u * da_v) + w_b * (b_v * db_u + b_u * db_v) + w_c * (c_v * dc_u + c_u * dc_v);
      s_n = w_a * a_v * da_v + w_b * b_v * db_v + w_c * c_v * dc_v;
      d = squared_area;
    }
    const double b2 = -q * r, b5 = -p * q;
    const double inverse = scale / ((p + r) * d);
    m_l = ((r * r + d) * s_l + b2 * s_m + q * q * s_n) * inverse;
    m_m = (b2 * s_l + p * r * s_m + b5 * s_n) * inverse;
    m_n = (q * q * s_l + b5 * s_m + (p * p + d) * s_n) * inverse;
    m_is_valid = std::isfinite(m_l + m_m + m_n);

    // products of the edges at each corner: the angles' cosines, up to a positive factor
    const double at_i = a.dot(b), at_next = -a.dot(c), at_previous = b.dot(c);
    m_area = .5 * doubled_area * unit_area;
    const double voronoi = .125 * (aa * at_previous + bb * at_next) * inverse_area * unit_area;
    const double elsewhere = at_next < 0. || at_previous < 0. ? .25 * m_area : voronoi;
    m_corner_area = at_i < 0. ? .5 * m_area : elsewhere;
  }

  // false if points or normals aren't finite, or the triangle has no area compared to its edges
  bool is_valid() const { return m_is_valid; }
  // the operator in the tangents of the vertex: [l m; m n]
  double l() const { return m_l; }
  double m() const { return m_m; }
  double n() const { return m_n; }
  double area() const { return m_area; }
  // the part of the area that belongs to the vertex (Meyer et al. 2003): Voronoi, unless an angle is obtuse
  double corner_area() const { return m_corner_area; }

private:
  bool m_is_valid = false;
  double m_l = 0., m_m = 0., m_n = 0., m_area = 0., m_corner_area = 0.;
};

// The weighted mean of the shape operators of the triangles at a vertex, in the vertex's tangent plane.
class Mean_shape_operator
{
public:
  void add(const Triangle_shape_operator& triangle, double weight)
  {
    m_l += weight * triangle.l();
    m_m += weight * triangle.m();
    m_n += weight * triangle.n();
    m_weight += weight;
  }

  // whether any triangle had a weight
  bool is_valid() const { return m_weight > 0.; }

  Shape_operator_eigen eigen(const Tangent_frame& frame) const
  {
    return eigen_of_shape_operator(frame.normal, m_l / m_weight, m_m / m_weight, m_n / m_weight, frame.t1,
                                   frame.t2);
  }

private:
  double m_l = 0., m_m = 0., m_n = 0., m_weight = 0.;
};

// what can be said of a vertex before its faces are looked at: ESTIMATED or BORDER to go on
inline Estimation_status
status_from_faces(const Face_graph_samples& samples, std::size_t i, Face_graph_samples::Workspace& workspace)
{
  const Estimation_status status = samples.status(i);
  if(!is_estimated(status))
    return status;
  const auto [begin, end] = samples.incident_faces(i);
  if(end - begin < 2 && samples.neighbors(i, 3, workspace).size() < 3)
    return Estimation_status::FEW_NEIGHBOURS;
  return status;
}

// The same of estimators that say what is at the vertex itself, and not around it: there is nothing to be said at the tip of a cone.
inline Estimation_status
status_at_vertex(const Face_graph_samples& samples, std::size_t i, Face_graph_samples::Workspace& workspace)
{
  const Estimation_status status = status_from_faces(samples, i, workspace);
  if(!is_estimated(status))
    return status;
  const std::size_t face = *samples.incident_faces(i).first, corner = samples.corner(face, i);
  const std::size_t j = samples.vertex(face, corner == 2 ? 0 : corner + 1);
  return is_beside_tip(samples.normal(i), samples.point(j) - samples.point(i), samples.normal(j)) &&
                 is_tip(samples, i, samples.neighbors(i, 0, workspace))
             ? Estimation_status::DEGENERATE
             : status;
}

inline void require_triangles(const Face_graph_samples& samples, const std::string& function)
{
  if(!samples.is_triangle_mesh())
    throw std::invalid_argument("Shape_characteristics: " + function +
                                " needs triangles, but the mesh has a face with another number of vertices");
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_TRIANGLE_SHAPE_OPERATOR_H
