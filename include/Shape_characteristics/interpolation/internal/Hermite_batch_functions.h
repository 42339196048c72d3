#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_BATCH_FUNCTIONS_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_BATCH_FUNCTIONS_H

#include <Shape_characteristics/interpolation/internal/Hermite_batch.h>
#include <Shape_characteristics/interpolation/internal/Hermite_batch_factorization.h>
#include <Shape_characteristics/interpolation/internal/Hermite_function_on_lanes.h>
#include <Shape_characteristics/interpolation/internal/Hermite_refinement_on_lanes.h>

#include <cstddef>

// Tuned for some processors (-march=native), GCC would take fused operations apart where they follow each other: a quarter
// slower, and with other bits. Clang doesn't, and doesn't know the word.
#if defined(__GNUC__) && __GNUC__ >= 12 && !defined(__clang__)
#define SHAPE_CHARACTERISTICS_TUNE ",tune=generic"
#else
#define SHAPE_CHARACTERISTICS_TUNE ""
#endif
#define SHAPE_CHARACTERISTICS_FOR_8_LANES                                                                    \
  gnu::target("avx512f,avx512dq,avx512vl,avx2,fma" SHAPE_CHARACTERISTICS_TUNE)
#define SHAPE_CHARACTERISTICS_FOR_4_LANES gnu::target("avx2,fma" SHAPE_CHARACTERISTICS_TUNE)

namespace Shape_characteristics {
namespace internal {

// Hermite_batch_factorization::solve(), compiled for several instruction sets: once for all basis functions. A template, so that it
// is compiled only where it is used.
template <typename Batch>
struct Hermite_batch_factorizations
{
#if defined(__GNUC__) && defined(__x86_64__)
  [[SHAPE_CHARACTERISTICS_FOR_8_LANES]] static void solve_8(Batch& batch)
  {
    Hermite_batch_factorization<8>::solve(batch);
  }

  [[SHAPE_CHARACTERISTICS_FOR_4_LANES]] static void solve_4(Batch& batch)
  {
    Hermite_batch_factorization<4>::solve(batch);
  }
#endif

  template <int n>
  static void solve_plain(Batch& batch)
  {
    Hermite_batch_factorization<n>::solve(batch);
  }
};

/*
  Hermite_function_on_lanes, Hermite_batch_factorization and Hermite_refinement_on_lanes, compiled for several instruction sets, and the choice of the widest that the
  processor has: the program need not have been compiled for it. Widths of 4 and 8 give the same bits; that of 2 has no fused
  multiplication and addition, unless the whole program was compiled with it.
*/
template <typename RadialBasisFunction>
struct Hermite_batch_functions
{
  using Function = void (*)(Hermite_batch&, const RadialBasisFunction&);

  std::size_t lanes;
  Function assemble;
  void (*solve)(Hermite_batch&); // what was assembled
  Function
      refine; // what was solved; does nothing unless Basis_function_on_lanes has numbers with more digits
  Function evaluate;       // value, gradient, Hessian matrix
  Function evaluate_value; // value and gradient

  // the widest that has no more than `max_lanes` lanes. Not inline: all functions are instantiated with it alone.
  static Hermite_batch_functions best(std::size_t max_lanes = Hermite_batch::max_lanes);

private:
  using Factorizations = Hermite_batch_factorizations<Hermite_batch>;

#if defined(__GNUC__) && defined(__x86_64__)
  [[SHAPE_CHARACTERISTICS_FOR_8_LANES]] static void assemble_8(Hermite_batch& batch,
                                                               const RadialBasisFunction& phi)
  {
    Hermite_function_on_lanes<8, RadialBasisFunction>::assemble(batch, phi);
  }

