#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_SCAN_FRAME_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_SCAN_FRAME_H

#include <Shape_characteristics/internal/length.h>
#include <Shape_characteristics/registration/Oriented_points.h>
#include <Shape_characteristics/registration/internal/centroid.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// Coordinates in which both surfaces have their centroid in the origin, and the larger one the radius 1: what is computed
// in them depends neither on the unit of length nor on where the surfaces begin.
class Scan_frame
{
public:
  Scan_frame(const Oriented_points& source, const Oriented_points& target)
    : m_source(centroid(source.points)),
      m_target(centroid(target.points)),
      m_size((std::max)(radius(source.points, m_source), radius(target.points, m_target)))
  {}

  // the distance of the farthest point from the centroid of its surface; 0 if there is none
  double size() const noexcept { return m_size; }
  bool is_valid() const
  {
    const double farthest = (std::max)(m_source.cwiseAbs().maxCoeff(), m_target.cwiseAbs().maxCoeff());
    return m_size > 0. && std::isfinite(8. * (m_size + farthest)); // and so are the motions outside
  }

  Eigen::Vector3d source(const Eigen::Vector3d& p) const { return (p - m_source) / m_size; }
  Eigen::Vector3d target(const Eigen::Vector3d& q) const { return (q - m_target) / m_size; }

  // a motion given in the coordinates of the frame, in those of the surfaces
  Eigen::Isometry3d outside(const Eigen::Isometry3d& motion) const
  {
    Eigen::Isometry3d result = motion;
    result.translation() = m_target + (m_size * motion.translation() - motion.linear() * m_source);
    return result;
  }
  // the reverse
  Eigen::Isometry3d inside(const Eigen::Isometry3d& motion) const
  {
    Eigen::Isometry3d result = motion;
    result.translation() = (motion * m_source - m_target) / m_size;
    return result;
  }

private:
  static double radius(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& center)
  {
    double result = 0.;
    for(const Eigen::Vector3d& p : points)
      if(p.allFinite())
        result = (std::max)(result, length(p - center));
    return result;
  }

  Eigen::Vector3d m_source, m_target;
  double m_size;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_SCAN_FRAME_H
