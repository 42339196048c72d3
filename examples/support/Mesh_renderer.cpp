#include "Mesh_renderer.h"

#include "local_spacing.h"

#include <CGAL/number_type_config.h>

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace support {

namespace {

// ----------------------------------------------------------------------------------------- vectors

Vector operator-(const Vector& a, const Vector& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector operator*(double s, const Vector& a)
{
  return {s * a[0], s * a[1], s * a[2]};
}
double dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector cross(const Vector& a, const Vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
bool is_finite(const Vector& a)
{
  return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
}

// Of unit length, or 0 if there is no direction.
Vector normalized(const Vector& a)
{
  const double largest = std::max({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])});
  if(!(largest > 0) || !std::isfinite(largest))
    return {0, 0, 0};
  const Vector b = {a[0] / largest, a[1] / largest, a[2] / largest};
  return (1 / std::sqrt(dot(b, b))) * b;
}

// ----------------------------------------------------------------------------------------- shaders

const char* const mesh_vertex_shader = R"(#version 430 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 vertex_normal;
layout(location = 2) in vec2 vertex_value; // place in the gradient and 1; or 0 and 0 if missing
uniform mat4 projection;
out vec3 normal;
out vec3 eye_position;
out vec2 value;
void main()
{
  normal = vertex_normal;
  eye_position = position;
  value = vertex_value;
  gl_Position = projection * vec4(position, 1);
}
)";

// A disc in the tangent plane, drawn as a square; the fragment shader cuts its corners. `push` moves it
// away from the eye, in radii, along the lines of sight: its outline stays.
const char* const splat_vertex_shader = R"(#version 430 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 vertex_normal;
layout(location = 2) in vec2 vertex_value;
layout(location = 3) in float radius;
uniform mat4 projection;
uniform float push;
out vec3 normal;
out vec2 value;
out vec2 disc;
void main()
{
  vec3 n = vertex_normal;
  if(dot(n, n) == 0)
    n = normalize(-position);
  vec3 u = normalize(abs(n.x) < abs(n.y) ? vec3(0, -n.z, n.y) : vec3(-n.z, 0, n.x));
  vec3 v = cross(n, u);
  disc = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID >> 1) * 2 - 1);
  normal = n;
  vec3 eye_position = position + radius * (disc.x * u + disc.y * v);
  eye_position *= 1 + push * radius / length(eye_position);
  value = vertex_value;
  gl_Position = projection * vec4(eye_position, 1);
  if(dot(n, position) > 0)
    gl_Position = vec4(2, 2, 2, 1); // turned away: out of the picture
}
)";

// A triangle that covers the picture.
const char* const picture_vertex_shader = R"(#version 430 core
uniform mat4 projection;
out vec3 eye_direction;
void main()
{
  vec2 corner = vec2((gl_VertexID & 1) * 4 - 1, (gl_VertexID >> 1) * 4 - 1);
  eye_direction = vec3(corner.x / projection[0][0], corner.y / projection[1][1], -1);
  gl_Position = vec4(corner, 0, 1);
}
)";

// Light is computed in linear colours. The surface that faces the eye shows nearly the gradient's colour.
const char* const shading = R"(#version 430 core
uniform sampler1D gradient;
uniform vec3 plain_color;
uniform vec3 missing_color;
uniform bool colored;
uniform float hatch_period;

vec3 lit(vec3 base, vec3 n, vec3 to_eye)
{
  if(dot(n, n) == 0)
    n = to_eye;
  n = normalize(n);
  if(dot(n, to_eye) < 0)
    n = -n; // seen from inside
  vec3 key = normalize(vec3(-0.45, 0.62, 0.75));
  vec3 fill = normalize(vec3(0.8, 0.05, 0.55));
  float from_key = max((dot(n, key) + 0.25) / 1.25, 0);
  float from_fill = max(dot(n, fill), 0);
  float from_sky = 0.5 + 0.5 * n.y;
  float facing = max(dot(n, to_eye), 0);
  float light = min(1.06, 0.22 + 0.16 * from_sky + 0.78 * from_key * from_key + 0.18 * from_fill + 0.1 * facing);
  float shine = pow(max(dot(n, normalize(key + to_eye)), 0), 42);
  float rim = pow(1 - facing, 4);
  return base * light * (1 - 0.25 * rim) + vec3(0.12 * shine);
}

