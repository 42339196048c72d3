// of matrices, by Eigen

#include <Eigen/Dense>

namespace Eigen {

SHAPE_CHARACTERISTICS_TEMPLATE class JacobiSVD<MatrixXd>;
SHAPE_CHARACTERISTICS_TEMPLATE void SVDBase<JacobiSVD<MatrixXd> >::_solve_impl(const VectorXd&,
                                                                               VectorXd&) const;
SHAPE_CHARACTERISTICS_TEMPLATE class LDLT<MatrixXd>;
SHAPE_CHARACTERISTICS_TEMPLATE LDLT<MatrixXd>& LDLT<MatrixXd>::compute(const EigenBase<MatrixXd>&);
SHAPE_CHARACTERISTICS_TEMPLATE void LDLT<MatrixXd>::_solve_impl_transposed<true>(const VectorXd&,
                                                                                 VectorXd&) const;
SHAPE_CHARACTERISTICS_TEMPLATE SelfAdjointEigenSolver<Matrix3d>&
SelfAdjointEigenSolver<Matrix3d>::compute(const EigenBase<Matrix3d>&, int);
SHAPE_CHARACTERISTICS_TEMPLATE SelfAdjointEigenSolver<Matrix<double, 6, 6> >&
SelfAdjointEigenSolver<Matrix<double, 6, 6> >::compute(const EigenBase<Matrix<double, 6, 6> >&, int);

} // namespace Eigen
