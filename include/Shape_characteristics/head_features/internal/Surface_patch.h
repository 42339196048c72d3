#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_SURFACE_PATCH_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_SURFACE_PATCH_H

#include <Shape_characteristics/head_features/internal/Head_surface.h>

#include <CGAL/Simple_cartesian.h>

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

// Some triangles of a surface, parts of which may count for less, and where they are nearest to a place.
class Surface_patch
{
public:
  // `spacing`: about how far apart the samples are that stand for the area; `weight`: how much the area at a place counts
  template <typename Weight>
  Surface_patch(const Head_surface& surface,
                std::vector<std::size_t> triangles,
                double spacing,
                const Weight& weight)
    : m_surface(&surface),
      m_triangles(std::move(triangles))
  {
    for(const std::size_t t : m_triangles)
      sample(t, spacing, weight);
  }

  bool is_empty() const { return m_samples.empty(); }

  // not valid if the patch is empty
  Surface_point nearest_point(const Eigen::Vector3d& p) const
  {
    Surface_point best;
    double nearest = std::numeric_limits<double>::infinity();
    for(const std::size_t t : m_triangles)
    {
      const auto& [a, b, c] = m_surface->triangles[t];
      const Kernel::Triangle_3 triangle(to_cgal(m_surface->points[a]), to_cgal(m_surface->points[b]),
                                        to_cgal(m_surface->points[c]));
      const Kernel::Point_3 projected = Kernel().construct_projected_point_3_object()(triangle, to_cgal(p));
      const Eigen::Vector3d q(projected.x(), projected.y(), projected.z());
      const double distance = (q - p).squaredNorm();
      if(distance < nearest)
      {
        nearest = distance;
        best.position = q;
        best.triangle = t;
      }
    }
    return best;
  }

  // The mean of the area, of which the less counts the farther it is from `p`: e times less for every `width` that it is farther
  // than the nearest place. No single vertex decides where that is. The patch must not be empty.
  Eigen::Vector3d mean_near(const Eigen::Vector3d& p, double width) const
  {
    double nearest = std::numeric_limits<double>::infinity();
    for(const Sample& s : m_samples)
      nearest = std::min(nearest, (s.position - p).norm());
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double weight = 0.;
    for(const Sample& s : m_samples)
    {
      const double w = s.area * std::exp((nearest - (s.position - p).norm()) / width);
      sum += w * s.position;
      weight += w;
    }
    return sum / weight;
  }

private:
  struct Sample
  {
    Eigen::Vector3d position;
    double area;
  };

  // the centers of equal parts of a triangle
  template <typename Weight>
  void sample(std::size_t t, double spacing, const Weight& weight)
  {
    const auto& [i, j, k] = m_surface->triangles[t];
    const Eigen::Vector3d &a = m_surface->points[i], u = m_surface->points[j] - a,
                          v = m_surface->points[k] - a;
    const double length = std::max({u.norm(), v.norm(), (u - v).norm()}), area = .5 * u.cross(v).norm();
    if(!(area > 0.))
      return;
    const int parts = int(std::min(std::max(std::ceil(length / spacing), 1.), 20.));
    for(int y = 0; y < parts; ++y)
      for(int x = 0; x + y < parts; ++x)
        for(int half = 0; half < (x + y + 1 < parts ? 2 : 1); ++half)
        {
          const double third = (half + 1) / 3.;
          const Eigen::Vector3d p = a + ((x + third) * u + (y + third) * v) / parts;
          if(const double w = weight(p); w > 0.)
            m_samples.push_back({p, w * area / (parts * parts)});
        }
  }

  using Kernel = CGAL::Simple_cartesian<double>;

  static Kernel::Point_3 to_cgal(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

  const Head_surface* m_surface;
  std::vector<std::size_t> m_triangles;
  std::vector<Sample> m_samples;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_SURFACE_PATCH_H