// `value`: the place in the gradient times how far it is known, and how far it is known.
vec3 surface_color(vec2 value)
{
  if(!colored)
    return plain_color;
  float known = value.y;
  if(known < 0.5)
  {
    // stripes of the picture's plane, with edges one pixel wide
    float stripe = abs(fract((gl_FragCoord.x + gl_FragCoord.y) / hatch_period) - 0.5) * 4 - 1;
    return missing_color * mix(0.78, 1.12, smoothstep(-0.35, 0.35, stripe));
  }
  // interpolated among the corners whose value is known
  return texture(gradient, (clamp(value.x / known, 0, 1) * 1023 + 0.5) / 1024).rgb;
}

vec4 shaded(vec3 color, vec3 n, vec3 to_eye)
{
  return vec4(pow(lit(pow(color, vec3(2.2)), n, to_eye), vec3(1 / 2.2)), 1);
}
)";

const char* const mesh_fragment_shader = R"(
in vec3 normal;
in vec3 eye_position;
in vec2 value;
layout(location = 0) out vec4 fragment_color;
void main() { fragment_color = shaded(surface_color(value), normal, normalize(-eye_position)); }
)";

// The discs' normals and values are added up where they overlap, with weights that fall towards the rims,
const char* const splat_fragment_shader = R"(#version 430 core
in vec3 normal;
in vec2 value;
in vec2 disc;
layout(location = 0) out vec4 normal_sum;
layout(location = 1) out vec4 value_sum;
void main()
{
  float r2 = dot(disc, disc);
  if(r2 > 1)
    discard;
  float weight = exp(-4 * r2);
  normal_sum = weight * vec4(normal, 1);
  value_sum = weight * vec4(value, 0, 1);
}
)";

// and the averages are lit.
const char* const splat_picture_fragment_shader = R"(
uniform sampler2D normal_sums;
uniform sampler2D value_sums;
uniform vec3 background;
in vec3 eye_direction;
layout(location = 0) out vec4 fragment_color;
void main()
{
  vec4 normal = texelFetch(normal_sums, ivec2(gl_FragCoord.xy), 0);
  vec4 value = texelFetch(value_sums, ivec2(gl_FragCoord.xy), 0);
  fragment_color = vec4(background, 1);
  if(normal.w > 0)
  {
    vec3 color = surface_color(value.xy / value.w);
    fragment_color = shaded(color, normal.xyz, -normalize(eye_direction));
  }
}
)";

GLuint compiled(GLenum kind, const std::string& source)
{
  const GLuint shader = glCreateShader(kind);
  const char* text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if(!good)
  {
    char log[2000] = "";
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    glDeleteShader(shader);
    throw std::runtime_error(std::string("Mesh_renderer: a shader doesn't compile: ") + log);
  }
  return shader;
}

GLuint linked(const std::string& vertex_source, const std::string& fragment_source)
{
  const GLuint vertex = compiled(GL_VERTEX_SHADER, vertex_source);
  const GLuint fragment = compiled(GL_FRAGMENT_SHADER, fragment_source);
  const GLuint program = glCreateProgram();
  glAttachShader(program, vertex);
  glAttachShader(program, fragment);
  glLinkProgram(program);
  glDeleteShader(vertex);
  glDeleteShader(fragment);
  GLint good = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &good);
  if(!good)
  {
    char log[2000] = "";
    glGetProgramInfoLog(program, sizeof log, nullptr, log);
    glDeleteProgram(program);
    throw std::runtime_error(std::string("Mesh_renderer: a program doesn't link: ") + log);
  }
  return program;
}

// ------------------------------------------------------------------------------------- eye space

