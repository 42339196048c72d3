#ifndef SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_GL_PROGRAM_H
#define SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_GL_PROGRAM_H

#include <epoxy/gl.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace support {

/// Compiles and links shaders, each a stage and its text, in the current context. The caller deletes the program. Throws
/// `std::runtime_error` with the words of the compiler.
inline unsigned gl_program(const std::vector<std::pair<unsigned, std::string>>& shaders)
{
  const unsigned program = glCreateProgram();
  char log[2000] = "";
  for(const auto& [stage, text] : shaders)
  {
    const unsigned shader = glCreateShader(stage);
    const char* source = text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    int is_compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &is_compiled);
    if(!is_compiled && !*log)
      glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    glAttachShader(program, shader);
    glDeleteShader(shader);
  }
  glLinkProgram(program);
  int is_linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &is_linked);
  if(!is_linked)
  {
    if(!*log)
      glGetProgramInfoLog(program, sizeof log, nullptr, log);
    glDeleteProgram(program);
    throw std::runtime_error(std::string("gl_program: ") + log);
  }
  return program;
}

} // namespace support

#endif
