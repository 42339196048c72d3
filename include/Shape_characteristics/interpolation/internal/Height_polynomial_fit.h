#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HEIGHT_POLYNOMIAL_FIT_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HEIGHT_POLYNOMIAL_FIT_H

#include <Shape_characteristics/interpolation/internal/Height_polynomial.h>
#include <Shape_characteristics/interpolation/internal/Lanes.h>

namespace Shape_characteristics {
namespace internal {

/*
  Fits a Height_polynomial to points and normals by least squares, and holds its coefficients to zero as a basis function of
  shape parameter `unit` does: it expects one of degree d to be of the size of unit^(d - 1), and what is left of that of
  unit^4. The squares of a degree are added over binomial coefficients: a sum that doesn't depend on the direction of the axes.

  A normal (nx, ny, nz) says that the slopes are -nx / nz and -ny / nz; it counts, and so does its point, with weight nz^2.
*/
template <typename V>
class Height_polynomial_fit
{
  using Polynomial = Height_polynomial<V>;

public:
  // of slopes, in units of unit^3: where more is left, points are too far from each other for a polynomial
  static constexpr double usual_remainder = 0.05;

  [[gnu::always_inline]] void add(const V& x, const V& y, const V& z, const V& nx, const V& ny, const V& nz)
  {
    V xs[s_moments], ys[s_moments];
    set_powers(x, xs);
    set_powers(y, ys);
    const V weight = nz * nz, height = weight * z, slope_x = -nx * nz, slope_y = -ny * nz;
    for(int a = 0; a < s_moments; ++a)
    {
      const V weighted = weight * xs[a];
      for(int b = a < 2 ? 2 - a : 0; a + b < s_moments; ++b)
        m_moments[a][b] += weighted * ys[b];
    }
    for(int degree = Polynomial::least_degree, k = 0; degree <= Polynomial::degree; ++degree)
      for(int b = 0; b <= degree; ++b, ++k)
      {
        const int a = degree - b;
        V sum = height * xs[a] * ys[b];
        if(a > 0)
          sum += double(a) * (slope_x * xs[a - 1] * ys[b]);
        if(b > 0)
          sum += double(b) * (slope_y * xs[a] * ys[b - 1]);
        m_right[k] += sum;
      }
  }

  [[gnu::always_inline]] void solve(const V& unit, Polynomial& polynomial) const
  {
    constexpr int n = int(Polynomial::size);
    const V square = unit * unit;
    const V held[3] = {square * square * square, square * square, square};
    V matrix[n][n]; // its factor, with inverse diagonal
    V y[n];
    V one;
    set_lanes(one, 1.);
    for(int di = 0, i = 0; di <= 2; ++di)
      for(int bi = 0; bi <= di + 2; ++bi, ++i)
      {
        const int ai = di + 2 - bi;
        for(int dj = 0, j = 0; dj <= di; ++dj)
          for(int bj = 0; bj <= dj + 2 && j <= i; ++bj, ++j)
          {
            const int aj = dj + 2 - bj, a = ai + aj, b = bi + bj;
            V entry = m_moments[a][b];
            if(ai > 0 && aj > 0)
              entry += double(ai * aj) * m_moments[a - 2][b];
            if(bi > 0 && bj > 0)
              entry += double(bi * bj) * m_moments[a][b - 2];
            if(i == j)
              entry += held[di] / Polynomial::binomials[i];
            for(int k = 0; k < j; ++k)
              entry -= matrix[i][k] * matrix[j][k];
            if(i == j)
            {
              const V usable = entry > 1e-280 ? entry : one;
              inverse_sqrt(usable, matrix[i][i]);
            }
            else
              matrix[i][j] = entry * matrix[j][j];
          }
        V right = m_right[i];
        for(int k = 0; k < i; ++k)
          right -= matrix[i][k] * y[k];
        y[i] = right * matrix[i][i];
      }
    for(int i = n; i-- > 0;)
    {
      V x = y[i];
      for(int k = i + 1; k < n; ++k)
        x -= matrix[k][i] * polynomial.c[k];
      polynomial.c[i] = x * matrix[i][i];
    }
  }

private:
  static constexpr int s_moments = 2 * Polynomial::degree + 1;

  V m_moments[s_moments][s_moments] = {}; // sums of x^a y^b of all points
  V m_right[Polynomial::size] = {};
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HEIGHT_POLYNOMIAL_FIT_H
