#define SHAPE_CHARACTERISTICS_TEMPLATES_OF_POLYHEDRA(Tag)                                                    \
  SHAPE_CHARACTERISTICS_SAMPLES_OF(precompiled::Polyhedron, Tag)                                             \
  SHAPE_CHARACTERISTICS_SAMPLES_OF(precompiled::Polyhedron_with_ids, Tag)

namespace Shape_characteristics {

SHAPE_CHARACTERISTICS_FOR_EACH_TAG(SHAPE_CHARACTERISTICS_TEMPLATES_OF_POLYHEDRA)

} // namespace Shape_characteristics
