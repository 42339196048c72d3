#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_SYMMETRY_AWARE_VARIANT_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_SYMMETRY_AWARE_VARIANT_H

namespace Shape_characteristics {

/// \ingroup PkgShapeCharacteristicsRegistration
/// names the symmetry-aware feature vectors of the thesis, by their numbers in section 10.1.3: a descriptor is multiplied by the flux
/// \f$ F_s \f$, and to its end is appended
enum class Symmetry_aware_variant : unsigned char
{
  FLUX = 1,             ///< the flux
  MEAN_VOLUME = 2,      ///< the signed volume by mean curvature
  FLUX_AND_VOLUMES = 3, ///< the flux, and the signed volumes by mean and by Gaussian curvature
  VOLUMES = 4           ///< the signed volumes by mean and by Gaussian curvature
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_SYMMETRY_AWARE_VARIANT_H
