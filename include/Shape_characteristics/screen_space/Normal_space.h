#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_NORMAL_SPACE_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_NORMAL_SPACE_H

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsScreenSpace

  says in which coordinates the normals of a G-buffer are.
*/
enum class Normal_space : unsigned char
{
  VIEW, ///< those of the camera: x to the right, y upwards, z towards the viewer
  WORLD ///< those of the scene; the view matrix of the camera turns them
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_NORMAL_SPACE_H
