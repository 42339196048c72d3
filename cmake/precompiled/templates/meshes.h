SHAPE_CHARACTERISTICS_TEMPLATE class std::vector<precompiled::Kernel::Point_3>;
SHAPE_CHARACTERISTICS_TEMPLATE class std::vector<precompiled::Kernel::Vector_3>;

namespace CGAL {

namespace Properties {

SHAPE_CHARACTERISTICS_TEMPLATE class Property_array<double>;
SHAPE_CHARACTERISTICS_TEMPLATE class Property_array<precompiled::Kernel::Point_3>;
SHAPE_CHARACTERISTICS_TEMPLATE class Property_array<precompiled::Kernel::Vector_3>;
SHAPE_CHARACTERISTICS_TEMPLATE class Property_array< precompiled::Mesh::Vertex_connectivity>;
SHAPE_CHARACTERISTICS_TEMPLATE class Property_array< precompiled::Mesh::Halfedge_connectivity>;
SHAPE_CHARACTERISTICS_TEMPLATE class Property_array< precompiled::Mesh::Face_connectivity>;

} // namespace Properties

// Members alone: in CGAL 5.5, the class has some that don't compile.
SHAPE_CHARACTERISTICS_TEMPLATE precompiled::Mesh::Surface_mesh();
SHAPE_CHARACTERISTICS_TEMPLATE precompiled::Mesh& precompiled::Mesh::operator=(const precompiled::Mesh&);

SHAPE_CHARACTERISTICS_TEMPLATE precompiled::Mesh::Face_index
Euler::add_face(const std::vector<precompiled::Mesh::Vertex_index>&, precompiled::Mesh&);
SHAPE_CHARACTERISTICS_TEMPLATE precompiled::Mesh::Face_index
Euler::add_face(const std::array<precompiled::Mesh::Vertex_index, 3>&, precompiled::Mesh&);
SHAPE_CHARACTERISTICS_TEMPLATE precompiled::Mesh::Face_index
Euler::add_face(const boost::array<precompiled::Mesh::Vertex_index, 3>&, precompiled::Mesh&);

} // namespace CGAL
