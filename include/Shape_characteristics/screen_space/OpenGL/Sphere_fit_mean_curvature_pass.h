#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_SPHERE_FIT_MEAN_CURVATURE_PASS_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_SPHERE_FIT_MEAN_CURVATURE_PASS_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/screen_space/OpenGL/G_buffer_textures.h>
#include <Shape_characteristics/screen_space/OpenGL/Shader_stage.h>
#include <Shape_characteristics/screen_space/OpenGL/internal/Gl_pixel_pass.h>
#include <Shape_characteristics/screen_space/OpenGL/internal/shader_texts.h>
#include <Shape_characteristics/screen_space/internal/Screen_frame.h>
#include <Shape_characteristics/screen_space/internal/pixel_radius.h>

#include <epoxy/gl.h>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsScreenSpace

  estimates the mean curvatures of what a picture shows on the GPU: `sphere_fit_mean_curvatures()` as a shader.

  It needs nothing but a current OpenGL context, 4.3 core or later. What it changes of OpenGL's state it gives back, and nothing is
  allocated from one picture to the next of the same size. The shader, OpenGL/shaders/sphere_fit_mean_curvature.glsl, stands alone
  and can be used without this class.
*/
class Sphere_fit_mean_curvature_pass
{
public:
  /// prepares the pass in the current context, in which it has to be used and destroyed.
  /// \throws std::runtime_error if no context is current, or if it has less than OpenGL 4.3
  explicit Sphere_fit_mean_curvature_pass(Shader_stage stage = Shader_stage::FRAGMENT)
    : m_pass("Sphere_fit_mean_curvature_pass", stage),
      m_program(m_pass.compile("", internal::sphere_fit_shader)),
      m_radius(m_program.program.uniform("sc_radius"))
  {}

  /*!
    estimates the mean curvatures of a picture and returns the name of the texture with the results, which the pass owns and the next call
    changes.

    Its channels are `GL_RGBA32F`: the mean curvature twice, quiet NaN, and the number of the `Estimation_status`. Without an estimate the first
    ones are quiet NaN too. `read_screen_space_curvatures()` copies it to memory.

    \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"
    \param g_buffer the textures and the camera
    \param np an optional sequence of \ref sc_namedparameters "Named Parameters": `pixel_radius`, as of `sphere_fit_mean_curvatures()`
    \return 0 if the picture has no pixels
    \throws std::invalid_argument if a parameter is out of its range, or the size is negative
    \throws std::runtime_error if a shader doesn't compile, with the words of the driver
  */
  template <typename NamedParameters = parameters::Default_named_parameters>
  unsigned operator()(const G_buffer_textures& g_buffer,
                      const NamedParameters& np = parameters::default_values())
  {
    const int radius = internal::pixel_radius(np);
    if(!internal::has_pixels(g_buffer))
      return 0;
    const unsigned target = m_pass.own_target(g_buffer.width, g_buffer.height);
    run(g_buffer, target, radius);
    return target;
  }

  /*!
    the same, into a texture of the caller. The fragment shader writes any format that can be drawn into, the compute shader `GL_RGBA32F`.
    \param target a 2D texture, at least of the size of the picture
    \param g_buffer the textures and the camera
    \param np as above
    \throws std::invalid_argument also if `target` can't be drawn into
  */
  template <typename NamedParameters = parameters::Default_named_parameters>
  void draw_into(unsigned target,
                 const G_buffer_textures& g_buffer,
                 const NamedParameters& np = parameters::default_values())
  {
    const int radius = internal::pixel_radius(np);
    if(internal::has_pixels(g_buffer))
      run(g_buffer, target, radius);
  }

private:
  void run(const G_buffer_textures& g, unsigned target, int radius)
  {
    glProgramUniform1i(m_program.program.name(), m_radius, radius);
    m_pass.run(m_program, g, internal::Screen_frame(g.camera, g.normal_space, g.width, g.height), target);
  }

  internal::Gl_pixel_pass m_pass;
  internal::Gl_pixel_program m_program;
  GLint m_radius;
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_SPHERE_FIT_MEAN_CURVATURE_PASS_H
