#include "precompiled.h"

template bool CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(
    const std::string&,
    CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>&,
    const CGAL::parameters::Default_named_parameters&);
