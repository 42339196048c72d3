#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_SCREEN_SPACE_CURVATURE_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_SCREEN_SPACE_CURVATURE_H

#include <Shape_characteristics/Estimation_status.h>

#include <limits>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsScreenSpace

  is what is known of the curvature of the surface that a pixel shows. `mean_curvature()`, `Gaussian_curvature()`, `shape_index()` and the
  other characteristics take it as it is.
*/
struct Screen_space_curvature
{
  /// smaller principal curvature, in 1/unit of the scene, positive where the surface is convex; quiet NaN without an estimate
  float min_curvature = std::numeric_limits<float>::quiet_NaN();
  /// larger principal curvature
  float max_curvature = std::numeric_limits<float>::quiet_NaN();
  /// `ESTIMATED`; `BORDER` where a neighboring pixel belongs to another surface, to the background or to nothing, and others served
  /// instead; `UNREFERENCED` for the background; or why there is no estimate
  Estimation_status status = Estimation_status::UNREFERENCED;
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_SCREEN_SPACE_CURVATURE_H
