#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_READ_TEXTURE_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_READ_TEXTURE_H

#include <Shape_characteristics/screen_space/OpenGL/internal/Gl_state.h>
#include <Shape_characteristics/screen_space/OpenGL/internal/require_texture.h>

#include <epoxy/gl.h>

namespace Shape_characteristics {
namespace internal {

// Copies a 2D texture of a size to memory, as floats without gaps. Depths are in the red channel if the texture has no others.
inline void
read_texture(const char* who, unsigned texture, int width, int height, GLenum channels, float* result)
{
  const Gl_state state;
  require_texture(who, texture, width, height);
  if(channels == GL_DEPTH_COMPONENT)
  {
    GLint bits = 0;
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_DEPTH_SIZE, &bits);
    channels = bits > 0 ? GL_DEPTH_COMPONENT : GL_RED;
  }
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glGetTexImage(GL_TEXTURE_2D, 0, channels, GL_FLOAT, result);
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_READ_TEXTURE_H
