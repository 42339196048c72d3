#ifndef SHAPE_CHARACTERISTICS_CHARACTERISTICS_IS_SHARP_H
#define SHAPE_CHARACTERISTICS_CHARACTERISTICS_IS_SHARP_H

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsCharacteristics

  returns whether the surface is sharp for its sampling: whether the normal turns by more than `largest_turn` from a sample to one
  that is `distance` away, as the larger magnitude \f$ K \f$ of the two principal curvatures says: \f$ K \cdot \f$ `distance`
  \f$ > \f$ `largest_turn`.

  Edges, corners and tips have no curvature. What estimators say of them is finite, some 1/`distance`, and grows as the mesh is
  refined: it tells of the sampling rather than of the surface. A smooth surface that bends as much from one sample to the next is
  sharp, too, whether its curvature is right or not. Of an edge between flat faces, estimators see about half of the angle
  between the faces' normals from one vertex to the next, so that by default edges of some 60 degrees and more are sharp.

  NaN in a curvature gives `false`. Constant time.

  \tparam PrincipalCurvatures a type with the members `min_curvature` and `max_curvature`, as
  `Principal_curvatures_and_directions`

  \param curvatures the principal curvatures
  \param distance how far apart samples are (unit: length), as `spacing()` of Face_graph_samples and Point_set_samples tells: the
         mean length of the edges at a vertex, or the mean distance of a point to those around it; for estimators that average
         over a ball, its radius, though a single tip may be lost in it
  \param largest_turn an angle in radians

  \throws std::invalid_argument if `distance` or `largest_turn` is negative or NaN

  \cgalExample{characteristics/sharp_vertices.cpp}
*/
template <typename PrincipalCurvatures>
auto is_sharp(const PrincipalCurvatures& curvatures, double distance, double largest_turn = 0.5)
    -> std::enable_if_t<sizeof(curvatures.min_curvature) != 0, bool>
{
  if(!(distance >= 0))
    throw std::invalid_argument("is_sharp: `distance` must not be negative");
  if(!(largest_turn >= 0))
    throw std::invalid_argument("is_sharp: `largest_turn` must not be negative");
  const double k_min = std::abs(CGAL::to_double(curvatures.min_curvature)),
               k_max = std::abs(CGAL::to_double(curvatures.max_curvature));
  return !std::isnan(k_min) && !std::isnan(k_max) && (std::max)(k_min, k_max) * distance > largest_turn;
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CHARACTERISTICS_IS_SHARP_H
