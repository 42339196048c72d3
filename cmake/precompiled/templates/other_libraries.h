// To read a mesh, or to decompose a matrix, takes the compiler longer than what most programs do with it.

SHAPE_CHARACTERISTICS_TEMPLATE bool
CGAL::IO::read_polygon_mesh(const std::string&,
                            precompiled::Mesh&,
                            const CGAL::parameters::Default_named_parameters&);
SHAPE_CHARACTERISTICS_TEMPLATE bool
CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(const std::string&,
                                                     precompiled::Mesh&,
                                                     const CGAL::parameters::Default_named_parameters&);

namespace Eigen {

SHAPE_CHARACTERISTICS_TEMPLATE class JacobiSVD<MatrixXd>;
SHAPE_CHARACTERISTICS_TEMPLATE class LDLT<MatrixXd>;
SHAPE_CHARACTERISTICS_TEMPLATE LDLT<MatrixXd>& LDLT<MatrixXd>::compute(const EigenBase<MatrixXd>&);
SHAPE_CHARACTERISTICS_TEMPLATE void LDLT<MatrixXd>::_solve_impl_transposed<true>(const VectorXd&,
                                                                                 VectorXd&) const;
SHAPE_CHARACTERISTICS_TEMPLATE SelfAdjointEigenSolver<Matrix<double, 6, 6> >&
SelfAdjointEigenSolver<Matrix<double, 6, 6> >::compute(const EigenBase<Matrix<double, 6, 6> >&, int);

} // namespace Eigen

SHAPE_CHARACTERISTICS_TEMPLATE class CGAL::
    Monge_via_jet_fitting<precompiled::Kernel, precompiled::Kernel, CGAL::Eigen_svd>;
