// Curvatures of what a picture shows, per pixel, from depths and normals (GLSL 4.30 and later).
//
// This file stands alone: put it behind your "#version 430 core" line (or a later one) and it is a whole
// fragment shader; with "#define SC_COMPUTE" before it, a whole compute shader; with "#define SC_LIBRARY", the
// function sc_curvature() and its uniforms for a shader of yours.
//
// Defines (before the file; the defaults are those of screen_space_curvatures(), its twin on the CPU):
//   SC_TRIANGLES      how many triangles around a pixel are taken, 1 to 4 (4)
//   SC_EDGES          from how many edges a triangle's shape operator is fitted, 2 or 3 (2)
//   SC_RULE           depth discontinuities: 0 none, 1 the far plane (7.13), 2 tangent planes (2)
//   SC_LEVEL_OF_DETAIL  1 to look up steps in sc_step_table, 0 for one pixel everywhere (0)
//   SC_LOCAL_SIZE_X, SC_LOCAL_SIZE_Y   the compute shader's work group (16, 8)
//
// Inputs:
//   sc_depths, sc_normals   textures of the picture's size: depth (red channel); outward normal (red, green, blue), of any
//                           length, in floating point or signed normalized. Filters aren't used; depth comparison must be off.
//   the other uniforms      follow from camera and picture. With OpenGL's usual depth, a perspective matrix P and pictures of w x h pixels:
//     sc_size = (w, h)
//     sc_distance = (-P[3][2], 0, -1 - P[2][2], -2)        sc_determinant = -2 P[3][2]
//     sc_depth_range = (1, 0, 0.99999994, 1)
//     sc_rays = ((1/w - 1 + P[2][0]) / P[0][0], (1/h - 1 + P[2][1]) / P[1][1], 2 / (w P[0][0]), 2 / (h P[1][1]))
//     sc_pixel = (sc_rays.z / m, sc_rays.w / m, m, 1)      where m = sqrt(abs(sc_rays.z sc_rays.w))
//     sc_to_view = the upper left of the view matrix if normals are in world space, otherwise the identity
//     sc_largest_distance_difference = 1                   if the far plane is at 100 or beyond
//     sc_largest_step, sc_step_table                       see Shape_characteristics::Level_of_detail::fill_table()
//                           internal/Screen_frame.h has them for other projections and kinds of depth.
// Output:
//   fragment shader: out vec4 at location 0; compute shader: image2D sc_result (rgba32f) at binding 0
//     x  smaller principal curvature     y  larger principal curvature, in 1/unit of the scene, convex is positive;
//        the mean curvature is (x + y) / 2, the Gaussian curvature x * y
//     z  shape index in [-1, 1]
//     w  status: 0 estimated, 1 estimated from one side (border), 2 too few neighbors, 3 degenerate, 4 depth or normal
//        unusable, 5 background (Shape_characteristics::Estimation_status)
//   Without an estimate, x, y and z are quiet NaN.
#ifdef __cplusplus
R"glsl(
#endif

#ifndef SC_TRIANGLES
#define SC_TRIANGLES 4
#endif
#ifndef SC_EDGES
#define SC_EDGES 2
#endif
#ifndef SC_RULE
#define SC_RULE 2
#endif
#ifndef SC_LEVEL_OF_DETAIL
#define SC_LEVEL_OF_DETAIL 0
#endif

uniform sampler2D sc_depths;
uniform sampler2D sc_normals;
uniform ivec2 sc_size;           // width and height of the picture
uniform vec4 sc_distance;        // distance = (x + y c) / (z + w c), c = depth - sc_depth_range.x
uniform float sc_determinant;    // y z - x w of sc_distance
uniform vec4 sc_depth_range;     // reference; lowest and highest depth of a surface; 1 if depths grow with distance, else -1
uniform vec4 sc_rays;            // x and y over distance of the first pixel's center; steps from pixel to pixel
uniform vec4 sc_pixel;           // step in units of z; geometric mean of the steps' sizes; 1 for perspective, 0 for parallel projection
uniform mat3 sc_to_view;         // turns normals to view space
uniform float sc_largest_distance_difference; // rule 1
uniform int sc_largest_step;               // level of detail
uniform float sc_step_table[32];           // the step is at least i + 1 up to the depth [i], or down to it

struct Sc_neighbor
{
  bool is_usable;
  vec3 edge;          // from the center, in units of the pixels' distance there
  vec3 normal_change;
};

struct Sc_center
{
  ivec2 pixel;
  int level_step;
  float depth, footprint;
  vec3 normal;
};

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

