#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_REFINEMENT_ON_LANES_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_REFINEMENT_ON_LANES_H

#include <Shape_characteristics/interpolation/internal/Hermite_batch.h>
#include <Shape_characteristics/interpolation/internal/Hermite_batch_factorization.h>
#include <Shape_characteristics/interpolation/internal/Lanes.h>
#include <Shape_characteristics/interpolation/internal/Pair_on_lanes.h>
#include <Shape_characteristics/interpolation/internal/Split_on_lanes.h>
#include <Shape_characteristics/interpolation/internal/basis_function_on_lanes.h>

#include <cstddef>
#include <cstdint>

namespace Shape_characteristics {
namespace internal {

/*
  Corrects the solutions of a Hermite_batch, `n` at a time, by a step of iterative refinement. Flat basis functions have large weights
  of opposite signs, in which rounding errors of the matrix' entries are seen, more than those of all else. What a solution leaves of
  the right side is found without the matrix, as what the function leaves of the data, in numbers with more digits; the factor that
  is there takes that away, nearly all of it: once is enough. The function is evaluated without more digits afterwards.
*/
template <int n, typename RadialBasisFunction>
class Hermite_refinement_on_lanes
{
  using V = Lanes<n>;
  using Pair = Pair_on_lanes<V>;
  using Split = Split_on_lanes<V>;
  using Sum = Sum_of_splits_on_lanes<V>;
  using Basis_function = Basis_function_on_lanes<RadialBasisFunction>;

public:
  // in those lanes that `batch.is_refined` says
  [[gnu::always_inline]] static void refine(Hermite_batch& batch, const RadialBasisFunction& phi)
  {
    V* const solution = vectors(batch.solution);
    V* const known = vectors(batch.known);
    for(std::size_t r = 0; r < 4 * batch.panels; ++r)
    {
      known[r] = solution[r];
      solution[r] = V{};
    }
    collect_weights(batch);
    apply_function(batch, Basis_function(phi));
    find_remainder(batch);
    Hermite_batch_factorization<n>::solve_again(batch);
    collect_weights(batch);
    take_weights(batch);
  }

private:
  [[gnu::always_inline]] static V* vectors(double* numbers) { return reinterpret_cast<V*>(numbers); }

  // number `k` of an array of pairs, or of splits, or sums
  template <typename Number = Pair>
  [[gnu::always_inline]] static Number get(const V* array, std::size_t k)
  {
    return {array[2 * k], array[2 * k + 1]};
  }

  [[gnu::always_inline]] static void set(V* array, std::size_t k, const Pair& value)
  {
    array[2 * k] = value.high;
    array[2 * k + 1] = value.low;
  }

  template <typename Split_or_sum>
  [[gnu::always_inline]] static void set(V* array, std::size_t k, const Split_or_sum& number)
  {
    array[2 * k] = number.first;
    array[2 * k + 1] = number.rest;
  }

  [[gnu::always_inline]] static void add(V* array, std::size_t k, const Pair& value)
  {
    set(array, k, get(array, k) + value);
  }

  // of the corrected solution
  [[gnu::always_inline]] static Pair component(const Hermite_batch& batch, std::size_t r)
  {
    return Pair(vectors(batch.known)[r]) + vectors(batch.solution)[r];
  }

