#ifndef SHAPE_CHARACTERISTICS_INTERNAL_LARGE_PAGES_H
#define SHAPE_CHARACTERISTICS_INTERNAL_LARGE_PAGES_H

#include <cstddef>
#include <cstdint>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace Shape_characteristics {
namespace internal {

// Asks the system to provide memory that nobody has written to yet 2 megabytes at a time, where it is long enough: page by page, that
// takes long beside the fastest estimators. Does nothing where the system can't.
inline void ask_for_large_pages(void* memory, std::size_t bytes)
{
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::uintptr_t page = std::uintptr_t(1) << 21;
  const auto address = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t begin = (address + page - 1) / page * page, end = (address + bytes) / page * page;
  if(begin < end)
    static_cast<void>(madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE)); // or it isn't so
#else
  static_cast<void>(memory);
  static_cast<void>(bytes);
#endif
}

// reserves memory for `size` elements of an empty vector, in large pages
template <typename T>
void reserve_large_pages(std::vector<T>& v, std::size_t size)
{
  v.reserve(size);
  ask_for_large_pages(v.data(), size * sizeof(T));
}

// gives an empty vector `size` elements, in large pages
template <typename T>
void resize_in_large_pages(std::vector<T>& v, std::size_t size, const T& value = T())
{
  reserve_large_pages(v, size);
  v.resize(size, value);
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_LARGE_PAGES_H