// from the center to a pixel of a depth: the difference of points, from that of depths, which is exact
vec3 sc_edge(Sc_center c, ivec2 offset, float depth)
{
  float g = sc_distance.z + sc_distance.w * (c.depth - sc_depth_range.x);
  float h = sc_distance.z + sc_distance.w * (depth - sc_depth_range.x);
  float away = sc_determinant * (depth - c.depth) / (g * h) / c.footprint;
  vec2 across = sc_pixel.xy * vec2(offset);
  return vec3(across + sc_pixel.w * away * (sc_rays.xy + sc_rays.zw * vec2(c.pixel + offset)), -away);
}

// whether a point is `-times` an edge away
bool sc_is_in_line(Sc_center c, ivec2 offset, vec3 edge, float times)
{
  ivec2 pixel = c.pixel + offset;
  if(any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, sc_size)))
    return false;
  float depth = texelFetch(sc_depths, pixel, 0).x;
  if(!sc_is_surface(depth))
    return false;
  vec3 bend = sc_edge(c, offset, depth) + times * edge;
  return dot(bend, bend) < 0.015625 * dot(edge, edge);
}

Sc_neighbor sc_neighbor_at(Sc_center c, ivec2 offset)
{
  Sc_neighbor result;
  result.is_usable = false;
  result.edge = vec3(0);
  result.normal_change = vec3(0);
  ivec2 pixel = c.pixel + offset;
  if(any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, sc_size)))
    return result;
  float depth = texelFetch(sc_depths, pixel, 0).x;
  if(!sc_is_surface(depth))
    return result;
  vec4 normal = sc_unit_normal(pixel);
  if(normal.w == 0)
    return result;

  result.edge = sc_edge(c, offset, depth);
  result.normal_change = normal.xyz - c.normal;
#if SC_RULE == 1
  result.is_usable = abs(offset.x) == 1 || abs(offset.y) == 1 ||
                     !(abs(result.edge.z) * c.footprint > sc_largest_distance_difference);
#elif SC_RULE == 2
  float squared_length = dot(result.edge, result.edge);
  vec2 across = sc_pixel.xy * vec2(offset);
  float rise = dot(c.normal + normal.xyz, result.edge);
  bool is_doubtful = squared_length > 4 * dot(across, across) && rise * rise > 0.25 * squared_length;
  // unless the points before or behind the edge are in line with it
  result.is_usable =
      !is_doubtful || sc_is_in_line(c, -offset, result.edge, 1) || sc_is_in_line(c, 2 * offset, result.edge, -2);
#else
  result.is_usable = true;
#endif
  return result;
}

Sc_neighbor sc_neighbor(Sc_center c, ivec2 direction)
{
#if SC_LEVEL_OF_DETAIL
  Sc_neighbor result = sc_neighbor_at(c, c.level_step * direction);
  if(!result.is_usable && c.level_step > 1)
    result = sc_neighbor_at(c, direction);
  return result;
#else
  return sc_neighbor_at(c, direction);
#endif
}

// the normal equations of the least squares (7.5), of all triangles
struct Sc_equations
{
  float p, q, r; // of the edges, as in (7.6)
  float s;       // p r - q q, without cancellation within a triangle
  float x, y, z; // right sides
};

void sc_add_triangle(Sc_neighbor a, Sc_neighbor b, vec3 u, vec3 v, inout Sc_equations sums)
{
  float u1 = dot(a.edge, u), v1 = dot(a.edge, v), u2 = dot(b.edge, u), v2 = dot(b.edge, v);
  float du1 = dot(a.normal_change, u), dv1 = dot(a.normal_change, v);
  float du2 = dot(b.normal_change, u), dv2 = dot(b.normal_change, v);
  float p = u1 * u1 + u2 * u2, q = u1 * v1 + u2 * v2, r = v1 * v1 + v2 * v2;
  float area = u1 * v2 - u2 * v1;
  float s = area * area;
  sums.x += u1 * du1 + u2 * du2;
  sums.y += v1 * du1 + u1 * dv1 + v2 * du2 + u2 * dv2;
  sums.z += v1 * dv1 + v2 * dv2;
#if SC_EDGES == 3
  float u3 = u2 - u1, v3 = v2 - v1, du3 = du2 - du1, dv3 = dv2 - dv1;
  p += u3 * u3;
  q += u3 * v3;
  r += v3 * v3;
  s *= 3;
  sums.x += u3 * du3;
  sums.y += v3 * du3 + u3 * dv3;
  sums.z += v3 * dv3;
#endif
  sums.s += s + max(sums.p * r + sums.r * p - 2 * sums.q * q, 0);
  sums.p += p;
  sums.q += q;
  sums.r += r;
}

