#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_GL_PROGRAM_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_GL_PROGRAM_H

#include <epoxy/gl.h>

#include <array>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <utility>

namespace Shape_characteristics {
namespace internal {

// A linked program, or none.
class Gl_program
{
public:
  Gl_program() = default;
  Gl_program(Gl_program&& other) noexcept
    : m_name(std::exchange(other.m_name, 0)),
      m_work_group(other.m_work_group)
  {}
  Gl_program& operator=(Gl_program&& other) noexcept
  {
    std::swap(m_name, other.m_name);
    std::swap(m_work_group, other.m_work_group);
    return *this;
  }
  ~Gl_program()
  {
    if(m_name)
      glDeleteProgram(m_name);
  }

  // compiles and links; throws with the compiler's words
  Gl_program(const char* who, std::initializer_list<std::pair<GLenum, std::string>> shaders)
  {
    m_name = glCreateProgram();
    std::string failure;
    for(const auto& [stage, text] : shaders)
    {
      const GLuint shader = glCreateShader(stage);
      const char* source = text.c_str();
      glShaderSource(shader, 1, &source, nullptr);
      glCompileShader(shader);
      GLint is_compiled = 0;
      glGetShaderiv(shader, GL_COMPILE_STATUS, &is_compiled);
      if(!is_compiled && failure.empty())
        failure = std::string("a shader doesn't compile: ") + log(shader, glGetShaderInfoLog);
      glAttachShader(m_name, shader);
      glDeleteShader(shader);
    }
    if(failure.empty())
    {
      glLinkProgram(m_name);
      GLint is_linked = 0;
      glGetProgramiv(m_name, GL_LINK_STATUS, &is_linked);
      if(!is_linked)
        failure = std::string("shaders don't link: ") + log(m_name, glGetProgramInfoLog);
    }
    if(!failure.empty())
    {
      glDeleteProgram(m_name);
      throw std::runtime_error(std::string("Shape_characteristics: ") + who + ": " + failure);
    }
    if(shaders.begin()->first == GL_COMPUTE_SHADER)
      glGetProgramiv(m_name, GL_COMPUTE_WORK_GROUP_SIZE, m_work_group.data());
  }

  GLuint name() const { return m_name; }
  GLint uniform(const char* uniform) const { return glGetUniformLocation(m_name, uniform); }

  // runs a compute shader, in use, at each pixel of a picture; what comes next may read what it has written
  void run_over(int width, int height) const
  {
    const auto groups = [](int pixels, GLint size) { return GLuint((pixels + size - 1) / size); };
    glDispatchCompute(groups(width, m_work_group[0]), groups(height, m_work_group[1]), 1);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
  }

private:
  template <typename Function>
  static std::string log(GLuint name, const Function& function)
  {
    char text[2000] = "";
    function(name, sizeof text, nullptr, text);
    return text;
  }

  GLuint m_name = 0;
  std::array<GLint, 3> m_work_group = {1, 1, 1};
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_GL_PROGRAM_H
