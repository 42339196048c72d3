#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_FUNCTION_ON_LANES_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_FUNCTION_ON_LANES_H

#include <Shape_characteristics/interpolation/internal/Cubic_height_fit.h>
#include <Shape_characteristics/interpolation/internal/Height_polynomial.h>
#include <Shape_characteristics/interpolation/internal/Height_polynomial_fit.h>
#include <Shape_characteristics/interpolation/internal/Hermite_batch.h>
#include <Shape_characteristics/interpolation/internal/Lanes.h>
#include <Shape_characteristics/interpolation/internal/basis_function_on_lanes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace Shape_characteristics {
namespace internal {

/*
  Assembles the systems of a Hermite_batch, `n` at a time, and evaluates what their solutions are, which Hermite_batch_factorization
  finds. Hermite_system says what the equations are.

  The equations are taken in another basis. Flat basis functions make rows that are nearly equal, large weights of opposite signs,
  and results that rounding errors of the entries are seen in. Nearly all of an entry comes from the first terms of the basis
  function, phi(0) - q / 2 with q = |x - y|^2; these are the same for a value f(p) and for f(0) + p . grad f(0), what value and
  gradient at the first center, the origin, say about it. So with each value, that is subtracted; and from each derivative along a
  tangent, that of grad f(0). The first terms are then left in the columns of the first center alone, and what is small elsewhere is
  computed from Basis_function_on_lanes, which gives all its digits. With estimated normals, the weights of derivatives are small
  for their noise, and these equations stay as they are. Noise of the first center's data is in all that was subtracted. That
  of its estimated normal would hide what is small again, and is left to Hermite_batch_factorization. The determinant is the same,
  and so are solution and likelihood.
*/
template <int n, typename RadialBasisFunction>
class Hermite_function_on_lanes
{
  using V = Lanes<n>;
  using Basis_function = Basis_function_on_lanes<RadialBasisFunction>;

public:
  [[gnu::always_inline]] static void assemble(Hermite_batch& batch, const RadialBasisFunction& phi)
  {
    const Basis_function basis_function(phi);
    relate_to_first(batch, basis_function);
    if(batch.equations() == Hermite_equations::TANGENTS)
    {
      find_tangents(batch);
      bend_trend(batch);
      assemble_tangents(batch, basis_function);
    }
    else
    {
      bend_trend_by_heights(batch);
      assemble_gradients(batch, basis_function);
    }
    const V* const solution = vectors(batch.solution);
    V* const right_side = vectors(batch.right_side);
    for(std::size_t r = 0; r < 4 * batch.panels; ++r)
      right_side[r] = solution[r];
  }

