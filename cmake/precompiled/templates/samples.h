#define SHAPE_CHARACTERISTICS_SAMPLES_OF(FaceGraph, Tag)                                                     \
  SHAPE_CHARACTERISTICS_TEMPLATE Face_graph_samples::Face_graph_samples(                                     \
      const FaceGraph&, const precompiled::Points_of<FaceGraph>&, const Neighborhood&, Connectivity, Tag);
#define SHAPE_CHARACTERISTICS_SAMPLES(Tag)                                                                   \
  SHAPE_CHARACTERISTICS_SAMPLES_OF(precompiled::Mesh, Tag)                                                   \
  SHAPE_CHARACTERISTICS_SAMPLES_OF(precompiled::Polyhedron, Tag)                                             \
  SHAPE_CHARACTERISTICS_SAMPLES_OF(precompiled::Polyhedron_with_ids, Tag)                                    \
  SHAPE_CHARACTERISTICS_TEMPLATE std::vector<Eigen::Vector3d> vertex_normals<Tag>(const Face_graph_samples&, \
                                                                                  Normal_weighting);         \
  SHAPE_CHARACTERISTICS_TEMPLATE bool internal::for_each_block<Tag>(                                         \
      std::size_t, std::size_t, std::size_t, const std::function<void(std::size_t, std::size_t)>&,           \
      const std::function<bool(double)>&);

SHAPE_CHARACTERISTICS_TEMPLATE class std::vector<Eigen::Vector3d>;

namespace Shape_characteristics {

SHAPE_CHARACTERISTICS_FOR_EACH_TAG(SHAPE_CHARACTERISTICS_SAMPLES)

// of a vertex and its surroundings
SHAPE_CHARACTERISTICS_TEMPLATE
Face_graph_samples::Face_graph_samples(precompiled::Mesh::Vertex_index,
                                       const precompiled::Mesh&,
                                       const precompiled::Points_of<precompiled::Mesh>&,
                                       const Neighborhood&,
                                       unsigned int,
                                       std::vector<precompiled::Mesh::Vertex_index>&);

SHAPE_CHARACTERISTICS_TEMPLATE void
internal::Neighbor_order::sort(const Face_graph_samples&, std::size_t, std::vector<std::uint32_t>&);
SHAPE_CHARACTERISTICS_TEMPLATE void
internal::Neighbor_order::sort(const Point_set_samples&, std::size_t, std::vector<std::uint32_t>&);

} // namespace Shape_characteristics
