#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_DELAUNAY_TRIANGLES_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_DELAUNAY_TRIANGLES_H

#include "Triangle_arrays.h"

#include <vector>

namespace benchmark_support {

/// The Delaunay triangulation of the points' projection to the xy plane: counterclockwise triangles seen from above,
/// sorted, the smallest index of each first. Of points with equal x and y, all but one belong to no triangle.
std::vector<Triangle> delaunay_triangles(const std::vector<Vector>& points);

} // namespace benchmark_support

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_DELAUNAY_TRIANGLES_H
