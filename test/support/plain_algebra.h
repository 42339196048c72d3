#ifndef SHAPE_CHARACTERISTICS_TEST_SUPPORT_PLAIN_ALGEBRA_H
#define SHAPE_CHARACTERISTICS_TEST_SUPPORT_PLAIN_ALGEBRA_H

#include <Eigen/Core>

// What plain implementations in the tests need of Eigen's decompositions, compiled once: they take a compiler longer than
// most tests.
namespace test_support {

using Long_matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

/// The `x` with the least sum of squares of `matrix * x - right`, a column for each of `right`.
Eigen::MatrixXd least_squares(const Eigen::Ref<const Eigen::MatrixXd>& matrix,
                              const Eigen::Ref<const Eigen::MatrixXd>& right);
Long_matrix least_squares(const Eigen::Ref<const Long_matrix>& matrix,
                          const Eigen::Ref<const Long_matrix>& right);

/// The eigenvalues of a symmetric matrix, ascending.
Eigen::Vector2d symmetric_eigenvalues(const Eigen::Matrix2d& matrix);

/// The left singular vectors as columns, by descending singular value.
Eigen::Matrix3d left_singular_vectors(const Eigen::Matrix3d& matrix);

/// The shortest rotation from one direction to another.
Eigen::Matrix3d shortest_rotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

} // namespace test_support

#endif // SHAPE_CHARACTERISTICS_TEST_SUPPORT_PLAIN_ALGEBRA_H
