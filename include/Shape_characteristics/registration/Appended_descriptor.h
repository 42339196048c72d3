#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_APPENDED_DESCRIPTOR_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_APPENDED_DESCRIPTOR_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/registration/internal/combine_descriptors.h>

#include <cstddef>
#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsRegistration

  is a descriptor followed by another one, or by a signal, times a factor for each of its components. `append_descriptors()` does the same
  to matrices; here nothing is computed before it is asked for, and `mirrored()` is passed on.

  \tparam Features a model of the concept `Descriptor`
  \tparam Signals another one

  \cgalModels{Descriptor}
*/
template <typename Features, typename Signals>
class Appended_descriptor
{
public:
  /// scratch memory of a thread
  struct Workspace
  {
    typename Features::Workspace features; ///< of the first descriptor
    typename Signals::Workspace signals;   ///< of the one that is appended
  };

  /// \param features the first descriptor. It is not copied, and has to live as long as this one.
  /// \param signals what is appended. It is not copied either.
  /// \param factors one for each component of `signals`; none if all are 1
  /// \throws std::invalid_argument if the factors are not finite or not as many as `signals` has components
  Appended_descriptor(const Features& features,
                      const Signals& signals,
                      const std::vector<double>& factors = std::vector<double>())
    : m_features(features),
      m_signals(signals),
      m_factors(internal::checked_factors(factors, signals.dimension()))
  {}

  /// the number of components of both
  std::size_t dimension() const { return m_features.dimension() + m_signals.dimension(); }

  /// writes both of sample `i` to `row`, or NaN if the status that is returned says that one of them is missing
  Estimation_status operator()(std::size_t i, Workspace& workspace, float* row) const
  {
    float* const appended = row + m_features.dimension();
    const Estimation_status first = m_features(i, workspace.features, row);
    const Estimation_status second = m_signals(i, workspace.signals, appended);
    for(std::size_t k = 0; k < m_factors.size(); ++k)
      appended[k] *= m_factors[k];
    return internal::finish_row(internal::combined_status(first, second), dimension(), row);
  }

  /// writes to `result` the descriptor of the mirrored surface. The signals' own `mirrored()` must do to multiples what
  /// it does to the signals.
  void mirrored(const float* row, float* result) const
  {
    m_features.mirrored(row, result);
    m_signals.mirrored(row + m_features.dimension(), result + m_features.dimension());
  }

private:
  const Features& m_features;
  const Signals& m_signals;
  std::vector<float> m_factors;
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_APPENDED_DESCRIPTOR_H
