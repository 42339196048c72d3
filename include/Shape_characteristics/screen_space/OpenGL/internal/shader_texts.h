#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_SHADER_TEXTS_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_SHADER_TEXTS_H

namespace Shape_characteristics {
namespace internal {

// The shaders are files of their own that are C++ string literals as well: what is in front of `R"glsl(` is between #ifdef and #endif for
// GLSL, which doesn't define __cplusplus; C++ takes the #endif and the last #ifdef for parts of the string. So the string is to be
// put between "#if 1" and "#endif".
inline constexpr char screen_space_curvature_shader[] =
#include <Shape_characteristics/screen_space/OpenGL/shaders/screen_space_curvature.glsl>
    ;

inline constexpr char sphere_fit_shader[] =
#include <Shape_characteristics/screen_space/OpenGL/shaders/sphere_fit_mean_curvature.glsl>
    ;

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_INTERNAL_SHADER_TEXTS_H
