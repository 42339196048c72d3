#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_FACE_VIEW_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_FACE_VIEW_H

#include <Shape_characteristics/head_features/internal/Range_image_curvature.h>
#include <Shape_characteristics/head_features/internal/Scalar_image.h>
#include <Shape_characteristics/head_features/internal/Skin_view.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Shape_characteristics {
namespace internal {

// The face from the front, with how strongly it is creased and, once it is asked for, its depth smoothed over another width: each
// takes longer than the view alone.
class Face_view : public Skin_view
{
public:
  explicit Face_view(Skin_view view)
    : Skin_view(std::move(view)),
      m_curvature(image().depth().smoothed(.004 / pixel), pixel)
  {}

  // how strongly the surface is creased (concave), in 1 / height of the head; 0 where that isn't known
  double crease(int i, int j) const
  {
    return m_curvature.min.has_value(i, j) ? std::max(-m_curvature.min(i, j), 0.) : 0.;
  }

  // the smooth depth between pixels, NaN where there is none
  double depth(double u, double v) const
  {
    if(m_smooth.width() == 0) // eyes are looked for without it, and often more than once
      m_smooth = image().depth().smoothed(.006 / pixel);
    const double x = image().column(u), y = image().row(v);
    if(!(x >= 0. && x < m_smooth.width() && y >= 0. && y < m_smooth.height()))
      return std::numeric_limits<double>::quiet_NaN();
    const int i = int(std::floor(x)), j = int(std::floor(y));
    if(!m_smooth.contains(i, j) || !m_smooth.contains(i + 1, j + 1))
      return std::numeric_limits<double>::quiet_NaN();
    const double s = x - i, t = y - j;
    return (1 - t) * ((1 - s) * m_smooth(i, j) + s * m_smooth(i + 1, j)) +
           t * ((1 - s) * m_smooth(i, j + 1) + s * m_smooth(i + 1, j + 1));
  }

private:
  mutable Scalar_image m_smooth; // empty before the first call of depth()
  Range_image_curvature m_curvature;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_FACE_VIEW_H
