#define SHAPE_CHARACTERISTICS_HERMITE_RBF_OF_POINT_SETS(Tag)                                                 \
  SHAPE_CHARACTERISTICS_HERMITE_RBF_OF(Point_set_samples, Tag)

namespace Shape_characteristics {
namespace internal {

SHAPE_CHARACTERISTICS_FOR_EACH_TAG(SHAPE_CHARACTERISTICS_HERMITE_RBF_OF_POINT_SETS)

} // namespace internal
} // namespace Shape_characteristics
