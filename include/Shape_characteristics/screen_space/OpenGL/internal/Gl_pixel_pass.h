#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_GL_PIXEL_PASS_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_GL_PIXEL_PASS_H

#include <Shape_characteristics/screen_space/OpenGL/G_buffer_textures.h>
#include <Shape_characteristics/screen_space/OpenGL/Shader_stage.h>
#include <Shape_characteristics/screen_space/OpenGL/internal/Gl_program.h>
#include <Shape_characteristics/screen_space/OpenGL/internal/Gl_state.h>
#include <Shape_characteristics/screen_space/OpenGL/internal/require_opengl.h>
#include <Shape_characteristics/screen_space/OpenGL/internal/require_texture.h>
#include <Shape_characteristics/screen_space/internal/Screen_frame.h>

#include <epoxy/gl.h>

#include <stdexcept>
#include <string>

namespace Shape_characteristics {
namespace internal {

// Whether there is anything to do.
inline bool has_pixels(const G_buffer_textures& g)
{
  if(g.width < 0 || g.height < 0)
    throw std::invalid_argument("Shape_characteristics: the size of a G-buffer must not be negative");
  return g.width > 0 && g.height > 0;
}

// A program made of one of the shader files, and where its uniforms are.
struct Gl_pixel_program
{
  Gl_program program;
  GLint depths = -1, normals = -1, size = -1, distance = -1, determinant = -1, depth_range = -1, rays = -1,
        pixel = -1, to_view = -1;
};

// Runs a shader at each pixel of a G-buffer. Nothing is allocated from one picture to the next of the same size.
class Gl_pixel_pass
{
public:
  Gl_pixel_pass(const char* who, Shader_stage stage) : m_who(who), m_stage(stage)
  {
    require_opengl(who);
    glGenVertexArrays(1, &m_vertex_array);
    glGenFramebuffers(1, &m_framebuffer);
    glGenSamplers(1, &m_sampler);
    glSamplerParameteri(m_sampler, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glSamplerParameteri(m_sampler, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glSamplerParameteri(m_sampler, GL_TEXTURE_COMPARE_MODE, GL_NONE);
  }

  ~Gl_pixel_pass()
  {
    glDeleteSamplers(1, &m_sampler);
    glDeleteFramebuffers(1, &m_framebuffer);
    glDeleteVertexArrays(1, &m_vertex_array);
    glDeleteTextures(1, &m_target);
  }

  Gl_pixel_pass(const Gl_pixel_pass&) = delete;
  Gl_pixel_pass& operator=(const Gl_pixel_pass&) = delete;

  Gl_pixel_program compile(const std::string& defines, const char* shader) const
  {
    const bool is_compute = m_stage == Shader_stage::COMPUTE;
    const std::string text = std::string("#version 430 core\n") + (is_compute ? "#define SC_COMPUTE\n" : "") +
                             defines + "#if 1\n" + shader + "\n#endif\n";
    constexpr char over_the_picture[] =
        "#version 430 core\n"
        "void main()\n"
        "{\n"
        "  gl_Position = vec4((gl_VertexID & 1) * 4 - 1, (gl_VertexID >> 1) * 4 - 1, 0, 1);\n"
        "}\n";
    Gl_pixel_program p;
    p.program = is_compute
                    ? Gl_program(m_who, {{GL_COMPUTE_SHADER, text}})
                    : Gl_program(m_who, {{GL_VERTEX_SHADER, over_the_picture}, {GL_FRAGMENT_SHADER, text}});
    p.depths = p.program.uniform("sc_depths");
    p.normals = p.program.uniform("sc_normals");
    p.size = p.program.uniform("sc_size");
    p.distance = p.program.uniform("sc_distance");
    p.determinant = p.program.uniform("sc_determinant");
    p.depth_range = p.program.uniform("sc_depth_range");
    p.rays = p.program.uniform("sc_rays");
    p.pixel = p.program.uniform("sc_pixel");
    p.to_view = p.program.uniform("sc_to_view");
    return p;
  }

  // the pass's own target, of the size of the picture
  unsigned own_target(int width, int height)
  {
    if(width != m_target_width || height != m_target_height || m_target == 0)
    {
      glDeleteTextures(1, &m_target); // first: wherever the application shows it, there is nothing then
      m_attached = 0;
      const Gl_state state;
      glGenTextures(1, &m_target);
      glActiveTexture(GL_TEXTURE0);
      glBindTexture(GL_TEXTURE_2D, m_target);
      glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA32F, width, height);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
      m_target_width = width;
      m_target_height = height;
    }
    return m_target;
  }

  void run(const Gl_pixel_program& p, const G_buffer_textures& g, const Screen_frame& frame, unsigned target)
  {
    const GLuint name = p.program.name();
    glProgramUniform1i(name, p.depths, 0);
    glProgramUniform1i(name, p.normals, 1);
    glProgramUniform2i(name, p.size, g.width, g.height);
    glProgramUniform4f(name, p.distance, frame.numerator[0], frame.numerator[1], frame.denominator[0],
                       frame.denominator[1]);
    glProgramUniform1f(name, p.determinant, frame.determinant);
    glProgramUniform4f(name, p.depth_range, frame.depth_reference, frame.lowest_depth, frame.highest_depth,
                       frame.depth_sign);
    glProgramUniform4f(name, p.rays, frame.ray_origin[0], frame.ray_origin[1], frame.ray_step[0],
                       frame.ray_step[1]);
    glProgramUniform4f(name, p.pixel, frame.pixel_edge[0], frame.pixel_edge[1], frame.pixel_size,
                       frame.perspective);
    glProgramUniformMatrix3fv(name, p.to_view, 1, GL_FALSE, frame.to_view.data());

    const Gl_state state;
    if(target != m_target)
      require_target(g, target);
    const GLuint textures[2] = {g.depths, g.normals};
    for(GLuint i = 0; i < 2; ++i)
    {
      glActiveTexture(GL_TEXTURE0 + i);
      glBindTexture(GL_TEXTURE_2D, textures[i]);
      glBindSampler(i, m_sampler);
    }
    glUseProgram(name);
    if(m_stage == Shader_stage::COMPUTE)
    {
      glBindImageTexture(0, target, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
      p.program.run_over(g.width, g.height);
      glBindImageTexture(0, 0, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
      return;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    if(target != m_attached)
    {
      glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target, 0);
      m_attached = 0;
      if(glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw std::invalid_argument(std::string("Shape_characteristics: ") + m_who +
                                    ": the target is no texture that can be drawn into");
      // a target of someone else may be deleted and its name used again
      m_attached = target == m_target ? target : 0;
    }
    glViewportIndexedf(0, 0.f, 0.f, float(g.width), float(g.height));
    glBindVertexArray(m_vertex_array);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }

private:
  // a texture of the application
  void require_target(const G_buffer_textures& g, unsigned target) const
  {
    const GLenum format = require_texture(m_who, target, g.width, g.height, true);
    if(m_stage == Shader_stage::COMPUTE && format != GL_RGBA32F)
      throw std::invalid_argument(std::string("Shape_characteristics: ") + m_who +
                                  ": compute shaders write into textures of the format GL_RGBA32F");
  }

  const char* m_who;
  Shader_stage m_stage;
  GLuint m_vertex_array = 0, m_framebuffer = 0, m_sampler = 0, m_target = 0, m_attached = 0;
  int m_target_width = 0, m_target_height = 0;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_GL_PIXEL_PASS_H
