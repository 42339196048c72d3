#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_SCALED_DESCRIPTOR_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_SCALED_DESCRIPTOR_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/registration/internal/combine_descriptors.h>

#include <cstddef>
#include <stdexcept>
#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsRegistration

  is a descriptor times a component of a signal. `multiply_descriptors()` does the same to matrices, and says what is to be said
  against it; here nothing is computed before it is asked for, and `mirrored()` is passed on.

  \tparam Features a model of the concept `Descriptor`
  \tparam Signals another one

  \cgalModels{Descriptor}
*/
template <typename Features, typename Signals>
class Scaled_descriptor
{
public:
  /// scratch memory of a thread
  class Workspace
  {
    friend class Scaled_descriptor;
    typename Features::Workspace m_features;
    typename Signals::Workspace m_signals;
    std::vector<float> m_row; // of the signals
  };

  /// \param features the descriptor. It is not copied, and has to live as long as this one.
  /// \param signals what it is multiplied by. It is not copied either.
  /// \param component which of the components of `signals`
  /// \throws std::invalid_argument if there is no such component
  Scaled_descriptor(const Features& features, const Signals& signals, std::size_t component = 0)
    : m_features(features),
      m_signals(signals),
      m_component(component)
  {
    if(component >= signals.dimension())
      throw std::invalid_argument("Shape_characteristics: the signal to multiply by has no such component");
  }

  /// the number of components of the features
  std::size_t dimension() const { return m_features.dimension(); }

  /// writes the descriptor of sample `i` times the signal to `row`, or NaN if the status that is returned says that one of them
  /// is missing
  Estimation_status operator()(std::size_t i, Workspace& workspace, float* row) const
  {
    std::vector<float>& signal = workspace.m_row;
    signal.resize(m_signals.dimension());
    const Estimation_status first = m_features(i, workspace.m_features, row);
    const Estimation_status second = m_signals(i, workspace.m_signals, signal.data());
    for(std::size_t k = 0; k < dimension(); ++k)
      row[k] *= signal[m_component];
    return internal::finish_row(internal::combined_status(first, second), dimension(), row);
  }

  /// writes to `result` the descriptor of the mirrored surface. The features' own `mirrored()` must do to multiples what it does
  /// to the features (as an exchange of components does), and that of the signals must keep or change signs.
  void mirrored(const float* row, float* result) const
  {
    const std::vector<float> ones(m_signals.dimension(), 1.f);
    std::vector<float> signs(ones.size());
    m_signals.mirrored(ones.data(), signs.data());
    m_features.mirrored(row, result);
    for(std::size_t k = 0; k < dimension(); ++k)
      result[k] *= signs[m_component];
  }

private:
  const Features& m_features;
  const Signals& m_signals;
  std::size_t m_component;
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_SCALED_DESCRIPTOR_H
