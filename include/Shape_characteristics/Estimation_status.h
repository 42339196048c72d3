#ifndef SHAPE_CHARACTERISTICS_ESTIMATION_STATUS_H
#define SHAPE_CHARACTERISTICS_ESTIMATION_STATUS_H

#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "Shape_characteristics needs NaN and infinity: add -fno-finite-math-only behind -ffast-math"
#endif

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsResults

  says of one sample (a vertex of a mesh, a point of a point set) whether a quantity could be estimated, and
  if not, why.

  Every estimator answers for every sample. A sample whose status is neither `ESTIMATED` nor `BORDER` carries
  quiet NaN in each of its values, and is counted in what the estimator returns; its neighbors are not
  affected by it. (Of a picture, the background isn't counted.)
*/
enum class Estimation_status : unsigned char
{
  ESTIMATED, ///< the quantity was estimated
  BORDER,    ///< estimated, but from a one-sided neighborhood: the sample lies on the border of the surface
  FEW_NEIGHBOURS, ///< the neighborhood has too few samples to determine the quantity
  DEGENERATE, ///< the neighborhood doesn't determine the quantity: coincident or collinear points, a fit that failed
  NON_FINITE_INPUT, ///< the point or the normal of the sample is infinite or NaN, or the normal is zero
  UNREFERENCED,     ///< no face is incident to the vertex; of a pixel: it shows no surface
  /// too few neighbors, and another vertex at the very same point: the mesh is a soup of faces, see
  /// `CGAL::Polygon_mesh_processing::stitch_borders()`. Told of whole meshes; an estimate of one vertex says `FEW_NEIGHBOURS`
  DUPLICATE,
  CANCELLED ///< the callback stopped the computation before this sample
};

/// \ingroup PkgShapeCharacteristicsResults
/// returns whether `status` says that there is a value: `ESTIMATED` or `BORDER`.
constexpr bool is_estimated(Estimation_status status) noexcept
{
  return status == Estimation_status::ESTIMATED || status == Estimation_status::BORDER;
}

/// \ingroup PkgShapeCharacteristicsResults
/// returns the name of `status` as it is written in the program, for tables and messages.
constexpr const char* to_string(Estimation_status status) noexcept
{
  switch(status)
  {
  case Estimation_status::ESTIMATED:
    return "ESTIMATED";
  case Estimation_status::BORDER:
    return "BORDER";
  case Estimation_status::FEW_NEIGHBOURS:
    return "FEW_NEIGHBOURS";
  case Estimation_status::DEGENERATE:
    return "DEGENERATE";
  case Estimation_status::NON_FINITE_INPUT:
    return "NON_FINITE_INPUT";
  case Estimation_status::UNREFERENCED:
    return "UNREFERENCED";
  case Estimation_status::DUPLICATE:
    return "DUPLICATE";
  case Estimation_status::CANCELLED:
    return "CANCELLED";
  }
  return "";
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_ESTIMATION_STATUS_H
