#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_POSE_STRAYS_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_POSE_STRAYS_H

#include <Shape_characteristics/head_features/internal/pose_grid.h>
#include <Shape_characteristics/internal/median.h>
#include <Shape_characteristics/sampling/Nearest_point_search.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// median distance of (some of) the points to the nearest one elsewhere; 0 if there is none
inline double spacing_of(const std::vector<Eigen::Vector3d>& points)
{
  const Nearest_point_search among(points);
  const std::size_t step = (std::max)(points.size() / 500, std::size_t(1));
  std::vector<double> nearest;
  for(std::size_t i = 0; i < points.size(); i += step)
    if(const auto j = among.nearest_elsewhere(i); j != Nearest_point_search::none)
      nearest.push_back((points[i] - points[j]).norm());
  return nearest.empty() ? 0. : median(nearest);
}

// Whether each point belongs to a small piece that is far from all else, as scanners leave them. `points` are finite, `spread` are the
// numbers of some that are evenly spread over them.
inline std::vector<bool> find_strays(const std::vector<Eigen::Vector3d>& points,
                                     const std::vector<std::size_t>& spread)
{
  constexpr double far = .25;   // in median distances from the middle of the shape
  constexpr double sparse = 4.; // spacings of samples, which are no gap
  constexpr double small = .01; // part of the samples
  constexpr double limit = 1e6; // gaps, beyond which it doesn't matter how far

  std::vector<bool> is_stray(points.size(), false);
  const Eigen::Vector3d first = points[spread[0]]; // coordinates may be large
  std::vector<Eigen::Vector3d> samples;
  for(const std::size_t i : spread)
    samples.push_back(points[i] - first);
  Eigen::Vector3d middle;
  std::vector<double> numbers(samples.size());
  for(int c = 0; c < 3; ++c)
  {
    std::transform(samples.begin(), samples.end(), numbers.begin(),
                   [c](const Eigen::Vector3d& p) { return p[c]; });
    middle[c] = median(numbers);
  }
  if(!middle.allFinite())
    return is_stray;
  std::transform(samples.begin(), samples.end(), numbers.begin(),
                 [&](const Eigen::Vector3d& p) { return (p - middle).norm(); });
  const double gap = (std::max)(far * median(numbers), sparse * spacing_of(samples));
  if(!(gap > 0.) || !std::isfinite(gap))
    return is_stray;

  // pieces of samples that are reached from one another
  std::vector<Eigen::Vector3d> places;
  for(const Eigen::Vector3d& p : samples)
    places.push_back(((p - middle) / gap).cwiseMin(limit).cwiseMax(-limit));
  Pose_grid grid(places, 1.);
  for(std::size_t i = 0; i < places.size(); ++i)
    grid.insert(i);
  std::vector<bool> is_reached(samples.size(), false), is_small(samples.size(), false);
  bool is_any_small = false;
  for(std::size_t start = 0; start < samples.size(); ++start)
  {
    if(is_reached[start])
      continue;
    is_reached[start] = true;
    std::vector<std::size_t> piece = {start};
    for(std::size_t next = 0; next < piece.size(); ++next)
      grid.for_each_within(places[piece[next]], 1.,
                           [&](const std::size_t j, double)
                           {
                             if(!is_reached[j])
                               piece.push_back(j);
                             is_reached[j] = true;
                             return true;
                           });
    if(double(piece.size()) < small * double(samples.size()))
    {
      is_any_small = true;
      for(const std::size_t i : piece)
        is_small[i] = true;
    }
  }
  if(!is_any_small)
    return is_stray;
  const Nearest_point_search search(samples);
  for(std::size_t i = 0; i < points.size(); ++i)
    if(const auto j = search.nearest(points[i] - first); j != Nearest_point_search::none)
      is_stray[i] = is_small[j];
  return is_stray;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_POSE_STRAYS_H
