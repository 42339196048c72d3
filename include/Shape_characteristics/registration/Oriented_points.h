#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_ORIENTED_POINTS_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_ORIENTED_POINTS_H

#include <Shape_characteristics/Estimation_status.h>

#include <Eigen/Core>

#include <cstddef>
#include <limits>
#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsRegistration

  holds a surface in the form in which all steps of registration take it: points with normals, a mesh and a point set
  alike.

  Points that can't be used (with infinite coordinates, without a normal) keep their number and are left out by every step:
  they are those with a coordinate or a normal that isn't finite, or the normal 0.
*/
struct Oriented_points
{
  std::vector<Eigen::Vector3d> points;  ///< the points
  std::vector<Eigen::Vector3d> normals; ///< for each its outward normal, of unit length

  /// returns the points and normals of all samples of a surface; those of samples that aren't usable are quiet NaN.
  ///
  /// \tparam SampledSurface a model of the concept `SampledSurface`
  /// \param surface the surface, with normals
  template <typename SampledSurface>
  static Oriented_points of(const SampledSurface& surface)
  {
    const Eigen::Vector3d none = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    Oriented_points result;
    result.points.reserve(surface.size());
    result.normals.reserve(surface.size());
    for(std::size_t i = 0; i < surface.size(); ++i)
    {
      const bool usable = is_estimated(surface.status(i));
      result.points.push_back(usable ? surface.point(i) : none);
      result.normals.push_back(usable ? surface.normal(i) : none);
    }
    return result;
  }

  /// number of points
  std::size_t size() const noexcept { return points.size(); }
  /// whether point `i` and its normal are finite, and the normal is not 0
  bool is_usable(std::size_t i) const
  {
    return points[i].allFinite() && normals[i].allFinite() && !normals[i].isZero(0.);
  }
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_ORIENTED_POINTS_H
