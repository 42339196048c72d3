#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_BATCH_FACTORIZATION_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_BATCH_FACTORIZATION_H

#include <Shape_characteristics/interpolation/internal/Hermite_batch.h>
#include <Shape_characteristics/interpolation/internal/Lanes.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace Shape_characteristics {
namespace internal {

/*
  Solves the systems of a Hermite_batch, `n` at a time, by Cholesky's method, and takes the solutions back to the basis of which
  Hermite_function_on_lanes has taken the equations. It doesn't matter of which basis function they are.

  The lower triangle of the matrix lies in panels of four rows, column by column, so that the innermost loop of the
  factorization reads two panels from front to back, and each number it reads is used four times. It does so for blocks of columns
  that the cache has room for: what lies to the right of a block is updated once it is known. The order of all sums is that of the
  columns, as without blocks.
*/
template <int n>
class Hermite_batch_factorization
{
  using V = Lanes<n>;

public:
  [[gnu::always_inline]] static void solve(Hermite_batch& batch)
  {
    factorize(batch);
    find_residual(batch);
    collect_weights(batch);
  }

  // After solve(): `batch.solution` are other right sides, and become their solutions. All else stays as it is.
  [[gnu::always_inline]] static void solve_again(Hermite_batch& batch)
  {
    for(std::size_t p = 0; p < batch.panels; ++p)
      substitute_forward(vectors(batch.matrix), p, vectors(batch.solution), 0, std::make_index_sequence<4>());
    V unused_square, unused_root;
    if(batch.equations() == Hermite_equations::GRADIENTS)
      take_first_noise(batch, unused_square, unused_root);
    substitute_backward(batch);
  }

private:
  static constexpr std::size_t s_block = 16; // panels: a group of tiles is updated with 128 KB, with 4 lanes

  [[gnu::always_inline]] static V* vectors(double* numbers) { return reinterpret_cast<V*>(numbers); }

  // Loads what is multiplied several times into a register. Left to itself, GCC reads it again for each product: more often than it
  // multiplies, and the processor does as many of both at a time.
  [[gnu::always_inline]] static void load(const V& number, V& into)
  {
    into = number;
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
    asm("" : "+v"(into));
#endif
  }

  // Solves with a corner as find_corner() leaves it: four numbers of a row of the factor, or of a right side.
  [[gnu::always_inline]] static void divide_by_corner(const V* corner, V* x)
  {
    x[0] = x[0] * corner[0];
    x[1] = (x[1] - x[0] * corner[1]) * corner[5];
    x[2] = (x[2] - x[0] * corner[2] - x[1] * corner[6]) * corner[10];
    x[3] = (x[3] - x[0] * corner[3] - x[1] * corner[7] - x[2] * corner[11]) * corner[15];
  }

  // the products of a column of some rows of a tile with one of the corner above
  template <int first, std::size_t... r>
  [[gnu::always_inline]] static void
  subtract_products(const V* rows, const V* columns, V* sums, std::index_sequence<r...> all)
  {
    V row[sizeof...(r)];
    (load(rows[first + r], row[r]), ...);
    subtract_multiple(row, columns[0], sums, all);
    subtract_multiple(row, columns[1], sums + 1, all);
    subtract_multiple(row, columns[2], sums + 2, all);
    subtract_multiple(row, columns[3], sums + 3, all);
  }

  template <std::size_t... r>
  [[gnu::always_inline]] static void
  subtract_multiple(const V* row, const V& factor, V* sums, std::index_sequence<r...>)
  {
    V loaded;
    load(factor, loaded);
    ((sums[4 * r] -= row[r] * loaded), ...);
  }

  /*
    Some rows of a tile, all at once because they are in registers meanwhile: entry `k` of the sequence is that in column `k % 4` of
    row `first + k / 4`. What some columns before the tile (`length` of them) have to do with it is subtracted: `rows` are those
    of the tile, `columns` those of the corner above. If these are the last ones, the factor of that corner, which follows, then
    divides it.
  */
  template <bool are_last, int first, std::size_t... k>
  [[gnu::always_inline]] static void
  update_rows(const V* rows, const V* columns, std::size_t length, V* tile, std::index_sequence<k...>)
  {
    V sums[] = {tile[4 * (k % 4) + first + k / 4]...};
    constexpr std::make_index_sequence<sizeof...(k) / 4> all;
    for(std::size_t c = 0; c < length; ++c, rows += 4, columns += 4)
      subtract_products<first>(rows, columns, sums, all);
    if constexpr(are_last)
      for(std::size_t r = 0; r < sizeof...(k); r += 4)
        divide_by_corner(columns, sums + r);
    ((tile[4 * (k % 4) + first + k / 4] = sums[k]), ...);
  }

