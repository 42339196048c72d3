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
template class LDLT<Matrix3d>;
template class LDLT<MatrixXd>;
template SelfAdjointEigenSolver<Matrix2d>&
SelfAdjointEigenSolver<Matrix2d>::compute(const EigenBase<Matrix2d>&, int);
template SelfAdjointEigenSolver<Matrix<double, 6, 6>>&
SelfAdjointEigenSolver<Matrix<double, 6, 6>>::compute(const EigenBase<Matrix<double, 6, 6>>&, int);

} // namespace Eigen
