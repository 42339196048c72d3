#ifndef SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_BALL_SECTION_H
#define SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_BALL_SECTION_H

#include <Shape_characteristics/internal/tangent_basis.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace Shape_characteristics {
namespace internal {

// the integrals over a solid of 1, of x, and of x x^T
struct Volume_moments
{
  double volume = 0.;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
};

// The moments of the part of a polyhedral solid that lies in the unit ball around the origin, exact but for rounding.
//
// The divergence theorem with the field x g(x) / (k + 3) turns the integral of a g that is homogeneous of degree k into one
// over the plane faces, where the integrands are polynomials and the regions are bounded by segments and arcs, and into one
// of g over the part of the sphere that is in the solid. Harmonics of degree l are -1 / (l (l + 1)) times their Laplacian on
// the sphere: their integrals over that part are integrals over its border, which consists of arcs in the faces. What remains
// is its solid angle: the flux of x / |x|^3 is the same through all surfaces around the origin, so it is that of the cone of
// the solid at the origin less that of the faces in the ball.
//
// On all surfaces that rays from the origin make up, these fields are tangential. So where the surface of the solid has a
// border, what is computed is the solid that goes on beyond it along rays.
class Ball_section
{
  using Vector = Eigen::Vector3d;
  using Plane_vector = Eigen::Vector2d;

public:
  // The solid angle of the cone of the solid at the origin: 0 outside, 4 pi inside
  explicit Ball_section(double solid_angle_at_origin = 0.) : m_solid_angle(solid_angle_at_origin) {}

  // A plane polygon, counterclockwise seen from the side to which its unit normal points. `distance` is that of its plane
  // from the origin along the normal. `sign` is 1 if the normal points outward, -1 if it points inward.
  template <std::size_t N>
  void add_face(const std::array<Vector, N>& corners, const Vector& normal, double distance, double sign)
  {
    const double square = (1. - distance) * (1. + distance); // of the radius of the disk
    if(!(square > 0.))
      return;
    Vector u, v;
    tangent_basis(normal, u, v);
    if(u.cross(v).dot(normal) < 0.)
      u = -u;
    Plane_region region(distance, square);
    std::array<Plane_vector, N> p;
    for(std::size_t k = 0; k < N; ++k)
      p[k] = Plane_vector(corners[k].dot(u), corners[k].dot(v));
    for(std::size_t k = 0; k < N; ++k)
      region.add_edge(p[k], p[k + 1 == N ? 0 : k + 1]);
    region.close();

    const double radius = std::sqrt(square);
    const auto in_space = [&](const Plane_vector& x) -> Vector { return x.x() * u + x.y() * v; };
    const auto tensor = [&](double xx, double xy, double yy) -> Eigen::Matrix3d {
      return xx * u * u.transpose() + xy * (u * v.transpose() + v * u.transpose()) + yy * v * v.transpose();
    };
    // of the face
    const Vector first = in_space(region.first);
    const Eigen::Matrix3d normals = normal * normal.transpose();
    m_moments.volume += sign * distance / 3. * region.area;
    m_moments.first += sign * distance / 4. * (distance * region.area * normal + first);
    m_moments.second += sign * distance / 5. *
                        (distance * distance * region.area * normals +
                         distance * (normal * first.transpose() + first * normal.transpose()) +
                         tensor(region.second_xx, region.second_xy, region.second_yy));
    // of its arcs: there a point is distance * normal + radius * y, and the direction out of the solid on the sphere is
    // radius * normal - distance * y
    const double double_product = 2. * distance * radius;
    const Vector direction = in_space(region.direction);
    m_first_on_sphere -= .5 * sign * radius * (radius * region.angle * normal - distance * direction);
    m_second_on_sphere -=
        sign * radius / 6. *
        (double_product * (region.angle * normals -
                           tensor(region.direction_xx, region.direction_xy, region.direction_yy)) +
         (square - distance * distance) * (normal * direction.transpose() + direction * normal.transpose()));
    m_solid_angle -= sign * region.solid_angle;
  }

  // A part of the border of the surface, or of the cone at the origin: seen from there, the solid is bounded by the shorter
  // great arc from the direction of `p` to that of `q`. It is as a face that has the edge from the origin to `p` and that
  // from `q` to the origin, in this order; for directions that are opposite, `normal` is the normal of that face.
  void add_great_arc(const Vector& p, const Vector& q, const Vector& normal, double sign)
  {
    const Vector d = p.normalized(), e = q.normalized(), cross = d.cross(e);
    const double sine = cross.norm();
    if(!(sine > 0.) && !(d.dot(e) < 0.))
      return;
    const Vector m = sine > 1e-9 ? Vector(cross / sine) : normal;
    const double angle = std::atan2(sine, d.dot(e));
    const Vector sum = m.cross(d) - m.cross(e); // the integral of the points of the arc
    m_first_on_sphere -= .5 * sign * angle * m;
    m_second_on_sphere -= sign / 6. * (m * sum.transpose() + sum * m.transpose());
  }

