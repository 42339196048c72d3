namespace Shape_characteristics {
namespace internal {

#ifdef CGAL_LINKED_WITH_TBB
SHAPE_CHARACTERISTICS_TEMPLATE void
Hermite_rbf_fitter<CGAL::Parallel_tag>::operator()(Face_graph_samples&,
                                                   const Inverse_multiquadric&,
                                                   std::size_t,
                                                   const std::vector<Index>&,
                                                   const Output&) const;
SHAPE_CHARACTERISTICS_TEMPLATE void
Hermite_rbf_fitter<CGAL::Parallel_tag>::operator()(Face_graph_samples&,
                                                   const Matern_9_2&,
                                                   std::size_t,
                                                   const std::vector<Index>&,
                                                   const Output&) const;
#endif
SHAPE_CHARACTERISTICS_TEMPLATE void
Hermite_rbf_fitter<CGAL::Sequential_tag>::operator()(Face_graph_samples&,
                                                     const Inverse_multiquadric&,
                                                     std::size_t,
                                                     const std::vector<Index>&,
                                                     const Output&) const;
SHAPE_CHARACTERISTICS_TEMPLATE void
Hermite_rbf_fitter<CGAL::Sequential_tag>::operator()(Face_graph_samples&,
                                                     const Matern_9_2&,
                                                     std::size_t,
                                                     const std::vector<Index>&,
                                                     const Output&) const;

} // namespace internal
} // namespace Shape_characteristics
