#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_SURFACE_DERIVATIVES_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_SURFACE_DERIVATIVES_H

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsInterpolation

  holds a point of a parametric surface \f$ x(u, v) \f$ and its first and second derivatives there, as
  `parametric_surface_curvatures()` takes them.

  \tparam GeomTraits a model of `Kernel`
*/
template <typename GeomTraits>
struct Surface_derivatives
{
  typename GeomTraits::Point_3 point; ///< \f$ x \f$
  typename GeomTraits::Vector_3 u;    ///< \f$ \partial x / \partial u \f$
  typename GeomTraits::Vector_3 v;    ///< \f$ \partial x / \partial v \f$
  typename GeomTraits::Vector_3 uu;   ///< \f$ \partial^2 x / \partial u^2 \f$
  typename GeomTraits::Vector_3 uv;   ///< \f$ \partial^2 x / \partial u \partial v \f$
  typename GeomTraits::Vector_3 vv;   ///< \f$ \partial^2 x / \partial v^2 \f$
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_SURFACE_DERIVATIVES_H
