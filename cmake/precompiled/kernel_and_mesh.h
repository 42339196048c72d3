#ifndef SHAPE_CHARACTERISTICS_PRECOMPILED_KERNEL_AND_MESH_H
#define SHAPE_CHARACTERISTICS_PRECOMPILED_KERNEL_AND_MESH_H

// The kernel and the mesh of most tests, examples and benchmarks.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace precompiled {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

} // namespace precompiled

#endif // SHAPE_CHARACTERISTICS_PRECOMPILED_KERNEL_AND_MESH_H
