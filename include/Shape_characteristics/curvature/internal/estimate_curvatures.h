#ifndef SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ESTIMATE_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ESTIMATE_CURVATURES_H

#include <Shape_characteristics/curvature/internal/write_curvatures.h>
#include <Shape_characteristics/internal/callback_of.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>
#include <Shape_characteristics/sampling/for_each_sample.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// What an estimator says of the samples `0, ..., size - 1`. An estimator has a type `Workspace` and a member
// `Curvature_estimate operator()(std::size_t, Workspace&) const` (or one that returns a type derived from it). Samples
// before which the callback stopped the computation are CANCELLED.
template <typename ConcurrencyTag, typename Estimator>
auto estimate_curvatures(const Estimator& estimator,
                         std::size_t size,
                         const std::function<bool(double)>& callback)
{
  using Workspace = typename Estimator::Workspace;
  using Estimate = decltype(estimator(std::size_t(), std::declval<Workspace&>()));

  std::vector<Estimate> estimates(size);
  for_each_sample<ConcurrencyTag, Workspace>(
      size, [&](const std::size_t i, Workspace& workspace) { estimates[i] = estimator(i, workspace); },
      callback);
  return estimates;
}

// writes the estimates `estimates[0], ...` of the samples `first, ..., last - 1`
using Write_curvatures =
    std::function<void(std::size_t first, std::size_t last, Curvature_estimate* estimates)>;

// The same, handed over to `write` by one thread and in the order of the samples, some thousands at a time: less memory, and what
// was just computed is still in the cache. No named parameters: what is computed is compiled once, whatever they are.
template <typename ConcurrencyTag, typename Estimator>
void estimate_and_write(const Estimator& estimator,
                        std::size_t size,
                        const std::function<bool(double)>& callback,
                        const Write_curvatures& write)
{
  using Workspace = typename Estimator::Workspace;
  constexpr std::size_t most_at_a_time = 16384, block_size = 128;

  Workspace_pool<Workspace> pool;
  std::vector<Curvature_estimate> estimates((std::min)(size, most_at_a_time));
  bool go_on = true;
  for(std::size_t begin = 0; begin < size; begin += most_at_a_time)
  {
    const std::size_t end = (std::min)(begin + most_at_a_time, size);
    std::function<bool(double)> callback_of_all;
    if(callback)
    {
      std::fill(estimates.begin(), estimates.end(), Curvature_estimate()); // some may be left out
      callback_of_all = [&](const double advancement)
      { return callback((double(begin) + advancement * double(end - begin)) / double(size)); };
    }
    go_on = go_on && for_each_sample_between<ConcurrencyTag>(
                         pool, begin, end,
                         [&](const std::size_t i, Workspace& w) { estimates[i - begin] = estimator(i, w); },
                         callback_of_all, block_size);
    write(begin, end, estimates.data());
  }
}

// Writes the estimates of all vertices of a mesh to the maps there are. Returns the number of those without one.
template <typename ConcurrencyTag, typename FaceGraph, typename Estimator, typename NamedParameters>
std::size_t estimate_vertices(const FaceGraph& mesh,
                              const Face_graph_samples& samples,
                              const Estimator& estimator,
                              const NamedParameters& np)
{
  Duplicates duplicates(samples);
  std::size_t failures = 0;
  auto v = vertices(mesh).begin();
  estimate_and_write<ConcurrencyTag>(
      estimator, samples.size(), callback_of(np),
      [&](const std::size_t first, const std::size_t last, Curvature_estimate* estimate)
      {
        for(std::size_t i = first; i < last; ++i, ++estimate)
        {
          duplicates.mark(i, *estimate);
          failures += !is_estimated(estimate->status);
          write_to_vertex(*v++, *estimate, np);
        }
      });
  return failures;
}

// the same of the points of a range
template <typename ConcurrencyTag, typename PointRange, typename Estimator, typename NamedParameters>
std::size_t
estimate_points(PointRange& points, std::size_t size, const Estimator& estimator, const NamedParameters& np)
{
  std::size_t failures = 0;
  auto item = std::begin(points);
  estimate_and_write<ConcurrencyTag>(
      estimator, size, callback_of(np),
      [&](const std::size_t first, const std::size_t last, const Curvature_estimate* estimate)
      {
        for(std::size_t i = first; i < last; ++i, ++estimate)
        {
          failures += !is_estimated(estimate->status);
          auto&& value = *item; // some ranges have no elements, but stand-ins
          write_to_item(value, *estimate, np);
          ++item;
        }
      });
  return failures;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ESTIMATE_CURVATURES_H
