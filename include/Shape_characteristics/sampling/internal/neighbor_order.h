#ifndef SHAPE_CHARACTERISTICS_SAMPLING_INTERNAL_NEIGHBOR_ORDER_H
#define SHAPE_CHARACTERISTICS_SAMPLING_INTERNAL_NEIGHBOR_ORDER_H

#include <Shape_characteristics/internal/lexicographically_smaller.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// Sorts neighbors by distance, then by coordinates, then by normals: an order that the surface alone determines. Sums over a
// neighborhood then have the same bits whatever the order of the input and the type of the mesh.
class Neighbor_order
{
public:
  template <typename Samples>
  void sort(const Samples& samples, std::size_t center, std::vector<std::uint32_t>& neighbors)
  {
    const Eigen::Vector3d& p = samples.point(center);
    m_keys.clear();
    for(const std::uint32_t j : neighbors)
      m_keys.emplace_back((samples.point(j) - p).squaredNorm(), j);
    std::sort(m_keys.begin(), m_keys.end(),
              [&](const Key& a, const Key& b)
              {
                if(a.first != b.first)
                  return a.first < b.first;
                if(samples.point(a.second) != samples.point(b.second) || !samples.has_normals())
                  return lexicographically_smaller(samples.point(a.second), samples.point(b.second));
                return lexicographically_smaller(samples.normal(a.second), samples.normal(b.second));
              });
    for(std::size_t k = 0; k < neighbors.size(); ++k)
      neighbors[k] = m_keys[k].second;
  }

private:
  using Key = std::pair<double, std::uint32_t>;
  std::vector<Key> m_keys;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SAMPLING_INTERNAL_NEIGHBOR_ORDER_H
