#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_MESH_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_MESH_H

#include "Scan.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace registration {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

/// the points and triangles of a scan, in their order
Mesh to_mesh(const Scan& scan);

} // namespace registration

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_MESH_H
