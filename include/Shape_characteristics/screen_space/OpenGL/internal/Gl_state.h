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
    glGetFloati_v(GL_VIEWPORT, 0, m_viewport.data());
    glGetIntegerv(GL_DEPTH_FUNC, &m_depth_function);
    glGetBooleanv(GL_DEPTH_WRITEMASK, &m_depth_mask);
    glGetBooleani_v(GL_COLOR_WRITEMASK, 0, m_color_mask.data());
    glGetFloatv(GL_COLOR_CLEAR_VALUE, m_clear_color.data());
    glGetFloatv(GL_DEPTH_CLEAR_VALUE, &m_clear_depth);
    glGetDoublei_v(GL_DEPTH_RANGE, 0, m_depth_range.data());
    GLint mode[2] = {GL_FILL, GL_FILL}; // some drivers tell two of them
    glGetIntegerv(GL_POLYGON_MODE, mode);
    m_polygon_mode = mode[0];
    for(std::size_t i = 0; i < switches.size(); ++i)
    {
      m_enabled[i] = glIsEnabled(switches[i]);
      glDisable(switches[i]);
    }
    for(std::size_t i = 0; i < first_switches.size(); ++i)
    {
      m_first_enabled[i] = glIsEnabledi(first_switches[i], 0);
      glDisablei(first_switches[i], 0);
    }
    if(has_clip_control())
    {
      glGetIntegerv(GL_CLIP_ORIGIN, &m_clip_origin);
      glGetIntegerv(GL_CLIP_DEPTH_MODE, &m_clip_depth);
      glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    }
    for(std::size_t i = 0; i < storage.size(); ++i)
    {
      glGetIntegerv(storage[i], &m_storage[i]);
      glPixelStorei(storage[i], 0);
    }
    for(std::size_t i = 0; i < alignments.size(); ++i)
    {
      glGetIntegerv(alignments[i], &m_alignments[i]);
      glPixelStorei(alignments[i], 4);
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
    for(std::size_t i = 0; i < first_switches.size(); ++i)
      (m_first_enabled[i] ? glEnablei : glDisablei)(first_switches[i], 0);
    if(has_clip_control())
      glClipControl(GLenum(m_clip_origin), GLenum(m_clip_depth));
    for(std::size_t i = 0; i < storage.size(); ++i)
      glPixelStorei(storage[i], m_storage[i]);
    for(std::size_t i = 0; i < alignments.size(); ++i)
      glPixelStorei(alignments[i], m_alignments[i]);
    glPolygonMode(GL_FRONT_AND_BACK, GLenum(m_polygon_mode));
    glDepthRangeIndexed(0, m_depth_range[0], m_depth_range[1]);
    glClearDepth(m_clear_depth);
    glClearColor(m_clear_color[0], m_clear_color[1], m_clear_color[2], m_clear_color[3]);
    glColorMaski(0, m_color_mask[0], m_color_mask[1], m_color_mask[2], m_color_mask[3]);
    glDepthMask(m_depth_mask);
    glDepthFunc(GLenum(m_depth_function));
    glViewportIndexedf(0, m_viewport[0], m_viewport[1], m_viewport[2], m_viewport[3]);
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
  static bool has_clip_control()
  {
    return epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_ARB_clip_control");
  }

  static constexpr std::array<GLenum, 8> switches = {
      GL_DEPTH_TEST,         GL_CULL_FACE,           GL_STENCIL_TEST,      GL_COLOR_LOGIC_OP,
      GL_RASTERIZER_DISCARD, GL_POLYGON_OFFSET_FILL, GL_PRIMITIVE_RESTART, GL_PRIMITIVE_RESTART_FIXED_INDEX};
  // there is one for each target or viewport, of which we use the first
  static constexpr std::array<GLenum, 2> first_switches = {GL_BLEND, GL_SCISSOR_TEST};
  static constexpr std::array<GLenum, 8> storage = {
      GL_PACK_ROW_LENGTH,   GL_PACK_SKIP_ROWS,   GL_PACK_SKIP_PIXELS,   GL_PACK_SWAP_BYTES,
      GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SWAP_BYTES};
  static constexpr std::array<GLenum, 2> alignments = {GL_PACK_ALIGNMENT, GL_UNPACK_ALIGNMENT};
  GLint m_program = 0, m_vertex_array = 0, m_array_buffer = 0, m_draw_framebuffer = 0, m_read_framebuffer = 0,
        m_pack_buffer = 0, m_unpack_buffer = 0, m_depth_function = 0, m_active_texture = 0,
        m_polygon_mode = 0;
  GLint m_image = 0, m_image_level = 0, m_image_layer = 0, m_image_access = 0, m_image_format = 0;
  GLboolean m_image_layered = GL_FALSE, m_depth_mask = GL_TRUE;
  GLint m_clip_origin = 0, m_clip_depth = 0;
  std::array<GLfloat, 4> m_viewport{};
  std::array<GLboolean, 4> m_color_mask{};
  std::array<GLfloat, 4> m_clear_color{};
  std::array<GLdouble, 2> m_depth_range{};
  GLfloat m_clear_depth = 1.f;
  std::array<GLboolean, switches.size()> m_enabled{};
  std::array<GLboolean, first_switches.size()> m_first_enabled{};
  std::array<GLint, storage.size()> m_storage{};
  std::array<GLint, alignments.size()> m_alignments{};
  std::array<GLint, 2> m_textures{}, m_samplers{};
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_GL_STATE_H