  // the function at `batch.where`; its second derivatives are left alone unless `with_hessian`
  template <bool with_hessian>
  [[gnu::always_inline]] static void evaluate(Hermite_batch& batch, const RadialBasisFunction& phi)
  {
    const Basis_function basis_function(phi);
    const V* const points = vectors(batch.points);
    const V* const weights = vectors(batch.weights);
    const V* const trend = vectors(batch.trend);
    const V* const where = vectors(batch.where);
    const V* const polynomial = vectors(batch.polynomial);
    const V x = where[0], y = where[1], z = where[2];
    const V squared_distance = x * x + y * y + z * z, bending = polynomial[4];
    V gx = trend[0] + polynomial[1], gy = trend[1] + polynomial[2], gz = trend[2] + polynomial[3];
    V value = polynomial[0] + gx * x + gy * y + gz * z +
              bending * (basis_function.at_origin() - 0.5 * squared_distance);
    gx -= bending * x;
    gy -= bending * y;
    gz -= bending * z;
    V trace = -bending, xx{}, xy{}, xz{}, yy{}, yz{}, zz{};
    const bool is_near = are_near(batch.radius + std::sqrt(largest(squared_distance)));
    for(std::size_t j = 0; j < batch.centers(); ++j)
    {
      const V dx = x - points[3 * j], dy = y - points[3 * j + 1], dz = z - points[3 * j + 2];
      const V alpha = weights[4 * j], bx = weights[4 * j + 1], by = weights[4 * j + 2],
              bz = weights[4 * j + 3];
      V psi, P, B, C;
      basis_function.template operator()<with_hessian>(V(dx * dx + dy * dy + dz * dz), is_near, psi, P, B, C);
      const V s = bx * dx + by * dy + bz * dz;
      const V first = alpha * P - B * s;
      value += alpha * psi - P * s;
      gx += first * dx - P * bx;
      gy += first * dy - P * by;
      gz += first * dz - P * bz;
      if constexpr(with_hessian)
      {
        // second d d^T - B (b d^T + d b^T), as the symmetric part of d e^T
        const V second = alpha * B - C * s;
        const V ex = second * dx - 2. * B * bx, ey = second * dy - 2. * B * by,
                ez = second * dz - 2. * B * bz;
        trace += first;
        xx += dx * ex;
        yy += dy * ey;
        zz += dz * ez;
        xy += dx * ey + dy * ex;
        xz += dx * ez + dz * ex;
        yz += dy * ez + dz * ey;
      }
    }
    const Bent_trend bent(batch);
    V a, b, h, ha, hb;
    bent.project(x, y, z, a, b);
    bent.height.value(a, b, h);
    bent.height.gradient(a, b, ha, hb);
    value -= h;
    const V* const u = bent.u;
    const V* const v = bent.v;
    gx -= ha * u[0] + hb * v[0];
    gy -= ha * u[1] + hb * v[1];
    gz -= ha * u[2] + hb * v[2];
    if constexpr(with_hessian)
    {
      V haa, hab, hbb;
      bent.height.hessian(a, b, haa, hab, hbb);
      // the images of u and v
      const V px = haa * u[0] + hab * v[0], py = haa * u[1] + hab * v[1], pz = haa * u[2] + hab * v[2];
      const V qx = hab * u[0] + hbb * v[0], qy = hab * u[1] + hbb * v[1], qz = hab * u[2] + hbb * v[2];
      xx -= px * u[0] + qx * v[0];
      yy -= py * u[1] + qy * v[1];
      zz -= pz * u[2] + qz * v[2];
      xy -= 2. * (px * u[1] + qx * v[1]);
      xz -= 2. * (px * u[2] + qx * v[2]);
      yz -= 2. * (py * u[2] + qy * v[2]);
    }
    V* const jet = vectors(batch.jet);
    jet[0] = value;
    jet[1] = gx;
    jet[2] = gy;
    jet[3] = gz;
    if constexpr(with_hessian)
    {
      xx += trace;
      yy += trace;
      zz += trace;
      xy *= 0.5;
      xz *= 0.5;
      yz *= 0.5;
      jet[4] = xx;
      jet[5] = xy;
      jet[6] = xz;
      jet[7] = yy;
      jet[8] = yz;
      jet[9] = zz;

      Shape_operator shape;
      shape.set(gx, gy, gz, xx, xy, xz, yy, yz, zz);
      jet[10] = shape.length;
      square_root(V(shape.uu * shape.uu + shape.vv * shape.vv + 2. * shape.uv * shape.uv), jet[11]);
      if(batch.is_any_scaled)
      {
        // Axis_scaling, of gradient and Hessian matrix
        const V* const axis = vectors(batch.axis);
        const V ax = axis[0], ay = axis[1], az = axis[2], part = *vectors(batch.compression);
        const V along = part * (ax * gx + ay * gy + az * gz);
        const V ix = xx * ax + xy * ay + xz * az, iy = xy * ax + yy * ay + yz * az,
                iz = xz * ax + yz * ay + zz * az;
        const V half = 0.5 * part * part * (ax * ix + ay * iy + az * iz);
        const V px = part * ix + half * ax, py = part * iy + half * ay, pz = part * iz + half * az;
        shape.set(V(gx + along * ax), V(gy + along * ay), V(gz + along * az), V(xx + 2. * ax * px),
                  V(xy + ax * py + ay * px), V(xz + ax * pz + az * px), V(yy + 2. * ay * py),
                  V(yz + ay * pz + az * py), V(zz + 2. * az * pz));
      }
      find_curvatures(shape, jet + 12);
    }
  }

private:
  static constexpr double s_least_square = 1e-280; // what inverse_sqrt() takes; is nothing beside others

