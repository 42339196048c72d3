#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_GRIFFIN_AMBIENT_OCCLUSION_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_GRIFFIN_AMBIENT_OCCLUSION_H

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsScreenSpace

  maps principal curvatures to the share of the ambient light that arrives, by a polynomial of the second degree (after Griffin, Wang,
  Berrios and Olano, Real-Time GPU Surface Curvature Estimation on Deforming Meshes and Volumetric Data Sets, 2012).

  With \f$ k_1 \f$ and \f$ k_2 \f$ the principal curvatures times a scale,

  \f[ c_0 + c_1 (k_1 + k_2) + c_2 (k_1^2 + k_2^2), \f]

  clamped to [0, 1]. 1 is fully lit, 0 is dark; flat places get \f$ c_0 \f$, never white. Constant time.

  The paper's coefficients come from a regression over ray-cast models. The default ones, 0.7369, 0.0776 and -0.0022, were written down
  without the paper at hand: they are parameters so that they can be set right, or fitted again.

  \cgalModels{AmbientOcclusionMapping}

  \cgalExample{screen_space/ambient_occlusion.cpp}
*/
class Griffin_ambient_occlusion
{
public:
  /*!
    \param scale the factor of the curvatures, in the unit of the surface. The thesis takes 5.
    \param constant \f$ c_0 \f$
    \param linear \f$ c_1 \f$
    \param quadratic \f$ c_2 \f$

    \throws std::invalid_argument if `scale` is not positive, or an argument is not finite
  */
  explicit Griffin_ambient_occlusion(double scale,
                                     double constant = 0.7369,
                                     double linear = 0.0776,
                                     double quadratic = -0.0022)
    : m_scale(scale),
      m_constant(constant),
      m_linear(linear),
      m_quadratic(quadratic)
  {
    if(!(std::isfinite(scale) && scale > 0))
      throw std::invalid_argument("Griffin_ambient_occlusion: `scale` must be positive and finite");
    if(!(std::isfinite(constant) && std::isfinite(linear) && std::isfinite(quadratic)))
      throw std::invalid_argument("Griffin_ambient_occlusion: the coefficients must be finite");
  }

  /// \name The arguments of the constructor
  /// @{
  double scale() const noexcept { return m_scale; }         ///< the factor of the curvatures
  double constant() const noexcept { return m_constant; }   ///< \f$ c_0 \f$
  double linear() const noexcept { return m_linear; }       ///< \f$ c_1 \f$
  double quadratic() const noexcept { return m_quadratic; } ///< \f$ c_2 \f$
  /// @}

  /// returns the share of the ambient light that arrives, in [0, 1]; NaN if a curvature is NaN.
  /// \tparam PrincipalCurvatures a type with the members `min_curvature` and `max_curvature`
  template <typename PrincipalCurvatures>
  double operator()(const PrincipalCurvatures& curvatures) const
  {
    const double k1 = m_scale * CGAL::to_double(curvatures.max_curvature),
                 k2 = m_scale * CGAL::to_double(curvatures.min_curvature);
    if(std::isnan(k1) || std::isnan(k2))
      return k1 + k2;
    // each curvature by itself, so that infinite ones don't cancel
    const double value = m_constant + k1 * (m_linear + m_quadratic * k1) + k2 * (m_linear + m_quadratic * k2);
    return value > 0 ? (std::min)(value, 1.) : 0.;
  }

private:
  double m_scale, m_constant, m_linear, m_quadratic;
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_GRIFFIN_AMBIENT_OCCLUSION_H
