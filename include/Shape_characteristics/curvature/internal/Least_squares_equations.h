#ifndef SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_LEAST_SQUARES_EQUATIONS_H
#define SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_LEAST_SQUARES_EQUATIONS_H

#include <array>
#include <cmath>
#include <cstddef>

namespace Shape_characteristics {
namespace internal {

// Least squares in few unknowns by Cholesky's method. Plain loops: matrices of a fixed size of Eigen's are unrolled, which
// takes minutes to compile.
template <std::size_t size>
class Least_squares_equations
{
public:
  using Coefficients = std::array<double, size>;

  void add(const Coefficients& row, double value)
  {
    for(std::size_t i = 0; i < size; ++i)
    {
      for(std::size_t j = 0; j <= i; ++j)
        m_matrix[i][j] += row[i] * row[j];
      m_right_side[i] += value * row[i];
    }
  }

  // Whether there is one solution. `smallest_pivot`: of the columns of the equations, the smallest part that is no
  // combination of those before it; about 0.1 where all is well, and 1e-8 where rounding errors are all there is.
  bool solve(Coefficients& x, double smallest_pivot = 1e-6)
  {
    Coefficients& d = m_lengths;
    for(std::size_t i = 0; i < size; ++i)
    {
      if(!(m_matrix[i][i] > 0.))
        return false;
      d[i] = std::sqrt(m_matrix[i][i]);
    }
    Coefficients y{};
    for(std::size_t i = 0; i < size; ++i)
    {
      y[i] = m_right_side[i] / d[i];
      for(std::size_t j = 0; j <= i; ++j)
      {
        double& entry = m_matrix[i][j];
        entry /= d[i] * d[j];
        for(std::size_t k = 0; k < j; ++k)
          entry -= m_matrix[i][k] * m_matrix[j][k];
        if(j < i)
        {
          entry /= m_matrix[j][j];
          y[i] -= entry * y[j];
        }
        else
        {
          entry = std::sqrt(entry);
          if(!(entry > smallest_pivot))
            return false;
        }
      }
      y[i] /= m_matrix[i][i];
    }
    for(std::size_t i = size; i-- > 0;)
    {
      for(std::size_t k = i + 1; k < size; ++k)
        y[i] -= m_matrix[k][i] * y[k];
      y[i] /= m_matrix[i][i];
    }
    for(std::size_t i = 0; i < size; ++i)
      x[i] = y[i] / d[i];
    return true;
  }

  // The part of the `i`th column of the equations, compared to the column, that is no combination of all others. After
  // solve() only, as the next one.
  double independence(std::size_t i) const
  {
    // column i of the inverse of the triangle: its square is the entry of the inverse of the matrix
    Coefficients column{};
    double sum = 0.;
    for(std::size_t j = i; j < size; ++j)
    {
      column[j] = i == j ? 1. : 0.;
      for(std::size_t k = i; k < j; ++k)
        column[j] -= m_matrix[j][k] * column[k];
      column[j] /= m_matrix[j][j];
      sum += column[j] * column[j];
    }
    return 1. / std::sqrt(sum);
  }

  // How far the `i`th coefficient is off, at most, where the values of the equations are off by a vector of length one.
  double error_factor(std::size_t i) const { return 1. / (m_lengths[i] * independence(i)); }

private:
  std::array<Coefficients, size> m_matrix{}; // the lower triangle
  Coefficients m_right_side{};
  Coefficients m_lengths{}; // of the columns of the equations
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_LEAST_SQUARES_EQUATIONS_H