  [[gnu::always_inline]] static V* vectors(double* numbers) { return reinterpret_cast<V*>(numbers); }

  // 1 where a lane has center `i`
  [[gnu::always_inline]] static void presence(const Hermite_batch& batch, std::size_t i, V& present)
  {
    V one, zero{};
    set_lanes(one, 1.);
    const V& count = *vectors(batch.count);
    present = count > double(i) ? one : zero;
  }

  [[gnu::always_inline]] static double largest(const V& v)
  {
    double numbers[n], result = 0.;
    std::memcpy(numbers, &v, sizeof(V));
    for(const double number : numbers)
      result = (std::max)(result, number);
    return result;
  }

  // whether points at a distance of at most `reach` are near enough for the basis function's faster formula
  [[gnu::always_inline]] static bool are_near(double reach) { return reach * reach <= Basis_function::near; }

  // `batch.radius` and `batch.at_first`
  [[gnu::always_inline]] static void relate_to_first(Hermite_batch& batch,
                                                     const Basis_function& basis_function)
  {
    const V* const points = vectors(batch.points);
    V* const at_first = vectors(batch.at_first);
    V largest_square{};
    for(std::size_t i = 0; i < batch.centers(); ++i)
    {
      const V x = points[3 * i], y = points[3 * i + 1], z = points[3 * i + 2];
      const V square = x * x + y * y + z * z;
      largest_square = square > largest_square ? square : largest_square;
    }
    batch.radius = std::sqrt(largest(largest_square));
    const bool is_near = are_near(batch.radius);
    for(std::size_t i = 0; i < batch.centers(); ++i)
    {
      const V x = points[3 * i], y = points[3 * i + 1], z = points[3 * i + 2];
      V unused;
      basis_function.template operator()<false>(V(x * x + y * y + z * z), is_near, at_first[3 * i],
                                                at_first[3 * i + 1], at_first[3 * i + 2], unused);
    }
  }

  // the basis function of center `j` at center `i`
  [[gnu::always_inline]] static void relate(const V* points,
                                            const Basis_function& basis_function,
                                            bool is_near,
                                            std::size_t i,
                                            std::size_t j,
                                            V& dx,
                                            V& dy,
                                            V& dz,
                                            V& psi,
                                            V& P,
                                            V& B)
  {
    dx = points[3 * i] - points[3 * j];
    dy = points[3 * i + 1] - points[3 * j + 1];
    dz = points[3 * i + 2] - points[3 * j + 2];
    V unused;
    basis_function.template operator()<false>(V(dx * dx + dy * dy + dz * dz), is_near, psi, P, B, unused);
  }

  // where row `r` begins
  [[gnu::always_inline]] static V* row(V* matrix, std::size_t r)
  {
    return matrix + Hermite_batch::panel(r / 4) + r % 4;
  }

  // equations of lanes that end within the last panel: unit rows
  [[gnu::always_inline]] static void fill_last_panel(Hermite_batch& batch)
  {
    V* const matrix = vectors(batch.matrix);
    V* const solution = vectors(batch.solution);
    for(std::size_t r = batch.number_of_equations; r < 4 * batch.panels; ++r)
    {
      V* const entries = row(matrix, r);
      for(std::size_t c = 0; c < 4 * batch.panels; ++c)
        entries[4 * c] = V{};
      set_lanes(entries[4 * r], 1.);
      solution[r] = V{};
    }
  }

