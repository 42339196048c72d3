#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_GL_STATE_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_GL_STATE_H

#include <epoxy/gl.h>

#include <array>
#include <cstddef>

namespace Shape_characteristics {
namespace internal {

// Keeps the part of OpenGL's state that our passes change, sets what they rely on, and gives all back when it ends, so that they can
// run in the middle of someone else's frame.
class Gl_state
{
public:
  Gl_state()
  {
    glGetIntegerv(GL_CURRENT_PROGRAM, &m_program);
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &m_vertex_array);
    glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &m_array_buffer);
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &m_draw_framebuffer);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &m_read_framebuffer);
    glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &m_pack_buffer);
    glGetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &m_unpack_buffer);
    glGetIntegerv(GL_VIEWPORT, m_viewport.data());
    glGetIntegerv(GL_DEPTH_FUNC, &m_depth_function);
    glGetBooleanv(GL_DEPTH_WRITEMASK, &m_depth_mask);
    glGetBooleani_v(GL_COLOR_WRITEMASK, 0, m_color_mask.data());
    glGetFloatv(GL_COLOR_CLEAR_VALUE, m_clear_color.data());
    glGetFloatv(GL_DEPTH_CLEAR_VALUE, &m_clear_depth);
    glGetFloatv(GL_DEPTH_RANGE, m_depth_range.data());
    GLint mode[2] = {GL_FILL, GL_FILL}; // some drivers tell two of them
    glGetIntegerv(GL_POLYGON_MODE, mode);
    m_polygon_mode = mode[0];
    for(std::size_t i = 0; i < switches.size(); ++i)
    {
      m_enabled[i] = glIsEnabled(switches[i]);
      glDisable(switches[i]);
    }
    glGetIntegerv(GL_ACTIVE_TEXTURE, &m_active_texture);
    for(std::size_t i = 0; i < m_textures.size(); ++i)
    {
      glActiveTexture(GLenum(GL_TEXTURE0 + i));
      glGetIntegerv(GL_TEXTURE_BINDING_2D, &m_textures[i]);
      glGetIntegerv(GL_SAMPLER_BINDING, &m_samplers[i]);
    }
    glGetIntegeri_v(GL_IMAGE_BINDING_NAME, 0, &m_image);
    if(m_image)
    {
      glGetIntegeri_v(GL_IMAGE_BINDING_LEVEL, 0, &m_image_level);
      glGetBooleani_v(GL_IMAGE_BINDING_LAYERED, 0, &m_image_layered);
      glGetIntegeri_v(GL_IMAGE_BINDING_LAYER, 0, &m_image_layer);
      glGetIntegeri_v(GL_IMAGE_BINDING_ACCESS, 0, &m_image_access);
      glGetIntegeri_v(GL_IMAGE_BINDING_FORMAT, 0, &m_image_format);
    }
    glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  }

  ~Gl_state()
  {
    if(m_image)
      glBindImageTexture(0, GLuint(m_image), m_image_level, m_image_layered, m_image_layer,
                         GLenum(m_image_access), GLenum(m_image_format));
    for(std::size_t i = 0; i < m_textures.size(); ++i)
    {
      glActiveTexture(GLenum(GL_TEXTURE0 + i));
      glBindTexture(GL_TEXTURE_2D, GLuint(m_textures[i]));
      glBindSampler(GLuint(i), GLuint(m_samplers[i]));
    }
    glActiveTexture(GLenum(m_active_texture));
    for(std::size_t i = 0; i < switches.size(); ++i)
      (m_enabled[i] ? glEnable : glDisable)(switches[i]);
    glPolygonMode(GL_FRONT_AND_BACK, GLenum(m_polygon_mode));
    glDepthRange(m_depth_range[0], m_depth_range[1]);
    glClearDepth(m_clear_depth);
    glClearColor(m_clear_color[0], m_clear_color[1], m_clear_color[2], m_clear_color[3]);
    glColorMaski(0, m_color_mask[0], m_color_mask[1], m_color_mask[2], m_color_mask[3]);
    glDepthMask(m_depth_mask);
    glDepthFunc(GLenum(m_depth_function));
    glViewport(m_viewport[0], m_viewport[1], m_viewport[2], m_viewport[3]);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, GLuint(m_unpack_buffer));
    glBindBuffer(GL_PIXEL_PACK_BUFFER, GLuint(m_pack_buffer));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(m_read_framebuffer));
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(m_draw_framebuffer));
    glBindVertexArray(GLuint(m_vertex_array));
    glBindBuffer(GL_ARRAY_BUFFER, GLuint(m_array_buffer));
    glUseProgram(GLuint(m_program));
  }

  Gl_state(const Gl_state&) = delete;
  Gl_state& operator=(const Gl_state&) = delete;

private:
  static constexpr std::array<GLenum, 7> switches = {GL_DEPTH_TEST,        GL_BLEND,        GL_CULL_FACE,
                                                     GL_SCISSOR_TEST,      GL_STENCIL_TEST, GL_COLOR_LOGIC_OP,
                                                     GL_RASTERIZER_DISCARD};
  GLint m_program = 0, m_vertex_array = 0, m_array_buffer = 0, m_draw_framebuffer = 0, m_read_framebuffer = 0,
        m_pack_buffer = 0, m_unpack_buffer = 0, m_depth_function = 0, m_active_texture = 0,
        m_polygon_mode = 0;
  GLint m_image = 0, m_image_level = 0, m_image_layer = 0, m_image_access = 0, m_image_format = 0;
  GLboolean m_image_layered = GL_FALSE, m_depth_mask = GL_TRUE;
  std::array<GLint, 4> m_viewport{};
  std::array<GLboolean, 4> m_color_mask{};
  std::array<GLfloat, 4> m_clear_color{};
  std::array<GLfloat, 2> m_depth_range{};
  GLfloat m_clear_depth = 1.f;
  std::array<GLboolean, switches.size()> m_enabled{};
  std::array<GLint, 2> m_textures{}, m_samplers{};
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_GL_STATE_H
