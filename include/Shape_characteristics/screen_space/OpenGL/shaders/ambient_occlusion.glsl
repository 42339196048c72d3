// How much of the ambient light arrives, per pixel, from curvature (GLSL 4.30 and later).
//
// This file stands alone: put it behind your "#version 430 core" line (or a later one) and it is a whole
// fragment shader; with "#define SC_COMPUTE" before it, a whole compute shader; with "#define SC_LIBRARY", the
// function sc_ambient_occlusion() and its uniforms for a shader of yours, for example one that has
// screen_space_curvature.glsl as a library as well and writes both at once.
//
// Defines (before the file):
//   SC_MAPPING        0 the thesis's two parts, 1 Hattori's quadric, 2 Griffin's polynomial (0); the C++ classes
//                     Two_part_ambient_occlusion, Hattori_ambient_occlusion and Griffin_ambient_occlusion say what they are
//   SC_LOCAL_SIZE_X, SC_LOCAL_SIZE_Y   the compute shader's work group (16, 8)
//
// Inputs:
//   sc_curvatures     texture of the picture's size, the output of screen_space_curvature.glsl: x and y are the principal curvatures
//   sc_occlusion      0: 1 / curvature extreme, flat value, -1 / (2 variance), expected value
//                     1: radius
//                     2: scale, constant, linear and quadratic coefficient
//   sc_background     what pixels without curvature get
// Output:
//   fragment shader: out float at location 0; compute shader: image2D sc_light (r32f) at binding 0
//     the share of the ambient light that arrives: 1 is fully lit, 0 is dark
#ifdef __cplusplus
R"glsl(
#endif

#ifndef SC_MAPPING
#define SC_MAPPING 0
#endif

uniform vec4 sc_occlusion;
uniform float sc_background;

// of the principal curvatures x and y
float sc_ambient_occlusion(vec4 curvature)
{
  // not finite: told by the bits, as comparisons may be optimized away
  uvec2 bits = floatBitsToUint(curvature.xy) & uvec2(0x7f800000u);
  if(bits.x == 0x7f800000u || bits.y == 0x7f800000u)
    return sc_background;
#if SC_MAPPING == 0
  float m = clamp(curvature.x * sc_occlusion.x * 0.5 + curvature.y * sc_occlusion.x * 0.5, -1.0, 1.0);
  if(m >= 0)
    return sc_occlusion.y + (1 - sc_occlusion.y) * m;
  float from_expected = m - sc_occlusion.w;
  return sc_occlusion.y * exp(from_expected * from_expected * sc_occlusion.z);
#elif SC_MAPPING == 1
  vec2 k = sc_occlusion.x * curvature.xy;
  float sum = k.x + k.y;
  return clamp(1 - (sum * sum + 2 * dot(k, k)) / 32, 0.0, 1.0);
#else
  vec2 k = sc_occlusion.x * curvature.xy;
  return clamp(sc_occlusion.y + k.x * (sc_occlusion.z + sc_occlusion.w * k.x) +
                   k.y * (sc_occlusion.z + sc_occlusion.w * k.y),
               0.0, 1.0);
#endif
}

#ifndef SC_LIBRARY
uniform sampler2D sc_curvatures;
#ifdef SC_COMPUTE
#ifndef SC_LOCAL_SIZE_X
#define SC_LOCAL_SIZE_X 16
#endif
#ifndef SC_LOCAL_SIZE_Y
#define SC_LOCAL_SIZE_Y 8
#endif
layout(local_size_x = SC_LOCAL_SIZE_X, local_size_y = SC_LOCAL_SIZE_Y) in;
layout(r32f, binding = 0) writeonly uniform image2D sc_light;
void main()
{
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if(all(lessThan(pixel, textureSize(sc_curvatures, 0))))
    imageStore(sc_light, pixel, vec4(sc_ambient_occlusion(texelFetch(sc_curvatures, pixel, 0))));
}
#else
layout(location = 0) out float sc_light;
void main() { sc_light = sc_ambient_occlusion(texelFetch(sc_curvatures, ivec2(gl_FragCoord.xy), 0)); }
#endif
#endif

#ifdef __cplusplus
)glsl"
#endif
