#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_SAMPLE_PATCHES_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_SAMPLE_PATCHES_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// Samples to be answered for, in an order of which each range of `patch_size` places is a patch.
class Sample_patches
{
public:
  using Index = std::uint32_t;

  // Enough patches for all threads, and large ones: their rims cost. Powers of two, so that some samples more or less mostly
  // don't move the limits of the patches.
  static std::size_t patch_size_for(std::size_t number_of_samples)
  {
    std::size_t size = 512;
    while(size < 2048 && 16 * size <= number_of_samples)
      size *= 2;
    return size;
  }

  // the samples 0, ..., `number_of_samples` - 1
  Sample_patches(std::size_t number_of_samples, std::size_t patch_size)
    : m_patch_size(patch_size),
      m_samples(number_of_samples)
  {
    std::iota(m_samples.begin(), m_samples.end(), Index(0));
    m_places = m_samples;
  }

  // all samples of a surface, in an order in which close samples are close
  template <typename SampledSurface>
  static Sample_patches compact(const SampledSurface& surface, std::size_t patch_size)
  {
    return Sample_patches(surface.traversal_order(patch_size), patch_size);
  }

  // some samples of a surface of `size_of_surface`
  static Sample_patches
  of(const std::vector<Index>& samples, std::size_t size_of_surface, std::size_t patch_size)
  {
    Sample_patches patches(size_of_surface, patch_size);
    patches.m_samples = samples;
    patches.m_places.assign(size_of_surface, (std::numeric_limits<Index>::max)());
    patches.place_all();
    return patches;
  }

  std::size_t size() const noexcept { return (m_samples.size() + m_patch_size - 1) / m_patch_size; }
  std::size_t begin(std::size_t patch) const noexcept { return patch * m_patch_size; }
  std::size_t end(std::size_t patch) const noexcept
  {
    return (std::min)(begin(patch) + m_patch_size, m_samples.size());
  }

  Index sample(std::size_t place) const { return m_samples[place]; }

  // whether the sample has its place between `begin` and `end`
  bool is_between(Index sample, std::size_t begin, std::size_t end) const
  {
    return sample < m_places.size() && m_places[sample] >= begin && m_places[sample] < end;
  }
  std::size_t place(Index sample) const { return m_places[sample]; }

private:
  Sample_patches(std::vector<Index> order, std::size_t patch_size)
    : m_patch_size(patch_size),
      m_samples(std::move(order)),
      m_places(m_samples.size())
  {
    place_all();
  }

  void place_all()
  {
    for(std::size_t place = 0; place < m_samples.size(); ++place)
      m_places[m_samples[place]] = Index(place);
  }

  std::size_t m_patch_size;
  std::vector<Index> m_samples, m_places;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_SAMPLE_PATCHES_H
