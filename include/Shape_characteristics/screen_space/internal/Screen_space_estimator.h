#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_INTERNAL_SCREEN_SPACE_ESTIMATOR_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_INTERNAL_SCREEN_SPACE_ESTIMATOR_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/screen_space/Depth_discontinuity_rule.h>
#include <Shape_characteristics/screen_space/Screen_space_curvature.h>
#include <Shape_characteristics/screen_space/internal/Screen_space_options.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace Shape_characteristics {
namespace internal {

// The unit normal of a pixel in view space; NaN if there is none.
inline Eigen::Vector3f unit_view_normal(const Screen_frame& frame, const Eigen::Vector3f& stored)
{
  const float largest =
      (std::max)((std::max)(std::abs(stored.x()), std::abs(stored.y())), std::abs(stored.z()));
  if(!(largest >= (std::numeric_limits<float>::min)()) || !(largest <= (std::numeric_limits<float>::max)()) ||
     !stored.allFinite())
    return Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
  const Eigen::Vector3f n = stored / largest;
  return frame.to_view * (n / std::sqrt(n.x() * n.x() + n.y() * n.y() + n.z() * n.z()));
}

// The curvature at one pixel. shaders/screen_space_curvature.glsl is the same, line by line, and has to stay so.
template <typename GBuffer>
class Screen_space_estimator
{
public:
  Screen_space_estimator(const GBuffer& g_buffer, const Screen_space_pass& pass)
    : m_g_buffer(g_buffer),
      m_pass(pass),
      m_width(g_buffer.width()),
      m_height(g_buffer.height())
  {}

  Screen_space_curvature operator()(int x, int y) const
  {
    Screen_space_curvature result;
    const std::size_t pixel = m_g_buffer.index(x, y);
    const Screen_frame& frame = m_pass.frame;
    Center c;
    c.x = x;
    c.y = y;
    c.depth = m_g_buffer.depth(pixel);
    if(!frame.is_surface(c.depth))
    {
      result.status =
          std::isnan(c.depth) ? Estimation_status::NON_FINITE_INPUT : Estimation_status::UNREFERENCED;
      return result;
    }
    c.normal = unit_view_normal(frame, m_g_buffer.normal(pixel));
    if(std::isnan(c.normal.x()))
    {
      result.status = Estimation_status::NON_FINITE_INPUT;
      return result;
    }
    c.footprint = frame.footprint(c.depth);
    c.step = m_pass.step(c.depth);

    // a fan around the pixel: right, up, left, down; opposite triangles come first
    constexpr int first[4] = {0, 2, 1, 3}, second[4] = {1, 3, 2, 0};
    Neighbor neighbors[4];
    neighbors[0] = neighbor(c, 1, 0);
    neighbors[1] = neighbor(c, 0, 1);
    const bool one_will_do =
        m_pass.number_of_triangles == 1 && neighbors[0].is_usable && neighbors[1].is_usable;
    if(!one_will_do)
    {
      neighbors[2] = neighbor(c, -1, 0);
      neighbors[3] = neighbor(c, 0, -1);
    }

    int used[4], number_of_used = 0;
    bool is_one_sided = false;
    Eigen::Vector3f plane = Eigen::Vector3f::Zero();
    for(int t = 0; t < 4 && number_of_used < m_pass.number_of_triangles; ++t)
    {
      const Neighbor &a = neighbors[first[t]], &b = neighbors[second[t]];
      if(a.is_usable && b.is_usable)
      {
        plane += a.edge.cross(b.edge);
        used[number_of_used++] = t;
      }
      else
        is_one_sided = true;
    }
    if(number_of_used == 0)
    {
      result.status = Estimation_status::FEW_NEIGHBOURS;
      return result;
    }

    // The triangle's plane (of several, that of the fan) is that of the shape operator: see the normal-mapped plane, where normals don't
    // belong to the points.
    plane /= std::sqrt(plane.dot(plane));
    const Eigen::Vector3f along = neighbors[first[used[0]]].edge;
    Eigen::Vector3f u = along - plane.dot(along) * plane;
    u /= std::sqrt(u.dot(u));
    const Eigen::Vector3f v = plane.cross(u);
    Normal_equations sums;
    for(int k = 0; k < number_of_used; ++k)
      add_triangle(neighbors[first[used[k]]], neighbors[second[used[k]]], u, v, sums);

    // the inverse of [p q 0; q p + r q; 0 q r], which is (7.7), divided by the determinant
    const float p = sums.p, q = sums.q, r = sums.r, s = sums.s;
    const float inverse = 1.f / ((p + r) * s);
    const float l = inverse * ((r * r + s) * sums.x - q * r * sums.y + q * q * sums.z);
    const float m = inverse * (-q * r * sums.x + p * r * sums.y - p * q * sums.z);
    const float n = inverse * (q * q * sums.x - p * q * sums.y + (p * p + s) * sums.z);

    const float mean = 0.5f * (l + n), half = 0.5f * (l - n);
    const float root = std::sqrt(half * half + m * m);
    const float scale = 1.f / c.footprint;
    const float min_curvature = (mean - root) * scale, max_curvature = (mean + root) * scale;
    if(!std::isfinite(min_curvature) || !std::isfinite(max_curvature))
    {
      result.status = Estimation_status::DEGENERATE;
      return result;
    }
    result.min_curvature = min_curvature;
    result.max_curvature = max_curvature;
    result.status = is_one_sided ? Estimation_status::BORDER : Estimation_status::ESTIMATED;
    return result;
  }

private:
  struct Center
  {
    int x, y, step;
    float depth, footprint;
    Eigen::Vector3f normal;
  };

