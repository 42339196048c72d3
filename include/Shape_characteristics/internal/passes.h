#ifndef SHAPE_CHARACTERISTICS_INTERNAL_PASSES_H
#define SHAPE_CHARACTERISTICS_INTERNAL_PASSES_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>

namespace Shape_characteristics {
namespace internal {

// throws if the named parameter has a value without meaning
inline void check_number_of_passes(std::int64_t passes, std::int64_t fewest = 1)
{
  if(passes < fewest || passes > 1000)
    throw std::invalid_argument("Shape_characteristics: number_of_passes must be between " +
                                std::to_string(fewest) + " and 1000");
}

// Progress of several passes as progress of one.
class Callback_of_pass
{
public:
  Callback_of_pass(const std::function<bool(double)>& callback,
                   std::size_t pass,
                   std::size_t number_of_passes)
    : m_callback(callback),
      m_begin(double(pass) / double(number_of_passes)),
      m_length(1. / double(number_of_passes))
  {}

  bool operator()(double advancement) const { return m_callback(m_begin + m_length * advancement); }

private:
  const std::function<bool(double)>& m_callback;
  double m_begin, m_length;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_PASSES_H
