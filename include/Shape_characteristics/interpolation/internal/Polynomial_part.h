#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_POLYNOMIAL_PART_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_POLYNOMIAL_PART_H

#include <Shape_characteristics/interpolation/internal/Hermite_jet.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// The monomials of three variables, up to a degree; none if it is negative.
class Polynomial_part
{
public:
  static constexpr int largest_degree = 8;

  explicit Polynomial_part(int degree = -1) : m_degree(degree)
  {
    for(int total = 0; total <= degree; ++total)
      for(int a = total; a >= 0; --a)
        for(int b = total - a; b >= 0; --b)
          m_exponents.push_back({a, b, total - a - b});
  }

  int degree() const { return m_degree; }
  std::size_t size() const { return m_exponents.size(); }

  // `function(k, jet)` with value and derivatives at `x` of each of them
  template <typename Function>
  void for_each_jet(const Eigen::Vector3d& x, const Function& function) const
  {
    std::array<Eigen::Vector3d, largest_degree + 1> powers;
    powers[0].setOnes();
    for(std::size_t e = 1; e < powers.size(); ++e)
      powers[e] = powers[e - 1].cwiseProduct(x);
    for(std::size_t k = 0; k < size(); ++k)
    {
      Eigen::Vector3d value, first, second; // of the power of each coordinate
      for(Eigen::Index c = 0; c < 3; ++c)
      {
        const int e = m_exponents[k][std::size_t(c)];
        value[c] = powers[std::size_t(e)][c];
        first[c] = e < 1 ? 0. : e * powers[std::size_t(e - 1)][c];
        second[c] = e < 2 ? 0. : e * (e - 1) * powers[std::size_t(e - 2)][c];
      }
      Hermite_jet jet;
      jet.value = value.prod();
      for(Eigen::Index c = 0; c < 3; ++c)
      {
        const Eigen::Index d = (c + 1) % 3, e = (c + 2) % 3;
        jet.gradient[c] = first[c] * value[d] * value[e];
        jet.hessian(c, c) = second[c] * value[d] * value[e];
        jet.hessian(c, d) = jet.hessian(d, c) = first[c] * first[d] * value[e];
      }
      function(k, jet);
    }
  }

private:
  int m_degree;
  std::vector<std::array<int, 3> > m_exponents;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_POLYNOMIAL_PART_H