// The shape moved and scaled into a box around the origin of about unit size, turned so that the eye
// looks along -z. All in double; what goes to OpenGL in float afterwards is small and centred.
struct Eye_space
{
  Vector center;
  double scale = 1;
  Vector right, up, back;
  Vector eye = {0, 0, 0}; // in turned and scaled coordinates

  Vector turn(const Vector& a) const { return {dot(right, a), dot(up, a), dot(back, a)}; }
  Vector place(const Vector& p) const
  {
    // Scaled before the difference is taken: the difference of huge coordinates may overflow.
    return turn(scale * p - scale * center) - eye;
  }
};

struct Frustum
{
  double slope_x, slope_y; // half the picture's size at distance 1
  double near_plane, far_plane;
};

Eye_space looked_at(const Camera& camera, const Vector& low, const Vector& high)
{
  Eye_space space;
  double extent = 0;
  for(std::size_t c = 0; c < 3; ++c)
  {
    space.center[c] = low[c] / 2 + high[c] / 2;
    extent = std::max(extent, high[c] / 2 - low[c] / 2);
  }
  space.scale = extent > std::numeric_limits<double>::min() ? 1 / extent : 1;
  space.back = normalized(camera.towards_eye);
  if(dot(space.back, space.back) == 0)
    throw std::invalid_argument("Mesh_renderer: camera: towards_eye is no direction");
  space.right = normalized(cross(camera.up, space.back));
  if(dot(space.right, space.right) < 0.5) // looked at along `up`
    space.right =
        normalized(cross(std::abs(space.back[0]) < 0.7 ? Vector{1, 0, 0} : Vector{0, 1, 0}, space.back));
  space.up = cross(space.back, space.right);
  return space;
}

// Moves the eye as near as the shape's points (or the discs around them) permit: each side of the viewing
// frustum touches the shape or, for the picture's other direction, leaves equal space at both sides.
Frustum framed(Eye_space& space,
               const std::vector<Vector>& placed,
               const std::vector<Vector>& normals,
               const std::vector<double>& radii,
               const Render_options& options)
{
  const double longer = std::max(options.width, options.height),
               shorter = std::min(options.width, options.height);
  const double slope = std::tan(options.camera.field_of_view * CGAL_PI / 360);
  Frustum frustum;
  frustum.slope_x = slope * options.width / longer;
  frustum.slope_y = slope * options.height / longer;
  const double free = options.margin * shorter;
  const double tx = frustum.slope_x * (1 - 2 * free / options.width);
  const double ty = frustum.slope_y * (1 - 2 * free / options.height);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double left = -infinity, right = -infinity, bottom = -infinity, top = -infinity, front = -infinity,
         back = infinity;
  for(std::size_t i = 0; i < placed.size(); ++i)
  {
    const Vector& p = placed[i];
    // how far the disc reaches in a direction
    const auto reach = [&](const Vector& a)
    {
      return radii.empty()
                 ? 0
                 : radii[i] * std::sqrt(std::max(0., dot(a, a) - dot(a, normals[i]) * dot(a, normals[i])));
    };
    const auto extend = [&](double& side, const Vector& a) { side = std::max(side, dot(a, p) + reach(a)); };
    extend(right, {1, 0, tx});
    extend(left, {-1, 0, tx});
    extend(top, {0, 1, ty});
    extend(bottom, {0, -1, ty});
    front = std::max(front, p[2] + reach({0, 0, 1}));
    back = std::min(back, p[2] - reach({0, 0, 1}));
  }
  space.eye[0] = (right - left) / 2;
  space.eye[1] = (top - bottom) / 2;
  space.eye[2] = std::max({(right + left) / (2 * tx), (top + bottom) / (2 * ty), front + 1e-3});
  const double depth = std::max(front - back, 0.1);
  frustum.near_plane = std::max(space.eye[2] - front - 0.01 * depth, 1e-3 * (space.eye[2] - back));
  frustum.far_plane = space.eye[2] - back + 0.01 * depth;
  return frustum;
}

// ----------------------------------------------------------------------------------------- vertices

struct Gpu_vertex
{
  float position[3];
  float normal[3];
  float value[2];
  float radius;
};