  // Hermite_batch_factorization::collect_weights()
  [[gnu::always_inline]] static void collect_weights(Hermite_batch& batch)
  {
    const V* const points = vectors(batch.points);
    V* const weights = vectors(batch.exact_weights);
    V* const polynomial = vectors(batch.exact_polynomial);
    const bool has_gradients = batch.equations() == Hermite_equations::GRADIENTS;
    if(has_gradients)
      for(std::size_t k = 0; k < 4 * batch.centers(); ++k)
        set(weights, k, component(batch, k));
    else
    {
      const V* const tangents = vectors(batch.tangents);
      const V* const trend = vectors(batch.trend);
      for(std::size_t j = 0; j < batch.centers(); ++j)
      {
        const std::size_t r = j == 0 ? 0 : 3 * j + 1;
        set(weights, 4 * j, component(batch, r));
        const Pair along_u = component(batch, r + 1), along_v = component(batch, r + 2);
        for(std::size_t c = 0; c < 3; ++c)
          set(weights, 4 * j + 1 + c, along_u * tangents[6 * j + c] + along_v * tangents[6 * j + 3 + c]);
      }
      const Pair along_normal = component(batch, 3);
      for(std::size_t c = 0; c < 3; ++c)
        add(weights, 1 + c, along_normal * trend[c]);
    }
    Pair values{V{}}, constant{V{}};
    Pair moment[3] = {values, values, values}, derivatives[3] = {values, values, values};
    for(std::size_t j = 1; j < batch.centers(); ++j)
    {
      const V* const p = points + 3 * j;
      const Pair weight = get(weights, 4 * j);
      values = values + weight;
      for(std::size_t c = 0; c < 3; ++c)
      {
        const Pair of_derivative = get(weights, 4 * j + 1 + c), product = weight * p[c];
        constant = constant + (magnify(product, 0.5) + of_derivative) * p[c];
        moment[c] = moment[c] + product;
        derivatives[c] = derivatives[c] + of_derivative;
      }
    }
    set(polynomial, 0, -constant);
    for(std::size_t c = 0; c < 3; ++c)
    {
      const Pair weight = get(weights, 1 + c);
      set(polynomial, 1 + c, has_gradients ? weight + derivatives[c] : weight);
      set(weights, 1 + c, weight - (has_gradients ? moment[c] : moment[c] + derivatives[c]));
    }
    const Pair weight = get(weights, 0);
    set(polynomial, 4, weight);
    set(weights, 0, weight - values);
  }

  // value and gradient of the function without its trend at each center, and what noise adds to them
  [[gnu::always_inline]] static void apply_function(Hermite_batch& batch,
                                                    const Basis_function& basis_function)
  {
    add_up_basis_functions(batch, basis_function);
    const V* const points = vectors(batch.points);
    const V* const weights = vectors(batch.exact_weights);
    const V* const polynomial = vectors(batch.exact_polynomial);
    V* const jets = vectors(batch.jets_at_centers);
    const V &value_noise = *vectors(batch.value_noise), &derivative_noise = *vectors(batch.derivative_noise);
    const Pair bending = get(polynomial, 4);
    V origin;
    set_lanes(origin, basis_function.at_origin());
    for(std::size_t i = 0; i < batch.centers(); ++i)
    {
      const V* const p = points + 3 * i;
      Pair value = get(polynomial, 0) + bending * origin + get(weights, 4 * i) * value_noise;
      for(std::size_t c = 0; c < 3; ++c)
      {
        const Pair of_linear = get(polynomial, 1 + c), of_bending = bending * p[c];
        value = value + (of_linear - magnify(of_bending, 0.5)) * p[c];
        const Pair derivative = of_linear - of_bending + get(weights, 4 * i + 1 + c) * derivative_noise;
        set(jets, 4 * i + 1 + c, derivative + get<Sum>(jets, 4 * i + 1 + c).pair());
      }
      set(jets, 4 * i, value + get<Sum>(jets, 4 * i).pair());
    }
  }

  // 1.5 * 2^52 units of numbers that are split: weights, and what they are multiplied by
  struct Shifts
  {
    V point, psi, P, B, weight, s, first;
  };

  // of P, which is at most 1; units in which nothing that is split has many more than 2^20
  static constexpr double s_shift = 0x1.8p32;

  [[gnu::always_inline]] static void find_shifts(const Hermite_batch& batch, Shifts& shifts)
  {
    // of coordinates and weights, powers of two, not larger
    V reach, weight;
    find_largest(vectors(batch.points), 3 * batch.centers(), 1, reach);
    find_largest(vectors(batch.exact_weights), 4 * batch.centers(), 2, weight);
    set_lanes(shifts.P, s_shift);
    set_lanes(shifts.B, 2. * s_shift);
    shifts.point = (2. * s_shift) * reach;
    shifts.psi = (8. * s_shift) * (reach * reach);
    shifts.weight = (2. * s_shift) * weight;
    shifts.s = (16. * s_shift) * (reach * weight);
    shifts.first = (2. * s_shift) * (weight * (1. + 16. * reach));
  }

