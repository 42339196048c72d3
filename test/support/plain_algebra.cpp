#include "plain_algebra.h"

#include <Eigen/Dense>

namespace test_support {

Eigen::MatrixXd least_squares(const Eigen::Ref<const Eigen::MatrixXd>& matrix,
                              const Eigen::Ref<const Eigen::MatrixXd>& right)
{
  return matrix.colPivHouseholderQr().solve(right);
}

Long_matrix least_squares(const Eigen::Ref<const Long_matrix>& matrix,
                          const Eigen::Ref<const Long_matrix>& right)
{
  return matrix.colPivHouseholderQr().solve(right);
}

Eigen::Vector2d symmetric_eigenvalues(const Eigen::Matrix2d& matrix)
{
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
}

Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& matrix)
{
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
}

Eigen::Matrix3d left_singular_vectors(const Eigen::Matrix3d& matrix)
{
  return Eigen::JacobiSVD<Eigen::Matrix3d>(matrix, Eigen::ComputeFullU).matrixU();
}

Eigen::Matrix3d shortest_rotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to)
{
  return Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix();
}

} // namespace test_support