  // What the panels `begin` to `end - 1` have to do with the tile of panel `p` below, or in, the corner of panel `q`, as many rows at
  // once as there are registers for
  template <bool are_last>
  [[gnu::always_inline]] static void
  update_tile(V* matrix, std::size_t p, std::size_t q, std::size_t begin, std::size_t end)
  {
    const V* const rows = matrix + Hermite_batch::panel(p) + 16 * begin;
    const V* const columns = matrix + Hermite_batch::panel(q) + 16 * begin;
    V* const tile = matrix + Hermite_batch::panel(p) + 16 * q;
    const std::size_t length = 4 * (end - begin);
    if constexpr(n == 8)
      update_rows<are_last, 0>(rows, columns, length, tile, std::make_index_sequence<16>());
    else
    {
      update_rows<are_last, 0>(rows, columns, length, tile, std::make_index_sequence<8>());
      update_rows<are_last, 2>(rows, columns, length, tile, std::make_index_sequence<8>());
    }
  }

  // the corner of panel `p`, with inverse diagonal: entry (r, c) at 4 c + r; `begin`: of the panels that it still has to do with
  [[gnu::always_inline]] static void
  find_corner(V* matrix, std::size_t p, std::size_t begin, V& ok, const V& one)
  {
    const V* const own = matrix + Hermite_batch::panel(p) + 16 * begin;
    V* const corner = matrix + Hermite_batch::panel(p) + 16 * p;
    V l00 = corner[0], l10 = corner[1], l20 = corner[2], l30 = corner[3], l11 = corner[5], l21 = corner[6],
      l31 = corner[7], l22 = corner[10], l32 = corner[11], l33 = corner[15];
    for(const V* a = own; a != corner; a += 4)
    {
      l00 -= a[0] * a[0];
      l10 -= a[1] * a[0];
      l20 -= a[2] * a[0];
      l30 -= a[3] * a[0];
      l11 -= a[1] * a[1];
      l21 -= a[2] * a[1];
      l31 -= a[3] * a[1];
      l22 -= a[2] * a[2];
      l32 -= a[3] * a[2];
      l33 -= a[3] * a[3];
    }
    invert_pivot(l00, ok, one);
    l10 *= l00;
    l20 *= l00;
    l30 *= l00;
    l11 -= l10 * l10;
    invert_pivot(l11, ok, one);
    l21 = (l21 - l20 * l10) * l11;
    l31 = (l31 - l30 * l10) * l11;
    l22 = l22 - l20 * l20 - l21 * l21;
    invert_pivot(l22, ok, one);
    l32 = (l32 - l30 * l20 - l31 * l21) * l22;
    l33 = l33 - l30 * l30 - l31 * l31 - l32 * l32;
    invert_pivot(l33, ok, one);
    corner[0] = l00;
    corner[1] = l10;
    corner[2] = l20;
    corner[3] = l30;
    corner[5] = l11;
    corner[6] = l21;
    corner[7] = l31;
    corner[10] = l22;
    corner[11] = l32;
    corner[15] = l33;
  }

  // Cholesky's method, and both substitutions. The diagonal of the factor is inverted.
  [[gnu::always_inline]] static void factorize(Hermite_batch& batch)
  {
    V* const matrix = vectors(batch.matrix);
    V ok, one;
    set_lanes(ok, 1.);
    set_lanes(one, 1.);
    for(std::size_t begin = 0; begin < batch.panels; begin += s_block)
    {
      const std::size_t end = (std::min)(begin + s_block, batch.panels);
      for(std::size_t p = begin; p < batch.panels; ++p)
      {
        for(std::size_t q = begin; q < (std::min)(p, end); ++q)
          update_tile<true>(matrix, p, q, begin, q);
        if(p < end)
        {
          find_corner(matrix, p, begin, ok, one);
          substitute_forward(batch, p);
        }
      }
      subtract_block(matrix, begin, end, batch.panels);
    }
    // what noise that isn't in the matrix adds to the Mahalanobis square, and divides the root of the determinant by
    V square{}, inverse_root = one;
    if(batch.equations() == Hermite_equations::GRADIENTS)
      take_first_noise(batch, square, inverse_root);
    find_mahalanobis_square(batch, square);
    *reinterpret_cast<V*>(batch.inverse_root_of_noise.data()) = inverse_root;
    substitute_backward(batch);
    *reinterpret_cast<V*>(batch.is_positive_definite.data()) = ok;
  }

