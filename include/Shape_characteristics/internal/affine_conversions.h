#ifndef SHAPE_CHARACTERISTICS_INTERNAL_AFFINE_CONVERSIONS_H
#define SHAPE_CHARACTERISTICS_INTERNAL_AFFINE_CONVERSIONS_H

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace Shape_characteristics {
namespace internal {

template <typename Kernel>
Eigen::Affine3d affine_to_eigen(const CGAL::Aff_transformation_3<Kernel>& motion)
{
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 4; ++j)
      result.matrix()(i, j) = CGAL::to_double(motion.m(i, j));
  return result;
}

template <typename Kernel>
CGAL::Aff_transformation_3<Kernel> affine_to_cgal(const Eigen::Affine3d& motion)
{
  using FT = typename Kernel::FT;
  const auto m = [&](const int i, const int j) { return FT(motion.matrix()(i, j)); };
  return {m(0, 0), m(0, 1), m(0, 2), m(0, 3), m(1, 0), m(1, 1),
          m(1, 2), m(1, 3), m(2, 0), m(2, 1), m(2, 2), m(2, 3)};
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_AFFINE_CONVERSIONS_H
