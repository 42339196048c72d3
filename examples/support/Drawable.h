#ifndef SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_DRAWABLE_H
#define SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_DRAWABLE_H

#include <array>
#include <cstddef>
#include <vector>

namespace support {

using Vector = std::array<double, 3>;

/// A triangle mesh, or, without triangles, a point set: what a picture shows.
struct Drawable
{
  std::vector<Vector> points;

  /// One per point, of any length. If empty, a mesh gets normals from its triangles, with creases kept
  /// sharp, and a point set is drawn with discs that face the eye.
  std::vector<Vector> normals;

  std::vector<std::array<std::size_t, 3>> triangles; ///< indices of points, counterclockwise from outside

  /// The value per point that the colour shows; NaN is a value that is missing. If empty, everything is
  /// drawn in one light colour.
  std::vector<double> scalars;
};

} // namespace support

#endif
