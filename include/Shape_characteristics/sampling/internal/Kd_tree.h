#ifndef SHAPE_CHARACTERISTICS_SAMPLING_INTERNAL_KD_TREE_H
#define SHAPE_CHARACTERISTICS_SAMPLING_INTERNAL_KD_TREE_H

#include <Shape_characteristics/internal/Rounded_comparison.h>
#include <Shape_characteristics/internal/large_pages.h>
#include <Shape_characteristics/internal/scale_to_range.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// The finite ones of some points, in an order in which those of each box of a kd-tree are in a row. In contrast to CGAL's
// tree it holds them by value in that order, a query allocates nothing, and the visitor decides which of equally far
// points it takes.
class Kd_tree
{
public:
  struct Entry
  {
    Eigen::Vector3d point;
    std::uint32_t index;
  };

  // Of points in the unit in which lengths that matter are about as large as `length`: all coordinates and distances are multiplied
  // by scale().
  explicit Kd_tree(const std::vector<Eigen::Vector3d>& points, double length)
    : m_scale(scale_to_range(length))
  {
    reserve_large_pages(m_entries, points.size());
    for(std::size_t i = 0; i < points.size(); ++i)
      if(points[i].allFinite())
        m_entries.push_back({scaled(points[i]), std::uint32_t(i)});
    if(!m_entries.empty())
      m_extent = box_of(0, m_entries.size()).sizes().maxCoeff();
    std::size_t number_of_leaves = 1;
    while(number_of_leaves * s_leaf_size < m_entries.size())
      number_of_leaves *= 2;
    m_nodes.resize(2 * number_of_leaves);
    build(1, 0, m_entries.size());
    resize_in_large_pages(m_place, points.size(), s_none);
    for(std::size_t k = 0; k < m_entries.size(); ++k)
      m_place[m_entries[k].index] = std::uint32_t(k);
  }

  const std::vector<Entry>& entries() const noexcept { return m_entries; }
  double scale() const noexcept { return m_scale; }
  // `p` in the unit of the tree; finite
  Eigen::Vector3d scaled(const Eigen::Vector3d& p) const
  {
    constexpr double largest = (std::numeric_limits<double>::max)();
    return (m_scale * p).cwiseMax(-largest).cwiseMin(largest);
  }
  // longest edge of the box around all points
  double extent() const noexcept { return m_extent; }
  // whether point `i` is finite
  bool contains(std::size_t i) const { return m_place[i] != s_none; }
  // point `i`, which must be finite
  const Eigen::Vector3d& point(std::size_t i) const { return m_entries[m_place[i]].point; }

  // Calls `visitor(entry, squared_distance)` for all points that aren't farther from `q` than `visitor.squared_radius()`,
  // which may shrink meanwhile, and for some that are. Those near the point come first.
  template <typename Visitor>
  void search(const Eigen::Vector3d& q, Visitor& visitor) const
  {
    search(1, 0, m_entries.size(), q, Eigen::Vector3d::Zero(), visitor);
  }

private:
  static constexpr std::size_t s_leaf_size = 12;
  static constexpr std::uint32_t s_none = (std::numeric_limits<std::uint32_t>::max)();

  struct Node
  {
    double below = 0., above = 0.; // no coordinate in the first half is larger, none in the second smaller
    int dimension = -1;            // of the coordinate; none if the node is a leaf
  };

  Eigen::AlignedBox3d box_of(std::size_t begin, std::size_t end) const
  {
    Eigen::AlignedBox3d box;
    for(std::size_t k = begin; k < end; ++k)
      box.extend(m_entries[k].point);
    return box;
  }

  // node `i` has the children `2 i` and `2 i + 1`, with half of its points each
  void build(std::size_t node, std::size_t begin, std::size_t end)
  {
    if(end - begin <= s_leaf_size)
      return;
    const Eigen::AlignedBox3d box = box_of(begin, end);
    const Eigen::Vector3d extent = box.sizes();
    if(!(extent.maxCoeff() > 0.)) // copies of one point, in whatever number, are a leaf
      return;
    // What is equal but for rounding is equal: the order of the points is the same however large a regular set is.
    const double unit = 0x1p-20 * extent.maxCoeff();
    int dimension = 0;
    while(extent[dimension] < extent.maxCoeff() - unit)
      ++dimension;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](const std::size_t k) { return m_entries.begin() + std::ptrdiff_t(k); };
    const auto is_before =
        [dimension, compare = Rounded_comparison(box.min()[dimension], unit)](const Entry& a, const Entry& b)
    { return compare(a.point[dimension], b.point[dimension]) < 0; };
    std::nth_element(at(begin), at(middle), at(end), is_before);
    double below = box.min()[dimension];
    for(std::size_t k = begin; k < middle; ++k)
      below = (std::max)(below, m_entries[k].point[dimension]);
    m_nodes[node] = {below, m_entries[middle].point[dimension] - unit, dimension};
    build(2 * node, begin, middle);
    build(2 * node + 1, middle, end);
  }

  // `offset`: of the box of the node from `q`, by coordinates
  template <typename Visitor>
  void search(std::size_t node,
              std::size_t begin,
              std::size_t end,
              const Eigen::Vector3d& q,
              const Eigen::Vector3d& offset,
              Visitor& visitor) const
  {
    const Node& n = m_nodes[node];
    if(n.dimension < 0)
    {
      for(std::size_t k = begin; k < end; ++k)
        visitor(m_entries[k], (m_entries[k].point - q).squaredNorm());
      return;
    }
    const std::size_t middle = begin + (end - begin) / 2;
    const double to_below = q[n.dimension] - n.below, to_above = n.above - q[n.dimension];
    const bool below_first = to_below < to_above;
    if(below_first)
      search(2 * node, begin, middle, q, offset, visitor);
    else
      search(2 * node + 1, middle, end, q, offset, visitor);

    Eigen::Vector3d far_offset = offset;
    far_offset[n.dimension] = (std::max)(offset[n.dimension], below_first ? to_above : to_below);
    // none is left out because of rounding
    constexpr double shrinkage = 1. - 1e-12;
    if(shrinkage * far_offset.squaredNorm() > visitor.squared_radius())
      return;
    if(below_first)
      search(2 * node + 1, middle, end, q, far_offset, visitor);
    else
      search(2 * node, begin, middle, q, far_offset, visitor);
  }

  std::vector<Entry> m_entries;
  std::vector<std::uint32_t> m_place; // of the points among the entries
  std::vector<Node> m_nodes;
  double m_extent = 0., m_scale;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SAMPLING_INTERNAL_KD_TREE_H