  // What the panels `begin` to `end - 1` of columns have to do with all tiles to their right. Some columns of tiles at a time: what they
  // are updated with stays in the cache.
  [[gnu::always_inline]] static void
  subtract_block(V* matrix, std::size_t begin, std::size_t end, std::size_t panels)
  {
    for(std::size_t first = end; first < panels; first += s_block)
      for(std::size_t p = first; p < panels; ++p)
        for(std::size_t q = first; q < (std::min)(first + s_block, p + 1); ++q)
          update_tile<false>(matrix, p, q, begin, end);
  }

  // A pivot that isn't positive tells that the matrix isn't positive definite in floating point.
  [[gnu::always_inline]] static void invert_pivot(V& pivot, V& ok, const V& one)
  {
    const V zero{};
    const V usable = pivot > 1e-280 ? pivot : one;
    ok = pivot > 1e-280 ? ok : zero;
    inverse_sqrt(usable, pivot);
  }

  // Rows of panel `p`, of some right sides at once: entry `k` of the sequence is that of row `k % 4` and right side `k / 4`.
  template <std::size_t... k>
  [[gnu::always_inline]] static void
  substitute_forward(const V* matrix, std::size_t p, V* right, std::size_t stride, std::index_sequence<k...>)
  {
    const V* rows = matrix + Hermite_batch::panel(p);
    V y[] = {right[(k / 4) * stride + 4 * p + k % 4]...};
    for(std::size_t c = 0; c < 4 * p; ++c, rows += 4)
      ((y[k] -= rows[k % 4] * right[(k / 4) * stride + c]), ...);
    for(std::size_t r = 0; r < sizeof...(k); r += 4)
      divide_by_corner(rows, y + r);
    ((right[(k / 4) * stride + 4 * p + k % 4] = y[k]), ...);
  }

  // of all right sides, as many at once as there are registers for
  [[gnu::always_inline]] static void substitute_forward(Hermite_batch& batch, std::size_t p)
  {
    const V* const matrix = vectors(batch.matrix);
    V* const right = vectors(batch.solution);
    const std::size_t stride = 4 * batch.panels;
    if(batch.equations() == Hermite_equations::TANGENTS)
      substitute_forward(matrix, p, right, stride, std::make_index_sequence<4>());
    else if constexpr(n == 8)
      substitute_forward(matrix, p, right, stride, std::make_index_sequence<16>());
    else
    {
      substitute_forward(matrix, p, right, stride, std::make_index_sequence<8>());
      substitute_forward(matrix, p, right + 2 * stride, stride, std::make_index_sequence<8>());
    }
  }

  /*
    Adds the noise of the first normal, of which some is in each value, to the covariance: between the substitutions. In the matrix,
    it would be added to what is smaller by many digits, though data tell so much of what it hides that hardly any is left
    (Woodbury's formula; the small matrix is I + variance * Z^T Z, where Z is the part of the noise after the first substitution).
  */
  [[gnu::always_inline]] static void take_first_noise(Hermite_batch& batch, V& square, V& inverse_root)
  {
    const std::size_t size = 4 * batch.panels;
    V* const solution = vectors(batch.solution);
    const V* const z0 = vectors(batch.first_noise);
    const V* const z1 = z0 + size;
    const V* const z2 = z1 + size;
    V a00{}, a10{}, a11{}, a20{}, a21{}, a22{}, b0{}, b1{}, b2{};
    for(std::size_t r = 0; r < size; ++r)
    {
      const V x = z0[r], y = z1[r], z = z2[r], s = solution[r];
      a00 += x * x;
      a10 += x * y;
      a11 += y * y;
      a20 += x * z;
      a21 += y * z;
      a22 += z * z;
      b0 += x * s;
      b1 += y * s;
      b2 += z * s;
    }
    const V& variance = *vectors(batch.derivative_noise);
    V i0, i1, i2; // inverse diagonal of the small factor
    inverse_sqrt(V(1. + variance * a00), i0);
    const V l10 = variance * a10 * i0, l20 = variance * a20 * i0;
    inverse_sqrt(V(1. + variance * a11 - l10 * l10), i1);
    const V l21 = (variance * a21 - l20 * l10) * i1;
    inverse_sqrt(V(1. + variance * a22 - l20 * l20 - l21 * l21), i2);
    const V c0 = b0 * i0, c1 = (b1 - l10 * c0) * i1, c2 = (b2 - l20 * c0 - l21 * c1) * i2;
    const V x2 = c2 * i2, x1 = (c1 - l21 * x2) * i1, x0 = (c0 - l10 * x1 - l20 * x2) * i0;
    square = variance * (x0 * x0 + x1 * x1 + x2 * x2);
    inverse_root = i0 * i1 * i2;
    const V d0 = variance * x0, d1 = variance * x1, d2 = variance * x2;
    for(std::size_t r = 0; r < size; ++r)
      solution[r] -= z0[r] * d0 + z1[r] * d1 + z2[r] * d2;
  }

