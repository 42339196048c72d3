// Mean curvature of what a picture shows, per pixel, from spheres fitted to depths and normals (GLSL 4.30 and later): the
// method of N. Mellado et al., Growing least squares for the analysis of manifolds in scale-space, 2012, on the screen.
//
// This file stands alone: put it behind your "#version 430 core" line (or a later one) and it is a whole fragment
// shader; with "#define SC_COMPUTE" before it, a whole compute shader; with "#define SC_LIBRARY", the function
// sc_sphere_curvature() and its uniforms for a shader of yours.
//
// Defines (before the file):
//   SC_LOCAL_SIZE_X, SC_LOCAL_SIZE_Y   the compute shader's work group (16, 8)
//
// Inputs: as those of screen_space_curvature.glsl, and
//   sc_radius               the ball around the point that sc_radius pixels span there is fitted
// Output:
//   fragment shader: out vec4 at location 0; compute shader: image2D sc_result (rgba32f) at binding 0
//     x, y  mean curvature, in 1/unit of the scene, convex is positive
//     z     quiet NaN
//     w     status: 0 estimated, 1 estimated from one side (border), 2 too few neighbors, 3 degenerate, 4 depth or normal
//           unusable, 5 background (Shape_characteristics::Estimation_status)
//   Without an estimate, x and y are quiet NaN.
#ifdef __cplusplus
R"glsl(
#endif

uniform sampler2D sc_depths;
uniform sampler2D sc_normals;
uniform ivec2 sc_size;        // width and height of the picture
uniform vec4 sc_distance;     // distance = (x + y c) / (z + w c), c = depth - sc_depth_range.x
uniform float sc_determinant; // y z - x w of sc_distance
uniform vec4 sc_depth_range;  // reference; lowest and highest depth of a surface; not used
uniform vec4 sc_rays;         // x and y over distance of the first pixel's center; steps from pixel to pixel
uniform vec4 sc_pixel;        // step in units of z; geometric mean of the steps' sizes; 1 for perspective, 0 for parallel projection
uniform mat3 sc_to_view;      // turns normals to view space
uniform int sc_radius;

bool sc_is_finite(float x) { return (floatBitsToUint(x) & 0x7f800000u) != 0x7f800000u; }
bool sc_is_nan(float x) { return (floatBitsToUint(x) & 0x7fffffffu) > 0x7f800000u; }
vec4 sc_none(float status) { return vec4(vec3(uintBitsToFloat(0x7fc00000u)), status); }

bool sc_is_surface(float depth)
{
  return !sc_is_nan(depth) && depth >= sc_depth_range.y && depth <= sc_depth_range.z;
}

// w: whether there is one
vec4 sc_unit_normal(ivec2 pixel)
{
  vec3 stored = texelFetch(sc_normals, pixel, 0).xyz;
  if(!sc_is_finite(stored.x) || !sc_is_finite(stored.y) || !sc_is_finite(stored.z))
    return vec4(0);
  float largest = max(max(abs(stored.x), abs(stored.y)), abs(stored.z));
  if(largest < 1.17549435e-38)
    return vec4(0);
  vec3 n = stored / largest;
  return vec4(sc_to_view * (n / sqrt(dot(n, n))), 1);
}

vec4 sc_sphere_curvature(ivec2 center)
{
  float center_depth = texelFetch(sc_depths, center, 0).x;
  if(!sc_is_surface(center_depth))
    return sc_none(sc_is_nan(center_depth) ? 4 : 5);
  if(sc_unit_normal(center).w == 0)
    return sc_none(4);
  float from_far = center_depth - sc_depth_range.x;
  float g = sc_distance.z + sc_distance.w * from_far;
  float footprint = sc_pixel.z;
  if(sc_pixel.w != 0)
    footprint *= (sc_distance.x + sc_distance.y * from_far) / g;

  // sums with weights: of 1, points, normals, p n, p p. Points are relative to the center, in units of the radius.
  float radius = float(sc_radius), unit = footprint * radius;
  float sum = 0, sum_pn = 0, sum_pp = 0;
  vec3 sum_p = vec3(0), sum_n = vec3(0);
  int count = 0;
  bool is_one_sided = false;
  for(int dy = 1 - sc_radius; dy < sc_radius; ++dy)
    for(int dx = 1 - sc_radius; dx < sc_radius; ++dx)
    {
      int squared = dx * dx + dy * dy;
      if(squared >= sc_radius * sc_radius)
        continue;
      ivec2 pixel = center + ivec2(dx, dy);
      bool is_usable = all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, sc_size));
      if(is_usable)
      {
        float depth = texelFetch(sc_depths, pixel, 0).x;
        is_usable = sc_is_surface(depth);
        if(is_usable)
        {
          float h = sc_distance.z + sc_distance.w * (depth - sc_depth_range.x);
          float away = sc_determinant * (depth - center_depth) / (g * h) / unit;
          vec4 normal = sc_unit_normal(pixel);
          is_usable = abs(away) <= 2 && normal.w != 0;
          if(is_usable)
          {
            vec3 p = vec3(sc_pixel.xy * vec2(dx, dy) / radius +
                              sc_pixel.w * away * (sc_rays.xy + sc_rays.zw * vec2(pixel)),
                          -away);
            float t = max(1 - dot(p, p), 0), weight = t * t;
            sum += weight;
            sum_p += weight * p;
            sum_n += weight * normal.xyz;
            sum_pn += weight * dot(p, normal.xyz);
            sum_pp += weight * dot(p, p);
            count += int(t > 0);
          }
        }
      }
      is_one_sided = is_one_sided || !is_usable;
    }
  if(count < 4)
    return sc_none(2);

  // the algebraic sphere c + l x + q x x whose gradient is nearest to the normals
  float q = 0.5 * (sum_pn - dot(sum_p, sum_n) / sum) / (sum_pp - dot(sum_p, sum_p) / sum);
  vec3 l = (sum_n - 2 * q * sum_p) / sum;
  float c = -(dot(l, sum_p) + q * sum_pp) / sum;
  float curvature = 2 * q / (sqrt(dot(l, l) - 4 * c * q) * unit);
  if(!sc_is_finite(curvature))
    return sc_none(3);
  return vec4(curvature, curvature, uintBitsToFloat(0x7fc00000u), is_one_sided ? 1 : 0);
}

#ifndef SC_LIBRARY
#ifdef SC_COMPUTE
#ifndef SC_LOCAL_SIZE_X
#define SC_LOCAL_SIZE_X 16
#endif
#ifndef SC_LOCAL_SIZE_Y
#define SC_LOCAL_SIZE_Y 8
#endif
layout(local_size_x = SC_LOCAL_SIZE_X, local_size_y = SC_LOCAL_SIZE_Y) in;
layout(rgba32f, binding = 0) writeonly uniform image2D sc_result;
void main()
{
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if(all(lessThan(pixel, sc_size)))
    imageStore(sc_result, pixel, sc_sphere_curvature(pixel));
}
#else
layout(location = 0) out vec4 sc_result;
void main() { sc_result = sc_sphere_curvature(ivec2(gl_FragCoord.xy)); }
#endif
#endif

#ifdef __cplusplus
)glsl"
#endif