vec4 sc_curvature(ivec2 pixel)
{
  Sc_center c;
  c.pixel = pixel;
  c.depth = texelFetch(sc_depths, pixel, 0).x;
  if(!sc_is_surface(c.depth))
    return sc_none(sc_is_nan(c.depth) ? 4 : 5);
  vec4 normal = sc_unit_normal(pixel);
  if(normal.w == 0)
    return sc_none(4);
  c.normal = normal.xyz;
  float from_far = c.depth - sc_depth_range.x;
  c.footprint = sc_pixel.z;
  if(sc_pixel.w != 0)
    c.footprint *= (sc_distance.x + sc_distance.y * from_far) / (sc_distance.z + sc_distance.w * from_far);
  c.level_step = 1;
#if SC_LEVEL_OF_DETAIL
  while(c.level_step < sc_largest_step &&
        sc_depth_range.w * c.depth <= sc_depth_range.w * sc_step_table[c.level_step])
    ++c.level_step;
#endif

  // a fan around the pixel; opposite triangles come first
  Sc_neighbor right = sc_neighbor(c, ivec2(1, 0)), up = sc_neighbor(c, ivec2(0, 1)), left, down;
  left.is_usable = false;
  down.is_usable = false;
#if SC_TRIANGLES == 1
  if(!(right.is_usable && up.is_usable))
#endif
  {
    left = sc_neighbor(c, ivec2(-1, 0));
    down = sc_neighbor(c, ivec2(0, -1));
  }
  bvec4 used = bvec4(right.is_usable && up.is_usable, left.is_usable && down.is_usable,
                     up.is_usable && left.is_usable, down.is_usable && right.is_usable);
  int number_of_used = int(used.x) + int(used.y) + int(used.z) + int(used.w);
  if(number_of_used == 0)
    return sc_none(2);
  bool is_one_sided = false; // a triangle was missing before there were enough of them
  int enough = 0;
  for(int t = 0; t < 4; ++t)
  {
    if(enough == SC_TRIANGLES)
      used[t] = false;
    else if(used[t])
      ++enough;
    else
      is_one_sided = true;
  }

  vec3 plane = vec3(0);
  if(used.x)
    plane += cross(right.edge, up.edge);
  if(used.y)
    plane += cross(left.edge, down.edge);
  if(used.z)
    plane += cross(up.edge, left.edge);
  if(used.w)
    plane += cross(down.edge, right.edge);
  plane /= sqrt(dot(plane, plane));
  vec3 along = used.x ? right.edge : used.y ? left.edge : used.z ? up.edge : down.edge;
  vec3 u = along - dot(plane, along) * plane;
  u /= sqrt(dot(u, u));
  vec3 v = cross(plane, u);
  Sc_equations sums = Sc_equations(0, 0, 0, 0, 0, 0, 0);
  if(used.x)
    sc_add_triangle(right, up, u, v, sums);
  if(used.y)
    sc_add_triangle(left, down, u, v, sums);
  if(used.z)
    sc_add_triangle(up, left, u, v, sums);
  if(used.w)
    sc_add_triangle(down, right, u, v, sums);

  // the inverse of [p q 0; q p + r q; 0 q r], which is (7.7), divided by the determinant
  float p = sums.p, q = sums.q, r = sums.r, s = sums.s;
  float inverse_determinant = 1 / ((p + r) * s);
  float l = inverse_determinant * ((r * r + s) * sums.x - q * r * sums.y + q * q * sums.z);
  float m = inverse_determinant * (-q * r * sums.x + p * r * sums.y - p * q * sums.z);
  float n = inverse_determinant * (q * q * sums.x - p * q * sums.y + (p * p + s) * sums.z);

  float mean = 0.5 * (l + n), half_difference = 0.5 * (l - n);
  float root = sqrt(half_difference * half_difference + m * m);
  float scale = 1 / c.footprint;
  float low = (mean - root) * scale, high = (mean + root) * scale;
  if(!sc_is_finite(low) || !sc_is_finite(high))
    return sc_none(3);
  float shape_index = low == 0 && high == 0 ? uintBitsToFloat(0x7fc00000u)
                                            : clamp(atan(high + low, high - low) * 0.636619772, -1.0, 1.0);
  return vec4(low, high, shape_index, is_one_sided ? 1 : 0);
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
    imageStore(sc_result, pixel, sc_curvature(pixel));
}
#else
layout(location = 0) out vec4 sc_result;
void main() { sc_result = sc_curvature(ivec2(gl_FragCoord.xy)); }
#endif
#endif

#ifdef __cplusplus
)glsl"
#endif
