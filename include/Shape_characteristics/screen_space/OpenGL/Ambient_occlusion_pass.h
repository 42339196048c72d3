#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_AMBIENT_OCCLUSION_PASS_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_AMBIENT_OCCLUSION_PASS_H

#include <Shape_characteristics/screen_space/Griffin_ambient_occlusion.h>
#include <Shape_characteristics/screen_space/Hattori_ambient_occlusion.h>
#include <Shape_characteristics/screen_space/OpenGL/Shader_stage.h>
#include <Shape_characteristics/screen_space/OpenGL/internal/Gl_ambient_occlusion.h>
#include <Shape_characteristics/screen_space/OpenGL/internal/Gl_program.h>
#include <Shape_characteristics/screen_space/OpenGL/internal/Gl_state.h>
#include <Shape_characteristics/screen_space/OpenGL/internal/require_opengl.h>
#include <Shape_characteristics/screen_space/OpenGL/internal/require_texture.h>
#include <Shape_characteristics/screen_space/Two_part_ambient_occlusion.h>

#include <epoxy/gl.h>

#include <array>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsScreenSpace

  guesses from curvature how much of the ambient light arrives at each pixel, on the GPU: `ambient_occlusion()` as a shader.

  It takes what `Screen_space_curvature_pass` returns, and needs nothing but a current OpenGL context, 4.3 core or later. What it changes of OpenGL's state it gives
  back, and nothing is allocated from one picture to the next of the same size. Shaders are compiled when a mapping is first used.

  Results differ from those of the mappings on the CPU by no more than \f$ 2^{-20} \f$ for the same curvatures, as long as those are far from
  overflow.

  The shader, OpenGL/shaders/ambient_occlusion.glsl, stands alone and can be used without this class: as a library it joins the shader of
  the curvatures, and no picture of curvatures has to be written and read.

  \cgalExample{screen_space/ambient_occlusion.cpp}
*/
class Ambient_occlusion_pass
{
public:
  /// prepares the pass in the current context, in which it has to be used and destroyed.
  /// \throws std::runtime_error if no context is current, or if it has less than OpenGL 4.3
  explicit Ambient_occlusion_pass(Shader_stage stage = Shader_stage::FRAGMENT) : m_stage(stage)
  {
    internal::require_opengl("Ambient_occlusion_pass");
    glGenVertexArrays(1, &m_vertex_array);
    glGenFramebuffers(1, &m_framebuffer);
    glGenSamplers(1, &m_sampler);
    glSamplerParameteri(m_sampler, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glSamplerParameteri(m_sampler, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }

  ~Ambient_occlusion_pass()
  {
    glDeleteTextures(1, &m_target);
    glDeleteSamplers(1, &m_sampler);
    glDeleteFramebuffers(1, &m_framebuffer);
    glDeleteVertexArrays(1, &m_vertex_array);
  }

  Ambient_occlusion_pass(const Ambient_occlusion_pass&) = delete;
  Ambient_occlusion_pass& operator=(const Ambient_occlusion_pass&) = delete;

  /*!
    maps the curvatures of a picture and returns the name of the texture with the results, which the pass owns and the next call
    changes.

    Its format is `GL_R32F`: the share of the ambient light that arrives, 1 is fully lit, 0 is dark.

    \tparam AmbientOcclusionMapping `Two_part_ambient_occlusion`, `Hattori_ambient_occlusion` or `Griffin_ambient_occlusion`
    \param curvatures the texture that `Screen_space_curvature_pass` returned, or another one with the principal curvatures in the
           first two channels
    \param width number of columns
    \param height number of rows
    \param mapping what makes light of curvature
    \param background what pixels without curvature get, the background among them
    \return 0 if the picture has no pixels
    \throws std::invalid_argument if the size is negative, or `curvatures` is no 2D texture, or smaller
    \throws std::runtime_error if a shader doesn't compile, with the words of the driver
  */
  template <typename AmbientOcclusionMapping>
  unsigned operator()(unsigned curvatures,
                      int width,
                      int height,
                      const AmbientOcclusionMapping& mapping,
                      float background = std::numeric_limits<float>::quiet_NaN())
  {
    if(width < 0 || height < 0)
      throw std::invalid_argument(
          "Shape_characteristics: Ambient_occlusion_pass: the size of a picture must not be negative");
    if(width == 0 || height == 0)
      return 0;
    run(curvatures, width, height, internal::Gl_ambient_occlusion(mapping), background);
    return m_target;
  }

private:
  struct Variant
  {
    internal::Gl_program program;
    GLint occlusion = -1, background = -1;
  };

  void run(unsigned curvatures,
           int width,
           int height,
           const internal::Gl_ambient_occlusion& mapping,
           float background)
  {
    Variant& v = m_variants[std::size_t(mapping.number)];
    if(v.program.name() == 0)
      compile(v, mapping.number);
    const GLuint name = v.program.name();
    glProgramUniform4fv(name, v.occlusion, 1, mapping.parameters.data());
    glProgramUniform1f(name, v.background, background);

    const bool is_resized = width != m_width || height != m_height;
    if(is_resized)
      glDeleteTextures(1, &m_target); // first: wherever the application shows it, there is nothing then
    const internal::Gl_state state;
    glActiveTexture(GL_TEXTURE0);
    if(is_resized)
    {
      glGenTextures(1, &m_target);
      glBindTexture(GL_TEXTURE_2D, m_target);
      glTexStorage2D(GL_TEXTURE_2D, 1, GL_R32F, width, height);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
      glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
      glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_target, 0);
      m_width = width;
      m_height = height;
    }
    internal::require_texture("Ambient_occlusion_pass", curvatures, width, height, true);
    glBindSampler(0, m_sampler);
    glUseProgram(name);
    if(m_stage == Shader_stage::COMPUTE)
    {
      glBindImageTexture(0, m_target, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
      v.program.run_over(width, height);
      glBindImageTexture(0, 0, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
      return;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    glViewportIndexedf(0, 0.f, 0.f, float(width), float(height));
    glBindVertexArray(m_vertex_array);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }

  void compile(Variant& v, int number) const
  {
    const bool is_compute = m_stage == Shader_stage::COMPUTE;
    const std::string text = std::string("#version 430 core\n") + (is_compute ? "#define SC_COMPUTE\n" : "") +
                             "#define SC_MAPPING " + std::to_string(number) + "\n#if 1\n" +
                             internal::ambient_occlusion_shader + "\n#endif\n";
    constexpr char over_the_picture[] =
        "#version 430 core\n"
        "void main()\n"
        "{\n"
        "  gl_Position = vec4((gl_VertexID & 1) * 4 - 1, (gl_VertexID >> 1) * 4 - 1, 0, 1);\n"
        "}\n";
    v.program =
        is_compute ? internal::Gl_program("Ambient_occlusion_pass", {{GL_COMPUTE_SHADER, text}})
                   : internal::Gl_program("Ambient_occlusion_pass",
                                          {{GL_VERTEX_SHADER, over_the_picture}, {GL_FRAGMENT_SHADER, text}});
    v.occlusion = v.program.uniform("sc_occlusion");
    v.background = v.program.uniform("sc_background");
    glProgramUniform1i(v.program.name(), v.program.uniform("sc_curvatures"), 0);
  }

  Shader_stage m_stage;
  GLuint m_vertex_array = 0, m_framebuffer = 0, m_sampler = 0, m_target = 0;
  int m_width = 0, m_height = 0;
  std::array<Variant, 3> m_variants;
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_AMBIENT_OCCLUSION_PASS_H
