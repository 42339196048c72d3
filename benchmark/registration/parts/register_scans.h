#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_REGISTER_SCANS_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_REGISTER_SCANS_H

#include "Mesh.h"
#include "Scan.h"

#include <Shape_characteristics/registration/Registration_result.h>

#include <CGAL/Simple_cartesian.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <utility>
#include <vector>

namespace registration {

using Kernel = CGAL::Simple_cartesian<double>;
using Registration_result = Shape_characteristics::Registration_result<Kernel>;

/// Points and normals, as a program that uses CGAL has them.
using Point_range = std::vector<std::pair<Kernel::Point_3, Kernel::Vector_3> >;

/// the points and normals of a scan, in their order
Point_range to_range(const Scan& scan);

/// `register_partial_scans()` of point sets, on one thread; `neighbors`: as many as it takes by default
Registration_result
register_scans(const Point_range& source, const Point_range& target, std::size_t neighbors = 60);

/// the same of meshes, with the normals that it computes, as a user's get them
Registration_result register_scans(const Mesh& source, const Mesh& target, std::size_t neighbors);

/// the motion that was found
Eigen::Isometry3d motion(const Registration_result& result);

} // namespace registration

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_REGISTER_SCANS_H
