#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_G_BUFFER_RENDERER_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_G_BUFFER_RENDERER_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>
#include <Shape_characteristics/sampling/Neighborhood.h>
#include <Shape_characteristics/screen_space/Camera.h>
#include <Shape_characteristics/screen_space/G_buffer.h>
#include <Shape_characteristics/screen_space/Normal_space.h>
#include <Shape_characteristics/screen_space/OpenGL/G_buffer_textures.h>
#include <Shape_characteristics/screen_space/OpenGL/internal/Gl_program.h>
#include <Shape_characteristics/screen_space/OpenGL/internal/Gl_state.h>
#include <Shape_characteristics/screen_space/OpenGL/internal/read_texture.h>
#include <Shape_characteristics/screen_space/OpenGL/internal/require_opengl.h>

#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <epoxy/gl.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsScreenSpace

  draws a mesh into a G-buffer: textures with the depth and the normal of each pixel.

  It needs nothing but a current OpenGL context, 4.3 core or later, and no window. What it changes of OpenGL's state it gives back.
  Both sides of faces are drawn, with the normal that the mesh says. Where the mesh begins doesn't matter: what OpenGL gets in single
  precision is relative to its center.

  \cgalExample{screen_space/screen_space_curvature.cpp}
*/
class G_buffer_renderer
{
public:
  /// prepares the renderer in the current context, in which it has to be used and destroyed.
  /// \throws std::runtime_error if no context is current, or if it has less than OpenGL 4.3
  G_buffer_renderer()
  {
    internal::require_opengl("G_buffer_renderer");
    m_program = internal::Gl_program(
        "G_buffer_renderer", {{GL_VERTEX_SHADER, vertex_shader()}, {GL_FRAGMENT_SHADER, fragment_shader()}});
    m_to_view = m_program.uniform("to_view");
    m_normal_to_view = m_program.uniform("normal_to_view");
    m_projection = m_program.uniform("projection");
    m_has_normal_map = m_program.uniform("has_normal_map");
    m_normal_map = m_program.uniform("normal_map");
    glGenVertexArrays(1, &m_vertex_array);
    glGenBuffers(2, m_buffers);
    glGenFramebuffers(1, &m_framebuffer);
  }

  ~G_buffer_renderer()
  {
    glDeleteFramebuffers(1, &m_framebuffer);
    glDeleteBuffers(2, m_buffers);
    glDeleteVertexArrays(1, &m_vertex_array);
    const GLuint textures[3] = {m_depths, m_normals, m_normal_texture};
    glDeleteTextures(3, textures);
  }

  G_buffer_renderer(const G_buffer_renderer&) = delete;
  G_buffer_renderer& operator=(const G_buffer_renderer&) = delete;

