#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_SCREEN_SPACE_CURVATURE_PASS_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_SCREEN_SPACE_CURVATURE_PASS_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/screen_space/OpenGL/G_buffer_textures.h>
#include <Shape_characteristics/screen_space/OpenGL/Shader_stage.h>
#include <Shape_characteristics/screen_space/OpenGL/internal/Gl_pixel_pass.h>
#include <Shape_characteristics/screen_space/OpenGL/internal/shader_texts.h>
#include <Shape_characteristics/screen_space/internal/Screen_space_options.h>

#include <epoxy/gl.h>

#include <cstddef>
#include <string>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsScreenSpace

  estimates the curvatures of what a picture shows on the GPU: `screen_space_curvatures()` as a shader.

  It needs nothing but a current OpenGL context, 4.3 core or later, and does not care who made it. What it changes of OpenGL's state it gives back, and nothing is
  allocated from one picture to the next of the same size. Shaders are compiled when their parameters are first used.

  Results differ from those of `screen_space_curvatures()` by the rounding of single precision: of a principal curvature by no more than
  \f$ 2^{-18} (|k| + 1/d) \f$ (of 999 in 1000 pixels, \f$ 2^{-20} (|k| + 1/d) \f$), where k is the one that is larger in size, and d the distance of neighboring pixels in the scene. Statuses are the same, but
  where a comparison is decided by that rounding.

  The shader, OpenGL/shaders/screen_space_curvature.glsl, stands alone and can be used without this class.

  \cgalExample{screen_space/screen_space_curvature.cpp}
*/
class Screen_space_curvature_pass
{
public:
  /// prepares the pass in the current context, in which it has to be used and destroyed.
  /// \throws std::runtime_error if no context is current, or if it has less than OpenGL 4.3
  explicit Screen_space_curvature_pass(Shader_stage stage = Shader_stage::FRAGMENT)
    : m_pass("Screen_space_curvature_pass", stage)
  {}

  /*!
    estimates the curvatures of a picture and returns the name of the texture with the results, which the pass owns and the next call changes.

    Its channels are `GL_RGBA32F`: the smaller and the larger principal curvature, the shape index, and the number of the
    `Estimation_status`. Without an estimate the first three are quiet NaN. `read_screen_space_curvatures()` copies it to memory.

    \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"
    \param g_buffer the textures and the camera
    \param np an optional sequence of \ref sc_namedparameters "Named Parameters": `number_of_triangles`, `number_of_edges`,
           `level_of_detail` and `depth_discontinuity_rule`, as of `screen_space_curvatures()`
    \return 0 if the picture has no pixels
    \throws std::invalid_argument if a parameter is out of its range, or the size is negative
    \throws std::runtime_error if a shader doesn't compile, with the words of the driver
  */
  template <typename NamedParameters = parameters::Default_named_parameters>
  unsigned operator()(const G_buffer_textures& g_buffer,
                      const NamedParameters& np = parameters::default_values())
  {
    const internal::Screen_space_options options(np);
    if(!internal::has_pixels(g_buffer))
      return 0;
    const unsigned target = m_pass.own_target(g_buffer.width, g_buffer.height);
    run(g_buffer, target, options);
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
    const internal::Screen_space_options options(np);
    if(internal::has_pixels(g_buffer))
      run(g_buffer, target, options);
  }

private:
  struct Variant
  {
    internal::Gl_pixel_program program;
    GLint largest_distance_difference = -1, largest_step = -1, step_table = -1;
  };

  void run(const G_buffer_textures& g, unsigned target, const internal::Screen_space_options& options)
  {
    const internal::Screen_space_pass pass(options, g.camera, g.normal_space, g.width, g.height);
    const bool has_levels = pass.largest_step > 1;
    Variant& v =
        m_variants[pass.number_of_triangles - 1][pass.number_of_edges - 2][int(pass.rule)][has_levels];
    if(v.program.program.name() == 0)
    {
      const auto define = [](const char* name, int value)
      { return std::string("#define ") + name + " " + std::to_string(value) + "\n"; };
      v.program = m_pass.compile(
          define("SC_TRIANGLES", pass.number_of_triangles) + define("SC_EDGES", pass.number_of_edges) +
              define("SC_RULE", int(pass.rule)) + define("SC_LEVEL_OF_DETAIL", int(has_levels)),
          internal::screen_space_curvature_shader);
      v.largest_distance_difference = v.program.program.uniform("sc_largest_distance_difference");
      v.largest_step = v.program.program.uniform("sc_largest_step");
      v.step_table = v.program.program.uniform("sc_step_table");
    }
    const GLuint name = v.program.program.name();
    glProgramUniform1f(name, v.largest_distance_difference, pass.largest_distance_difference);
    glProgramUniform1i(name, v.largest_step, pass.largest_step);
    glProgramUniform1fv(name, v.step_table, GLsizei(pass.step_table.size()), pass.step_table.data());
    m_pass.run(v.program, g, pass.frame, target);
  }

  internal::Gl_pixel_pass m_pass;
  Variant m_variants[4][2][3][2];
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_SCREEN_SPACE_CURVATURE_PASS_H
