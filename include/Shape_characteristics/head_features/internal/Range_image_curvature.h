#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_RANGE_IMAGE_CURVATURE_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_RANGE_IMAGE_CURVATURE_H

#include <Shape_characteristics/head_features/internal/Scalar_image.h>

#include <algorithm>
#include <cmath>

namespace Shape_characteristics {
namespace internal {

// The principal curvatures of a surface given by its depth over a grid, convex positive, where a pixel and its 8 neighbors have
// a depth.
struct Range_image_curvature
{
  Scalar_image min, max;

  Range_image_curvature(const Scalar_image& z, double pixel)
    : min(z.width(), z.height()),
      max(z.width(), z.height())
  {
    for(int j = 1; j + 1 < z.height(); ++j)
      for(int i = 1; i + 1 < z.width(); ++i)
      {
        const double zx = (z(i + 1, j) - z(i - 1, j)) / (2 * pixel),
                     zy = (z(i, j + 1) - z(i, j - 1)) / (2 * pixel),
                     zxx = (z(i + 1, j) - 2 * z(i, j) + z(i - 1, j)) / (pixel * pixel),
                     zyy = (z(i, j + 1) - 2 * z(i, j) + z(i, j - 1)) / (pixel * pixel),
                     zxy = (z(i + 1, j + 1) - z(i - 1, j + 1) - z(i + 1, j - 1) + z(i - 1, j - 1)) /
                           (4 * pixel * pixel),
                     g = 1 + zx * zx + zy * zy,
                     mean = -((1 + zy * zy) * zxx - 2 * zx * zy * zxy + (1 + zx * zx) * zyy) /
                            (2 * g * std::sqrt(g)),
                     gauss = (zxx * zyy - zxy * zxy) / (g * g);
        if(std::isnan(mean) || std::isnan(gauss))
          continue;
        const double difference = std::sqrt(std::max(mean * mean - gauss, 0.));
        min(i, j) = mean - difference;
        max(i, j) = mean + difference;
      }
  }
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_RANGE_IMAGE_CURVATURE_H
