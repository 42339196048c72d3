#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_SYSTEM_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_SYSTEM_H

#include <Shape_characteristics/interpolation/internal/Hermite_trend.h>
#include <Shape_characteristics/interpolation/internal/Polynomial_part.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/QR>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

/*
  The function (thesis, equation 3.9, with a trend)

    f(x) = t(x) + sum_j alpha_j phi(|x - p_j|) - beta_j . grad phi(|x - p_j|) [+ q(x)]

  with prescribed values, and prescribed derivatives along some directions, at its centers p_j. One equation for
  each; alpha_j belongs to the value, beta_j is spanned by the directions. With all three directions at each center that
  is the thesis's system of 4m equations (3.11).

  The matrix applies the functionals that define the data to both arguments of phi(|x - y|): it is symmetric, and positive
  definite if phi is. With d = p_i - p_j, and phi, A, B the first three radial derivatives at |d|^2, its entries are

    value at i, value at j            phi
    value at i, derivative v at j     -A (v.d)
    derivative u at i, value at j     A (u.d)
    derivatives u at i, v at j        -A (u.v) - B (u.d) (v.d)

  A basis function that is conditionally definite, of order m, makes the matrix definite for weights that see no polynomial of a
  degree less than m: these, and a polynomial q of such a degree, are what a polynomial part adds.

  An object may be used again and again: it keeps its memory.
*/
template <typename RadialBasisFunction>
class Hermite_system
{
public:
  // `polynomial_degree`: of the polynomial part, for solve_indefinite(); negative: there is none
  void clear(const RadialBasisFunction& phi, const Hermite_trend& trend, int polynomial_degree = -1)
  {
    if(m_polynomial.degree() != polynomial_degree)
      m_polynomial = Polynomial_part(polynomial_degree);
    m_coefficients.setZero(0);
    m_phi = phi;
    // noise levels are meant for phi''(0) = -1
    m_factor = RadialBasisFunction::is_positive_definite ? -1. / phi.radial_derivatives(0.)[1] : 1.;
    m_trend = trend;
    m_points.clear();
    m_directions.clear();
    m_first.assign(1, 0);
    m_data.clear();
  }

  // a center, its value, and the derivatives there (of the trend and the rest together) along `directions`
  template <std::size_t n>
  void add_center(const Eigen::Vector3d& point,
                  double value,
                  const std::array<Eigen::Vector3d, n>& directions,
                  const std::array<double, n>& derivatives)
  {
    m_points.push_back(point);
    const Hermite_jet trend = m_trend(point);
    m_data.push_back(value - trend.value);
    for(std::size_t k = 0; k < n; ++k)
    {
      m_directions.push_back(directions[k]);
      m_data.push_back(derivatives[k] - trend.gradient.dot(directions[k]));
    }
    m_first.push_back(m_data.size());
  }

  std::size_t number_of_centers() const { return m_points.size(); }
  std::size_t number_of_equations() const { return m_data.size(); }

  // Solves with a positive definite phi. The noise variances are added to the diagonal: zero interpolates, more is the
  // posterior mean of a Gaussian process. Returns false if the matrix is not positive definite in floating point.
  bool solve_positive_definite(double value_noise, double derivative_noise)
  {
    const Eigen::Index n = assemble(true);
    Eigen::Map<Eigen::MatrixXd> matrix(m_matrix.data(), n, n);
    for(std::size_t j = 0; j < number_of_centers(); ++j)
    {
      matrix(Eigen::Index(m_first[j]), Eigen::Index(m_first[j])) += value_noise;
      for(std::size_t k = m_first[j] + 1; k < m_first[j + 1]; ++k)
        matrix(Eigen::Index(k), Eigen::Index(k)) += derivative_noise;
    }
    Eigen::Ref<Eigen::MatrixXd> in_place(matrix);
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>, Eigen::Lower> cholesky(in_place);
    if(cholesky.info() != Eigen::Success)
      return false;
    m_weights = m_data;
    Eigen::Map<Eigen::VectorXd> weights(m_weights.data(), n);
    cholesky.matrixL().solveInPlace(weights);
    m_mahalanobis_square = weights.squaredNorm();
    m_log_likelihood = -m_mahalanobis_square / 2.;
    for(Eigen::Index k = 0; k < n; ++k)
      m_log_likelihood -= std::log(matrix(k, k));
    cholesky.matrixU().solveInPlace(weights);
    find_residual(value_noise, derivative_noise);
    collect_weights();
    return weights.allFinite();
  }