  void add_solid_angle(double angle) { m_solid_angle += angle; }

  // the part of the segment from `p` to `q` that is in the ball; false if there is none
  static bool clip(Vector& p, Vector& q)
  {
    const Vector d = q - p;
    double begin = 0., end = 1.;
    if(!clip(d.squaredNorm(), p.dot(d), p.squaredNorm() - 1., begin, end))
      return false;
    const Vector start = p;
    p = start + begin * d;
    if(end < 1.)
      q = start + end * d;
    return true;
  }

  // of what was added
  Volume_moments moments() const
  {
    Volume_moments m = m_moments;
    m.volume += m_solid_angle / 3.;
    m.first += m_first_on_sphere / 4.;
    m.second += (m_second_on_sphere + m_solid_angle / 3. * Eigen::Matrix3d::Identity()) / 5.;
    return m;
  }

  // the signed solid angle of the triangle of three unit vectors (A. van Oosterom, J. Strackee, 1983)
  static double solid_angle(const Vector& a, const Vector& b, const Vector& c)
  {
    return 2. * std::atan2(a.dot(b.cross(c)), 1. + a.dot(b) + b.dot(c) + c.dot(a));
  }

private:
  // of the t in [0, 1] those with a t^2 + 2 b t + c < 0
  static bool clip(double a, double b, double c, double& begin, double& end)
  {
    const double discriminant = b * b - a * c;
    if(!(discriminant > 0.))
      return false;
    const double root = std::sqrt(discriminant);
    // neither cancels
    const double far = b > 0. ? -b - root : root - b;
    double t1 = far / a, t2 = c / far;
    if(b <= 0.)
      std::swap(t1, t2);
    begin = t1 > 0. ? t1 : 0.;
    end = t2 < 1. ? t2 : 1.;
    return begin < end;
  }

  // The part of a polygon that lies in the disk in which its plane meets the ball, as the sum over its edges of what lies
  // between the edge and the center of the disk: triangles, and sectors where the edge is outside
  struct Plane_region
  {
    double distance, square;
    double area = 0., second_xx = 0., second_xy = 0., second_yy = 0.;
    Plane_vector first = Plane_vector::Zero();
    // the integrals over the angles of the sectors of 1, of the direction y, and of y y^T
    double angle = 0., direction_xx = 0., direction_xy = 0., direction_yy = 0.;
    Plane_vector direction = Plane_vector::Zero();
    double solid_angle = 0.;

    Plane_region(double distance, double square) : distance(distance), square(square) {}

    static double cross(const Plane_vector& a, const Plane_vector& b)
    {
      return a.x() * b.y() - a.y() * b.x();
    }

    void add_edge(const Plane_vector& p, const Plane_vector& q)
    {
      const Plane_vector d = q - p;
      double begin = 0., end = 1.;
      if(!clip(d.squaredNorm(), p.dot(d), p.squaredNorm() - square, begin, end))
      {
        add_sector(p, q);
        return;
      }
      const Plane_vector from = p + begin * d, to = end < 1. ? Plane_vector(p + end * d) : q;
      if(begin > 0.)
        add_sector(p, from);
      add_triangle(from, to);
      if(end < 1.)
        add_sector(to, q);
    }

    void add_triangle(const Plane_vector& p, const Plane_vector& q)
    {
      const double c = cross(p, q);
      const Plane_vector sum = p + q;
      area += c / 2.;
      first += c / 6. * sum;
      second_xx += c / 24. * (p.x() * p.x() + q.x() * q.x() + sum.x() * sum.x());
      second_xy += c / 24. * (p.x() * p.y() + q.x() * q.y() + sum.x() * sum.y());
      second_yy += c / 24. * (p.y() * p.y() + q.y() * q.y() + sum.y() * sum.y());
      const double d = std::abs(distance), p_length = std::sqrt(p.squaredNorm() + d * d),
                   q_length = std::sqrt(q.squaredNorm() + d * d);
      if(d > 0.)
        solid_angle += 2. * std::atan2(c, p_length * q_length + d * (p_length + q_length) + d * d + p.dot(q));
    }

