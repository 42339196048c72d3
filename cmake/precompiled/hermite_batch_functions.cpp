#include <Shape_characteristics/interpolation/internal/Hermite_batch_functions.h>

namespace Shape_characteristics {
namespace internal {

template Hermite_batch_functions<Inverse_multiquadric>
    Hermite_batch_functions<Inverse_multiquadric>::best(std::size_t);
template Hermite_batch_functions<Matern_9_2> Hermite_batch_functions<Matern_9_2>::best(std::size_t);

} // namespace internal
} // namespace Shape_characteristics