Gpu_vertex gpu_vertex(const Vector& position, const Vector& normal, double radius)
{
  return {{float(position[0]), float(position[1]), float(position[2])},
          {float(normal[0]), float(normal[1]), float(normal[2])},
          {0, 0},
          float(radius)};
}

void set_value(Gpu_vertex& vertex, const Drawable& shape, std::size_t point, const Value_range& range)
{
  if(shape.scalars.empty() || std::isnan(shape.scalars[point]))
    return;
  // bounded, so that infinite values make no NaN where they are interpolated
  vertex.value[0] = float(std::min(std::max(range.position(shape.scalars[point]), -1e4), 1e4));
  vertex.value[1] = 1;
}

// The normal of each triangle's corner: the average over the triangles around its point, weighted by
// area, of those whose planes differ by at most the crease angle.
std::vector<Vector> corner_normals(const std::vector<Vector>& placed,
                                   const std::vector<std::array<std::size_t, 3>>& triangles,
                                   double crease_angle)
{
  std::vector<Vector> area_normals, unit_normals;
  std::vector<std::size_t> first(placed.size() + 1, 0), around(3 * triangles.size());
  for(const auto& t : triangles)
  {
    area_normals.push_back(cross(placed[t[1]] - placed[t[0]], placed[t[2]] - placed[t[0]]));
    unit_normals.push_back(normalized(area_normals.back()));
    for(std::size_t v : t)
      ++first[v + 1];
  }
  for(std::size_t i = 0; i < placed.size(); ++i)
    first[i + 1] += first[i];
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for(std::size_t f = 0; f < triangles.size(); ++f)
    for(std::size_t v : triangles[f])
      around[next[v]++] = f;
  const double limit = std::cos(crease_angle * CGAL_PI / 180);
  std::vector<Vector> normals;
  for(std::size_t f = 0; f < triangles.size(); ++f)
    for(std::size_t v : triangles[f])
    {
      Vector sum = {0, 0, 0};
      for(std::size_t k = first[v]; k < first[v + 1]; ++k)
        if(dot(unit_normals[f], unit_normals[around[k]]) >= limit)
          for(std::size_t c = 0; c < 3; ++c)
            sum[c] += area_normals[around[k]][c];
      normals.push_back(normalized(sum));
    }
  return normals;
}

// Whether a triangle has no area in the precision that OpenGL sees it with. Mesa 22's software renderer
// draws nothing at all if the last triangle is such a one.
bool is_degenerate(const std::vector<Vector>& placed, const std::array<std::size_t, 3>& triangle)
{
  const auto rounded = [&](std::size_t v) {
    return Vector{float(placed[v][0]), float(placed[v][1]), float(placed[v][2])};
  };
  const Vector a = rounded(triangle[0]), n = cross(rounded(triangle[1]) - a, rounded(triangle[2]) - a);
  return n[0] == 0 && n[1] == 0 && n[2] == 0;
}

// Names of OpenGL that are given back whatever happens.
struct Gl_names
{
  std::vector<GLuint> buffers, arrays, renderbuffers, framebuffers, textures;
  ~Gl_names()
  {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glBindVertexArray(0);
    for(GLuint n : buffers)
      glDeleteBuffers(1, &n);
    for(GLuint n : arrays)
      glDeleteVertexArrays(1, &n);
    for(GLuint n : renderbuffers)
      glDeleteRenderbuffers(1, &n);
    for(GLuint n : framebuffers)
      glDeleteFramebuffers(1, &n);
    for(GLuint n : textures)
      glDeleteTextures(1, &n);
  }
  // Leaves the new framebuffer bound.
  GLuint framebuffer()
  {
    GLuint name;
    glGenFramebuffers(1, &name);
    framebuffers.push_back(name);
    glBindFramebuffer(GL_FRAMEBUFFER, name);
    return name;
  }
  void attach_renderbuffer(GLenum attachment, GLenum format, int samples, int width, int height)
  {
    GLuint name;
    glGenRenderbuffers(1, &name);
    renderbuffers.push_back(name);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, name);
  }
  // Leaves the texture bound to the unit.
  void attach_texture(GLenum attachment, GLenum format, int unit, int width, int height)
  {
    GLuint name;
    glGenTextures(1, &name);
    textures.push_back(name);
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glBindTexture(GL_TEXTURE_2D, name);
    glTexStorage2D(GL_TEXTURE_2D, 1, format, width, height);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, name, 0);
  }
};

