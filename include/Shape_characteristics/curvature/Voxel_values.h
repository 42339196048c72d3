#ifndef SHAPE_CHARACTERISTICS_CURVATURE_VOXEL_VALUES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_VOXEL_VALUES_H

namespace Shape_characteristics {

/// \ingroup PkgShapeCharacteristicsCurvature
/// what the values of voxels are that are made of a mesh
enum class Voxel_values : unsigned char
{
  SHARES, ///< of each voxel, the share that is inside of the mesh
  BINARY  ///< 1 where the center of the voxel is inside of the mesh, 0 elsewhere
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_VOXEL_VALUES_H
