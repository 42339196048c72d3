#ifndef SHAPE_CHARACTERISTICS_CURVATURE_PARAMETRIC_SURFACE_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_PARAMETRIC_SURFACE_CURVATURES_H

#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/Fundamental_forms.h>

#include <CGAL/Kernel_traits.h>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  returns the principal curvatures and directions of a parametric surface \f$ x(u, v) \f$ at a point, from its first
  and second derivatives there (the thesis's section 4.3.2).

  The curvatures are positive where the surface is convex seen along \f$ T_u \times T_v \f$. Where that is zero, or anything
  is not finite, all members of the result are quiet NaN. Constant time.

  \tparam Vector_3 the vector type of a model of `Kernel`, whose number type must have a quiet NaN

  \cgalExample{curvature/parametric_surface.cpp}

  \sa `Fundamental_forms`
*/
template <typename Vector_3>
Principal_curvatures_and_directions<typename CGAL::Kernel_traits<Vector_3>::Kernel>
parametric_surface_curvatures(const Vector_3& Tu,
                              const Vector_3& Tv,
                              const Vector_3& Tuu,
                              const Vector_3& Tuv,
                              const Vector_3& Tvv)
{
  return Fundamental_forms<typename CGAL::Kernel_traits<Vector_3>::Kernel>(Tu, Tv, Tuu, Tuv, Tvv)
      .curvatures();
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_PARAMETRIC_SURFACE_CURVATURES_H