  /*!
    copies a mesh to the GPU, in place of the one before.

    Vertices with coordinates that aren't finite are left out with their faces. Those without a normal make pixels with a normal that isn't finite, or zero.

    \tparam ConcurrencyTag of the normals, if they are computed
    \tparam FaceGraph a model of `FaceListGraph`
    \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

    \param mesh the mesh. Faces with more than three vertices are drawn as fans of triangles.
    \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

    \cgalNamedParamsBegin
      \cgalParamNBegin{vertex_point_map}
        \cgalParamDescription{the points of the vertices}
        \cgalParamType{a model of `ReadablePropertyMap` with value type `%Point_3`}
        \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
      \cgalParamNEnd
      \cgalParamNBegin{vertex_normal_map}
        \cgalParamDescription{the outward normals of the vertices, of any length}
        \cgalParamType{a model of `ReadablePropertyMap` with value type `%Vector_3`}
        \cgalParamDefault{`vertex_normals()` with `normal_weighting`}
      \cgalParamNEnd
      \cgalParamNBegin{normal_weighting}
        \cgalParamDescription{how normals are computed if none are given}
        \cgalParamType{`Normal_weighting`}
        \cgalParamDefault{`Normal_weighting::MAX`}
      \cgalParamNEnd
      \cgalParamNBegin{vertex_texture_coordinates_map}
        \cgalParamDescription{where the vertices are in the normal map, [0, 1] being its extent}
        \cgalParamType{a model of `ReadablePropertyMap` with value type `%Point_2`}
        \cgalParamDefault{no normal map is used}
      \cgalParamNEnd
    \cgalNamedParamsEnd
  */
  template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
            typename FaceGraph,
            typename NamedParameters = parameters::Default_named_parameters>
  void set_mesh(const FaceGraph& mesh, const NamedParameters& np = parameters::default_values())
  {
    using parameters::get_parameter;
    using parameters::is_default_parameter;
    const Face_graph_samples samples = sampled_surface<ConcurrencyTag>(
        mesh, Neighborhood::rings(1), np, Face_graph_samples::Connectivity::FACES);

    Eigen::Vector3d low = Eigen::Vector3d::Constant((std::numeric_limits<double>::max)()), high = -low;
    for(std::size_t i = 0; i < samples.size(); ++i)
      if(samples.point(i).allFinite())
      {
        low = low.cwiseMin(samples.point(i));
        high = high.cwiseMax(samples.point(i));
      }
    m_center = low.x() <= high.x() ? Eigen::Vector3d(0.5 * low + 0.5 * high) : Eigen::Vector3d(0., 0., 0.);

    constexpr std::size_t size = 8; // point, normal, texture coordinates
    std::vector<float> vertices_of_gpu(size * samples.size(), 0.f);
    for(std::size_t i = 0; i < samples.size(); ++i)
    {
      const Eigen::Vector3f p = (samples.point(i) - m_center).cast<float>();
      const Eigen::Vector3f n = samples.normal(i).cast<float>();
      for(std::size_t k = 0; k < 3; ++k)
      {
        vertices_of_gpu[size * i + k] = p[Eigen::Index(k)];
        vertices_of_gpu[size * i + 3 + k] = n[Eigen::Index(k)];
      }
    }
    m_has_coordinates =
        !is_default_parameter<NamedParameters, internal_np::vertex_texture_coordinates_map_t>::value;
    if constexpr(!is_default_parameter<NamedParameters, internal_np::vertex_texture_coordinates_map_t>::value)
    {
      const auto map = get_parameter(np, internal_np::vertex_texture_coordinates_map);
      std::size_t i = 0;
      for(const auto v : vertices(mesh))
      {
        const auto& t = get(map, v);
        vertices_of_gpu[size * i + 6] = float(CGAL::to_double(t.x()));
        vertices_of_gpu[size * i + 7] = float(CGAL::to_double(t.y()));
        ++i;
      }
    }

    std::vector<std::uint32_t> triangles;
    triangles.reserve(3 * samples.number_of_faces());
    for(std::size_t f = 0; f < samples.number_of_faces(); ++f)
      for(std::size_t k = 2; k < samples.degree(f); ++k)
      {
        const std::uint32_t corners[3] = {samples.vertex(f, 0), samples.vertex(f, k - 1),
                                          samples.vertex(f, k)};
        Eigen::Vector3f p[3];
        for(int j = 0; j < 3; ++j)
          p[j] = (samples.point(corners[j]) - m_center).cast<float>();
        // Mesa 22's software renderer draws nothing at all if the last triangle has no area
        const Eigen::Vector3f area = (p[1] - p[0]).cross(p[2] - p[0]);
        if(area.allFinite() && !area.isZero(0.f))
          triangles.insert(triangles.end(), corners, corners + 3);
      }
    m_number_of_indices = GLsizei(triangles.size());

    const internal::Gl_state state;
    glBindVertexArray(m_vertex_array);
    glBindBuffer(GL_ARRAY_BUFFER, m_buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(sizeof(float) * vertices_of_gpu.size()), vertices_of_gpu.data(),
                 GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_buffers[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(sizeof(std::uint32_t) * triangles.size()),
                 triangles.data(), GL_STATIC_DRAW);
    const int components[3] = {3, 3, 2}, offsets[3] = {0, 3, 6};
    for(GLuint i = 0; i < 3; ++i)
    {
      glEnableVertexAttribArray(i);
      glVertexAttribPointer(i, components[i], GL_FLOAT, GL_FALSE, GLsizei(size * sizeof(float)),
                            reinterpret_cast<const void*>(sizeof(float) * std::size_t(offsets[i])));
    }
  }

  /*!
    sets the normals that a texture adds to the mesh, which needs a `vertex_texture_coordinates_map`. Outside of [0, 1] it is repeated.

    \param width number of columns
    \param height number of rows
    \param normals for each texel, row by row from texture coordinate 0 on, a normal: along the first texture coordinate, along the second, and
           outwards. Components are in [-1, 1].
    \throws std::invalid_argument if a size is less than 1 or the array is missing
  */
  void set_normal_map(int width, int height, const float* normals)
  {
    if(width < 1 || height < 1 || !normals)
      throw std::invalid_argument("Shape_characteristics: a normal map needs texels");
    glDeleteTextures(1, &m_normal_texture);
    const internal::Gl_state state;
    glGenTextures(1, &m_normal_texture);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, m_normal_texture);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA32F, width, height);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGB, GL_FLOAT, normals);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  }

  /// removes the normal map.
  void remove_normal_map()
  {
    glDeleteTextures(1, &m_normal_texture);
    m_normal_texture = 0;
  }

  /*!
    draws the mesh and returns the textures, which the renderer owns and the next call changes. Nothing is allocated from one picture to the next of the same size.

    \param camera from where; its depth convention has to be `WINDOW_DEPTH`, with depth that grows with the distance
    \param width number of columns; may be 0
    \param height number of rows; may be 0
    \throws std::invalid_argument if a size is negative or larger than OpenGL has it, or the camera has another kind of depth
    \throws std::runtime_error if OpenGL has no framebuffer of that size
  */
  G_buffer_textures draw(const Camera& camera, int width, int height)
  {
    if(width < 0 || height < 0)
      throw std::invalid_argument("Shape_characteristics: the size of a G-buffer must not be negative");
    if(camera.depth_convention() != Depth_convention::WINDOW_DEPTH || !camera.depth_grows())
      throw std::invalid_argument(
          "Shape_characteristics: G_buffer_renderer draws OpenGL's usual window depth alone");
    G_buffer_textures result = {width, height, 0, 0, camera, Normal_space::VIEW};
    if(width == 0 || height == 0)
      return result;
    if(width != m_width || height != m_height)
      remove_textures(); // before the state is kept: wherever the application shows them, there is nothing then
    const internal::Gl_state state;
    resize(width, height);
    result.depths = m_depths;
    result.normals = m_normals;

    Eigen::Matrix4d to_view = camera.view();
    to_view.block<3, 1>(0, 3) += to_view.topLeftCorner<3, 3>() * m_center;
    const Eigen::Matrix4f projection = camera.projection().cast<float>(), view = to_view.cast<float>();
    const Eigen::Matrix3f rotation = view.topLeftCorner<3, 3>();
    const GLuint name = m_program.name();
    glProgramUniformMatrix4fv(name, m_to_view, 1, GL_FALSE, view.data());
    glProgramUniformMatrix4fv(name, m_projection, 1, GL_FALSE, projection.data());
    glProgramUniformMatrix3fv(name, m_normal_to_view, 1, GL_FALSE, rotation.data());
    glProgramUniform1i(name, m_has_normal_map, m_has_coordinates && m_normal_texture != 0);
    glProgramUniform1i(name, m_normal_map, 0);

    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    glViewportIndexedf(0, 0.f, 0.f, float(width), float(height));
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDepthRangeIndexed(0, 0., 1.);
    const float no_normal[4] = {0.f, 0.f, 0.f, 0.f}, far_away = 1.f;
    glClearBufferfv(GL_COLOR, 0, no_normal);
    glClearBufferfv(GL_DEPTH, 0, &far_away);
    if(m_number_of_indices > 0)
    {
      glActiveTexture(GL_TEXTURE0);
      glBindTexture(GL_TEXTURE_2D, m_normal_texture);
      glBindSampler(0, 0);
      glUseProgram(name);
      glBindVertexArray(m_vertex_array);
      glDrawElements(GL_TRIANGLES, m_number_of_indices, GL_UNSIGNED_INT, nullptr);
    }
    return result;
  }

