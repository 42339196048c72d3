#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_POINT_GRID_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_POINT_GRID_H

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// Points in the cells of a grid, to find those within a given distance in constant time. Points come in one by one. In
// contrast to a kd-tree, a million points are entered in a tenth of a second.
class Point_grid
{
public:
  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();

  // `reach`: the largest distance that is ever asked for. Points must be finite.
  Point_grid(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& origin, double reach)
    : m_points(points),
      m_origin(origin),
      m_reach((std::max)(reach, (std::numeric_limits<double>::min)())), // 0 where all points are one
      m_next(points.size(), none)
  {
    std::size_t size = 64;
    while(size < points.size())
      size *= 2;
    m_first.assign(size, none);
  }

  void insert(std::uint32_t i)
  {
    std::uint32_t& first = m_first[bucket(cell(m_points[i]))];
    m_next[i] = first;
    first = i;
  }

  // whether a point is nearer to `q` than `distance`, which isn't more than the reach
  bool has_nearer_than(const Eigen::Vector3d& q, double distance) const
  {
    bool found = false;
    visit(q,
          [&](const std::uint32_t i)
          {
            found = (m_points[i] - q).squaredNorm() < distance * distance;
            return !found;
          });
    return found;
  }

  // The nearest point to `q` within the reach, or `none`. Of equally far ones, the one with the lowest number.
  std::uint32_t nearest(const Eigen::Vector3d& q) const
  {
    std::uint32_t best = none;
    double least = m_reach * m_reach;
    visit(q,
          [&](const std::uint32_t i)
          {
            const double d = (m_points[i] - q).squaredNorm();
            if(d < least || (d == least && i < best))
            {
              least = d;
              best = i;
            }
            return true;
          });
    return best;
  }

private:
  using Cell = Eigen::Matrix<std::int64_t, 3, 1>;

  Cell cell(const Eigen::Vector3d& p) const
  {
    constexpr double largest = 0x1p40; // what is farther away shares a cell
    const Eigen::Vector3d q = ((p - m_origin) / m_reach).cwiseMin(largest).cwiseMax(-largest);
    return {std::int64_t(std::floor(q.x())), std::int64_t(std::floor(q.y())),
            std::int64_t(std::floor(q.z()))};
  }

  std::size_t bucket(const Cell& c) const
  {
    const std::uint64_t h = std::uint64_t(c.x()) * 0x9e3779b97f4a7c15u ^
                            std::uint64_t(c.y()) * 0xc2b2ae3d27d4eb4fu ^
                            std::uint64_t(c.z()) * 0x165667b19e3779f9u;
    return std::size_t((h ^ (h >> 29)) * 0xbf58476d1ce4e5b9u >> 17) & (m_first.size() - 1);
  }

  // Calls `visitor(i)` for all points within the reach and for some farther ones, perhaps twice, until it says `false`.
  template <typename Visitor>
  void visit(const Eigen::Vector3d& q, const Visitor& visitor) const
  {
    const Cell center = cell(q);
    for(int k = 0; k < 27; ++k)
    {
      const Cell c = center + Cell(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
      for(std::uint32_t i = m_first[bucket(c)]; i != none; i = m_next[i])
        if(!visitor(i))
          return;
    }
  }

  const std::vector<Eigen::Vector3d>& m_points;
  Eigen::Vector3d m_origin;
  double m_reach;
  std::vector<std::uint32_t> m_first, m_next;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_POINT_GRID_H