  // Solves with any phi, by LU with partial pivoting (thesis, 8.1.4). Returns false if the matrix is singular. Of a polynomial part,
  // the equations must be twice as many as its monomials, or it has a lower degree.
  bool solve_indefinite()
  {
    while(2 * m_polynomial.size() > number_of_equations())
      m_polynomial = Polynomial_part(m_polynomial.degree() - 1);
    if(m_polynomial.size() > 0)
      return solve_with_polynomial();
    const Eigen::Index n = assemble(false);
    Eigen::Map<Eigen::MatrixXd> matrix(m_matrix.data(), n, n);
    Eigen::Ref<Eigen::MatrixXd> in_place(matrix);
    const Eigen::PartialPivLU<Eigen::Ref<Eigen::MatrixXd> > lu(in_place);
    if((lu.matrixLU().diagonal().array() == 0.).any())
      return false;
    m_weights = m_data;
    Eigen::Map<Eigen::VectorXd> weights(m_weights.data(), n);
    weights = lu.solve(Eigen::Map<const Eigen::VectorXd>(m_data.data(), n)).eval();
    collect_weights();
    return weights.allFinite();
  }

  // log of the probability density of the data, up to a constant: after solve_positive_definite()
  double log_likelihood() const { return m_log_likelihood; }

  // what the function leaves of the data, but at the first center, as a sum of squares, each divided by the variance of its
  // noise: after solve_positive_definite()
  double residual() const { return m_residual; }

  // of the data from the trend; on average the number of equations, if their covariance is what the matrix says: after
  // solve_positive_definite()
  double mahalanobis_square() const { return m_mahalanobis_square; }

  Hermite_jet operator()(const Eigen::Vector3d& x) const
  {
    Hermite_jet jet = m_trend(x);
    for(std::size_t j = 0; j < number_of_centers(); ++j)
    {
      const Eigen::Vector3d d = x - m_points[j];
      const auto [phi, A, B, C] = m_phi.radial_derivatives(d.squaredNorm());
      const double alpha = m_factor * m_alpha[j];
      const Eigen::Vector3d beta = m_factor * m_beta[j];
      const double s = beta.dot(d);
      jet.value += alpha * phi - A * s;
      jet.gradient += (alpha * A - B * s) * d - A * beta;
      jet.hessian +=
          (alpha * B - C * s) * d * d.transpose() - B * (beta * d.transpose() + d * beta.transpose());
      jet.hessian.diagonal().array() += alpha * A - B * s;
    }
    if(m_coefficients.size() > 0)
      m_polynomial.for_each_jet(x,
                                [&](const std::size_t k, const Hermite_jet& monomial)
                                {
                                  const double c = m_coefficients[Eigen::Index(k)];
                                  jet.value += c * monomial.value;
                                  jet.gradient += c * monomial.gradient;
                                  jet.hessian += c * monomial.hessian;
                                });
    return jet;
  }

private:
  // The weights are of those that see none of the monomials: in the basis of an orthogonal decomposition of what the data are of
  // these, the last ones. Monomials that data don't tell from others, as those of the height over a plane, have no part.
  bool solve_with_polynomial()
  {
    constexpr double indistinct = 1e-9;
    const Eigen::Index n = assemble(false), monomials = Eigen::Index(m_polynomial.size());
    const Eigen::Map<const Eigen::MatrixXd> matrix(m_matrix.data(), n, n);
    const Eigen::Map<const Eigen::VectorXd> data(m_data.data(), n);
    Eigen::MatrixXd of_monomials(n, monomials);
    for(std::size_t j = 0; j < number_of_centers(); ++j)
      m_polynomial.for_each_jet(m_points[j],
                                [&](const std::size_t k, const Hermite_jet& monomial)
                                {
                                  const auto column = Eigen::Index(k);
                                  of_monomials(Eigen::Index(m_first[j]), column) = monomial.value;
                                  for(std::size_t row = m_first[j] + 1; row < m_first[j + 1]; ++row)
                                    of_monomials(Eigen::Index(row), column) =
                                        monomial.gradient.dot(m_directions[row - 1 - j]);
                                });
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition(n, monomials);
    decomposition.setThreshold(indistinct);
    decomposition.compute(of_monomials);
    const Eigen::Index rank = decomposition.rank(), rest = n - rank;
    const auto q = decomposition.householderQ();
    const Eigen::MatrixXd turned = (q.adjoint() * (matrix * q)).eval();
    const Eigen::VectorXd turned_data = q.adjoint() * data;
    const Eigen::PartialPivLU<Eigen::MatrixXd> lu(turned.bottomRightCorner(rest, rest));
    if((lu.matrixLU().diagonal().array() == 0.).any())
      return false;
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(n);
    weights.tail(rest) = lu.solve(turned_data.tail(rest));
    const Eigen::VectorXd left =
        turned_data.head(rank) - turned.topRightCorner(rank, rest) * weights.tail(rest);
    Eigen::VectorXd coefficients = Eigen::VectorXd::Zero(monomials);
    coefficients.head(rank) =
        decomposition.matrixR().topLeftCorner(rank, rank).template triangularView<Eigen::Upper>().solve(left);
    m_coefficients = decomposition.colsPermutation() * coefficients;
    weights = (q * weights).eval();
    m_weights.assign(weights.data(), weights.data() + n);
    collect_weights();
    return weights.allFinite() && m_coefficients.allFinite();
  }