  // the trend of exact fits, w . x - h(u . x, v . x): a plane, bent by a polynomial
  struct Bent_trend
  {
    [[gnu::always_inline]] explicit Bent_trend(const Hermite_batch& batch)
      : u(vectors(batch.tangents)),
        v(u + 3),
        w(vectors(batch.trend))
    {
      const V* const coefficients = vectors(batch.bend);
      for(std::size_t k = 0; k < height.size; ++k)
        height.c[k] = coefficients[k];
    }

    [[gnu::always_inline]] void project(const V& x, const V& y, const V& z, V& a, V& b) const
    {
      a = u[0] * x + u[1] * y + u[2] * z;
      b = v[0] * x + v[1] * y + v[2] * z;
    }

    [[gnu::always_inline]] void gradient(const V& a, const V& b, V& gx, V& gy, V& gz) const
    {
      V ha, hb;
      height.gradient(a, b, ha, hb);
      gx = w[0] - ha * u[0] - hb * v[0];
      gy = w[1] - ha * u[1] - hb * v[1];
      gz = w[2] - ha * u[2] - hb * v[2];
    }

    const V *u, *v, *w;
    Height_polynomial<V> height;
  };

  // tangent_basis()
  [[gnu::always_inline]] static void find_tangents(const V* normal, V* t1, V* t2)
  {
    const V x = normal[0], y = normal[1], z = normal[2];
    V one;
    set_lanes(one, 1.);
    const V x_or_y = y != 0. ? y : x;
    const V decisive = z != 0. ? z : x_or_y;
    const V sign = decisive < 0. ? -one : one;
    const V a = -1. / (sign + z), b = x * y * a;
    t1[0] = 1. + sign * x * x * a;
    t1[1] = sign * b;
    t1[2] = -sign * x;
    t2[0] = b;
    t2[1] = sign + y * y * a;
    t2[2] = -y;
  }

  // of each normal
  [[gnu::always_inline]] static void find_tangents(Hermite_batch& batch)
  {
    const V* const normals = vectors(batch.normals);
    V* const tangents = vectors(batch.tangents);
    for(std::size_t i = 0; i < batch.centers(); ++i)
      find_tangents(normals + 3 * i, tangents + 6 * i, tangents + 6 * i + 3);
  }

  // the root of a square, and of 0
  [[gnu::always_inline]] static void square_root(const V& square, V& root)
  {
    const V usable = square + s_least_square;
    V inverse;
    inverse_sqrt(usable, inverse);
    root = square * inverse;
  }

  // that of a level set, [uu uv; uv vv] in tangents u and v
  struct Shape_operator
  {
    [[gnu::always_inline]] void set(const V& gx,
                                    const V& gy,
                                    const V& gz,
                                    const V& xx,
                                    const V& xy,
                                    const V& xz,
                                    const V& yy,
                                    const V& yz,
                                    const V& zz)
    {
      const V squared_length = gx * gx + gy * gy + gz * gz + s_least_square;
      V inverse_length;
      inverse_sqrt(squared_length, inverse_length);
      length = squared_length * inverse_length;
      normal[0] = gx * inverse_length;
      normal[1] = gy * inverse_length;
      normal[2] = gz * inverse_length;
      find_tangents(normal, u, v);
      const V ux = xx * u[0] + xy * u[1] + xz * u[2], uy = xy * u[0] + yy * u[1] + yz * u[2],
              uz = xz * u[0] + yz * u[1] + zz * u[2];
      const V vx = xx * v[0] + xy * v[1] + xz * v[2], vy = xy * v[0] + yy * v[1] + yz * v[2],
              vz = xz * v[0] + yz * v[1] + zz * v[2];
      uu = (u[0] * ux + u[1] * uy + u[2] * uz) * inverse_length;
      uv = (u[0] * vx + u[1] * vy + u[2] * vz) * inverse_length;
      vv = (v[0] * vx + v[1] * vy + v[2] * vz) * inverse_length;
    }

