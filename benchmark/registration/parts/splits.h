#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_SPLITS_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_SPLITS_H

#include "Scan.h"

#include <Eigen/Geometry>

#include <cstdint>

namespace registration {

/// Two parts of a model that overlap, and what would bring them together.
struct Split
{
  Scan target;              ///< P, in its place
  Scan source;              ///< Q, moved
  Eigen::Isometry3d motion; ///< brings Q back
  double overlap;           ///< share of Q's points in the band that both parts have
  double spacing;           ///< mean edge of both parts; of point sets, mean distance to the nearest point
};

/// How parts are made (10.2.1).
struct Split_protocol
{
  double least_band = .1,
         largest_band = .4; ///< half the width of the band, in radii of the model: drawn between these
  double angle = 30.;       ///< largest rotation of the plane about each axis, in degrees
  double noise = .1;        ///< standard deviation of the points, in mean edges
};

/*!
  cuts two samplings of one model by a plane: x = 0 through the centroid of the first, turned about the three axes at random.
  P is what lies on one side of it in the first, Q what lies on the other in the second, both and the band between. Points
  get noise, normals are computed anew, and Q is turned and moved at random.
*/
Split split(const Scan& first, const Scan& second, const Split_protocol& protocol, std::uint64_t seed);

/// Mean distance of Q's points from where they belong, in radii of Q (10.2.2): below .1 the parts are registered.
double registration_error(const Split& split, const Eigen::Isometry3d& motion);

} // namespace registration

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_SPLITS_H
