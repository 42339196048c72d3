#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_FOR_EACH_PATCH_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_FOR_EACH_PATCH_H

#include <Shape_characteristics/interpolation/internal/Sample_patches.h>
#include <Shape_characteristics/sampling/for_each_sample.h>

#include <atomic>
#include <cstddef>
#include <functional>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// Fits all patches of a surface of `size` samples with a `Batched_hermite_rbf`, which calls `output`. Returns whether the
// callback let it visit all of them.
template <typename ConcurrencyTag, typename Fit>
bool for_each_patch(const Fit& fit,
                    std::size_t size,
                    Sample_patches& patches,
                    const typename Fit::Output& output,
                    const std::function<bool(double)>& callback = {})
{
  std::vector<unsigned char> is_served(size, 0);
  std::atomic<std::size_t> next{0}; // in their order, in which they grow, whichever thread comes
  return Shape_characteristics::for_each_sample<ConcurrencyTag, typename Fit::Workspace>(
      patches.size(),
      [&](std::size_t, typename Fit::Workspace& workspace)
      {
        const std::size_t patch = next++;
        patches.require(patch);
        fit(patches, patch, is_served, workspace, output);
      },
      callback, 1);
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_FOR_EACH_PATCH_H
