#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_REQUIRE_OPENGL_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_REQUIRE_OPENGL_H

#include <epoxy/gl.h>

#include <stdexcept>
#include <string>

namespace Shape_characteristics {
namespace internal {

// Throws unless a context of OpenGL 4.3 or later is current in this thread.
inline void require_opengl(const char* who)
{
  const GLubyte* text = glGetString(GL_VERSION);
  if(!text)
    throw std::runtime_error(std::string("Shape_characteristics: ") + who +
                             ": no OpenGL context is current in this thread");
  const std::string version = reinterpret_cast<const char*>(text);
  if(version.rfind("OpenGL ES", 0) == 0 || epoxy_gl_version() < 43)
    throw std::runtime_error(std::string("Shape_characteristics: ") + who +
                             ": OpenGL 4.3 or later is needed, the current context has " + version);
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_REQUIRE_OPENGL_H
