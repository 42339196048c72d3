#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_PLAIN_THESIS_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_PLAIN_THESIS_H

#include "Workload.h"

namespace speed {

/// The thesis's estimator (8.1) as its text has it, with nothing done for speed: for each vertex the system of
/// 4m equations of r^5 on the points and normals of its rings, solved by LU, and the curvatures of the interpolant there.
void plain_thesis(Workload& workload, unsigned int rings);

} // namespace speed

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_PLAIN_THESIS_H
