#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_CHECK_ORIENTED_POINTS_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_CHECK_ORIENTED_POINTS_H

#include <Shape_characteristics/registration/Correspondence.h>
#include <Shape_characteristics/registration/Oriented_points.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace Shape_characteristics {
namespace internal {

inline constexpr double longest_slip = 1e-3; // that single precision and a few decimals leave of the length 1

inline void check_normals(const Oriented_points& source, const Oriented_points& target)
{
  if(source.normals.size() != source.points.size() || target.normals.size() != target.points.size())
    throw std::invalid_argument("Shape_characteristics: each of the oriented points needs a normal");
  for(const Oriented_points* const scan : {&source, &target})
    for(std::size_t i = 0; i < scan->size(); ++i)
      if(scan->is_usable(i) && !(std::abs(scan->normals[i].norm() - 1.) < longest_slip))
        throw std::invalid_argument(
            "Shape_characteristics: the normals of oriented points must be of unit length");
}

// that a motion, if it is finite, neither stretches nor mirrors
inline void check_motion(const Eigen::Isometry3d& motion)
{
  const Eigen::Matrix3d linear = motion.linear();
  if(linear.allFinite() &&
     (!((linear.transpose() * linear).isApprox(Eigen::Matrix3d::Identity(), longest_slip)) ||
      !(linear.determinant() > 0.)))
    throw std::invalid_argument("Shape_characteristics: a motion must be rigid");
}

inline void check_correspondences(const Oriented_points& source,
                                  const Oriented_points& target,
                                  const std::vector<Correspondence>& correspondences)
{
  for(const Correspondence& c : correspondences)
    if(c.source >= source.size() || c.target >= target.size())
      throw std::invalid_argument("Shape_characteristics: a correspondence names a point that isn't there");
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_CHECK_ORIENTED_POINTS_H