  // fills the lower triangle, or all
  Eigen::Index assemble(bool lower)
  {
    const Eigen::Index n = Eigen::Index(number_of_equations());
    m_matrix.resize(std::size_t(n) * std::size_t(n));
    Eigen::Map<Eigen::MatrixXd> matrix(m_matrix.data(), n, n);
    for(std::size_t j = 0; j < number_of_centers(); ++j)
      for(std::size_t i = j; i < number_of_centers(); ++i)
        assemble_block(i, j, matrix);
    if(!lower)
      matrix.template triangularView<Eigen::StrictlyUpper>() = matrix.transpose();
    return n;
  }

  void assemble_block(std::size_t i, std::size_t j, Eigen::Map<Eigen::MatrixXd>& matrix)
  {
    const Eigen::Vector3d d = m_points[i] - m_points[j];
    const std::array<double, 4> radial = m_phi.radial_derivatives(d.squaredNorm());
    const double A = m_factor * radial[1], B = m_factor * radial[2];
    const Eigen::Index row = Eigen::Index(m_first[i]), column = Eigen::Index(m_first[j]);
    const Eigen::Index rows = Eigen::Index(m_first[i + 1]) - row;
    const Eigen::Index columns = Eigen::Index(m_first[j + 1]) - column;
    const Eigen::Vector3d* u = m_directions.data() + (m_first[i] - i);
    const Eigen::Vector3d* v = m_directions.data() + (m_first[j] - j);

    std::array<double, 3> ud{};
    for(Eigen::Index k = 1; k < rows; ++k)
      ud[k - 1] = u[k - 1].dot(d);
    matrix(row, column) = m_factor * radial[0];
    for(Eigen::Index k = 1; k < rows; ++k)
      matrix(row + k, column) = A * ud[k - 1];
    for(Eigen::Index l = 1; l < columns; ++l)
    {
      const double vd = v[l - 1].dot(d);
      matrix(row, column + l) = -A * vd;
      for(Eigen::Index k = 1; k < rows; ++k)
        matrix(row + k, column + l) = -A * u[k - 1].dot(v[l - 1]) - B * ud[k - 1] * vd;
    }
  }

  // The noise times the weights is what the function leaves of the data.
  void find_residual(double value_noise, double derivative_noise)
  {
    m_residual = 0.;
    for(std::size_t j = 1; j < number_of_centers(); ++j)
    {
      m_residual += value_noise * m_weights[m_first[j]] * m_weights[m_first[j]];
      for(std::size_t k = m_first[j] + 1; k < m_first[j + 1]; ++k)
        m_residual += derivative_noise * m_weights[k] * m_weights[k];
    }
  }

  void collect_weights()
  {
    m_alpha.resize(number_of_centers());
    m_beta.resize(number_of_centers());
    for(std::size_t j = 0; j < number_of_centers(); ++j)
    {
      m_alpha[j] = m_weights[m_first[j]];
      m_beta[j].setZero();
      for(std::size_t k = m_first[j] + 1; k < m_first[j + 1]; ++k)
        m_beta[j] += m_weights[k] * m_directions[k - 1 - j];
    }
  }

  RadialBasisFunction m_phi;
  double m_factor = 1.;
  Hermite_trend m_trend;
  Polynomial_part m_polynomial;
  Eigen::VectorXd m_coefficients; // of its monomials
  std::vector<Eigen::Vector3d> m_points, m_directions, m_beta;
  std::vector<std::size_t> m_first = std::vector<std::size_t>(1, 0); // equation of each center's value
  // Aligned for vector instructions: elsewhere Eigen adds in another order, and rounding would depend on addresses.
  std::vector<double, Eigen::aligned_allocator<double> > m_data, m_weights, m_matrix;
  std::vector<double> m_alpha;
  double m_log_likelihood = 0., m_mahalanobis_square = 0., m_residual = 0.;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_SYSTEM_H
