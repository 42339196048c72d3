// with the basis functions that estimators take by default

namespace Shape_characteristics {
namespace internal {

SHAPE_CHARACTERISTICS_TEMPLATE Hermite_batch_functions<Inverse_multiquadric>
    Hermite_batch_functions<Inverse_multiquadric>::best(std::size_t);
SHAPE_CHARACTERISTICS_TEMPLATE Hermite_batch_functions<Matern_9_2>
    Hermite_batch_functions<Matern_9_2>::best(std::size_t);

} // namespace internal
} // namespace Shape_characteristics
