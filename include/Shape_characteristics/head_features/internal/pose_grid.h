#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_POSE_GRID_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_POSE_GRID_H

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// Points in cubic cells: those within the width of a cell of a place are found in 27 of them.
class Pose_grid
{
public:
  Pose_grid(const std::vector<Eigen::Vector3d>& points, const double width) : m_points(points), m_width(width)
  {}

  void insert(const std::size_t i) { m_cells[cell(m_points[i])].push_back(std::uint32_t(i)); }

  // calls `function(number, squared distance)` for the points within `radius` (at most the width), until it returns false;
  // says whether it never did
  template <typename Function>
  bool for_each_within(const Eigen::Vector3d& place, const double radius, const Function& function) const
  {
    const Cell middle = cell(place);
    for(std::int64_t x = -1; x <= 1; ++x)
      for(std::int64_t y = -1; y <= 1; ++y)
        for(std::int64_t z = -1; z <= 1; ++z)
        {
          const auto found = m_cells.find({middle[0] + x, middle[1] + y, middle[2] + z});
          if(found == m_cells.end())
            continue;
          for(const std::uint32_t i : found->second)
            if(const double d = (m_points[i] - place).squaredNorm(); d <= radius * radius)
              if(!function(std::size_t(i), d))
                return false;
        }
    return true;
  }

private:
  using Cell = std::array<std::int64_t, 3>;

  struct Hash
  {
    std::size_t operator()(const Cell& c) const noexcept
    {
      std::uint64_t h = 0;
      for(const std::int64_t x : c)
        h = (h ^ std::uint64_t(x)) * 0x9e3779b97f4a7c15u, h ^= h >> 32;
      return std::size_t(h);
    }
  };

  Cell cell(const Eigen::Vector3d& p) const
  {
    return {std::int64_t(std::floor(p[0] / m_width)), std::int64_t(std::floor(p[1] / m_width)),
            std::int64_t(std::floor(p[2] / m_width))};
  }

  const std::vector<Eigen::Vector3d>& m_points;
  double m_width;
  std::unordered_map<Cell, std::vector<std::uint32_t>, Hash> m_cells;
};

// Numbers of at most `enough` of the points, evenly spread, and not much fewer where there are more: no two are nearer to each
// other than a distance, which is found by trial. Linear in the number of points.
inline std::vector<std::size_t> evenly_spread(const std::vector<Eigen::Vector3d>& points,
                                              const std::size_t enough)
{
  std::vector<std::size_t> best;
  if(points.size() <= enough)
  {
    for(std::size_t i = 0; i < points.size(); ++i)
      best.push_back(i);
    return best;
  }
  Eigen::Vector3d lowest = points[0], highest = lowest;
  for(const Eigen::Vector3d& p : points)
  {
    lowest = lowest.cwiseMin(p);
    highest = highest.cwiseMax(p);
  }
  const double size = (highest - lowest).norm();
  best.push_back(0);
  if(!(size > 0.) || !std::isfinite(size))
    return best;
  double too_small = 0., large_enough = size, distance = size / std::sqrt(double(enough));
  for(int k = 0; k < 12 && best.size() < enough - enough / 8; ++k)
  {
    Pose_grid grid(points, distance);
    std::vector<std::size_t> kept;
    for(std::size_t i = 0; i < points.size() && kept.size() <= enough; ++i)
      if(grid.for_each_within(points[i], distance, [](std::size_t, double) { return false; }))
      {
        grid.insert(i);
        kept.push_back(i);
      }
    if(kept.size() > enough)
    {
      too_small = distance;
      distance = (std::min)(1.25 * distance, .5 * (distance + large_enough));
    }
    else
    {
      large_enough = distance;
      // as many points as fit a surface grow with the inverse square of their distance
      const double wanted = distance * std::sqrt(double(kept.size()) / (double(enough) * .95));
      distance = wanted > too_small && wanted < distance ? wanted : .5 * (too_small + distance);
      best = std::move(kept);
    }
  }
  return best;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_POSE_GRID_H