void check_framebuffer(int width, int height)
{
  if(glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error("Mesh_renderer: no framebuffer of " + std::to_string(width) + " x " +
                             std::to_string(height) + " pixels");
}

void check(const Drawable& shape, const Render_options& options)
{
  if(options.width <= 0 || options.height <= 0)
    throw std::invalid_argument("Mesh_renderer: width and height must be positive");
  if(!(options.camera.field_of_view > 0 && options.camera.field_of_view < 150))
    throw std::invalid_argument("Mesh_renderer: camera: field_of_view must be in (0,150)");
  if(!(options.margin >= 0 && options.margin < 0.45))
    throw std::invalid_argument("Mesh_renderer: margin must be in [0,0.45)");
  if(!(options.splat_size > 0))
    throw std::invalid_argument("Mesh_renderer: splat_size must be positive");
  if(!shape.normals.empty() && shape.normals.size() != shape.points.size())
    throw std::invalid_argument("Mesh_renderer: there must be as many normals as points, or none");
  if(!shape.scalars.empty() && shape.scalars.size() != shape.points.size())
    throw std::invalid_argument("Mesh_renderer: there must be as many scalars as points, or none");
  if(!(options.range.low < options.range.high))
    throw std::invalid_argument("Mesh_renderer: range is empty");
}

} // namespace

Mesh_renderer::Mesh_renderer()
{
  mesh_program_ = linked(mesh_vertex_shader, std::string(shading) + mesh_fragment_shader);
  splat_program_ = linked(splat_vertex_shader, splat_fragment_shader);
  splat_picture_program_ =
      linked(picture_vertex_shader, std::string(shading) + splat_picture_fragment_shader);
}

Mesh_renderer::~Mesh_renderer()
{
  try
  {
    context_.make_current();
    glDeleteProgram(mesh_program_);
    glDeleteProgram(splat_program_);
    glDeleteProgram(splat_picture_program_);
  }
  catch(const std::runtime_error&)
  {
    // the programs go with the context
  }
}

