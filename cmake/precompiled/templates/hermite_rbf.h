// with the basis functions that estimators take by default

#define SHAPE_CHARACTERISTICS_FITTER(Tag, Samples, Phi)                                                      \
  SHAPE_CHARACTERISTICS_TEMPLATE void Hermite_rbf_fitter<Tag>::operator()(                                   \
      Samples&, const Phi&, std::size_t, const std::vector<Index>&, const Output&) const;
#define SHAPE_CHARACTERISTICS_FITTERS(Tag)                                                                   \
  SHAPE_CHARACTERISTICS_FITTER(Tag, Face_graph_samples, Inverse_multiquadric)                                \
  SHAPE_CHARACTERISTICS_FITTER(Tag, Face_graph_samples, Matern_9_2)                                          \
  SHAPE_CHARACTERISTICS_FITTER(Tag, Point_set_samples, Inverse_multiquadric)                                 \
  SHAPE_CHARACTERISTICS_FITTER(Tag, Point_set_samples, Matern_9_2)

namespace Shape_characteristics {
namespace internal {

SHAPE_CHARACTERISTICS_TEMPLATE Hermite_batch_functions<Inverse_multiquadric>
    Hermite_batch_functions<Inverse_multiquadric>::best(std::size_t);
SHAPE_CHARACTERISTICS_TEMPLATE Hermite_batch_functions<Matern_9_2>
    Hermite_batch_functions<Matern_9_2>::best(std::size_t);
SHAPE_CHARACTERISTICS_FOR_EACH_TAG(SHAPE_CHARACTERISTICS_FITTERS)

} // namespace internal
} // namespace Shape_characteristics