    V length; // of the gradient
    V normal[3], u[3], v[3];
    V uu, uv, vv;
  };

  // eigen_of_shape_operator(): the smaller eigenvalue, the larger one, and their directions. What cancels is left to cancel: a fit
  // is not that exact.
  [[gnu::always_inline]] static void find_curvatures(const Shape_operator& shape, V* result)
  {
    const V mean = 0.5 * (shape.uu + shape.vv), delta = 0.5 * (shape.uu - shape.vv), uv = shape.uv;
    const V* const normal = shape.normal;
    V radius, length;
    square_root(V(delta * delta + uv * uv), radius);
    result[0] = mean - radius;
    result[1] = mean + radius;
    // (radius + delta, uv) and (uv, radius - delta) are parallel; take the one that is the sum of two positive terms
    V one;
    set_lanes(one, 1.);
    const V magnitude = delta < 0. ? -delta : delta;
    V along = radius + magnitude, across = uv;
    along = radius > 1e-140 ? along : one;
    inverse_sqrt(V(along * along + across * across), length);
    along *= length;
    across *= length;
    const V c = delta < 0. ? across : along, s = delta < 0. ? along : across;
    V* const min_direction = result + 2;
    V* const max_direction = result + 5;
    for(std::size_t k = 0; k < 3; ++k)
      max_direction[k] = c * shape.u[k] + s * shape.v[k];
    for(std::size_t k = 0; k < 3; ++k)
      min_direction[k] =
          normal[(k + 1) % 3] * max_direction[(k + 2) % 3] - normal[(k + 2) % 3] * max_direction[(k + 1) % 3];
  }

  // trend_of_exact_fit()
  [[gnu::always_inline]] static void bend_trend(Hermite_batch& batch)
  {
    const V* const points = vectors(batch.points);
    const V* const normals = vectors(batch.normals);
    const V* const tangents = vectors(batch.tangents);
    const V& unit = *vectors(batch.unit);
    const V inverse = 1. / unit;
    Bent_trend bent(batch);
    Height_polynomial_fit<V> fit;
    for(std::size_t i = 1; i < batch.centers(); ++i)
    {
      const V x = points[3 * i] * inverse, y = points[3 * i + 1] * inverse, z = points[3 * i + 2] * inverse;
      const V nx = normals[3 * i], ny = normals[3 * i + 1], nz = normals[3 * i + 2];
      V a, b, na, nb;
      bent.project(x, y, z, a, b);
      bent.project(nx, ny, nz, na, nb);
      const V* const w = bent.w;
      fit.add(a, b, w[0] * x + w[1] * y + w[2] * z, na, nb, w[0] * nx + w[1] * ny + w[2] * nz);
    }
    fit.solve(unit, bent.height);
    bent.height.magnify(inverse);

    V square{};
    for(std::size_t i = 1; i < batch.centers(); ++i)
    {
      V a, b, gx, gy, gz;
      bent.project(points[3 * i], points[3 * i + 1], points[3 * i + 2], a, b);
      bent.gradient(a, b, gx, gy, gz);
      const V* const s = tangents + 6 * i;
      const V* const t = s + 3;
      const V gs = gx * s[0] + gy * s[1] + gz * s[2], gt = gx * t[0] + gy * t[1] + gz * t[2];
      square += gs * gs + gt * gt;
    }
    const V& count = *vectors(batch.count);
    const V remainder = Height_polynomial_fit<V>::usual_remainder * (unit * unit * unit);
    const V excess = square / (2. * (count - 1.) * remainder * remainder);
    V one, zero{};
    set_lanes(one, 1.);
    const V falling = (4. - excess) / 3.;
    const V part = falling > 1. ? one : falling;
    V* const coefficients = vectors(batch.bend);
    for(std::size_t k = 0; k < bent.height.size; ++k)
    {
      const V coefficient = part * bent.height.c[k];
      coefficients[k] = part > 0. ? coefficient : zero;
    }
  }

