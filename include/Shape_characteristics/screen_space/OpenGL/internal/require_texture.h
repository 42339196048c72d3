#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_REQUIRE_TEXTURE_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_REQUIRE_TEXTURE_H

#include <epoxy/gl.h>

#include <stdexcept>
#include <string>

namespace Shape_characteristics {
namespace internal {

// Binds a 2D texture to the first unit, while a Gl_state is alive, and returns the format of its first level; throws if there is
// none of that name, or none with `width` columns and `height` rows. `is_larger` allows more of them.
inline GLenum
require_texture(const char* who, unsigned texture, int width, int height, bool is_larger = false)
{
  const auto require = [&](const bool condition, const char* complaint)
  {
    if(!condition)
      throw std::invalid_argument(std::string("Shape_characteristics: ") + who + ": " + complaint);
  };
  require(texture != 0 && glIsTexture(texture), "there is no texture of this name");
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture);
  GLint bound = 0, columns = 0, rows = 0, format = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
  if(GLuint(bound) != texture)
    glGetError(); // that it is of another kind
  require(GLuint(bound) == texture, "the texture isn't a 2D texture");
  glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &columns);
  glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &rows);
  require(is_larger ? columns >= width && rows >= height : columns == width && rows == height,
          "the texture has another size");
  glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_INTERNAL_FORMAT, &format);
  return GLenum(format);
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_REQUIRE_TEXTURE_H
