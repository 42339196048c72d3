#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_APPEND_DESCRIPTORS_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_APPEND_DESCRIPTORS_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/descriptors/Descriptor_matrix.h>
#include <Shape_characteristics/registration/internal/combine_descriptors.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsRegistration

  appends components to descriptors: row `i` of the result is that of `features`, followed by that of `signals` times `factors`.

  How much a signal counts in the distance of two descriptors is up to its factor. `signal_factors()` gives those that make it
  count as much as is wanted; source and target need the same ones.

  \param features descriptors of any kind
  \param signals what is appended, of the same samples
  \param factors one for each column of `signals`; none if all are 1

  \return a row for each sample, as wide as both together. Where one of them has no value, it has none, and its status says why.

  \throws std::invalid_argument if the numbers of rows differ, or the factors aren't finite or not as many as `signals` has columns

  Complexity: linear in the size of the result.
*/
inline Descriptor_matrix append_descriptors(const Descriptor_matrix& features,
                                            const Descriptor_matrix& signals,
                                            const std::vector<double>& factors = std::vector<double>())
{
  internal::check_combination(features, signals);
  const Eigen::Index m = features.values.cols(), n = signals.values.cols();
  const std::vector<float> f = internal::checked_factors(factors, std::size_t(n));
  Descriptor_matrix result;
  result.values.resize(features.values.rows(), m + n);
  result.status.resize(features.status.size());
  for(Eigen::Index i = 0; i < result.values.rows(); ++i)
  {
    auto row = result.values.row(i);
    row.head(m) = features.values.row(i);
    for(Eigen::Index k = 0; k < n; ++k)
      row[m + k] = f[std::size_t(k)] * signals.values(i, k);
    const std::size_t s = std::size_t(i);
    result.status[s] = internal::finish_row(internal::combined_status(features.status[s], signals.status[s]),
                                            std::size_t(m + n), row.data());
  }
  return result;
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_APPEND_DESCRIPTORS_H
