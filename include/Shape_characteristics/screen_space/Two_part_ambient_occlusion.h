#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_TWO_PART_AMBIENT_OCCLUSION_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_TWO_PART_AMBIENT_OCCLUSION_H

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsScreenSpace

  maps the mean curvature to the share of the ambient light that arrives, in two parts that join where it is zero (the thesis's
  section 7.4; Prantl, Váša and Kolingerová, Screen Space Curvature and Ambient Occlusion, 2017).

  Hollows, where the mean curvature is negative, darken along a Gaussian function, bumps brighten linearly: with \f$ m \f$ the mean curvature
  over its extreme, clamped to [-1, 1], the value is

  \f[ a \exp \left( -\frac{(m - \mu)^2}{2 \delta^2} \right) \textrm{ for } m < 0, \qquad a + (1 - a) m \textrm{ for } m \geq 0. \f]

  1 is fully lit, 0 is dark; flat places get \f$ a \f$. (The thesis calls the dark places convex; its formula and its pictures darken hollows, as
  light does.) Constant time.

  \cgalModels{AmbientOcclusionMapping}

  \cgalExample{screen_space/ambient_occlusion.cpp}
*/
class Two_part_ambient_occlusion
{
public:
  /*!
    \param curvature_extreme the magnitude of the mean curvature, in 1/length, that gets the darkest and the brightest value.
           `mean_curvature_extreme()` finds it for a picture.
    \param flat_value \f$ a \f$ in [0, 1], the value of flat places
    \param variance \f$ \delta^2 \f$
    \param expected_value \f$ \mu \f$. The two parts meet if it is 0.

    \throws std::invalid_argument if an argument is not finite, `curvature_extreme` or `variance` is not positive, or `flat_value` is
            outside [0, 1]
  */
  explicit Two_part_ambient_occlusion(double curvature_extreme,
                                      double flat_value = 0.9,
                                      double variance = 0.2,
                                      double expected_value = 0)
    : m_extreme(curvature_extreme),
      m_flat(flat_value),
      m_variance(variance),
      m_expected(expected_value)
  {
    if(!(std::isfinite(curvature_extreme) && curvature_extreme > 0))
      throw std::invalid_argument(
          "Two_part_ambient_occlusion: `curvature_extreme` must be positive and finite");
    if(!(flat_value >= 0 && flat_value <= 1))
      throw std::invalid_argument("Two_part_ambient_occlusion: `flat_value` must be in [0, 1]");
    if(!(std::isfinite(variance) && variance > 0))
      throw std::invalid_argument("Two_part_ambient_occlusion: `variance` must be positive and finite");
    if(!std::isfinite(expected_value))
      throw std::invalid_argument("Two_part_ambient_occlusion: `expected_value` must be finite");
  }

  /// \name The arguments of the constructor
  /// @{

  /// the magnitude of the mean curvature that gets the darkest and the brightest value
  double curvature_extreme() const noexcept { return m_extreme; }
  double flat_value() const noexcept { return m_flat; }         ///< \f$ a \f$, the value of flat places
  double variance() const noexcept { return m_variance; }       ///< \f$ \delta^2 \f$
  double expected_value() const noexcept { return m_expected; } ///< \f$ \mu \f$
  /// @}

  /// returns the share of the ambient light that arrives, in [0, 1]; NaN if a curvature is NaN.
  /// \tparam PrincipalCurvatures a type with the members `min_curvature` and `max_curvature`
  template <typename PrincipalCurvatures>
  double operator()(const PrincipalCurvatures& curvatures) const
  {
    // each divided before they are added: the sum might overflow
    const double ratio = CGAL::to_double(curvatures.min_curvature) / m_extreme * 0.5 +
                         CGAL::to_double(curvatures.max_curvature) / m_extreme * 0.5;
    if(std::isnan(ratio))
      return ratio;
    const double m = std::clamp(ratio, -1., 1.);
    if(m >= 0)
      return m_flat + (1 - m_flat) * m;
    return m_flat * std::exp(-(m - m_expected) * (m - m_expected) / (2 * m_variance));
  }

private:
  double m_extreme, m_flat, m_variance, m_expected;
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_TWO_PART_AMBIENT_OCCLUSION_H
