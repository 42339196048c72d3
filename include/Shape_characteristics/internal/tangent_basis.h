#ifndef SHAPE_CHARACTERISTICS_INTERNAL_TANGENT_BASIS_H
#define SHAPE_CHARACTERISTICS_INTERNAL_TANGENT_BASIS_H

#include <Eigen/Core>

#include <cmath>

namespace Shape_characteristics {
namespace internal {

// two unit vectors orthogonal to the unit vector `normal` and to each other, right-handed (Duff et al., Building an
// Orthonormal Basis, Revisited, 2017)
inline void tangent_basis(const Eigen::Vector3d& normal, Eigen::Vector3d& t1, Eigen::Vector3d& t2) noexcept
{
  // odd in the normal: that of a flipped surface has the same t1 and the opposite t2, whatever the signs of zeros
  const double sign =
      std::copysign(1., normal.z() != 0. ? normal.z() : (normal.y() != 0. ? normal.y() : normal.x()));
  const double a = -1 / (sign + normal.z());
  const double b = normal.x() * normal.y() * a;
  t1 = {1 + sign * normal.x() * normal.x() * a, sign * b, -sign * normal.x()};
  t2 = {b, sign + normal.y() * normal.y() * a, -normal.y()};
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_TANGENT_BASIS_H
