#ifndef SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_TRIANGLE_SHAPE_OPERATOR_H
#define SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_TRIANGLE_SHAPE_OPERATOR_H

#include <Shape_characteristics/curvature/internal/shape_operator.h>
#include <Shape_characteristics/internal/length.h>
#include <Shape_characteristics/internal/tangent_basis.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

namespace Shape_characteristics {
namespace internal {

// A symmetric bilinear form on vectors of space.
struct Symmetric_form
{
  double xx = 0., xy = 0., xz = 0., yy = 0., yz = 0., zz = 0.;

  double operator()(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const
  {
    return a.x() * (xx * b.x() + xy * b.y() + xz * b.z()) + a.y() * (xy * b.x() + yy * b.y() + yz * b.z()) +
           a.z() * (xz * b.x() + yz * b.y() + zz * b.z());
  }
};

// The shape operator of a triangle, from the differences of the normals along its edges (Rusinkiewicz 2004; thesis,
// equations 5.1 and 7.1 to 7.9). Convex positive.
//
// The side of the triangle that is outside is the one to which the normals point, whatever the order of its vertices:
// flipping all the normals flips the signs of the operator and of nothing else, bit for bit.
class Triangle_shape_operator
{
public:
  // `number_of_edges`: all three, or the two at the second vertex
  Triangle_shape_operator(const Face_graph_samples& samples, std::size_t face, unsigned int number_of_edges)
  {
    for(std::size_t k = 0; k < 3; ++k)
      if(!samples.is_usable(samples.vertex(face, k)))
        return;

    std::array<Eigen::Vector3d, 3> edge, difference;
    Eigen::Vector3d sum_of_normals = Eigen::Vector3d::Zero();
    std::array<double, 3> lengths;
    for(std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t a = samples.vertex(face, k), b = samples.vertex(face, (k + 1) % 3);
      edge[k] = samples.point(b) - samples.point(a);
      difference[k] = samples.normal(b) - samples.normal(a);
      sum_of_normals += samples.normal(a);
      lengths[k] = length(edge[k]);
    }
    // Of edges of unit size: neither squares of tiny nor of huge ones are in the range of numbers.
    const std::size_t longest =
        std::size_t(std::max_element(lengths.begin(), lengths.end()) - lengths.begin());
    m_size = lengths[longest];
    if(!(m_size > 0. && std::isfinite(m_size)))
      return;
    for(Eigen::Vector3d& e : edge)
      e /= m_size;

    const Eigen::Vector3d cross = edge[longest].cross(edge[(longest + 1) % 3]);
    const double doubled_area = cross.norm();
    if(!(doubled_area > 4. * std::numeric_limits<double>::epsilon()))
      return;
    m_normal = cross / doubled_area;
    if(m_normal.dot(sum_of_normals) < 0.)
      m_normal = -m_normal;
    m_u = edge[longest].normalized();
    m_v = m_normal.cross(m_u);

    // The normal equations of (7.5). Their determinant is a square of the area: computed as such, nothing cancels.
    double p = 0., q = 0., r = 0., s_l = 0., s_m = 0., s_n = 0.;
    for(std::size_t k = 0; k < number_of_edges; ++k)
    {
      const double u = edge[k].dot(m_u), v = edge[k].dot(m_v);
      const double d_u = difference[k].dot(m_u), d_v = difference[k].dot(m_v);
      p += u * u;
      q += u * v;
      r += v * v;
      s_l += u * d_u;
      s_m += v * d_u + u * d_v;
      s_n += v * d_v;
    }
    const double d = (number_of_edges == 3 ? 3. : 1.) * doubled_area * doubled_area; // p r - q^2
    const double b1 = r * r + d, b2 = -q * r, b3 = q * q, b4 = p * r, b5 = -p * q, b6 = p * p + d;
    const double factor = 1. / ((p + r) * d) / m_size;
    m_l = (b1 * s_l + b2 * s_m + b3 * s_n) * factor;
    m_m = (b2 * s_l + b4 * s_m + b5 * s_n) * factor;
    m_n = (b3 * s_l + b5 * s_m + b6 * s_n) * factor;

    const std::array<double, 3> squares = {edge[0].squaredNorm(), edge[1].squaredNorm(),
                                           edge[2].squaredNorm()};
    m_area = .5 * doubled_area * m_size * m_size;
    for(std::size_t k = 0; k < 3; ++k)
      m_corner_areas[k] = corner_area(edge, squares, doubled_area, k) * m_size * m_size;
    m_is_valid = std::isfinite(m_l) && std::isfinite(m_m) && std::isfinite(m_n);
  }

