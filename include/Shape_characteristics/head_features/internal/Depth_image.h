#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_DEPTH_IMAGE_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_DEPTH_IMAGE_H

#include <Shape_characteristics/head_features/internal/Head_surface.h>
#include <Shape_characteristics/head_features/internal/Scalar_image.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// The part of a surface that is seen from one direction, from far away: for each pixel the nearest triangle that faces the eye,
// and its depth (which grows towards the eye).
class Depth_image
{
public:
  // `right`, `up` and `forward` (towards the eye) are an orthonormal basis, of either handedness. Pixels lie at multiples of
  // `pixel` from the corner `(left, bottom)` on.
  Depth_image(const Head_surface& surface,
              const Eigen::Vector3d& right,
              const Eigen::Vector3d& up,
              const Eigen::Vector3d& forward,
              double left,
              double bottom,
              double width,
              double height,
              double pixel)
    : m_surface(&surface),
      m_right(right),
      m_up(up),
      m_forward(forward),
      m_left(left),
      m_bottom(bottom),
      m_pixel(pixel),
      m_depth(int(std::ceil(width / pixel)) + 1, int(std::ceil(height / pixel)) + 1),
      m_triangle(std::size_t(m_depth.width()) * std::size_t(m_depth.height()), Surface_point::no_triangle)
  {
    for(std::size_t t = 0; t < surface.triangles.size(); ++t)
      draw(t);
  }

  const Scalar_image& depth() const { return m_depth; }
  double pixel() const { return m_pixel; }
  double u(double i) const { return m_left + i * m_pixel; }
  double v(double j) const { return m_bottom + j * m_pixel; }
  double column(double u) const { return (u - m_left) / m_pixel; }
  double row(double v) const { return (v - m_bottom) / m_pixel; }

  std::size_t triangle(int i, int j) const
  {
    return m_triangle[std::size_t(j) * std::size_t(m_depth.width()) + std::size_t(i)];
  }

  // What is seen at `(u, v)`; not valid if there is nothing.
  Surface_point point(double u, double v) const
  {
    return point(u, v, [](int, int) { return true; });
  }

  // The same for the triangles of pixels of one kind; where they end, the point of theirs that is nearest in the image.
  template <typename Predicate>
  Surface_point point(double u, double v, const Predicate& accepts) const
  {
    Surface_point best;
    // far outside, or no place at all
    if(!(column(u) > -2. && column(u) < m_depth.width() + 1. && row(v) > -2. &&
         row(v) < m_depth.height() + 1.))
      return best;
    const int i0 = int(std::floor(column(u))), j0 = int(std::floor(row(v)));
    double best_depth = -std::numeric_limits<double>::infinity(), best_violation = 1.5 * m_pixel;
    bool is_inside = false;
    for(int j = j0 - 1; j <= j0 + 2; ++j)
      for(int i = i0 - 1; i <= i0 + 2; ++i)
      {
        if(!m_depth.contains(i, j) || triangle(i, j) == Surface_point::no_triangle || !accepts(i, j))
          continue;
        const std::size_t t = triangle(i, j);
        const Projected p = project(t);
        if(!(p.area > 0.))
          continue;
        const std::array<double, 3> w = p.weights(u, v);
        const bool inside = w[0] >= -1e-9 && w[1] >= -1e-9 && w[2] >= -1e-9;
        const double depth = w[0] * p.d[0] + w[1] * p.d[1] + w[2] * p.d[2];
        if(inside ? (!is_inside || depth > best_depth) : false)
        {
          is_inside = true;
          best_depth = depth;
          best = at(t, w);
        }
        else if(!is_inside && !inside)
        {
          // no triangle of the neighborhood is hit: the nearest one will do
          std::array<double, 3> c = {std::max(w[0], 0.), std::max(w[1], 0.), std::max(w[2], 0.)};
          const double sum = c[0] + c[1] + c[2];
          for(double& x : c)
            x /= sum;
          const double du = c[0] * p.u[0] + c[1] * p.u[1] + c[2] * p.u[2] - u,
                       dv = c[0] * p.v[0] + c[1] * p.v[1] + c[2] * p.v[2] - v, violation = std::hypot(du, dv);
          if(violation < best_violation)
          {
            best_violation = violation;
            best = at(t, c);
          }
        }
      }
    return best;
  }

private:
  struct Projected
  {
    std::array<double, 3> u, v, d;
    double area; // twice, positive if it faces the eye

