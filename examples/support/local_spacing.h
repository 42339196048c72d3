#ifndef SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_LOCAL_SPACING_H
#define SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_LOCAL_SPACING_H

#include "Drawable.h"

#include <cstddef>
#include <vector>

namespace support {

/// The mean distance of each point to its `neighbours` nearest other points: how densely the surface is
/// sampled there. Points that are not finite get 0 and are nobody's neighbour. O(n log n).
std::vector<double> local_spacing(const std::vector<Vector>& points, std::size_t neighbours = 6);

} // namespace support

#endif
