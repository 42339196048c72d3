#ifndef SHAPE_CHARACTERISTICS_TEST_REGISTRATION_BUMPY_BALL_H
#define SHAPE_CHARACTERISTICS_TEST_REGISTRATION_BUMPY_BALL_H

#include <Shape_characteristics/registration/Oriented_points.h>

#include "../../benchmark/support/Random.h"

#include <CGAL/number_type_config.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>

namespace test_support {

using benchmark_support::Random;

/// `n` points, spread evenly, of a closed surface of radius about 1 that no motion maps to itself, with the exact normals.
/// `symmetric`: its mirror image at the plane x = 0 is the same. `turn`: another one gives other points of the surface.
inline Shape_characteristics::Oriented_points
bumpy_ball(std::size_t n, bool symmetric = false, double turn = 0.)
{
  const double golden_angle = CGAL_PI * (3. - std::sqrt(5.)), phase = symmetric ? 0. : .8;
  Shape_characteristics::Oriented_points result;
  for(std::size_t i = 0; i < n; ++i)
  {
    const double z = 1. - (2. * double(i) + 1.) / double(n), angle = golden_angle * double(i) + turn;
    const double radius = std::sqrt(1. - z * z);
    const Eigen::Vector3d d(radius * std::cos(angle), radius * std::sin(angle), z);
    // the radius in the direction d, and its gradient
    const double g = 1. + .15 * std::cos(3. * d.x() + phase) + .12 * std::sin(2. * d.y() + 4. * d.z());
    const double along = .24 * std::cos(2. * d.y() + 4. * d.z());
    const Eigen::Vector3d gradient(-.45 * std::sin(3. * d.x() + phase), along, 2. * along);
    const Eigen::Vector3d tangential = gradient - d * d.dot(gradient);
    result.points.push_back(g * d);
    result.normals.push_back((d - tangential / g).normalized());
  }
  return result;
}

/// a rotation by any angle about any axis, and a translation of the given length
inline Eigen::Isometry3d random_motion(Random& random, double length)
{
  const auto direction = [&]
  {
    const double x = random.gaussian(), y = random.gaussian();
    return Eigen::Vector3d(x, y, random.gaussian()).normalized();
  };
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = Eigen::AngleAxisd(random.uniform(0., CGAL_PI), direction()).toRotationMatrix();
  motion.translation() = length * direction();
  return motion;
}

inline Shape_characteristics::Oriented_points moved(Shape_characteristics::Oriented_points points,
                                                    const Eigen::Isometry3d& motion)
{
  for(auto& p : points.points)
    p = motion * p;
  for(auto& n : points.normals)
    n = motion.linear() * n;
  return points;
}

} // namespace test_support

#endif
