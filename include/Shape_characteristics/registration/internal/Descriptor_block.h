#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_DESCRIPTOR_BLOCK_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_DESCRIPTOR_BLOCK_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace Shape_characteristics {
namespace internal {

/*
  The inner loop of a search for nearest neighbors: squared distances of `rows` descriptors from the descriptors of a panel, as
  the sum of their squared norms less twice their product.

  `a` holds the rows one after the other; `b` the panel, component by component, `panel_size` numbers each. What is of the
  panel, and `distances`, is aligned to `alignment`. The norms, of rows
  and of the panel, are lessened by what rounding can amount to: what comes out is at most the distance. Where it isn't below
  the larger one of the two limits, of the row and of the panel's column, for any pair, the answer is `false`, and no more is
  to be done; that is nearly everywhere.
*/
struct Descriptor_block
{
  static constexpr std::size_t rows = 4;
  static constexpr std::size_t largest_panel = 32;
  static constexpr std::size_t alignment = 64;

  const float *a, *b;
  std::size_t dimension;
  const float *a_norms, *b_norms, *a_limits, *b_limits;
  float* distances; // `rows` times the size of the panel

  using Function = bool (*)(const Descriptor_block&);
  struct Implementation
  {
    std::size_t panel_size;
    Function are_any_below;
  };

  // the one that is fastest on this processor
  static Implementation best(std::size_t max_panel = largest_panel)
  {
#if defined(__GNUC__)
#if defined(__x86_64__)
    if(max_panel >= 32 && __builtin_cpu_supports("avx512f"))
      return {32, &run_16};
    if(max_panel >= 16 && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
      return {16, &run_8};
#endif
    if(max_panel >= 8)
      return {8, &run_4};
#endif
    static_cast<void>(max_panel);
    return {2, &run_1};
  }

private:
  // `V`: numbers computed with side by side
  template <typename V>
  [[gnu::always_inline]] static inline bool run(const Descriptor_block& block)
  {
    constexpr std::size_t lanes = sizeof(V) / sizeof(float), width = 2; // vectors in a row of the panel
    const auto at = [](const float* p) { return reinterpret_cast<const V*>(p); };
    V products[rows][width] = {};
    const float* b = block.b;
    for(std::size_t k = 0; k < block.dimension; ++k, b += width * lanes)
    {
      V column[width];
#pragma GCC unroll 2
      for(std::size_t w = 0; w < width; ++w)
        column[w] = at(b)[w];
#pragma GCC unroll 4
      for(std::size_t i = 0; i < rows; ++i)
      {
        const float factor = block.a[i * block.dimension + k];
#pragma GCC unroll 2
        for(std::size_t w = 0; w < width; ++w)
          products[i][w] += factor * column[w];
      }
    }

    V least = {};
#pragma GCC unroll 4
    for(std::size_t i = 0; i < rows; ++i)
#pragma GCC unroll 2
      for(std::size_t w = 0; w < width; ++w)
      {
        const V distance = block.a_norms[i] + at(block.b_norms)[w] - 2.f * products[i][w];
        reinterpret_cast<V*>(block.distances)[i * width + w] = distance;
        const V row_limit = V{} + block.a_limits[i], column_limit = at(block.b_limits)[w];
        const V above = distance - (column_limit > row_limit ? column_limit : row_limit);
        least = above < least ? above : least;
      }

    // is the sign bit of one of them set?
    std::uint32_t bits[lanes], signs = 0;
    std::memcpy(&bits, &least, sizeof(bits));
    for(std::size_t l = 0; l < lanes; ++l)
      signs |= bits[l];
    return (signs >> 31) != 0;
  }

#if defined(__GNUC__)
  template <int n>
  struct Lanes
  {
    typedef float type __attribute__((vector_size(n * sizeof(float)), may_alias));
  };

#if defined(__x86_64__)
  [[gnu::target("avx512f,avx2,fma")]] static bool run_16(const Descriptor_block& block)
  {
    return run<Lanes<16>::type>(block);
  }
  [[gnu::target("avx2,fma")]] static bool run_8(const Descriptor_block& block)
  {
    return run<Lanes<8>::type>(block);
  }
#endif
  static bool run_4(const Descriptor_block& block)
  {
    return run<Lanes<4>::type>(block);
  }
#endif
  static bool run_1(const Descriptor_block& block)
  {
    return run<float>(block);
  }
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_DESCRIPTOR_BLOCK_H