    void add_sector(const Plane_vector& p, const Plane_vector& q)
    {
      const Plane_vector d = p.normalized(), e = q.normalized();
      const double theta = std::atan2(cross(d, e), d.dot(e));
      const double sines = (e.x() * e.y() - d.x() * d.y()) / 2.;
      angle += theta;
      direction += Plane_vector(e.y() - d.y(), d.x() - e.x());
      direction_xx += theta / 2. + sines;
      direction_xy += (e.y() * e.y() - d.y() * d.y()) / 2.;
      direction_yy += theta / 2. - sines;
    }

    // adds the sectors
    void close()
    {
      area += square / 2. * angle;
      first += square * std::sqrt(square) / 3. * direction;
      const double factor = square * square / 4.;
      second_xx += factor * direction_xx;
      second_xy += factor * direction_xy;
      second_yy += factor * direction_yy;
      solid_angle += angle * (1. - std::abs(distance));
      if(!(std::abs(distance) > 0.))
        solid_angle = 0.;
      else if(distance < 0.)
        solid_angle = -solid_angle;
    }
  };

  Volume_moments m_moments; // the part of the faces
  Vector m_first_on_sphere = Vector::Zero();
  Eigen::Matrix3d m_second_on_sphere = Eigen::Matrix3d::Zero(); // of x x^T - 1/3
  double m_solid_angle;
};

// The moments of the part of a box that lies in the unit ball around the origin
inline Volume_moments box_in_ball(const Eigen::Vector3d& low, const Eigen::Vector3d& high)
{
  using Vector = Eigen::Vector3d;
  double solid_angle = 4. * CGAL_PI;
  for(int k = 0; k < 3; ++k)
    solid_angle *= low[k] < 0. && high[k] > 0. ? 1. : low[k] > 0. || high[k] < 0. ? 0. : .5;
  Ball_section section(solid_angle);
  for(int k = 0; k < 3; ++k)
  {
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    const Vector normal = Vector::Unit(k);
    for(const bool is_upper : {false, true})
    {
      const double distance = is_upper ? high[k] : low[k];
      const auto corner = [&](double x, double y)
      {
        Vector p;
        p[k] = distance;
        p[a] = x;
        p[b] = y;
        return p;
      };
      section.add_face(std::array<Vector, 4>{corner(low[a], low[b]), corner(high[a], low[b]),
                                             corner(high[a], high[b]), corner(low[a], high[b])},
                       normal, distance, is_upper ? 1. : -1.);
    }
  }
  return section.moments();
}

// The surface of a solid, as its moments in a ball show it.
struct Surface_of_moments
{
  std::array<double, 3> shape_operator; // in the tangent plane, in units of 1 / radius
  double height;                        // over the center of the ball, in units of the radius
};

// The surface of a solid whose moments in the unit ball around a point of it are `m`, over the tangent plane of the unit vectors t1
// and t2.
//
// Over the tangent plane the surface is the height -x^T S x / 2 + ...; odd terms cancel in the integrals over the disk, so
// that, up to the fourth power of the radius and relative to half of the ball, the volume is -pi / 8 tr S and the second
// moments are -pi / 48 (2 S + tr S). If the surface is at the height h over the point, the volume is by pi (h - h^3 / 3) larger,
// and the second moments by pi / 4 (h - 2 / 3 h^3 + h^5 / 5). Together they give tr S without h, but for its third power, which
// is then known.
//
// Of a plane, h is exact. Where it isn't small, that is all that can be said.
inline Surface_of_moments
surface_of_moments(const Volume_moments& m, const Eigen::Vector3d& t1, const Eigen::Vector3d& t2)
{
  const double volume = m.volume - 2. * CGAL_PI / 3., half_ball = 2. * CGAL_PI / 15.;
  const Eigen::Vector3d image_1 = m.second * t1, image_2 = m.second * t2;
  const double xx = t1.dot(image_1) - half_ball, yy = t2.dot(image_2) - half_ball;
  const double xy = .5 * (t1.dot(image_2) + t2.dot(image_1));
  const double trace = 48. / CGAL_PI * (volume / 2. - xx - yy);
  // h + 2 / 3 h^3 - 3 / 5 h^5, which grows up to h = 1
  const double first = volume / CGAL_PI + trace / 8.;
  double h = (std::min)((std::max)(first, -.9), .9);
  for(int step = 0; step < 4; ++step) // Newton's method
  {
    const double q = h * h;
    h -= (h * (1. + q * (2. / 3. - .6 * q)) - first) / (1. + q * (2. - 3. * q));
    h = (std::min)((std::max)(h, -.9), .9);
  }
  const double half_trace = .5 * (trace - h * h * h * (8. - 4.8 * h * h));
  const double factor = -24. / CGAL_PI;
  return {{half_trace + factor * (xx - yy) / 2., factor * xy, half_trace - factor * (xx - yy) / 2.}, h};
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_BALL_SECTION_H
