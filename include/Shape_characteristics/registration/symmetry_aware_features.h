#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_SYMMETRY_AWARE_FEATURES_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_SYMMETRY_AWARE_FEATURES_H

#include <Shape_characteristics/descriptors/Descriptor_matrix.h>
#include <Shape_characteristics/registration/Symmetry_aware_variant.h>
#include <Shape_characteristics/registration/append_descriptors.h>
#include <Shape_characteristics/registration/multiply_descriptors.h>

#include <stdexcept>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsRegistration

  makes the symmetry-aware feature vectors of the thesis (section 10.1.3) of descriptors and signals, to the letter: `features` times
  the flux, followed by what `Symmetry_aware_variant` says.

  The thesis's signals have units, a length and squared lengths (`Signal_scaling::AS_PRINTED`), so its features depend on the unit
  of the points: in millimeters, the appended values of a head count for something, in units of its size for nothing. Signals
  that are free of units give features that don't. Better ones than all four are `append_descriptors()` of
  `chiralities()`, with `signal_factors()`.

  \param variant which of the four
  \param features descriptors of any kind; the thesis has FPFH
  \param fluxes the result of `symmetry_fluxes()` for the same samples: one column
  \param volumes the result of `signed_volumes()` for the same samples: two columns

  \return a row for each sample. Where one of the three has no value, it has none, and its status says why.

  \throws std::invalid_argument if the numbers of rows differ, or a number of columns is wrong

  Complexity: linear in the size of the result.
*/
inline Descriptor_matrix symmetry_aware_features(Symmetry_aware_variant variant,
                                                 const Descriptor_matrix& features,
                                                 const Descriptor_matrix& fluxes,
                                                 const Descriptor_matrix& volumes)
{
  if(fluxes.values.cols() != 1 || volumes.values.cols() != 2)
    throw std::invalid_argument(
        "Shape_characteristics: there must be one flux and two signed volumes per row");
  const Descriptor_matrix product = multiply_descriptors(features, fluxes);
  switch(variant)
  {
  case Symmetry_aware_variant::FLUX:
    return append_descriptors(product, fluxes);
  case Symmetry_aware_variant::MEAN_VOLUME:
  {
    Descriptor_matrix mean = volumes;
    mean.values.conservativeResize(Eigen::NoChange, 1);
    return append_descriptors(product, mean);
  }
  case Symmetry_aware_variant::FLUX_AND_VOLUMES:
    return append_descriptors(append_descriptors(product, fluxes), volumes);
  case Symmetry_aware_variant::VOLUMES:
    return append_descriptors(product, volumes);
  }
  throw std::invalid_argument("Shape_characteristics: there are four symmetry-aware variants");
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_SYMMETRY_AWARE_FEATURES_H
