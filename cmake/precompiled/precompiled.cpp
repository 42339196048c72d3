#include "precompiled.h"

template bool CGAL::IO::read_polygon_mesh(const std::string&,
                                          CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>&,
                                          const CGAL::parameters::Default_named_parameters&);
template bool CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(
    const std::string&,
    CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>&,
    const CGAL::parameters::Default_named_parameters&);

namespace Eigen {

template class JacobiSVD<MatrixXd>;
template class LDLT<MatrixXd>;
template LDLT<MatrixXd>& LDLT<MatrixXd>::compute(const EigenBase<MatrixXd>&);
template void LDLT<MatrixXd>::_solve_impl_transposed<true>(const VectorXd&, VectorXd&) const;
template SelfAdjointEigenSolver<Matrix<double, 6, 6>>&
SelfAdjointEigenSolver<Matrix<double, 6, 6>>::compute(const EigenBase<Matrix<double, 6, 6>>&, int);

} // namespace Eigen
