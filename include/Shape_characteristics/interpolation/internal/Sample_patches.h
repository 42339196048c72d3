#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_SAMPLE_PATCHES_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_SAMPLE_PATCHES_H

#include <Shape_characteristics/internal/large_pages.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <numeric>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

/*
  Samples to be answered for, in an order of which each range of `patch_size` places is a patch.

  Patches of close samples grow one out of the other, so that one thread has to do it. They do when they are first asked
  for: other threads have patches to work at meanwhile, and what was read to grow one is at hand for what comes next.
*/
class Sample_patches
{
public:
  using Index = std::uint32_t;

  // Enough patches for all threads, and large ones: their rims cost. Powers of two, so that some samples more or less mostly
  // don't move the limits of the patches.
  static std::size_t patch_size_for(std::size_t number_of_samples, std::size_t least_number_of_patches = 8)
  {
    std::size_t size = 512;
    while(size < 2048 && 2 * size * least_number_of_patches <= number_of_samples)
      size *= 2;
    return size;
  }

  // the samples 0, ..., `number_of_samples` - 1
  Sample_patches(std::size_t number_of_samples, std::size_t patch_size)
    : Sample_patches(number_of_samples, number_of_samples, patch_size, Grow())
  {
    std::iota(m_samples.begin(), m_samples.end(), Index(0));
    enter(0, m_samples.size());
  }

  // some samples of a surface of `size_of_surface`
  Sample_patches(const std::vector<Index>& samples, std::size_t size_of_surface, std::size_t patch_size)
    : Sample_patches(samples.size(), size_of_surface, patch_size, Grow())
  {
    m_samples = samples;
    enter(0, m_samples.size());
  }

  // all samples of a surface, which must outlive the patches, in an order in which close samples are close
  template <typename SampledSurface>
  static Sample_patches compact(const SampledSurface& surface, std::size_t patch_size)
  {
    return Sample_patches(surface.size(), surface.size(), patch_size,
                          [traversal = typename SampledSurface::Traversal(surface, patch_size)](
                              std::vector<Index>& patch) mutable { traversal.next(patch); });
  }

  std::size_t size() const noexcept { return (m_samples.size() + m_patch_size - 1) / m_patch_size; }
  std::size_t begin(std::size_t patch) const noexcept { return patch * m_patch_size; }
  std::size_t end(std::size_t patch) const noexcept
  {
    return (std::min)(begin(patch) + m_patch_size, m_samples.size());
  }

  // Grows the patches up to this one. Each thread calls it before it works at a patch; the others may be at work meanwhile.
  void require(std::size_t patch)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    for(; m_grow && m_number_of_grown <= patch; ++m_number_of_grown)
    {
      m_grow(m_patch);
      const std::size_t first = begin(m_number_of_grown);
      std::copy(m_patch.begin(), m_patch.end(), m_samples.begin() + std::ptrdiff_t(first));
      enter(first, first + m_patch.size());
      if(m_number_of_grown + 1 == size())
        m_grow = nullptr;
    }
  }

  Index sample(std::size_t place) const { return m_samples[place]; }

  // whether the sample has its place between `begin` and `end`, the limits of a patch that has grown
  bool is_between(Index sample, std::size_t begin, std::size_t end) const
  {
    return sample < m_size_of_surface && place(sample) >= begin && place(sample) < end;
  }
  std::size_t place(Index sample) const { return m_places[sample].load(std::memory_order_relaxed); }

private:
  using Grow = std::function<void(std::vector<Index>&)>;

  Sample_patches(std::size_t number_of_samples,
                 std::size_t size_of_surface,
                 std::size_t patch_size,
                 Grow grow)
    : m_patch_size(patch_size),
      m_size_of_surface(size_of_surface),
      m_places(new std::atomic<Index>[size_of_surface]),
      m_grow(std::move(grow))
  {
    resize_in_large_pages(m_samples, number_of_samples);
    ask_for_large_pages(m_places.get(), size_of_surface * sizeof(std::atomic<Index>));
    for(std::size_t i = 0; i < size_of_surface; ++i)
      m_places[i].store((std::numeric_limits<Index>::max)(), std::memory_order_relaxed);
  }

  // the samples between these places
  void enter(std::size_t begin, std::size_t end)
  {
    for(std::size_t place = begin; place < end; ++place)
      m_places[m_samples[place]].store(Index(place), std::memory_order_relaxed);
  }

  std::size_t m_patch_size, m_size_of_surface;
  std::vector<Index> m_samples;
  std::unique_ptr<std::atomic<Index>[]> m_places; // read for samples of other patches, too, while those grow
  Grow m_grow;                                    // none: all is there
  std::vector<Index> m_patch;
  std::size_t m_number_of_grown = 0;
  std::mutex m_mutex;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_SAMPLE_PATCHES_H