  // bend_by_heights()
  [[gnu::always_inline]] static void bend_trend_by_heights(Hermite_batch& batch)
  {
    const V* const points = vectors(batch.points);
    const V* const w = vectors(batch.trend);
    const V &bends = *vectors(batch.bends), inverse = 1. / *vectors(batch.unit);
    V* const u = vectors(batch.tangents);
    V* const v = u + 3;
    find_tangents(w, u, v);
    Height_polynomial<V> height;
    if(largest(bends) > 0.)
    {
      Cubic_height_fit<V> fit;
      for(std::size_t i = 0; i < batch.centers(); ++i)
      {
        V present;
        presence(batch, i, present);
        const V x = points[3 * i] * inverse, y = points[3 * i + 1] * inverse, z = points[3 * i + 2] * inverse;
        fit.add(present, V(u[0] * x + u[1] * y + u[2] * z), V(v[0] * x + v[1] * y + v[2] * z),
                V(w[0] * x + w[1] * y + w[2] * z));
      }
      fit.solve(height);
      height.magnify(inverse);
    }
    V* const coefficients = vectors(batch.bend);
    for(std::size_t k = 0; k < height.size; ++k)
      coefficients[k] = bends * height.c[k];
  }

  [[gnu::always_inline]] static void assemble_gradients(Hermite_batch& batch,
                                                        const Basis_function& basis_function)
  {
    V* const matrix = vectors(batch.matrix);
    V* const solution = vectors(batch.solution);
    const V* const at_first = vectors(batch.at_first);
    const V* const points = vectors(batch.points);
    const V* const normals = vectors(batch.normals);
    const Bent_trend bent(batch);
    V* const first_noise = vectors(batch.first_noise);
    const V value_noise = *vectors(batch.value_noise), derivative_noise = *vectors(batch.derivative_noise);
    const bool is_near = are_near(2. * batch.radius);
    for(std::size_t i = 0; i < batch.centers(); ++i)
    {
      V present;
      presence(batch, i, present);
      const V* const p = points + 3 * i;
      V* const entries = matrix + Hermite_batch::panel(i);
      const V psi_i = at_first[3 * i], P_i = at_first[3 * i + 1], B_i = at_first[3 * i + 2];
      set_derivatives(entries, p[0], p[1], p[2], P_i, B_i);
      entries[0] = psi_i - 0.5 * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) - value_noise;
      if(i == 0)
        set_lanes(entries[0], basis_function.at_origin());
      const V of_derivative = P_i - 1.;
      for(std::size_t k = 0; k < 3; ++k)
      {
        entries[4 * (k + 1)] = -P_i * p[k];
        entries[k + 1] = of_derivative * p[k];
      }
      for(std::size_t j = 1; j <= i; ++j)
      {
        V dx, dy, dz, psi, P, B;
        relate(points, basis_function, is_near, i, j, dx, dy, dz, psi, P, B);
        const V* const q = points + 3 * j;
        const V psi_j = at_first[3 * j], P_j = at_first[3 * j + 1], B_j = at_first[3 * j + 2];
        const V pq = p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
        V* const block = entries + 16 * j;
        set_derivatives(block, dx, dy, dz, P, B);
        block[0] = (psi - (psi_i - value_noise) - psi_j) + (P_i + P_j) * pq;
        const V of_i = P_j - P, of_j = B_j * pq - of_i;
        const V for_j = P_i - P, for_i = B_i * pq - for_j;
        for(std::size_t k = 0; k < 3; ++k)
        {
          block[4 * (k + 1)] = of_i * p[k] + of_j * q[k];
          block[k + 1] = for_j * q[k] + for_i * p[k];
        }
      }
      V* const diagonal = entries + 16 * i;
      diagonal[0] += value_noise;
      if(i > 0)
        for(std::size_t k = 1; k < 4; ++k)
          diagonal[5 * k] += derivative_noise;
      if(i >= batch.smallest_count) // an equation that is absent says that its weight is 0
      {
        for(std::size_t k = 0; k < 16 * (i + 1); ++k)
          entries[k] *= present;
        for(std::size_t k = 0; k < 4; ++k)
          diagonal[5 * k] += 1. - present;
      }
      V a, b, h, gradient[3];
      bent.project(p[0], p[1], p[2], a, b);
      bent.height.value(a, b, h);
      bent.gradient(a, b, gradient[0], gradient[1], gradient[2]);
      solution[4 * i] = present * (h - (normals[0] * p[0] + normals[1] * p[1] + normals[2] * p[2]));
      for(std::size_t k = 0; k < 3; ++k)
      {
        solution[4 * i + 1 + k] = present * (normals[3 * i + k] - gradient[k]);
        V* const noise = first_noise + (k * batch.panels + i) * 4;
        noise[0] = -present * p[k];
        for(std::size_t l = 0; l < 3; ++l)
          set_lanes(noise[1 + l], i == 0 && k == l ? 1. : 0.);
      }
    }
  }

