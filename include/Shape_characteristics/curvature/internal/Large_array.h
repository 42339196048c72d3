#ifndef SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_LARGE_ARRAY_H
#define SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_LARGE_ARRAY_H

#include <Shape_characteristics/internal/large_pages.h>
#include <Shape_characteristics/sampling/No_workspace.h>
#include <Shape_characteristics/sampling/for_each_sample.h>

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>

namespace Shape_characteristics {
namespace internal {

// Values that all threads construct, each some thousands in a row. A `std::vector` constructs them by one, which then also
// waits for the system to provide the memory: that happens page by page, when something is written there first.
template <typename T>
class Large_array
{
  static_assert(std::is_trivially_destructible<T>::value, "values are never destroyed");

public:
  template <typename ConcurrencyTag>
  Large_array(std::size_t size, ConcurrencyTag) : m_memory(new Memory[size])
  {
    ask_for_large_pages(m_memory.get(), size * sizeof(Memory));
    for_each_sample<ConcurrencyTag, No_workspace>(
        size, [&](const std::size_t i, No_workspace&) { ::new(static_cast<void*>(m_memory[i].bytes)) T(); },
        {}, s_block);
  }

  T& operator[](std::size_t i) { return *std::launder(reinterpret_cast<T*>(m_memory[i].bytes)); }
  const T& operator[](std::size_t i) const
  {
    return *std::launder(reinterpret_cast<const T*>(m_memory[i].bytes));
  }

private:
  static constexpr std::size_t s_block = 4096;

  struct Memory
  {
    alignas(T) unsigned char bytes[sizeof(T)];
  };

  std::unique_ptr<Memory[]> m_memory; // `new` leaves it as it is
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_LARGE_ARRAY_H
