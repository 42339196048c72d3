#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HEIGHT_POLYNOMIAL_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HEIGHT_POLYNOMIAL_H

#include <cstddef>

namespace Shape_characteristics {
namespace internal {

/*
  A height over a tangent plane that it touches at the origin: the polynomial of degree 4

    h(x, y) = c0 x^2 + c1 x y + c2 y^2 + c3 x^3 + ... + c6 y^3 + c7 x^4 + ... + c11 y^4

  of numbers, or of Lanes; so functions take and give references.
*/
template <typename V>
struct Height_polynomial
{
  static constexpr int least_degree = 2, degree = 4;
  static constexpr std::size_t size = 12;
  static constexpr double binomials[size] = {1., 2., 1., 1., 3., 3., 1., 1., 4., 6., 4., 1.};

  [[gnu::always_inline]] void value(const V& x, const V& y, V& h) const
  {
    const V xx = x * x, xy = x * y, yy = y * y;
    h = xx * (c[0] + c[3] * x + c[4] * y + c[7] * xx + c[8] * xy + c[9] * yy) + c[1] * xy +
        yy * (c[2] + c[5] * x + c[6] * y + c[10] * xy + c[11] * yy);
  }

  [[gnu::always_inline]] void gradient(const V& x, const V& y, V& hx, V& hy) const
  {
    const V xx = x * x, xy = x * y, yy = y * y;
    hx = x * (2. * c[0] + 3. * (c[3] * x + c[8] * xy) + 2. * (c[4] * y + c[9] * yy) + 4. * (c[7] * xx)) +
         y * (c[1] + c[5] * y + c[10] * yy);
    hy = y * (2. * c[2] + 3. * (c[6] * y + c[10] * xy) + 2. * (c[5] * x + c[9] * xx) + 4. * (c[11] * yy)) +
         x * (c[1] + c[4] * x + c[8] * xx);
  }

  [[gnu::always_inline]] void hessian(const V& x, const V& y, V& hxx, V& hxy, V& hyy) const
  {
    const V xx = x * x, xy = x * y, yy = y * y;
    hxx = 2. * (c[0] + c[4] * y + c[9] * yy) + 6. * (c[3] * x + c[8] * xy) + 12. * (c[7] * xx);
    hxy = c[1] + 2. * (c[4] * x + c[5] * y) + 3. * (c[8] * xx + c[10] * yy) + 4. * (c[9] * xy);
    hyy = 2. * (c[2] + c[5] * x + c[9] * xx) + 6. * (c[6] * y + c[10] * xy) + 12. * (c[11] * yy);
  }

  // that of a surface 1 / `inverse` times as large
  [[gnu::always_inline]] void magnify(const V& inverse)
  {
    V power = inverse;
    for(int d = least_degree, k = 0; d <= degree; ++d)
    {
      for(int b = 0; b <= d; ++b, ++k)
        c[k] = c[k] * power;
      power = power * inverse;
    }
  }

  V c[size] = {};
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HEIGHT_POLYNOMIAL_H
