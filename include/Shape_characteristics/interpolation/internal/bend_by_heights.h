#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_BEND_BY_HEIGHTS_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_BEND_BY_HEIGHTS_H

#include <Shape_characteristics/internal/tangent_basis.h>
#include <Shape_characteristics/interpolation/internal/Cubic_height_fit.h>
#include <Shape_characteristics/interpolation/internal/Hermite_trend.h>

#include <Eigen/Core>

#include <vector>

namespace Shape_characteristics {
namespace internal {

/*
  Bends a plane, the trend of a fit to inexact normals, by a polynomial where the points are nearly on it.

  A basis function holds a fit to its trend a little, however exact the points are: a part of the curvature, .01 to .1 %, would be
  missing however fine the sampling is.
*/
inline void bend_by_heights(Hermite_trend& trend, const std::vector<Eigen::Vector3d>& points)
{
  tangent_basis(trend.w, trend.u, trend.v);
  Cubic_height_fit<double> fit;
  for(const Eigen::Vector3d& p : points)
    fit.add(1., trend.u.dot(p), trend.v.dot(p), trend.w.dot(p));
  fit.solve(trend.height);
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_BEND_BY_HEIGHTS_H
