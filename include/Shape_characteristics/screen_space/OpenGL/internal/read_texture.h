#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_READ_TEXTURE_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_READ_TEXTURE_H

#include <Shape_characteristics/screen_space/OpenGL/internal/Gl_state.h>

#include <epoxy/gl.h>

namespace Shape_characteristics {
namespace internal {

// Copies a 2D texture to memory, as floats without gaps.
inline void read_texture(unsigned texture, GLenum channels, float* result)
{
  const Gl_state state;
  constexpr GLenum settings[] = {GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS,
                                 GL_PACK_SWAP_BYTES};
  GLint values[4], alignment = 4;
  glGetIntegerv(GL_PACK_ALIGNMENT, &alignment);
  for(int i = 0; i < 4; ++i)
  {
    glGetIntegerv(settings[i], &values[i]);
    glPixelStorei(settings[i], 0);
  }
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture);
  glGetTexImage(GL_TEXTURE_2D, 0, channels, GL_FLOAT, result);
  for(int i = 0; i < 4; ++i)
    glPixelStorei(settings[i], values[i]);
  glPixelStorei(GL_PACK_ALIGNMENT, alignment);
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_READ_TEXTURE_H