  // the power of two that isn't larger than the largest of `size` numbers, each `stride`-th one of an array
  [[gnu::always_inline]] static void
  find_largest(const V* numbers, std::size_t size, std::size_t stride, V& power)
  {
    V largest{};
    for(std::size_t k = 0; k < size * stride; k += stride)
    {
      const V absolute = numbers[k] < 0. ? -numbers[k] : numbers[k];
      largest = absolute > largest ? absolute : largest;
    }
    Bits_of_lanes<V> bits;
    copy_bits(bits, largest);
    bits = bits & (std::uint64_t(0x7ff) << 52);
    copy_bits(power, bits);
  }

  // to where jets are: values and gradients of the basis functions without their first terms
  [[gnu::always_inline]] static void add_up_basis_functions(Hermite_batch& batch,
                                                            const Basis_function& basis_function)
  {
    V* const jets = vectors(batch.jets_at_centers);
    V* const points = vectors(batch.split_points);
    V* const weights = vectors(batch.split_weights);
    const V* const functions = vectors(batch.split_functions);
    Shifts shifts;
    find_shifts(batch, shifts);
    for(std::size_t k = 0; k < 3 * batch.centers(); ++k)
      set(points, k, split(Pair(vectors(batch.points)[k]), shifts.point));
    for(std::size_t k = 0; k < 4 * batch.centers(); ++k)
    {
      set(weights, k, split(get(vectors(batch.exact_weights), k), shifts.weight));
      set(jets, k, Sum());
    }
    for(std::size_t i = 1; i < batch.centers(); ++i)
    {
      find_functions_of_row(batch, basis_function, shifts, i);
      V jet[8], own_weights[8]; // of this center: in registers, if there are some to spare
      for(std::size_t k = 0; k < 8; ++k)
      {
        jet[k] = jets[8 * i + k];
        own_weights[k] = weights[8 * i + k];
      }
      for(std::size_t j = 0; j < i; ++j)
      {
        Split d[3];
        find_displacement(points, i, j, d);
        const Split psi = get<Split>(functions, 3 * j), P = get<Split>(functions, 3 * j + 1),
                    B = get<Split>(functions, 3 * j + 2);
        add_to_jet<1>(jet, weights + 8 * j, d, psi, P, B, shifts);
        add_to_jet<-1>(jets + 8 * j, own_weights, d, psi, P, B, shifts);
      }
      for(std::size_t k = 0; k < 8; ++k)
        jets[8 * i + k] = jet[k];
    }
  }

  // psi, P and B between center `i` and those before it. Apart from what they are used for: each waits long for its root, but some of
  // them are found side by side.
  [[gnu::always_inline]] static void find_functions_of_row(Hermite_batch& batch,
                                                           const Basis_function& basis_function,
                                                           const Shifts& shifts,
                                                           std::size_t i)
  {
    const V* const points = vectors(batch.split_points);
    V* const functions = vectors(batch.split_functions);
    const bool is_near = 4. * batch.radius * batch.radius <= Basis_function::near;
    for(std::size_t j = 0; j < i; ++j)
    {
      Split d[3];
      find_displacement(points, i, j, d);
      Sum square;
      for(std::size_t c = 0; c < 3; ++c)
        square.add_square(d[c]);
      Pair psi, P, B;
      basis_function(square.pair(), is_near, psi, P, B);
      set(functions, 3 * j, split(psi, shifts.psi));
      set(functions, 3 * j + 1, split(P, shifts.P));
      set(functions, 3 * j + 2, split(B, shifts.B));
    }
  }

  // of center `i` from center `j`
  [[gnu::always_inline]] static void
  find_displacement(const V* points, std::size_t i, std::size_t j, Split* displacement)
  {
    for(std::size_t c = 0; c < 3; ++c)
    {
      const Split p = get<Split>(points, 3 * i + c), q = get<Split>(points, 3 * j + c);
      displacement[c] = {p.first - q.first, p.rest - q.rest};
    }
  }

