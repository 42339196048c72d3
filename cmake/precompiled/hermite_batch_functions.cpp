#include <Shape_characteristics/interpolation/internal/Extended_hermite_functions.h>
#include <Shape_characteristics/interpolation/internal/Hermite_batch_functions.h>

namespace Shape_characteristics {
namespace internal {

template Hermite_batch_functions<Inverse_multiquadric>
    Hermite_batch_functions<Inverse_multiquadric>::best(std::size_t);
template Hermite_batch_functions<Matern_9_2> Hermite_batch_functions<Matern_9_2>::best(std::size_t);
template struct Extended_hermite_functions<Inverse_multiquadric>;
template struct Extended_hermite_functions<Matern_9_2>;

} // namespace internal
} // namespace Shape_characteristics
