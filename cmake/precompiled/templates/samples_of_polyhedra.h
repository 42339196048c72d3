namespace Shape_characteristics {

SHAPE_CHARACTERISTICS_TEMPLATE
Face_graph_samples::Face_graph_samples(const precompiled::Polyhedron&,
                                       const precompiled::Points_of<precompiled::Polyhedron>&,
                                       const Neighborhood&,
                                       Connectivity,
                                       CGAL::Sequential_tag);
SHAPE_CHARACTERISTICS_TEMPLATE
Face_graph_samples::Face_graph_samples(const precompiled::Polyhedron_with_ids&,
                                       const precompiled::Points_of<precompiled::Polyhedron_with_ids>&,
                                       const Neighborhood&,
                                       Connectivity,
                                       CGAL::Sequential_tag);

#ifdef CGAL_LINKED_WITH_TBB
SHAPE_CHARACTERISTICS_TEMPLATE
Face_graph_samples::Face_graph_samples(const precompiled::Polyhedron&,
                                       const precompiled::Points_of<precompiled::Polyhedron>&,
                                       const Neighborhood&,
                                       Connectivity,
                                       CGAL::Parallel_tag);
SHAPE_CHARACTERISTICS_TEMPLATE
Face_graph_samples::Face_graph_samples(const precompiled::Polyhedron_with_ids&,
                                       const precompiled::Points_of<precompiled::Polyhedron_with_ids>&,
                                       const Neighborhood&,
                                       Connectivity,
                                       CGAL::Parallel_tag);
#endif

} // namespace Shape_characteristics
