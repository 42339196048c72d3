#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_INTERNAL_AMBIENT_RAY_CASTER_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_INTERNAL_AMBIENT_RAY_CASTER_H

#include <Shape_characteristics/internal/CGAL_compatibility.h>
#include <Shape_characteristics/internal/tangent_basis.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// The faces of a mesh, asked how much of the light from all around reaches a point on them.
class Ambient_ray_caster
{
public:
  // Faces of more than three corners are cut into triangles; those without an area or with a coordinate that isn't finite are
  // left out.
  template <typename FaceGraph, typename PointMap>
  Ambient_ray_caster(const FaceGraph& mesh, const PointMap& point_map)
  {
    std::vector<Point> corners;
    for(const auto f : faces(mesh))
    {
      corners.clear();
      for(const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      {
        const auto& p = get(point_map, v);
        corners.emplace_back(CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2]));
      }
      for(std::size_t i = 2; i < corners.size(); ++i)
        add(corners[0], corners[i - 1], corners[i]);
    }
    if(m_triangles.empty())
      return;
    m_tree.rebuild(m_triangles.begin(), m_triangles.end());
    m_tree.accelerate_distance_queries(); // now: later several threads ask
    const auto box = m_tree.bbox();
    m_size = std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
    for(const double x : {box.xmin(), box.xmax(), box.ymin(), box.ymax(), box.zmin(), box.zmax()})
      m_largest_coordinate = (std::max)(m_largest_coordinate, std::abs(x));
  }

  bool is_empty() const noexcept { return m_triangles.empty(); }

  // the diagonal of the bounding box
  double size() const noexcept { return m_size; }

  // The share of the light, weighted by the cosine to `normal`, that reaches the point of the mesh nearest to `point` from directions in which
  // nothing is nearer than `reach` (infinite: nothing at all). Nothing if the mesh is farther from the point than `tolerance`.
  // `turn` in [0, 1) turns the pattern of rays.
  std::optional<double> light(const Eigen::Vector3d& point,
                              const Eigen::Vector3d& normal,
                              std::size_t number_of_rays,
                              double reach,
                              double tolerance,
                              double turn) const
  {
    if(is_empty())
      return std::nullopt;
    const auto nearest = m_tree.closest_point_and_primitive(Point(point[0], point[1], point[2]));
    const Eigen::Vector3d foot = vector(nearest.first - CGAL::ORIGIN);
    if(!((foot - point).norm() <= tolerance))
      return std::nullopt;
    Eigen::Vector3d up = vector(CGAL::cross_product((*nearest.second)[1] - (*nearest.second)[0],
                                                    (*nearest.second)[2] - (*nearest.second)[0]));
    up.normalize();
    if(up.dot(normal) < 0)
      up = -up;
    // above the rounding of the foot and of the intersections, below all that can be seen
    const double lift = 1e-9 * (m_largest_coordinate + m_size);
    const Eigen::Vector3d start = foot + lift * up;
    const Point origin(start[0], start[1], start[2]);

    Eigen::Vector3d s, t;
    tangent_basis(normal, s, t);
    std::size_t open = 0, cast = 0;
    for(std::size_t i = 0; i < number_of_rays; ++i)
    {
      // points spread evenly over the disc below a hemisphere: directions whose density is the cosine
      constexpr double golden_ratio = 0.61803398874989484820;
      const double q = (double(i) + .5) / double(number_of_rays);
      const double angle = 2 * CGAL_PI * (std::fmod(double(i) * golden_ratio, 1.) + turn);
      const Eigen::Vector3d direction =
          std::sqrt(q) * (std::cos(angle) * s + std::sin(angle) * t) + std::sqrt(1 - q) * normal;
      // interpolated normals lean over the faces they belong to; the smooth surface that they stand for isn't in its own way
      if(direction.dot(up) <= 0)
        continue;
      ++cast;
      open += is_open(origin, direction, reach) ? 1 : 0;
    }
    return cast == 0 ? 0. : double(open) / double(cast);
  }

private:
  using Kernel = CGAL::Simple_cartesian<double>;
  using Point = Kernel::Point_3;
  using Triangles = std::vector<Kernel::Triangle_3>;
  using Primitive = AABB_triangle_primitive_3<Kernel, Triangles::const_iterator>;
  using Tree = CGAL::AABB_tree<AABB_traits_3<Kernel, Primitive> >;

  template <typename Vector>
  static Eigen::Vector3d vector(const Vector& v)
  {
    return {v.x(), v.y(), v.z()};
  }

  void add(const Point& p, const Point& q, const Point& r)
  {
    for(const Point* corner : {&p, &q, &r})
      if(!(std::isfinite(corner->x()) && std::isfinite(corner->y()) && std::isfinite(corner->z())))
        return;
    const Kernel::Vector_3 normal = CGAL::cross_product(q - p, r - p);
    const double area = normal.squared_length();
    if(area > 0 && std::isfinite(area))
      m_triangles.emplace_back(p, q, r);
  }

  bool is_open(const Point& origin, const Eigen::Vector3d& direction, double reach) const
  {
    const Kernel::Vector_3 d(direction[0], direction[1], direction[2]);
    if(!(reach < 1e300)) // farther, the end might not be finite
      return !m_tree.do_intersect(Kernel::Ray_3(origin, d));
    return !m_tree.do_intersect(Kernel::Segment_3(origin, origin + reach * d));
  }

  Triangles m_triangles;
  Tree m_tree;
  double m_size = 0, m_largest_coordinate = 0;
};

// a number in [0, 1) for each pixel, without a pattern to be seen
inline double turn_of_pixel(std::size_t pixel) noexcept
{
  std::uint64_t x = (std::uint64_t(pixel) + 1) * 0x9E3779B97F4A7C15u;
  x ^= x >> 32;
  x *= 0xD6E8FEB86659FD93u;
  x ^= x >> 32;
  return double(x >> 11) * 0x1p-53;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_INTERNAL_AMBIENT_RAY_CASTER_H