private:
  void remove_textures()
  {
    const GLuint old[2] = {m_depths, m_normals};
    glDeleteTextures(2, old);
    m_depths = m_normals = 0;
    m_width = m_height = -1;
  }

  void resize(int width, int height)
  {
    if(width == m_width && height == m_height)
      return;
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if(width > largest || height > largest)
      throw std::invalid_argument(
          "Shape_characteristics: the size of a G-buffer is larger than OpenGL has textures");
    GLuint names[2];
    glGenTextures(2, names);
    m_depths = names[0];
    m_normals = names[1];
    const GLenum formats[2] = {GL_DEPTH_COMPONENT32F, GL_RGBA32F};
    glActiveTexture(GL_TEXTURE0);
    for(int i = 0; i < 2; ++i)
    {
      glBindTexture(GL_TEXTURE_2D, names[i]);
      glTexStorage2D(GL_TEXTURE_2D, 1, formats[i], width, height);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, m_depths, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_normals, 0);
    m_width = width;
    m_height = height;
    if(glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    {
      m_width = m_height = -1;
      throw std::runtime_error(
          "Shape_characteristics: G_buffer_renderer: OpenGL has no framebuffer for this size");
    }
  }

  static constexpr const char* vertex_shader()
  {
    return R"(#version 430 core
layout(location = 0) in vec3 vertex_point;
layout(location = 1) in vec3 vertex_normal;
layout(location = 2) in vec2 vertex_coordinates;
uniform mat4 to_view;
uniform mat3 normal_to_view;
uniform mat4 projection;
out vec3 point;
out vec3 normal;
out vec2 coordinates;
void main()
{
  vec4 p = to_view * vec4(vertex_point, 1);
  point = p.xyz;
  normal = normal_to_view * vertex_normal;
  coordinates = vertex_coordinates;
  gl_Position = projection * p;
}
)";
  }

  // The directions along which texture coordinates grow follow from how point and coordinates change from pixel to pixel.
  static constexpr const char* fragment_shader()
  {
    return R"(#version 430 core
uniform bool has_normal_map;
uniform sampler2D normal_map;
in vec3 point;
in vec3 normal;
in vec2 coordinates;
layout(location = 0) out vec4 view_normal;
void main()
{
  vec3 n = normalize(normal);
  if(has_normal_map)
  {
    vec3 px = dFdx(point), py = dFdy(point);
    vec2 tx = dFdx(coordinates), ty = dFdy(coordinates);
    // gradients of the texture coordinates on the surface, up to a common positive factor
    float orientation = dot(cross(px, py), n) < 0 ? -1 : 1;
    vec3 a = orientation * cross(py, n), b = orientation * cross(n, px);
    vec3 u = normalize(a * tx.x + b * ty.x), v = normalize(a * tx.y + b * ty.y);
    vec3 m = texture(normal_map, coordinates).xyz;
    n = normalize(m.x * u + m.y * v + m.z * n);
  }
  view_normal = vec4(n, 0);
}
)";
  }

  internal::Gl_program m_program;
  GLint m_to_view = -1, m_normal_to_view = -1, m_projection = -1, m_has_normal_map = -1, m_normal_map = -1;
  GLuint m_vertex_array = 0, m_buffers[2] = {0, 0}, m_framebuffer = 0, m_depths = 0, m_normals = 0,
         m_normal_texture = 0;
  int m_width = -1, m_height = -1;
  GLsizei m_number_of_indices = 0;
  bool m_has_coordinates = false;
  Eigen::Vector3d m_center = Eigen::Vector3d(0., 0., 0.);
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_G_BUFFER_RENDERER_H
