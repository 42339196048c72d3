#ifndef SHAPE_CHARACTERISTICS_INTERNAL_IS_TIP_H
#define SHAPE_CHARACTERISTICS_INTERNAL_IS_TIP_H

#include <Shape_characteristics/internal/leave_wide_gap.h>
#include <Shape_characteristics/internal/length.h>
#include <Shape_characteristics/internal/tangent_basis.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// Whether a sample lies in the plane of a neighbor, at `displacement` from it, which falls away from its own.
inline bool is_beside_tip(const Eigen::Vector3d& normal,
                          const Eigen::Vector3d& displacement,
                          const Eigen::Vector3d& normal_of_neighbor)
{
  constexpr double least_fall = .25;    // to the distance
  constexpr double largest_share = .15; // of the fall
  const double fall = std::abs(normal.dot(displacement));
  return std::abs(normal_of_neighbor.dot(displacement)) <= largest_share * fall &&
         fall >= least_fall * length(displacement);
}

/*
  Whether a sample is the tip of a cone: its neighbors, which come from near to far, fall away from its tangent plane on all sides, and yet
  it lies in theirs, while they turn little from one to the next around it. (On a smooth surface it is as far from their planes as they are
  from its own, however coarsely it is sampled; around the corner of a cube, or the tip of a pyramid, they turn at the edges.) Farther
  neighbors may be beyond the end of the cone.
*/
template <typename SampledSurface, typename Neighbors>
bool is_tip(const SampledSurface& surface, std::size_t i, const Neighbors& neighbors)
{
  constexpr double least_cosine = .87; // of a neighbor's normal with that of the next
  constexpr std::size_t fewest = 5;

  const Eigen::Vector3d& normal = surface.normal(i);
  const auto displacement = [&](const std::size_t k)
  { return Eigen::Vector3d(surface.point(neighbors[k]) - surface.point(i)); };
  std::size_t size = 0;
  double side = 0.;
  for(; size < neighbors.size(); ++size)
  {
    const Eigen::Vector3d d = displacement(size);
    const double fall = normal.dot(d);
    if(!is_beside_tip(normal, d, surface.normal(neighbors[size])) || (size > 0 && (fall < 0.) != (side < 0.)))
      break;
    side = fall;
  }
  if(size < fewest)
    return false;

  Eigen::Vector3d t1, t2;
  tangent_basis(normal, t1, t2);
  std::vector<std::pair<double, std::size_t> > around;
  for(std::size_t k = 0; k < size; ++k)
  {
    const Eigen::Vector3d d = displacement(k);
    around.emplace_back(std::atan2(t2.dot(d), t1.dot(d)), neighbors[k]);
  }
  std::sort(around.begin(), around.end());
  if(leave_wide_gap(size, [&](const std::size_t k) { return around[k].first; }))
    return false;
  for(std::size_t k = 0; k < size; ++k)
  {
    const std::size_t next = around[k + 1 < size ? k + 1 : 0].second;
    if(!(surface.normal(around[k].second).dot(surface.normal(next)) >= least_cosine))
      return false;
  }
  return true;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_IS_TIP_H
