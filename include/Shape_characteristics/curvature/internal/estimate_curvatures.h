#ifndef SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ESTIMATE_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ESTIMATE_CURVATURES_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/curvature/internal/write_curvatures.h>
#include <Shape_characteristics/sampling/for_each_sample.h>

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// What an estimator says of the samples `0, ..., size - 1`. An estimator has a type `Workspace` and a member
// `Curvature_estimate operator()(std::size_t, Workspace&) const` (or one that returns a type derived from it). Samples
// before which the callback stopped the computation are CANCELLED.
template <typename ConcurrencyTag, typename Estimator, typename NamedParameters>
auto estimate_curvatures(const Estimator& estimator, std::size_t size, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Workspace = typename Estimator::Workspace;
  using Estimate = decltype(estimator(std::size_t(), std::declval<Workspace&>()));

  const std::function<bool(double)> callback =
      choose_parameter(get_parameter(np, internal_np::callback), std::function<bool(double)>());
  std::vector<Estimate> estimates(size);
  for_each_sample<ConcurrencyTag, Workspace>(
      size, [&](const std::size_t i, Workspace& workspace) { estimates[i] = estimator(i, workspace); },
      callback);
  return estimates;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ESTIMATE_CURVATURES_H
