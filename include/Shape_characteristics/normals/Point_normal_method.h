#ifndef SHAPE_CHARACTERISTICS_NORMALS_POINT_NORMAL_METHOD_H
#define SHAPE_CHARACTERISTICS_NORMALS_POINT_NORMAL_METHOD_H

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsNormals

  says how `point_normals()` estimates the normal of a point from its neighbors.
*/
enum class Point_normal_method : unsigned char
{
  PCA, ///< normal of the plane that fits best (as `CGAL::pca_estimate_normals()`): the more robust against noise
  JET ///< normal of the quadric that fits best (`CGAL::Monge_via_jet_fitting`, as in `CGAL::jet_estimate_normals()`):
      ///< the more accurate on smooth surfaces; needs 5 neighbors
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_NORMALS_POINT_NORMAL_METHOD_H
