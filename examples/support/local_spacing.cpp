#include "local_spacing.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace support {

namespace {

// A kd-tree without nodes: the indices are ordered so that the middle of each range splits it along the
// axis of its largest extent.
class Kd_tree
{
public:
  explicit Kd_tree(const std::vector<Vector>& points) : points_(points), axis_(points.size(), 0)
  {
    for(std::size_t i = 0; i < points.size(); ++i)
      if(std::isfinite(points[i][0]) && std::isfinite(points[i][1]) && std::isfinite(points[i][2]))
        order_.push_back(i);
    build(0, order_.size());
  }

  // Squared distances of the nearest others, unordered; at most `count`.
  std::vector<double> nearest(std::size_t self, std::size_t count) const
  {
    std::vector<double> heap;
    search(0, order_.size(), self, count, heap);
    return heap;
  }

private:
  void build(std::size_t first, std::size_t last)
  {
    if(last - first < 2)
      return;
    Vector low = points_[order_[first]], high = low;
    for(std::size_t i = first; i < last; ++i)
      for(int c = 0; c < 3; ++c)
      {
        low[c] = std::min(low[c], points_[order_[i]][c]);
        high[c] = std::max(high[c], points_[order_[i]][c]);
      }
    unsigned char axis = 0;
    for(unsigned char c = 1; c < 3; ++c)
      if(high[c] - low[c] > high[axis] - low[axis])
        axis = c;
    const std::size_t middle = first + (last - first) / 2;
    std::nth_element(order_.begin() + std::ptrdiff_t(first), order_.begin() + std::ptrdiff_t(middle),
                     order_.begin() + std::ptrdiff_t(last),
                     [&](std::size_t a, std::size_t b) { return points_[a][axis] < points_[b][axis]; });
    axis_[middle] = axis;
    build(first, middle);
    build(middle + 1, last);
  }

  void search(std::size_t first,
              std::size_t last,
              std::size_t self,
              std::size_t count,
              std::vector<double>& heap) const
  {
    if(first >= last)
      return;
    const std::size_t middle = first + (last - first) / 2, index = order_[middle];
    const Vector &p = points_[self], &q = points_[index];
    if(index != self)
    {
      const double d2 =
          (p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) + (p[2] - q[2]) * (p[2] - q[2]);
      if(heap.size() == count && d2 < heap.front())
      {
        std::pop_heap(heap.begin(), heap.end());
        heap.pop_back();
      }
      if(heap.size() < count)
      {
        heap.push_back(d2);
        std::push_heap(heap.begin(), heap.end());
      }
    }
    const double side = p[axis_[middle]] - q[axis_[middle]];
    const bool left_first = side < 0;
    search(left_first ? first : middle + 1, left_first ? middle : last, self, count, heap);
    if(heap.size() < count || side * side <= heap.front())
      search(left_first ? middle + 1 : first, left_first ? last : middle, self, count, heap);
  }

  const std::vector<Vector>& points_;
  std::vector<std::size_t> order_;
  std::vector<unsigned char> axis_;
};

} // namespace

std::vector<double> local_spacing(const std::vector<Vector>& points, std::size_t neighbours)
{
  const Kd_tree tree(points);
  std::vector<double> spacing(points.size(), 0.);
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    if(neighbours == 0 ||
       !(std::isfinite(points[i][0]) && std::isfinite(points[i][1]) && std::isfinite(points[i][2])))
      continue;
    const std::vector<double> squares = tree.nearest(i, neighbours);
    for(double d2 : squares)
      spacing[i] += std::sqrt(d2) / double(squares.size());
  }
  return spacing;
}

} // namespace support
