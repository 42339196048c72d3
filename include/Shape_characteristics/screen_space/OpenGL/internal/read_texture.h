#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_READ_TEXTURE_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_READ_TEXTURE_H

#include <Shape_characteristics/screen_space/OpenGL/internal/Gl_state.h>
#include <Shape_characteristics/screen_space/OpenGL/internal/require_texture.h>

#include <epoxy/gl.h>

namespace Shape_characteristics {
namespace internal {

// Copies a 2D texture of a size to memory, as floats without gaps.
inline void
read_texture(const char* who, unsigned texture, int width, int height, GLenum channels, float* result)
{
  const Gl_state state;
  require_texture(who, texture, width, height);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glGetTexImage(GL_TEXTURE_2D, 0, channels, GL_FLOAT, result);
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_READ_TEXTURE_H