  struct Neighbor
  {
    bool is_usable = false;
    Eigen::Vector3f edge,
        normal_change; // from the center to the neighbor; the edge in units of the footprint
  };

  Neighbor neighbor(const Center& c, int dx, int dy) const
  {
    Neighbor result = neighbor_at(c, c.step * dx, c.step * dy);
    if(!result.is_usable && c.step > 1)
      result = neighbor_at(c, dx, dy);
    return result;
  }

  Neighbor neighbor_at(const Center& c, int dx, int dy) const
  {
    Neighbor result;
    const int x = c.x + dx, y = c.y + dy;
    if(x < 0 || y < 0 || x >= m_width || y >= m_height)
      return result;
    const std::size_t pixel = m_g_buffer.index(x, y);
    const float depth = m_g_buffer.depth(pixel);
    if(!m_pass.frame.is_surface(depth))
      return result;
    const Eigen::Vector3f normal = unit_view_normal(m_pass.frame, m_g_buffer.normal(pixel));
    if(std::isnan(normal.x()))
      return result;
    result.edge = m_pass.frame.edge(c.depth, c.footprint, depth, x, y, dx, dy);
    result.normal_change = normal - c.normal;
    if(m_pass.rule == Depth_discontinuity_rule::FAR_PLANE)
      result.is_usable = std::abs(dx) == 1 || std::abs(dy) == 1 || // the last resort
                         !(std::abs(result.edge.z()) * c.footprint > m_pass.largest_distance_difference);
    else if(m_pass.rule == Depth_discontinuity_rule::TANGENT_PLANES)
    {
      const float across = m_pass.frame.pixel_edge[0] * float(dx),
                  up = m_pass.frame.pixel_edge[1] * float(dy);
      const float squared_length = result.edge.dot(result.edge);
      const float rise = (c.normal + normal).dot(result.edge);
      const bool is_doubtful =
          squared_length > 4.f * (across * across + up * up) && rise * rise > 0.25f * squared_length;
      result.is_usable = !is_doubtful || is_in_line(c, dx, dy, result.edge);
    }
    else
      result.is_usable = true;
    return result;
  }

  // whether the points before or behind an edge are in line with it
  bool is_in_line(const Center& c, int dx, int dy, const Eigen::Vector3f& edge) const
  {
    return is_in_line(c, -dx, -dy, edge, 1.f) || is_in_line(c, 2 * dx, 2 * dy, edge, -2.f);
  }

  // whether a point is `-times` the edge away
  bool is_in_line(const Center& c, int dx, int dy, const Eigen::Vector3f& edge, float times) const
  {
    const int x = c.x + dx, y = c.y + dy;
    if(x < 0 || y < 0 || x >= m_width || y >= m_height)
      return false;
    const float depth = m_g_buffer.depth(m_g_buffer.index(x, y));
    if(!m_pass.frame.is_surface(depth))
      return false;
    const Eigen::Vector3f other = m_pass.frame.edge(c.depth, c.footprint, depth, x, y, dx, dy);
    const Eigen::Vector3f bend = other + times * edge;
    return bend.dot(bend) < 0.015625f * edge.dot(edge);
  }

  // those of the least squares (7.5), of all triangles
  struct Normal_equations
  {
    float p = 0.f, q = 0.f, r = 0.f; // of the edges, as in (7.6)
    float s = 0.f;                   // p r - q q, without cancellation within a triangle
    float x = 0.f, y = 0.f, z = 0.f; // right sides
  };

  void add_triangle(const Neighbor& a,
                    const Neighbor& b,
                    const Eigen::Vector3f& u,
                    const Eigen::Vector3f& v,
                    Normal_equations& sums) const
  {
    const float u1 = a.edge.dot(u), v1 = a.edge.dot(v), u2 = b.edge.dot(u), v2 = b.edge.dot(v);
    const float du1 = a.normal_change.dot(u), dv1 = a.normal_change.dot(v);
    const float du2 = b.normal_change.dot(u), dv2 = b.normal_change.dot(v);
    float p = u1 * u1 + u2 * u2, q = u1 * v1 + u2 * v2, r = v1 * v1 + v2 * v2;
    const float area = u1 * v2 - u2 * v1;
    float s = area * area;
    sums.x += u1 * du1 + u2 * du2;
    sums.y += v1 * du1 + u1 * dv1 + v2 * du2 + u2 * dv2;
    sums.z += v1 * dv1 + v2 * dv2;
    if(m_pass.number_of_edges == 3)
    {
      const float u3 = u2 - u1, v3 = v2 - v1, du3 = du2 - du1, dv3 = dv2 - dv1;
      p += u3 * u3;
      q += u3 * v3;
      r += v3 * v3;
      s *= 3.f;
      sums.x += u3 * du3;
      sums.y += v3 * du3 + u3 * dv3;
      sums.z += v3 * dv3;
    }
    sums.s += s + (std::max)(sums.p * r + sums.r * p - 2.f * sums.q * q, 0.f);
    sums.p += p;
    sums.q += q;
    sums.r += r;
  }

  const GBuffer& m_g_buffer;
  const Screen_space_pass& m_pass;
  int m_width, m_height;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_INTERNAL_SCREEN_SPACE_ESTIMATOR_H
