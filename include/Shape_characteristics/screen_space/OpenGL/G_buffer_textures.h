#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_G_BUFFER_TEXTURES_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_G_BUFFER_TEXTURES_H

#include <Shape_characteristics/screen_space/Camera.h>
#include <Shape_characteristics/screen_space/Normal_space.h>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsScreenSpace

  names the textures of a renderer that are its G-buffer. It owns nothing.

  Depths are the first channel of a texture with a depth format or a float format; normals are the first three channels of a float or
  signed normalized format. Curvatures are differences of normals: 16 bits a channel are the least that is useful, and half floats leave an error of
  \f$ 2^{-12} \f$ divided by the size of a pixel in the scene. Both textures have the size of the picture.
*/
struct G_buffer_textures
{
  int width;                                      ///< number of columns; may be 0
  int height;                                     ///< number of rows; may be 0
  unsigned depths;                                ///< name of a 2D texture
  unsigned normals;                               ///< name of a 2D texture
  Camera camera;                                  ///< where the picture was taken from, and what depths mean
  Normal_space normal_space = Normal_space::VIEW; ///< in which coordinates normals are
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_G_BUFFER_TEXTURES_H