    std::array<double, 3> weights(double x, double y) const
    {
      const auto cross = [&](const std::size_t a, const std::size_t b)
      { return (u[a] - x) * (v[b] - y) - (u[b] - x) * (v[a] - y); };
      return {cross(1, 2) / area, cross(2, 0) / area, cross(0, 1) / area};
    }
  };

  Projected project(std::size_t t) const
  {
    Projected p;
    for(std::size_t k = 0; k < 3; ++k)
    {
      const Eigen::Vector3d& x = m_surface->points[m_surface->triangles[t][k]];
      p.u[k] = m_right.dot(x);
      p.v[k] = m_up.dot(x);
      p.d[k] = m_forward.dot(x);
    }
    p.area = (p.u[1] - p.u[0]) * (p.v[2] - p.v[0]) - (p.u[2] - p.u[0]) * (p.v[1] - p.v[0]);
    // a left-handed basis shows the surface in a mirror
    const double handedness = m_right.cross(m_up).dot(m_forward);
    if(handedness < 0.)
    {
      std::swap(p.u[1], p.u[2]);
      std::swap(p.v[1], p.v[2]);
      std::swap(p.d[1], p.d[2]);
      p.area = -p.area;
    }
    return p;
  }

  Surface_point at(std::size_t t, std::array<double, 3> w) const
  {
    if(m_right.cross(m_up).dot(m_forward) < 0.)
      std::swap(w[1], w[2]);
    Surface_point s;
    s.triangle = t;
    for(std::size_t k = 0; k < 3; ++k)
      s.position += w[k] * m_surface->points[m_surface->triangles[t][k]];
    return s;
  }

  void draw(std::size_t t)
  {
    const Projected p = project(t);
    if(!(p.area > 0.) || !std::isfinite(p.area))
      return;
    const auto [u_min, u_max] = std::minmax_element(p.u.begin(), p.u.end());
    const auto [v_min, v_max] = std::minmax_element(p.v.begin(), p.v.end());
    // within the image and one pixel about it: farther away, numbers are no indices any more
    const auto within = [](double x, int size) { return std::min(std::max(x, -1.), double(size)); };
    const int i_begin = std::max(int(std::ceil(within(column(*u_min), m_depth.width()))), 0),
              i_end = std::min(int(std::floor(within(column(*u_max), m_depth.width()))), m_depth.width() - 1),
              j_begin = std::max(int(std::ceil(within(row(*v_min), m_depth.height()))), 0),
              j_end = std::min(int(std::floor(within(row(*v_max), m_depth.height()))), m_depth.height() - 1);
    for(int j = j_begin; j <= j_end; ++j)
      for(int i = i_begin; i <= i_end; ++i)
      {
        const std::array<double, 3> w = p.weights(u(i), v(j));
        if(w[0] < -1e-9 || w[1] < -1e-9 || w[2] < -1e-9)
          continue;
        const double depth = w[0] * p.d[0] + w[1] * p.d[1] + w[2] * p.d[2];
        if(!(m_depth(i, j) >= depth))
        {
          m_depth(i, j) = depth;
          m_triangle[std::size_t(j) * std::size_t(m_depth.width()) + std::size_t(i)] = t;
        }
      }
  }

  const Head_surface* m_surface;
  Eigen::Vector3d m_right, m_up, m_forward;
  double m_left, m_bottom, m_pixel;
  Scalar_image m_depth;
  std::vector<std::size_t> m_triangle;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_DEPTH_IMAGE_H
