#ifndef SHAPE_CHARACTERISTICS_EXAMPLES_PRECOMPILED_H
#define SHAPE_CHARACTERISTICS_EXAMPLES_PRECOMPILED_H

// What most examples include and none changes: compiled once, before them. To read a mesh takes the compiler longer than what
// most examples do with it: that is in precompiled.cpp.

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/property_map.h>

#include <Eigen/Dense>

#include <string>

extern template bool CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(
    const std::string&,
    CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>&,
    const CGAL::parameters::Default_named_parameters&);

#endif // SHAPE_CHARACTERISTICS_EXAMPLES_PRECOMPILED_H