Image Mesh_renderer::render(const Drawable& shape, const Render_options& options)
{
  check(shape, options);
  Image image(options.width, options.height,
              {options.background.r, options.background.g, options.background.b, 255});

  // What is drawn: triangles without bad points, or the good points.
  const bool is_mesh = !shape.triangles.empty();
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<char> used(shape.points.size(), !is_mesh);
  for(const auto& t : shape.triangles)
  {
    const auto good = [&](std::size_t v) { return v < shape.points.size() && is_finite(shape.points[v]); };
    if(good(t[0]) && good(t[1]) && good(t[2]))
    {
      triangles.push_back(t);
      used[t[0]] = used[t[1]] = used[t[2]] = 1;
    }
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vector low = {infinity, infinity, infinity}, high = {-infinity, -infinity, -infinity};
  for(std::size_t i = 0; i < shape.points.size(); ++i)
  {
    used[i] = used[i] && is_finite(shape.points[i]);
    for(std::size_t c = 0; used[i] && c < 3; ++c)
    {
      low[c] = std::min(low[c], shape.points[i][c]);
      high[c] = std::max(high[c], shape.points[i][c]);
    }
  }
  Eye_space space = looked_at(options.camera, low[0] <= high[0] ? low : Vector{0, 0, 0},
                              low[0] <= high[0] ? high : Vector{0, 0, 0});
  if(!(low[0] <= high[0]))
    return image;

  std::vector<Vector> placed;        // the used points, and
  std::vector<std::size_t> original; // which they are
  std::vector<std::size_t> index(shape.points.size(), 0);
  for(std::size_t i = 0; i < shape.points.size(); ++i)
    if(used[i])
    {
      index[i] = placed.size();
      placed.push_back(space.place(shape.points[i]));
      original.push_back(i);
    }
  for(auto& t : triangles)
    t = {index[t[0]], index[t[1]], index[t[2]]};

  std::vector<double> radii;
  if(!is_mesh)
  {
    // Isolated points shall not become plates: bounded by a multiple of the typical spacing.
    radii = local_spacing(placed);
    const double typical = percentile(radii, 0.5);
    for(double& r : radii)
      r = options.splat_size * std::min(std::max(1.05 * r, 0.1 * typical), 4 * typical);
    if(typical == 0)
      radii.assign(radii.size(), options.splat_size * (placed.size() == 1 ? 1 : 0.02));
  }
  std::vector<Vector> given_normals; // turned and of unit length, or 0
  for(std::size_t i : original)
    given_normals.push_back(shape.normals.empty() ? Vector{0, 0, 0}
                                                  : space.turn(normalized(shape.normals[i])));
  const Frustum frustum = framed(space, placed, given_normals, radii, options);
  for(Vector& p : placed)
    p = p - space.eye;

  std::vector<Gpu_vertex> vertices;
  if(is_mesh)
  {
    const std::vector<Vector> normals = corner_normals(placed, triangles, options.crease_angle);
    for(std::size_t corner = 0; corner < normals.size(); ++corner)
    {
      if(corner % 3 == 0 && is_degenerate(placed, triangles[corner / 3]))
      {
        corner += 2;
        continue;
      }
      const std::size_t i = triangles[corner / 3][corner % 3];
      const Vector& given = given_normals[i];
      vertices.push_back(gpu_vertex(placed[i], dot(given, given) > 0 ? given : normals[corner], 0));
      set_value(vertices.back(), shape, original[i], options.range);
    }
  }
  else
    for(std::size_t i = 0; i < placed.size(); ++i)
    {
      vertices.push_back(gpu_vertex(placed[i], given_normals[i], radii[i]));
      set_value(vertices.back(), shape, original[i], options.range);
    }
  if(vertices.empty())
    return image;

  // Each pixel has 2 x 2 fragments of a mesh, with 4 samples each of its edges, or 3 x 3 of a point set.
  context_.make_current();
  Gl_names names;
  GLint max_size = 0, max_samples = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &max_size);
  glGetIntegerv(GL_MAX_SAMPLES, &max_samples);
  int finer = is_mesh ? 2 : 3;
  while(finer > 1 && finer * std::max(options.width, options.height) > max_size)
    --finer;
  const int width = finer * options.width, height = finer * options.height;

  GLuint array = 0, buffer = 0, texture = 0;
  glGenVertexArrays(1, &array);
  names.arrays.push_back(array);
  glBindVertexArray(array);
  glGenBuffers(1, &buffer);
  names.buffers.push_back(buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size() * sizeof(Gpu_vertex)), vertices.data(),
               GL_STATIC_DRAW);
  const auto attribute = [&](GLuint location, GLint size, std::size_t offset)
  {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, sizeof(Gpu_vertex),
                          reinterpret_cast<const void*>(offset));
    glVertexAttribDivisor(location, is_mesh ? 0 : 1);
  };
  attribute(0, 3, offsetof(Gpu_vertex, position));
  attribute(1, 3, offsetof(Gpu_vertex, normal));
  attribute(2, 2, offsetof(Gpu_vertex, value));
  attribute(3, 1, offsetof(Gpu_vertex, radius));

  std::vector<float> texels;
  for(int i = 0; i < 1024; ++i)
    for(double channel : options.gradient(i / 1023.))
      texels.push_back(float(channel));
  glGenTextures(1, &texture);
  names.textures.push_back(texture);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_1D, texture);
  glTexImage1D(GL_TEXTURE_1D, 0, GL_RGB16F, 1024, 0, GL_RGB, GL_FLOAT, texels.data());
  glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);

  const double n = frustum.near_plane, f = frustum.far_plane;
  float projection[16] = {};
  projection[0] = float(1 / frustum.slope_x);
  projection[5] = float(1 / frustum.slope_y);
  projection[10] = float((f + n) / (n - f));
  projection[11] = -1;
  projection[14] = float(2 * f * n / (n - f));
  const auto use = [&](GLuint program)
  {
    glUseProgram(program);
    const auto uniform = [&](const char* name) { return glGetUniformLocation(program, name); };
    const auto color_uniform = [&](const char* name, Rgba c)
    { glUniform3f(uniform(name), c.r / 255.f, c.g / 255.f, c.b / 255.f); };
    glUniformMatrix4fv(uniform("projection"), 1, GL_FALSE, projection);
    glUniform1i(uniform("gradient"), 0);
    glUniform1i(uniform("normal_sums"), 1);
    glUniform1i(uniform("value_sums"), 2);
    color_uniform("plain_color", options.plain_color);
    color_uniform("missing_color", missing_value_color);
    color_uniform("background", options.background);
    glUniform1i(uniform("colored"), shape.scalars.empty() ? 0 : 1);
    glUniform1f(uniform("hatch_period"),
                float(finer * std::max(6., std::min(options.width, options.height) / 90.)));
  };

  glViewport(0, 0, width, height);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glEnable(GL_DEPTH_CLAMP); // what is pushed away below shall not vanish
  if(is_mesh)
  {
    const int samples = std::min(4, int(max_samples));
    const GLuint multisampled = names.framebuffer();
    names.attach_renderbuffer(GL_COLOR_ATTACHMENT0, GL_RGBA8, samples, width, height);
    names.attach_renderbuffer(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, samples, width, height);
    check_framebuffer(width, height);
    glClearColor(options.background.r / 255.f, options.background.g / 255.f, options.background.b / 255.f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    use(mesh_program_);
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(vertices.size()));

    const GLuint resolved = names.framebuffer();
    names.attach_renderbuffer(GL_COLOR_ATTACHMENT0, GL_RGBA8, 0, width, height);
    check_framebuffer(width, height);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, multisampled);
    glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved);
  }
  else
  {
    names.framebuffer();
    names.attach_texture(GL_COLOR_ATTACHMENT0, GL_RGBA32F, 1, width, height);
    names.attach_texture(GL_COLOR_ATTACHMENT1, GL_RGBA32F, 2, width, height);
    names.attach_renderbuffer(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, 0, width, height);
    const GLenum targets[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glDrawBuffers(2, targets);
    check_framebuffer(width, height);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    use(splat_program_);
    const auto draw = [&](float push)
    {
      glUniform1f(glGetUniformLocation(splat_program_, "push"), push);
      glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, GLsizei(vertices.size()));
    };
    // First how far one sees, with some tolerance, so that then the discs of one sheet are added up but
    // not those behind it.
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    draw(0.8f);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    draw(0);

    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    names.framebuffer();
    names.attach_renderbuffer(GL_COLOR_ATTACHMENT0, GL_RGBA8, 0, width, height);
    check_framebuffer(width, height);
    use(splat_picture_program_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  std::vector<std::uint8_t> fine(std::size_t(width) * std::size_t(height) * 4);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, fine.data());
  const GLenum error = glGetError();
  if(error != GL_NO_ERROR)
    throw std::runtime_error("Mesh_renderer: OpenGL reports error " + std::to_string(error));

  const auto mean = [&](int x, int y, int channel)
  {
    unsigned sum = 0;
    for(int dy = 0; dy < finer; ++dy)
      for(int dx = 0; dx < finer; ++dx)
        sum += fine[(std::size_t(y * finer + dy) * std::size_t(width) + std::size_t(x * finer + dx)) * 4 +
                    std::size_t(channel)];
    return std::uint8_t((sum + unsigned(finer * finer) / 2) / unsigned(finer * finer));
  };
  for(int y = 0; y < options.height; ++y)
    for(int x = 0; x < options.width; ++x) // OpenGL's rows start at the bottom
      image.at(x, options.height - 1 - y) = {mean(x, y, 0), mean(x, y, 1), mean(x, y, 2), 255};
  return image;
}

} // namespace support
