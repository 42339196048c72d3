#ifndef SHAPE_CHARACTERISTICS_INTERNAL_SOLVE_POSITIVE_SEMIDEFINITE_H
#define SHAPE_CHARACTERISTICS_INTERNAL_SOLVE_POSITIVE_SEMIDEFINITE_H

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace Shape_characteristics {
namespace internal {

// Solves a small symmetric system, of which the lower triangle is read. Of any size, so that it is compiled but once: for each fixed
// size, the compiler takes longer than for most of what this is called by.
inline Eigen::VectorXd solve_positive_semidefinite(const Eigen::MatrixXd& matrix,
                                                   const Eigen::VectorXd& right)
{
  return matrix.ldlt().solve(right);
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_SOLVE_POSITIVE_SEMIDEFINITE_H
