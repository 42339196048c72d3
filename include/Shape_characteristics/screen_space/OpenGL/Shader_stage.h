#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_SHADER_STAGE_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_SHADER_STAGE_H

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsScreenSpace

  chooses the kind of shader that a pass over the pixels is. Both give the same.
*/
enum class Shader_stage : unsigned char
{
  FRAGMENT, ///< a triangle over the picture is drawn into the target
  COMPUTE   ///< the target is written as an image
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_SHADER_STAGE_H
