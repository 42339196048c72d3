#ifndef SHAPE_CHARACTERISTICS_SAMPLING_INTERNAL_NEIGHBOR_ORDER_H
#define SHAPE_CHARACTERISTICS_SAMPLING_INTERNAL_NEIGHBOR_ORDER_H

#include <Shape_characteristics/internal/Rounded_distance.h>
#include <Shape_characteristics/internal/Rounded_order.h>
#include <Shape_characteristics/internal/lexicographically_smaller.h>
#include <Shape_characteristics/internal/scale_to_range.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// Sorts neighbors by rounded distance, then by rounded coordinates, then by normals: an order that the surface alone
// determines. Sums over a neighborhood then have the same bits whatever the order of the input and the type of the mesh.
class Neighbor_order
{
public:
  using Key = std::pair<double, std::uint32_t>; // rounded squared distance and sample

  // whether neighbor `a` of `center`, at `p`, comes before `b`, at `q`
  template <typename Samples>
  static bool comes_before(const Samples& samples,
                           const Eigen::Vector3d& center,
                           const Rounded_distance& rounded,
                           const Key& a,
                           const Eigen::Vector3d& p,
                           const Key& b,
                           const Eigen::Vector3d& q)
  {
    if(a.first != b.first)
      return a.first < b.first;
    if(p != q || !samples.has_normals())
      return Rounded_order(center, rounded.length(a.first))(p, q);
    return lexicographically_smaller(samples.normal(a.second), samples.normal(b.second));
  }

  // Not inline: a program may instantiate it in one source file for all.
  template <typename Samples>
  void sort(const Samples& samples, std::size_t center, std::vector<std::uint32_t>& neighbors);

private:
  static constexpr int s_index_bits = 6;
  static constexpr std::size_t s_most_ranked = std::size_t(1) << s_index_bits;

  // Counts for each how many come before it, by the leading bits of the distance and the place: more comparisons than sorting
  // takes, but none of them is a branch to be foreseen. What that leaves undecided is sorted by all there is.
  template <typename Is_before>
  void sort_few(const Is_before& is_before)
  {
    const std::size_t n = m_distances.size();
    std::array<std::int32_t, s_most_ranked> leading, in_order;
    for(std::size_t k = 0; k < n; ++k)
    {
      std::uint64_t bits; // in the order of the numbers, as none is negative
      std::memcpy(&bits, &m_distances[k].first, sizeof(bits));
      leading[k] = std::int32_t(bits >> (32 + s_index_bits) << s_index_bits | k);
    }
    m_sorted.resize(n);
    for(std::size_t i = 0; i < n; ++i)
    {
      std::int32_t rank = 0;
      for(std::size_t k = 0; k < n; ++k)
        rank += leading[k] < leading[i];
      m_sorted[std::size_t(rank)] = m_distances[i];
      in_order[std::size_t(rank)] = leading[i] >> s_index_bits;
    }
    m_distances.swap(m_sorted);
    for(std::size_t begin = 0, end; begin < n; begin = end)
    {
      for(end = begin + 1; end < n && in_order[end] == in_order[begin];)
        ++end;
      if(end - begin > 1)
        std::sort(m_distances.begin() + std::ptrdiff_t(begin), m_distances.begin() + std::ptrdiff_t(end),
                  is_before);
    }
  }

  std::vector<double> m_squares;
  std::vector<Key> m_distances, m_sorted;
};

template <typename Samples>
void Neighbor_order::sort(const Samples& samples, std::size_t center, std::vector<std::uint32_t>& neighbors)
{
  const std::size_t n = neighbors.size();
  m_squares.resize(n);
  double scale = 1., largest = 0.;
  const auto square_all = [&]
  {
    largest = 0.;
    for(std::size_t k = 0; k < n; ++k)
    {
      m_squares[k] = (scale * (samples.point(neighbors[k]) - samples.point(center))).squaredNorm();
      largest = (std::max)(largest, m_squares[k]);
    }
  };
  square_all();
  if(!(largest > 1e-140 && largest < 1e140)) // the smallest may be out of the range of numbers
  {
    double farthest = 0.;
    for(std::size_t k = 0; k < n; ++k)
      farthest =
          (std::max)(farthest, (samples.point(neighbors[k]) - samples.point(center)).cwiseAbs().maxCoeff());
    scale = scale_to_range(farthest);
    square_all();
  }
  const Eigen::Vector3d p = scale * samples.point(center);
  const Rounded_distance rounded(largest);
  m_distances.resize(n);
  for(std::size_t k = 0; k < n; ++k)
    m_distances[k] = {rounded(m_squares[k]), neighbors[k]};
  const auto is_before = [&](const Key& a, const Key& b)
  {
    return comes_before(samples, p, rounded, a, scale * samples.point(a.second), b,
                        scale * samples.point(b.second));
  };
  if(n <= s_most_ranked)
    sort_few(is_before);
  else
    std::sort(m_distances.begin(), m_distances.end(), is_before);
  for(std::size_t k = 0; k < n; ++k)
    neighbors[k] = m_distances[k].second;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SAMPLING_INTERNAL_NEIGHBOR_ORDER_H