  [[gnu::always_inline]] static void substitute_backward(Hermite_batch& batch)
  {
    const V* const matrix = vectors(batch.matrix);
    V* const solution = vectors(batch.solution);
    for(std::size_t p = batch.panels; p-- > 0;)
    {
      const V* const rows = matrix + Hermite_batch::panel(p);
      const V* const corner = rows + 16 * p;
      V* const mine = solution + 4 * p;
      const V x3 = mine[3] * corner[15];
      const V x2 = (mine[2] - corner[11] * x3) * corner[10];
      const V x1 = (mine[1] - corner[6] * x2 - corner[7] * x3) * corner[5];
      const V x0 = (mine[0] - corner[1] * x1 - corner[2] * x2 - corner[3] * x3) * corner[0];
      mine[0] = x0;
      mine[1] = x1;
      mine[2] = x2;
      mine[3] = x3;
      for(std::size_t c = 0; c < 4 * p; ++c)
        solution[c] -= rows[4 * c] * x0 + rows[4 * c + 1] * x1 + rows[4 * c + 2] * x2 + rows[4 * c + 3] * x3;
    }
  }

  // between the substitutions; `part` is what is known of it
  [[gnu::always_inline]] static void find_mahalanobis_square(Hermite_batch& batch, const V& part)
  {
    const V* const solution = vectors(batch.solution);
    V square = part;
    for(std::size_t r = 0; r < batch.number_of_equations; ++r)
      square += solution[r] * solution[r];
    *reinterpret_cast<V*>(batch.mahalanobis_square.data()) = square;
  }

  // The noise times the weights is what the function leaves of the data.
  [[gnu::always_inline]] static void find_residual(Hermite_batch& batch)
  {
    const V* const solution = vectors(batch.solution);
    const std::size_t stride = batch.equations() == Hermite_equations::TANGENTS ? 3 : 4;
    V values{}, derivatives{};
    for(std::size_t r = 4; r < batch.number_of_equations; r += stride)
    {
      values += solution[r] * solution[r];
      for(std::size_t k = 1; k < stride; ++k)
        derivatives += solution[r + k] * solution[r + k];
    }
    *reinterpret_cast<V*>(batch.residual.data()) =
        *vectors(batch.value_noise) * values + *vectors(batch.derivative_noise) * derivatives;
    *reinterpret_cast<V*>(batch.weight_square.data()) = values + derivatives;
  }

  // What the solution says about the basis function without its first terms at each center, about the gradient of that, and
  // about the polynomial that those terms add up to.
  [[gnu::always_inline]] static void collect_weights(Hermite_batch& batch)
  {
    const V* const solution = vectors(batch.solution);
    const V* const points = vectors(batch.points);
    V* const weights = vectors(batch.weights);
    V* const polynomial = vectors(batch.polynomial);
    const bool has_gradients = batch.equations() == Hermite_equations::GRADIENTS;
    if(has_gradients)
      for(std::size_t k = 0; k < 4 * batch.centers(); ++k)
        weights[k] = solution[k];
    else
    {
      const V* const tangents = vectors(batch.tangents);
      const V* const trend = vectors(batch.trend);
      for(std::size_t j = 0; j < batch.centers(); ++j)
      {
        const std::size_t r = j == 0 ? 0 : 3 * j + 1;
        weights[4 * j] = solution[r];
        for(std::size_t c = 0; c < 3; ++c)
          weights[4 * j + 1 + c] =
              solution[r + 1] * tangents[6 * j + c] + solution[r + 2] * tangents[6 * j + 3 + c];
      }
      for(std::size_t c = 0; c < 3; ++c)
        weights[1 + c] += solution[3] * trend[c];
    }
    V values{}, constant{};
    V moment[3] = {}, derivatives[3] = {};
    for(std::size_t j = 1; j < batch.centers(); ++j)
    {
      const V* const p = points + 3 * j;
      const V* const w = weights + 4 * j;
      values += w[0];
      for(std::size_t c = 0; c < 3; ++c)
      {
        constant += p[c] * (0.5 * w[0] * p[c] + w[1 + c]);
        moment[c] += w[0] * p[c];
        derivatives[c] += w[1 + c];
      }
    }
    polynomial[0] = -constant;
    for(std::size_t c = 0; c < 3; ++c)
    {
      polynomial[1 + c] = has_gradients ? weights[1 + c] + derivatives[c] : weights[1 + c];
      weights[1 + c] -= has_gradients ? moment[c] : moment[c] + derivatives[c];
    }
    polynomial[4] = weights[0];
    weights[0] -= values;
  }
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_BATCH_FACTORIZATION_H
