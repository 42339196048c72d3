#ifndef SHAPE_CHARACTERISTICS_PRECOMPILED_H
#define SHAPE_CHARACTERISTICS_PRECOMPILED_H

// What most tests, examples and benchmarks include and none changes: compiled once, before them. To read a mesh, or to
// decompose a matrix, takes the compiler longer than what most of them do with it: that is in precompiled.cpp.

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/for_each.h>
#include <CGAL/property_map.h>

#include <Eigen/Dense>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/scalable_allocator.h>
#endif

#include <functional>
#include <mutex>
#include <string>
#include <unordered_map>

extern template bool CGAL::IO::read_polygon_mesh(const std::string&,
                                                 CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>&,
                                                 const CGAL::parameters::Default_named_parameters&);
extern template bool CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(
    const std::string&,
    CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>&,
    const CGAL::parameters::Default_named_parameters&);

namespace Eigen {

extern template class JacobiSVD<MatrixXd>; // CGAL's jets
extern template class LDLT<MatrixXd>;
extern template LDLT<MatrixXd>& LDLT<MatrixXd>::compute(const EigenBase<MatrixXd>&);
extern template void LDLT<MatrixXd>::_solve_impl_transposed<true>(const VectorXd&, VectorXd&) const;
extern template SelfAdjointEigenSolver<Matrix<double, 6, 6>>&
SelfAdjointEigenSolver<Matrix<double, 6, 6>>::compute(const EigenBase<Matrix<double, 6, 6>>&, int);

} // namespace Eigen

#endif // SHAPE_CHARACTERISTICS_PRECOMPILED_H
