#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_GL_AMBIENT_OCCLUSION_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_GL_AMBIENT_OCCLUSION_H

#include <Shape_characteristics/screen_space/Griffin_ambient_occlusion.h>
#include <Shape_characteristics/screen_space/Hattori_ambient_occlusion.h>
#include <Shape_characteristics/screen_space/Two_part_ambient_occlusion.h>

#include <array>

namespace Shape_characteristics {
namespace internal {

inline constexpr char ambient_occlusion_shader[] =
#include <Shape_characteristics/screen_space/OpenGL/shaders/ambient_occlusion.glsl>
    ;

// a mapping as the shader knows it: its number and its parameters
struct Gl_ambient_occlusion
{
  int number;
  std::array<float, 4> parameters;

  Gl_ambient_occlusion(const Two_part_ambient_occlusion& m)
    : number(0),
      parameters{float(1 / m.curvature_extreme()), float(m.flat_value()), float(-1 / (2 * m.variance())),
                 float(m.expected_value())}
  {}
  Gl_ambient_occlusion(const Hattori_ambient_occlusion& m)
    : number(1),
      parameters{float(m.radius()), 0.f, 0.f, 0.f}
  {}
  Gl_ambient_occlusion(const Griffin_ambient_occlusion& m)
    : number(2),
      parameters{float(m.scale()), float(m.constant()), float(m.linear()), float(m.quadratic())}
  {}
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_GL_AMBIENT_OCCLUSION_H
