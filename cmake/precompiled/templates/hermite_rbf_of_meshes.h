#define SHAPE_CHARACTERISTICS_HERMITE_RBF_OF_MESHES(Tag)                                                     \
  SHAPE_CHARACTERISTICS_HERMITE_RBF_OF(Face_graph_samples, Tag)

namespace Shape_characteristics {
namespace internal {

SHAPE_CHARACTERISTICS_FOR_EACH_TAG(SHAPE_CHARACTERISTICS_HERMITE_RBF_OF_MESHES)

} // namespace internal
} // namespace Shape_characteristics
