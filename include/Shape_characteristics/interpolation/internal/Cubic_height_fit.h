#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_CUBIC_HEIGHT_FIT_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_CUBIC_HEIGHT_FIT_H

#include <Shape_characteristics/interpolation/internal/Height_polynomial.h>
#include <Shape_characteristics/interpolation/internal/Lanes.h>

namespace Shape_characteristics {
namespace internal {

/*
  Fits a polynomial of degree 3 to heights over a plane by least squares, and makes a Height_polynomial of it: zero, unless the
  heights are nearly those of the polynomial, and the points are around the origin. Near a border, a polynomial may be anything where
  no point holds it.

  Points are at distances of about 1. The coefficients are held to zero a little, so that there is an answer however the points lie.
  The squares of a degree are added over binomial coefficients: a sum that doesn't depend on the direction of the axes. Constant and
  linear terms take their part in the fit, and are left out of the answer.
*/
template <typename V>
class Cubic_height_fit
{
public:
  // a point that counts if `weight` is 1, and not if it is 0
  [[gnu::always_inline]] void add(const V& weight, const V& x, const V& y, const V& height)
  {
    V xs[s_moments], ys[s_moments];
    set_powers(x, xs);
    set_powers(y, ys);
    for(int a = 0; a < s_moments; ++a)
    {
      const V weighted = weight * xs[a];
      for(int b = 0; a + b < s_moments; ++b)
        m_moments[a][b] += weighted * ys[b];
    }
    for(int degree = 0, k = 0; degree <= s_degree; ++degree)
      for(int b = 0; b <= degree; ++b, ++k)
        m_right[k] += weight * height * xs[degree - b] * ys[b];
    m_square += weight * height * height;
  }

  [[gnu::always_inline]] void solve(Height_polynomial<V>& polynomial) const
  {
    const V &number_of_points = m_moments[0][0], held = s_held * number_of_points;
    V factor[s_size][s_size], inverse[s_size], y[s_size]; // L D L^T, inverse D
    V remainder = m_square;
    for(int di = 0, i = 0; di <= s_degree; ++di)
      for(int bi = 0; bi <= di; ++bi, ++i)
      {
        y[i] = m_right[i];
        for(int dj = 0, j = 0; dj <= di; ++dj)
          for(int bj = 0; bj <= dj && j <= i; ++bj, ++j)
          {
            V entry = m_moments[di - bi + dj - bj][bi + bj];
            if(i == j)
              entry += i < s_lower ? held : held / Height_polynomial<V>::binomials[i - s_lower];
            for(int k = 0; k < j; ++k)
              entry -= factor[i][k] * factor[j][k] * inverse[k];
            if(i == j)
              inverse[i] = 1. / entry;
            else
              factor[i][j] = entry;
          }
        for(int k = 0; k < i; ++k)
          y[i] -= factor[i][k] * y[k];
        remainder -= y[i] * y[i] * inverse[i];
        y[i] *= inverse[i];
      }
    for(int i = s_size; i-- > s_lower;)
    {
      V& c = polynomial.c[i - s_lower];
      c = y[i];
      for(int k = i + 1; k < s_size; ++k)
        c -= factor[k][i] * inverse[i] * polynomial.c[k - s_lower];
    }

    const V offset = (m_moments[1][0] * m_moments[1][0] + m_moments[0][1] * m_moments[0][1]) /
                     (number_of_points * number_of_points);
    V one, zero{};
    set_lanes(one, 1.);
    // 1 up to one limit, 0 from the next, and falling between them
    const V freedom = number_of_points - double(s_size);
    const V of_remainder = (4. - remainder / (s_remainder * s_remainder * freedom)) / 3.;
    const V of_offset = (s_most_offset * s_most_offset - offset) /
                        (s_most_offset * s_most_offset - s_least_offset * s_least_offset);
    const V smaller = of_remainder < of_offset ? of_remainder : of_offset;
    const V known = freedom > .5 ? smaller : zero;
    const V limited = known > 1. ? one : known;
    const V part = limited > 0. ? limited : zero;
    for(int k = 0; k < s_size - s_lower; ++k)
      polynomial.c[k] *= part;
  }

private:
  static constexpr int s_degree = 3, s_moments = 2 * s_degree + 1;
  static constexpr int s_size = 10, s_lower = 3; // coefficients: all, and those that are left out
  // Of heights, root mean square: twice as much is too much. On coarser meshes, the answer would be no better than a plane.
  static constexpr double s_remainder = 7e-4;
  static constexpr double s_held = 1e-4;                           // of the number of points
  static constexpr double s_least_offset = .3, s_most_offset = .5; // of the points' centroid

  V m_moments[s_moments][s_moments] = {}; // sums of x^a y^b of all points
  V m_right[s_size] = {};
  V m_square = {};
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_CUBIC_HEIGHT_FIT_H