  [[SHAPE_CHARACTERISTICS_FOR_8_LANES]] static void refine_8([[maybe_unused]] Hermite_batch& batch,
                                                             [[maybe_unused]] const RadialBasisFunction& phi)
  {
    if constexpr(Basis_function_on_lanes<RadialBasisFunction>::has_more_digits)
      Hermite_refinement_on_lanes<8, RadialBasisFunction>::refine(batch, phi);
  }

  template <bool with_hessian>
  [[SHAPE_CHARACTERISTICS_FOR_8_LANES]] static void evaluate_8(Hermite_batch& batch,
                                                               const RadialBasisFunction& phi)
  {
    Hermite_function_on_lanes<8, RadialBasisFunction>::template evaluate<with_hessian>(batch, phi);
  }

  [[SHAPE_CHARACTERISTICS_FOR_4_LANES]] static void assemble_4(Hermite_batch& batch,
                                                               const RadialBasisFunction& phi)
  {
    Hermite_function_on_lanes<4, RadialBasisFunction>::assemble(batch, phi);
  }

  [[SHAPE_CHARACTERISTICS_FOR_4_LANES]] static void refine_4([[maybe_unused]] Hermite_batch& batch,
                                                             [[maybe_unused]] const RadialBasisFunction& phi)
  {
    if constexpr(Basis_function_on_lanes<RadialBasisFunction>::has_more_digits)
      Hermite_refinement_on_lanes<4, RadialBasisFunction>::refine(batch, phi);
  }

  template <bool with_hessian>
  [[SHAPE_CHARACTERISTICS_FOR_4_LANES]] static void evaluate_4(Hermite_batch& batch,
                                                               const RadialBasisFunction& phi)
  {
    Hermite_function_on_lanes<4, RadialBasisFunction>::template evaluate<with_hessian>(batch, phi);
  }
#endif

  template <int n>
  static void assemble_plain(Hermite_batch& batch, const RadialBasisFunction& phi)
  {
    Hermite_function_on_lanes<n, RadialBasisFunction>::assemble(batch, phi);
  }

  template <int n>
  static void refine_plain([[maybe_unused]] Hermite_batch& batch,
                           [[maybe_unused]] const RadialBasisFunction& phi)
  {
    if constexpr(Basis_function_on_lanes<RadialBasisFunction>::has_more_digits)
      Hermite_refinement_on_lanes<n, RadialBasisFunction>::refine(batch, phi);
  }

  template <int n, bool with_hessian>
  static void evaluate_plain(Hermite_batch& batch, const RadialBasisFunction& phi)
  {
    Hermite_function_on_lanes<n, RadialBasisFunction>::template evaluate<with_hessian>(batch, phi);
  }

  template <int n>
  static Hermite_batch_functions plain()
  {
    return {n,
            assemble_plain<n>,
            Factorizations::template solve_plain<n>,
            refine_plain<n>,
            evaluate_plain<n, true>,
            evaluate_plain<n, false>};
  }
};

template <typename RadialBasisFunction>
Hermite_batch_functions<RadialBasisFunction>
Hermite_batch_functions<RadialBasisFunction>::best([[maybe_unused]] const std::size_t max_lanes)
{
#if defined(__GNUC__) && defined(__x86_64__)
  if(max_lanes >= 8 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
     __builtin_cpu_supports("avx512vl"))
    return {8, assemble_8, Factorizations::solve_8, refine_8, evaluate_8<true>, evaluate_8<false>};
  if(max_lanes >= 4 && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    return {4, assemble_4, Factorizations::solve_4, refine_4, evaluate_4<true>, evaluate_4<false>};
#endif
#if defined(__GNUC__)
  if(max_lanes >= 2)
    return plain<2>();
#endif
  return plain<1>();
}

} // namespace internal
} // namespace Shape_characteristics

#undef SHAPE_CHARACTERISTICS_FOR_4_LANES
#undef SHAPE_CHARACTERISTICS_FOR_8_LANES
#undef SHAPE_CHARACTERISTICS_TUNE

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_BATCH_FUNCTIONS_H
