SHAPE_CHARACTERISTICS_TEMPLATE class std::vector<Eigen::Vector3d>;

namespace Shape_characteristics {

SHAPE_CHARACTERISTICS_TEMPLATE
Face_graph_samples::Face_graph_samples(const precompiled::Mesh&,
                                       const precompiled::Points_of<precompiled::Mesh>&,
                                       const Neighborhood&,
                                       Connectivity,
                                       CGAL::Sequential_tag);
SHAPE_CHARACTERISTICS_TEMPLATE std::vector<Eigen::Vector3d>
vertex_normals<CGAL::Sequential_tag>(const Face_graph_samples&, Normal_weighting);

SHAPE_CHARACTERISTICS_TEMPLATE bool
internal::for_each_block<CGAL::Sequential_tag>(std::size_t,
                                               std::size_t,
                                               std::size_t,
                                               const std::function<void(std::size_t, std::size_t)>&,
                                               const std::function<bool(double)>&);

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

#ifdef CGAL_LINKED_WITH_TBB
SHAPE_CHARACTERISTICS_TEMPLATE
Face_graph_samples::Face_graph_samples(const precompiled::Mesh&,
                                       const precompiled::Points_of<precompiled::Mesh>&,
                                       const Neighborhood&,
                                       Connectivity,
                                       CGAL::Parallel_tag);
SHAPE_CHARACTERISTICS_TEMPLATE std::vector<Eigen::Vector3d>
vertex_normals<CGAL::Parallel_tag>(const Face_graph_samples&, Normal_weighting);
SHAPE_CHARACTERISTICS_TEMPLATE bool
internal::for_each_block<CGAL::Parallel_tag>(std::size_t,
                                             std::size_t,
                                             std::size_t,
                                             const std::function<void(std::size_t, std::size_t)>&,
                                             const std::function<bool(double)>&);
#endif

} // namespace Shape_characteristics
