#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_HATTORI_AMBIENT_OCCLUSION_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_HATTORI_AMBIENT_OCCLUSION_H

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsScreenSpace

  maps principal curvatures to the share of the ambient light that arrives, by a quadric within a sphere (after Hattori, Kubo and
  Morishima, Curvature-approximated estimation of real-time ambient occlusion, 2012).

  The surface around the point is the quadric \f$ z = (k_1 x^2 + k_2 y^2) / 2 \f$, and only what lies in the sphere of radius \f$ r \f$ occludes. In
  the direction \f$ \varphi \f$ the quadric meets the sphere at a height whose sine is \f$ s = r k(\varphi) / 2 \f$ to first order, with \f$ k(\varphi) = k_1 \cos^2
  \varphi + k_2 \sin^2 \varphi \f$; it hides the share \f$ s^2 \f$ of the light, weighted by the cosine, that comes from there. The mean over all
  directions leaves

  \f[ 1 - \frac{r^2}{32} \left( 3 k_1^2 + 2 k_1 k_2 + 3 k_2^2 \right), \f]

  clamped to [0, 1]. As the square shows no sign, bumps are as dark as hollows: that is what the thesis (section 7.4) holds against the
  method. 1 is fully lit, 0 is dark; flat places get 1. Constant time.

  The formula is derived here from the construction that the paper describes; the paper may divide by other constants, which
  another radius makes up for.

  \cgalModels{AmbientOcclusionMapping}

  \cgalExample{screen_space/ambient_occlusion.cpp}
*/
class Hattori_ambient_occlusion
{
public:
  /*!
    \param radius the radius of the sphere, in the unit of the surface. The thesis takes 0.25.

    \throws std::invalid_argument if `radius` is not positive and finite
  */
  explicit Hattori_ambient_occlusion(double radius) : m_radius(radius)
  {
    if(!(std::isfinite(radius) && radius > 0))
      throw std::invalid_argument("Hattori_ambient_occlusion: `radius` must be positive and finite");
  }

  /// the radius of the sphere, in the unit of the surface
  double radius() const noexcept { return m_radius; }

  /// returns the share of the ambient light that arrives, in [0, 1]; NaN if a curvature is NaN.
  /// \tparam PrincipalCurvatures a type with the members `min_curvature` and `max_curvature`
  template <typename PrincipalCurvatures>
  double operator()(const PrincipalCurvatures& curvatures) const
  {
    const double k1 = m_radius * CGAL::to_double(curvatures.max_curvature),
                 k2 = m_radius * CGAL::to_double(curvatures.min_curvature);
    if(std::isnan(k1) || std::isnan(k2))
      return k1 + k2;
    // a sum of squares: infinity gives 0, not NaN
    const double value = 1 - ((k1 + k2) * (k1 + k2) + 2 * k1 * k1 + 2 * k2 * k2) / 32;
    return value > 0 ? (std::min)(value, 1.) : 0.;
  }

private:
  double m_radius;
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_HATTORI_AMBIENT_OCCLUSION_H