  // what the weights of a center have to do with the jet at `d` from it, or at -d (`side` -1)
  template <int side>
  [[gnu::always_inline]] static void add_to_jet(V* jet,
                                                const V* weights,
                                                const Split* d,
                                                const Split& psi,
                                                const Split& P,
                                                const Split& B,
                                                const Shifts& shifts)
  {
    const Split alpha = get<Split>(weights, 0),
                b[3] = {get<Split>(weights, 1), get<Split>(weights, 2), get<Split>(weights, 3)};
    Sum sum;
    for(std::size_t c = 0; c < 3; ++c)
      sum.template add_product<side>(d[c], b[c]);
    const Split s = sum.split(shifts.s);
    sum = Sum();
    sum.template add_product<1>(P, alpha);
    sum.template add_product<-1>(B, s);
    const Split first = sum.split(shifts.first);
    sum = get<Sum>(jet, 0);
    sum.template add_product<1>(psi, alpha);
    sum.template add_product<-1>(P, s);
    set(jet, 0, sum);
    for(std::size_t c = 0; c < 3; ++c)
    {
      sum = get<Sum>(jet, 1 + c);
      sum.template add_product<side>(first, d[c]);
      sum.template add_product<-1>(P, b[c]);
      set(jet, 1 + c, sum);
    }
  }

  // to where the solution was: what is left of the right sides, in the basis of the equations (see Hermite_function_on_lanes)
  [[gnu::always_inline]] static void find_remainder(Hermite_batch& batch)
  {
    const V* const points = vectors(batch.points);
    const V* const tangents = vectors(batch.tangents);
    const V* const trend = vectors(batch.trend);
    const V* const jets = vectors(batch.jets_at_centers);
    const V* const right_side = vectors(batch.right_side);
    const V& count = *vectors(batch.count);
    V* const remainder = vectors(batch.solution);
    V one, zero{};
    set_lanes(one, 1.);
    const bool has_gradients = batch.equations() == Hermite_equations::GRADIENTS;
    const Pair at_first = get(jets, 0), of_first[3] = {get(jets, 1), get(jets, 2), get(jets, 3)};
    std::size_t r = 0;
    for(std::size_t i = 0; i < batch.centers(); ++i)
    {
      const V present = count > double(i) ? one : zero;
      const V* const p = points + 3 * i;
      Pair value = get(jets, 4 * i);
      Pair gradient[3] = {get(jets, 4 * i + 1), get(jets, 4 * i + 2), get(jets, 4 * i + 3)};
      if(i > 0)
      {
        value = value - (at_first + (of_first[0] * p[0] + of_first[1] * p[1] + of_first[2] * p[2]));
        if(!has_gradients)
          for(std::size_t c = 0; c < 3; ++c)
            gradient[c] = gradient[c] - of_first[c];
      }
      leave(value, present, right_side, remainder, r);
      if(has_gradients)
        for(std::size_t c = 0; c < 3; ++c)
          leave(gradient[c], present, right_side, remainder, r);
      else
      {
        leave(along(gradient, tangents + 6 * i), present, right_side, remainder, r);
        leave(along(gradient, tangents + 6 * i + 3), present, right_side, remainder, r);
        if(i == 0)
          leave(along(gradient, trend), present, right_side, remainder, r);
      }
    }
    for(; r < 4 * batch.panels; ++r)
      remainder[r] = zero;
  }

  [[gnu::always_inline]] static Pair along(const Pair* gradient, const V* direction)
  {
    return gradient[0] * direction[0] + gradient[1] * direction[1] + gradient[2] * direction[2];
  }

  // of equation `r`, which becomes the next one
  [[gnu::always_inline]] static void
  leave(const Pair& found, const V& present, const V* right_side, V* remainder, std::size_t& r)
  {
    V rounded;
    (Pair(right_side[r]) - found).round(rounded);
    remainder[r++] = present * rounded;
  }

  [[gnu::always_inline]] static void take(const V* exact, std::size_t size, const V& is_refined, V* rounded)
  {
    for(std::size_t k = 0; k < size; ++k)
    {
      V refined;
      get(exact, k).round(refined);
      rounded[k] = is_refined != 0. ? refined : rounded[k];
    }
  }

  [[gnu::always_inline]] static void take_weights(Hermite_batch& batch)
  {
    const V& is_refined = *vectors(batch.is_refined.data());
    take(vectors(batch.exact_weights), 4 * batch.centers(), is_refined, vectors(batch.weights));
    take(vectors(batch.exact_polynomial), 5, is_refined, vectors(batch.polynomial));
  }
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_REFINEMENT_ON_LANES_H
