#ifndef SHAPE_CHARACTERISTICS_DESCRIPTORS_FLUX_METHOD_H
#define SHAPE_CHARACTERISTICS_DESCRIPTORS_FLUX_METHOD_H

namespace Shape_characteristics {

/// \ingroup PkgShapeCharacteristicsDescriptors
/// says over what the flux of `Symmetry_flux_descriptor` is summed
enum class Flux_method : unsigned char
{
  POINTS, ///< over the neighbors and their normals (10.12): point sets, and the vertices of meshes
  /// over the triangles of a mesh around the vertex, those at the rim clipped to the ball (10.3, 10.11)
  CLIPPED_TRIANGLES,
  BOUNDARY ///< along the boundary of these triangles: the same value by Stokes' theorem
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_DESCRIPTORS_FLUX_METHOD_H