  // of derivatives at both: -A I - B d d^T
  [[gnu::always_inline]] static void
  set_derivatives(V* block, const V& dx, const V& dy, const V& dz, const V& P, const V& B)
  {
    const V minus_A = 1. - P;
    const V Bx = B * dx, By = B * dy, Bz = B * dz;
    const V xy = -Bx * dy, xz = -Bx * dz, yz = -By * dz;
    block[5] = minus_A - Bx * dx;
    block[6] = block[9] = xy;
    block[7] = block[13] = xz;
    block[10] = minus_A - By * dy;
    block[11] = block[14] = yz;
    block[15] = minus_A - Bz * dz;
  }

  // Rows 0 to 3 are those of the first center: value, tangents, normal; then come three of each center.
  [[gnu::always_inline]] static void assemble_tangents(Hermite_batch& batch,
                                                       const Basis_function& basis_function)
  {
    V* const matrix = vectors(batch.matrix);
    V* const solution = vectors(batch.solution);
    const V* const points = vectors(batch.points);
    const V* const tangents = vectors(batch.tangents);
    const V* const trend = vectors(batch.trend);
    const V value_noise = *vectors(batch.value_noise), derivative_noise = *vectors(batch.derivative_noise);
    const V* const at_first = vectors(batch.at_first);
    V* const along_tangents = vectors(batch.along_tangents);
    const Bent_trend bent(batch);
    const bool is_near = are_near(2. * batch.radius);
    for(std::size_t r = 0; r < 4; ++r)
    {
      for(std::size_t c = 0; c < 4; ++c)
        matrix[4 * c + r] = V{};
      solution[r] = V{};
    }
    matrix[0] = basis_function.at_origin() + value_noise;
    for(std::size_t k = 1; k < 4; ++k)
      matrix[5 * k] = 1. + derivative_noise;
    for(std::size_t i = 1; i < batch.centers(); ++i)
    {
      V present;
      presence(batch, i, present);
      const V* const p = points + 3 * i;
      const V* const u = tangents + 6 * i;
      const V* const v = u + 3;
      V* const value_row = row(matrix, 3 * i + 1);
      V* const u_row = row(matrix, 3 * i + 2);
      V* const v_row = row(matrix, 3 * i + 3);
      const V up = u[0] * p[0] + u[1] * p[1] + u[2] * p[2], vp = v[0] * p[0] + v[1] * p[1] + v[2] * p[2];
      const V psi_i = at_first[3 * i] - value_noise, P_i = at_first[3 * i + 1], B_i = at_first[3 * i + 2];
      const V noisy_P_i = P_i + derivative_noise;
      along_tangents[2 * i] = up;
      along_tangents[2 * i + 1] = vp;
      const V B_up = B_i * up, B_vp = B_i * vp;
      value_row[0] = psi_i - 0.5 * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
      u_row[0] = (P_i - 1.) * up;
      v_row[0] = (P_i - 1.) * vp;
      for(std::size_t k = 0; k < 3; ++k)
      {
        // tangents and normal of the first center
        const V* const w = k < 2 ? tangents + 3 * k : trend;
        const V wp = w[0] * p[0] + w[1] * p[1] + w[2] * p[2];
        value_row[4 * (k + 1)] = -noisy_P_i * wp;
        u_row[4 * (k + 1)] = -(noisy_P_i * (u[0] * w[0] + u[1] * w[1] + u[2] * w[2]) + B_up * wp);
        v_row[4 * (k + 1)] = -(noisy_P_i * (v[0] * w[0] + v[1] * w[1] + v[2] * w[2]) + B_vp * wp);
      }
      for(std::size_t j = 1; j <= i; ++j)
      {
        V dx, dy, dz, psi, P, B;
        relate(points, basis_function, is_near, i, j, dx, dy, dz, psi, P, B);
        const V* const q = points + 3 * j;
        const V psi_j = at_first[3 * j], P_j = at_first[3 * j + 1], B_j = at_first[3 * j + 2];
        const V pq = p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
        const V uq = u[0] * q[0] + u[1] * q[1] + u[2] * q[2], vq = v[0] * q[0] + v[1] * q[1] + v[2] * q[2];
        const V s = P - noisy_P_i - P_j;
        const V of_value = P - P_j + B_j * pq, for_value = P - P_i + B_i * pq;
        const V Bud = B * (up - uq), Bvd = B * (vp - vq);
        const V ui = Bud - B_up, uj = Bud + B_j * uq, vi = Bvd - B_vp, vj = Bvd + B_j * vq;
        std::size_t column = 4 * (3 * j + 1);
        value_row[column] = (psi - psi_i - psi_j) + (P - s) * pq;
        u_row[column] = for_value * up - s * uq;
        v_row[column] = for_value * vp - s * vq;
        for(std::size_t k = 0; k < 2; ++k)
        {
          column += 4;
          const V* const w = tangents + 6 * j + 3 * k;
          const V wp = w[0] * p[0] + w[1] * p[1] + w[2] * p[2], wq = along_tangents[2 * j + k];
          value_row[column] = of_value * wq - s * wp;
          u_row[column] = uj * wq - ui * wp - s * (u[0] * w[0] + u[1] * w[1] + u[2] * w[2]);
          v_row[column] = vj * wq - vi * wp - s * (v[0] * w[0] + v[1] * w[1] + v[2] * w[2]);
        }
      }
      V &value_diagonal = value_row[4 * (3 * i + 1)], &u_diagonal = u_row[4 * (3 * i + 2)],
        &v_diagonal = v_row[4 * (3 * i + 3)];
      value_diagonal += value_noise;
      u_diagonal += derivative_noise;
      v_diagonal += derivative_noise;
      if(i >= batch.smallest_count)
      {
        for(std::size_t k = 0; k < 3 * i + 4; ++k)
        {
          value_row[4 * k] *= present;
          u_row[4 * k] *= present;
          v_row[4 * k] *= present;
        }
        const V absent = 1. - present;
        value_diagonal += absent;
        u_diagonal += absent;
        v_diagonal += absent;
      }
      V a, b, h, gx, gy, gz;
      bent.project(p[0], p[1], p[2], a, b);
      bent.height.value(a, b, h);
      bent.gradient(a, b, gx, gy, gz);
      solution[3 * i + 1] = present * (h - (trend[0] * p[0] + trend[1] * p[1] + trend[2] * p[2]));
      solution[3 * i + 2] = -present * (gx * u[0] + gy * u[1] + gz * u[2]);
      solution[3 * i + 3] = -present * (gx * v[0] + gy * v[1] + gz * v[2]);
    }
    fill_last_panel(batch);
  }
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_FUNCTION_ON_LANES_H