  // false if points or normals aren't finite, or the triangle has no area compared to its edges
  bool is_valid() const { return m_is_valid; }
  const Eigen::Vector3d& normal() const { return m_normal; }
  double area() const { return m_area; }
  // the part of the area that belongs to the `k`-th vertex (Meyer et al. 2003): Voronoi, unless an angle is obtuse
  const std::array<double, 3>& corner_areas() const { return m_corner_areas; }

  Shape_operator_eigen eigen() const { return eigen_of_shape_operator(m_normal, m_l, m_m, m_n, m_u, m_v); }

  Symmetric_form form() const
  {
    const auto entry = [&](const Eigen::Index i, const Eigen::Index j)
    { return m_l * m_u[i] * m_u[j] + m_m * (m_u[i] * m_v[j] + m_v[i] * m_u[j]) + m_n * m_v[i] * m_v[j]; };
    return {entry(0, 0), entry(0, 1), entry(0, 2), entry(1, 1), entry(1, 2), entry(2, 2)};
  }

private:
  static double corner_area(const std::array<Eigen::Vector3d, 3>& edge,
                            const std::array<double, 3>& squares,
                            double doubled_area,
                            std::size_t k)
  {
    const std::size_t next = (k + 1) % 3, previous = (k + 2) % 3;
    // products of the edges at each corner: the angles' cosines, up to a positive factor
    const double at_k = -edge[previous].dot(edge[k]), at_next = -edge[k].dot(edge[next]),
                 at_previous = -edge[next].dot(edge[previous]);
    if(at_k < 0.)
      return .25 * doubled_area;
    if(at_next < 0. || at_previous < 0.)
      return .125 * doubled_area;
    return .125 * (squares[k] * at_previous + squares[previous] * at_next) / doubled_area;
  }

  bool m_is_valid = false;
  double m_size = 0., m_area = 0., m_l = 0., m_m = 0., m_n = 0.;
  std::array<double, 3> m_corner_areas{};
  Eigen::Vector3d m_normal, m_u, m_v;
};

// The weighted mean of the shape operators of the faces at a vertex, in the vertex's tangent plane. Each is turned with
// the shortest rotation from the plane of its face to that of the vertex (not projected, which would shrink it).
class Mean_shape_operator
{
public:
  explicit Mean_shape_operator(const Eigen::Vector3d& normal) : m_normal(normal)
  {
    tangent_basis(normal, m_t1, m_t2);
  }

  void add(const Eigen::Vector3d& face_normal, const Symmetric_form& form, double weight)
  {
    const double cosine = m_normal.dot(face_normal);
    const Eigen::Vector3d sum = m_normal + face_normal;
    // where the normals are opposite, any half turn is shortest, and the operator, being quadratic, is the same
    // whether the tangents are negated or not
    const double factor = 1. + cosine > std::numeric_limits<double>::epsilon() ? 1. / (1. + cosine) : 0.;
    const Eigen::Vector3d r1 = m_t1 - (face_normal.dot(m_t1) * factor) * sum;
    const Eigen::Vector3d r2 = m_t2 - (face_normal.dot(m_t2) * factor) * sum;
    m_l += weight * form(r1, r1);
    m_m += weight * form(r1, r2);
    m_n += weight * form(r2, r2);
    m_weight += weight;
  }

  // whether any face had a weight
  bool is_valid() const { return m_weight > 0.; }

  Shape_operator_eigen eigen() const
  {
    return eigen_of_shape_operator(m_normal, m_l / m_weight, m_m / m_weight, m_n / m_weight, m_t1, m_t2);
  }

private:
  Eigen::Vector3d m_normal, m_t1, m_t2;
  double m_l = 0., m_m = 0., m_n = 0., m_weight = 0.;
};

// the place of vertex `i` among those of triangle `f`
inline std::size_t corner_of(const Face_graph_samples& samples, std::size_t f, std::size_t i)
{
  return samples.vertex(f, 0) == i ? 0 : samples.vertex(f, 1) == i ? 1 : 2;
}

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

inline void require_triangles(const Face_graph_samples& samples, const std::string& function)
{
  if(!samples.is_triangle_mesh())
    throw std::invalid_argument("Shape_characteristics: " + function +
                                " needs triangles, but the mesh has a face with another number of vertices");
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_TRIANGLE_SHAPE_OPERATOR_H
