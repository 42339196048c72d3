#include "plain_algebra.h"

#include <Eigen/Dense>

#include <cmath>

namespace test_support {

Eigen::MatrixXd least_squares(const Eigen::Ref<const Eigen::MatrixXd>& matrix,
                              const Eigen::Ref<const Eigen::MatrixXd>& right)
{
  return Eigen::JacobiSVD<Eigen::MatrixXd>(matrix, Eigen::ComputeThinU | Eigen::ComputeThinV).solve(right);
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

Eigen::Matrix3d left_singular_vectors(const Eigen::Matrix3d& matrix)
{
  return Eigen::JacobiSVD<Eigen::MatrixXd>(matrix, Eigen::ComputeFullU).matrixU();
}

Eigen::Matrix3d shortest_rotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to)
{
  const Eigen::Vector3d axis = from.cross(to); // none if they are parallel: any will do
  return Eigen::AngleAxisd(std::atan2(axis.norm(), from.dot(to)),
                           axis.isZero(0.) ? from.unitOrthogonal() : Eigen::Vector3d(axis.normalized()))
      .toRotationMatrix();
}

} // namespace test_support
