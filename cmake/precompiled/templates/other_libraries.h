// To read a mesh, or to fit a jet, takes the compiler longer than what most programs do with it.

#include "../kernel_and_mesh.h"

#include <CGAL/Eigen_svd.h>
#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <string>

SHAPE_CHARACTERISTICS_TEMPLATE bool
CGAL::IO::read_polygon_mesh(const std::string&,
                            precompiled::Mesh&,
                            const CGAL::parameters::Default_named_parameters&);
SHAPE_CHARACTERISTICS_TEMPLATE bool
CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(const std::string&,
                                                     precompiled::Mesh&,
                                                     const CGAL::parameters::Default_named_parameters&);

SHAPE_CHARACTERISTICS_TEMPLATE class CGAL::
    Monge_via_jet_fitting<precompiled::Kernel, precompiled::Kernel, CGAL::Eigen_svd>;
