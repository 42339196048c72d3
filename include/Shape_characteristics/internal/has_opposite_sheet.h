#ifndef SHAPE_CHARACTERISTICS_INTERNAL_HAS_OPPOSITE_SHEET_H
#define SHAPE_CHARACTERISTICS_INTERNAL_HAS_OPPOSITE_SHEET_H

#include <Eigen/Core>

#include <cmath>
#include <cstddef>

namespace Shape_characteristics {
namespace internal {

// Whether many neighbors of a point lie beside it, and face the other way: those of another sheet that is nearer than the points of one are to
// each other, or with normals that aren't oriented. (What is around a thin tube, or a small ball, lies behind the point.)
template <typename SampledSurface, typename Neighbors>
bool has_opposite_sheet(const SampledSurface& surface, std::size_t i, const Neighbors& neighbors)
{
  constexpr double largest_cosine = -.5; // of both normals
  constexpr double largest_slope = .3;   // of the way to the neighbor
  constexpr std::size_t share = 4;       // one in so many
  const Eigen::Vector3d& n = surface.normal(i);
  std::size_t opposite = 0;
  for(const auto j : neighbors)
    if(n.dot(surface.normal(j)) < largest_cosine)
    {
      const Eigen::Vector3d d = surface.point(j) - surface.point(i);
      const double size = d.cwiseAbs().maxCoeff();
      opposite += std::abs(n.dot(d / size)) < largest_slope * (d / size).norm();
    }
  return share * opposite >= neighbors.size() && opposite > 0;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_HAS_OPPOSITE_SHEET_H
