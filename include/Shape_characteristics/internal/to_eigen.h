#ifndef SHAPE_CHARACTERISTICS_INTERNAL_TO_EIGEN_H
#define SHAPE_CHARACTERISTICS_INTERNAL_TO_EIGEN_H

#include <CGAL/number_utils.h>

#include <Eigen/Core>

namespace Shape_characteristics {
namespace internal {

template <typename Triple> // a point or a vector
Eigen::Vector3d to_eigen(const Triple& p)
{
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_TO_EIGEN_H
