// A window that shows the curvature of a mesh, estimated anew in each frame from what is on the screen.
//
//     viewer [mesh] [--show mean|Gaussian|shape_index|ambient_occlusion|light] [--lod] [--size 1280x800]
//            [--screenshot out.png] [--frames 3]
//
// Drag to turn, turn the wheel to come nearer. Keys: 1 mean curvature, 2 Gaussian curvature, 3 shape index, 4 ambient occlusion, 5 light
// alone, L level of detail on and off, Up and Down contrast, R colours for what is seen now, S a picture (viewer.png), Escape ends. With `--screenshot`, the window
// closes by itself after `--frames` frames, and the program fails if the picture is blank.
#include "../support/Color_gradient.h"
#include "../support/Image.h"
#include "../support/Orbit_camera.h"
#include "../support/Painter.h"
#include "../support/Value_range.h"
#include "../support/camera_for.h"
#include "../support/data_file.h"
#include "../support/gl_program.h"

#include <Shape_characteristics/screen_space/OpenGL/Ambient_occlusion_pass.h>
#include <Shape_characteristics/screen_space/OpenGL/G_buffer_renderer.h>
#include <Shape_characteristics/screen_space/OpenGL/Screen_space_curvature_pass.h>
#include <Shape_characteristics/screen_space/OpenGL/read_screen_space_curvatures.h>
#include <Shape_characteristics/screen_space/Two_part_ambient_occlusion.h>
#include <Shape_characteristics/screen_space/mean_curvature_extreme.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/property_map.h>

#include <epoxy/gl.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iomanip>
#include <iostream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace {

enum class Quantity
{
  MEAN,
  GAUSSIAN,
  SHAPE_INDEX,
  AMBIENT_OCCLUSION,
  LIGHT
};
const char* const quantity_names[] = {"mean", "Gaussian", "shape_index", "ambient_occlusion", "light"};

struct Arguments
{
  std::string mesh, screenshot;
  Quantity quantity = Quantity::MEAN;
  bool has_lod = false;
  int width = 1280, height = 800, frames = 3;
};

Arguments parse(int argc, char** argv)
{
  Arguments result;
  for(int i = 1; i < argc; ++i)
  {
    const std::string a = argv[i];
    const auto value = [&]() -> std::string
    {
      if(i + 1 == argc)
        throw std::invalid_argument(a + " needs a value");
      return argv[++i];
    };
    if(a == "--lod")
      result.has_lod = true;
    else if(a == "--screenshot")
      result.screenshot = value();
    else if(a == "--frames")
      result.frames = std::max(1, std::atoi(value().c_str()));
    else if(a == "--size")
    {
      char x = 0;
      std::istringstream in(value());
      if(!(in >> result.width >> x >> result.height) || x != 'x' || result.width < 64 || result.height < 64)
        throw std::invalid_argument("--size: two numbers of at least 64, such as 1280x800");
    }
    else if(a == "--show")
    {
      const auto end = std::end(quantity_names);
      const auto found = std::find(std::begin(quantity_names), end, value());
      if(found == end)
        throw std::invalid_argument("--show: mean, Gaussian, shape_index, ambient_occlusion or light");
      result.quantity = Quantity(found - std::begin(quantity_names));
    }
    else if(a.rfind("--", 0) == 0 || !result.mesh.empty())
      throw std::invalid_argument("unknown argument " + a);
    else
      result.mesh = a;
  }
  return result;
}

// A library and its window.
class Window
{
public:
  Window(int width, int height, const std::string& title)
  {
    if(!glfwInit())
      throw std::runtime_error("There is no display for a window: " + error());
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
    if(!window_)
    {
      const std::string why = error();
      glfwTerminate();
      throw std::runtime_error("There is no window with OpenGL 4.3: " + why);
    }
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(0); // frame times, not those of the display
  }
  ~Window()
  {
    glfwDestroyWindow(window_);
    glfwTerminate();
  }
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;
  GLFWwindow* get() const { return window_; }

private:
  static std::string error()
  {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "no reason given";
  }
  GLFWwindow* window_ = nullptr;
};

// What the window shows, frame by frame.
class Scene
{
public:
  Scene(const std::string& file, const Arguments& arguments)
    : quantity(arguments.quantity),
      has_lod(arguments.has_lod),
      orbit_(read(file), support::camera_for(file))
  {
    const support::Color_gradient gradient = support::Color_gradient::blue_green_red();
    std::vector<float> colors;
    for(int i = 0; i < 256; ++i)
      for(const double c : gradient(i / 255.))
        colors.push_back(float(c));
    glGenTextures(1, &gradient_);
    glBindTexture(GL_TEXTURE_2D, gradient_);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGB16F, 256, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 256, 1, GL_RGB, GL_FLOAT, colors.data());
    for(const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
      glTexParameteri(GL_TEXTURE_2D, name, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glGenTextures(1, &text_);
    glGenVertexArrays(1, &vertex_array_);
    constexpr char over_the_picture[] = R"(#version 430 core
void main() { gl_Position = vec4((gl_VertexID & 1) * 4 - 1, (gl_VertexID >> 1) * 4 - 1, 0, 1); }
)";
    shade_ =
        support::gl_program({{GL_VERTEX_SHADER, over_the_picture}, {GL_FRAGMENT_SHADER, shading_shader}});
    copy_ = support::gl_program({{GL_VERTEX_SHADER, over_the_picture}, {GL_FRAGMENT_SHADER, text_shader}});
    glGenQueries(1, &query_);
  }

  ~Scene()
  {
    glDeleteProgram(shade_);
    glDeleteProgram(copy_);
    glDeleteQueries(1, &query_);
    glDeleteVertexArrays(1, &vertex_array_);
    const GLuint textures[] = {gradient_, text_};
    glDeleteTextures(2, textures);
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  void draw(int width, int height)
  {
    const SC::G_buffer_textures g = renderer_.draw(orbit_.camera(width, height), width, height);
    glBeginQuery(GL_TIME_ELAPSED, query_);
    const unsigned curvatures =
        pass_(g, SC::parameters::level_of_detail(has_lod ? SC::Level_of_detail::by_length(1.5 * edge_)
                                                         : SC::Level_of_detail::none()));
    glEndQuery(GL_TIME_ELAPSED);
    if(needs_range)
      find_range(curvatures, width, height);
    const unsigned light =
        occlude_(curvatures, width, height, SC::Two_part_ambient_occlusion(occlusion_extreme_), 1.f);

    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, width, height);
    glUseProgram(shade_);
    const unsigned textures[] = {curvatures, g.normals, g.depths, light, gradient_};
    const char* const names[] = {"curvatures", "normals", "depths", "light", "gradient"};
    for(int i = 0; i < 5; ++i)
    {
      glActiveTexture(GLenum(GL_TEXTURE0 + i));
      glBindTexture(GL_TEXTURE_2D, textures[i]);
      glUniform1i(glGetUniformLocation(shade_, names[i]), i);
    }
    glUniform1i(glGetUniformLocation(shade_, "quantity"), int(quantity));
    glUniform1f(glGetUniformLocation(shade_, "extreme"),
                float(quantity == Quantity::GAUSSIAN ? gaussian_extreme_
                      : quantity == Quantity::MEAN   ? mean_extreme_
                                                     : 1.));
    glBindVertexArray(vertex_array_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glActiveTexture(GL_TEXTURE0);
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(query_, GL_QUERY_RESULT, &nanoseconds);
    pass_ms_ = 1e-6 * double(nanoseconds);
  }

  // a few lines in the upper left corner
  void write(int width, int height, double frame_ms)
  {
    std::ostringstream times;
    times << std::fixed << std::setprecision(2) << "frame " << frame_ms << " ms, curvature " << pass_ms_
          << " ms";
    std::ostringstream what;
    const char* const titles[] = {"mean curvature", "Gaussian curvature", "shape index", "ambient occlusion",
                                  "light"};
    what << titles[int(quantity)] << std::setprecision(3);
    if(quantity == Quantity::MEAN || quantity == Quantity::GAUSSIAN)
    {
      const double extreme = quantity == Quantity::MEAN ? mean_extreme_ : gaussian_extreme_;
      what << ", " << -extreme << " (blue) to " << extreme << " (red)";
    }
    what << ", LOD " << (has_lod ? "on" : "off");
    support::Image image(std::min(width, 560), std::min(height, 92), {255, 255, 255, 215});
    support::Painter painter(image);
    support::Text_style style;
    style.size = 20;
    painter.text(what.str(), {12, 28}, style);
    painter.text(times.str(), {12, 54}, style);
    style.size = 15;
    painter.text("1-5 quantity   L level of detail   Up, Down, R contrast   S picture   Esc end", {12, 80},
                 style);
    std::vector<std::uint8_t> pixels;
    for(int y = image.height() - 1; y >= 0; --y)
      for(int x = 0; x < image.width(); ++x)
      {
        const support::Rgba c = image.at(x, y);
        pixels.insert(pixels.end(), {c.r, c.g, c.b, c.a});
      }
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, text_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width(), image.height(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 pixels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, height - image.height(), image.width(), image.height());
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glUseProgram(copy_);
    glUniform1i(glGetUniformLocation(copy_, "picture"), 0);
    glUniform1i(glGetUniformLocation(copy_, "top"), height - image.height());
    glBindVertexArray(vertex_array_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
  }

  support::Orbit_camera& orbit() { return orbit_; }

  void change_contrast(double factor)
  {
    for(double* extreme : {&mean_extreme_, &gaussian_extreme_, &occlusion_extreme_})
      *extreme /= factor;
  }

  Quantity quantity;
  bool has_lod, needs_range = true;

private:
  CGAL::Bbox_3 read(const std::string& file)
  {
    Mesh mesh;
    if(!CGAL::IO::read_polygon_mesh(file, mesh) || mesh.is_empty())
      throw std::runtime_error(file + " is no mesh that can be read");
    renderer_.set_mesh(mesh);
    CGAL::Bbox_3 box;
    for(const auto v : mesh.vertices())
      box += mesh.point(v).bbox();
    for(const auto e : mesh.edges())
      edge_ +=
          std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)))) /
          double(mesh.number_of_edges());
    return box;
  }

  void find_range(unsigned curvatures, int width, int height)
  {
    std::vector<float> mean(std::size_t(width) * std::size_t(height)), gaussian(mean);
    SC::read_screen_space_curvatures(curvatures, width, height,
                                     SC::parameters::mean_curvature_map(CGAL::make_property_map(mean))
                                         .Gaussian_curvature_map(CGAL::make_property_map(gaussian)));
    const auto extreme = [](const std::vector<float>& values, double share)
    {
      const double e = SC::mean_curvature_extreme(values, share);
      return e > 0 ? e : 1.;
    };
    mean_extreme_ = extreme(mean, .95);
    gaussian_extreme_ = extreme(gaussian, .9);
    occlusion_extreme_ = extreme(mean, .97);
    needs_range = false;
  }

  static constexpr const char* shading_shader = R"(#version 430 core
uniform sampler2D curvatures, normals, depths, light, gradient;
uniform int quantity;
uniform float extreme;
layout(location = 0) out vec4 color;
void main()
{
  ivec2 p = ivec2(gl_FragCoord.xy);
  if(texelFetch(depths, p, 0).x >= 1)
  {
    color = vec4(0.82, 0.87, 0.93, 1);
    return;
  }
  vec4 c = texelFetch(curvatures, p, 0);
  float value = quantity == 0 ? 0.5 * (c.x + c.y) : quantity == 1 ? c.x * c.y : c.z;
  vec3 surface = vec3(0.85);
  if(quantity < 3) // grey where there is no value
    surface = isnan(value) ? vec3(0.62) : texture(gradient, vec2(0.5 + 0.5 * value / extreme, 0.5)).rgb;
  float shade = 1;
  if(quantity == 3)
    surface = vec3(texelFetch(light, p, 0).x);
  else
    shade = 0.35 + 0.65 * abs(normalize(texelFetch(normals, p, 0).xyz).z);
  color = vec4(surface * shade, 1);
}
)";
  static constexpr const char* text_shader = R"(#version 430 core
uniform sampler2D picture;
uniform int top;
layout(location = 0) out vec4 color;
void main() { color = texelFetch(picture, ivec2(gl_FragCoord.xy) - ivec2(0, top), 0); }
)";

  SC::G_buffer_renderer renderer_;
  double edge_ = 0;
  support::Orbit_camera orbit_;
  SC::Screen_space_curvature_pass pass_;
  SC::Ambient_occlusion_pass occlude_;
  GLuint shade_ = 0, copy_ = 0, gradient_ = 0, text_ = 0, vertex_array_ = 0, query_ = 0;
  double mean_extreme_ = 1, gaussian_extreme_ = 1, occlusion_extreme_ = 1, pass_ms_ = 0;
};

support::Image read_window(int width, int height)
{
  std::vector<std::uint8_t> pixels(4 * std::size_t(width) * std::size_t(height));
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  support::Image image(width, height);
  for(int y = 0; y < height; ++y)
    for(int x = 0; x < width; ++x)
    {
      const std::uint8_t* p = &pixels[4 * (std::size_t(y) * std::size_t(width) + std::size_t(x))];
      image.at(x, height - 1 - y) = {p[0], p[1], p[2], 255};
    }
  return image;
}

// whether there is no more than a few colours in the picture's middle, where no text is
bool is_blank(const support::Image& image)
{
  std::set<unsigned> colors;
  for(int y = image.height() / 4; y < image.height() * 3 / 4; ++y)
    for(int x = image.width() / 4; x < image.width() * 3 / 4; ++x)
    {
      const support::Rgba c = image.at(x, y);
      colors.insert(unsigned(c.r) << 16 | unsigned(c.g) << 8 | c.b);
    }
  return colors.size() < 16;
}

struct Pointer
{
  Scene* scene;
  double x = 0, y = 0;
  bool is_down = false, wants_picture = false;
};

Pointer& pointer_of(GLFWwindow* window)
{
  return *static_cast<Pointer*>(glfwGetWindowUserPointer(window));
}

void listen(GLFWwindow* window, Pointer& pointer)
{
  glfwSetWindowUserPointer(window, &pointer);
  glfwSetMouseButtonCallback(window,
                             [](GLFWwindow* w, int button, int action, int)
                             {
                               if(button == GLFW_MOUSE_BUTTON_LEFT)
                                 pointer_of(w).is_down = action == GLFW_PRESS;
                             });
  glfwSetCursorPosCallback(window,
                           [](GLFWwindow* w, double x, double y)
                           {
                             Pointer& p = pointer_of(w);
                             if(p.is_down)
                               p.scene->orbit().turn((x - p.x) * .008, (y - p.y) * .008);
                             p.x = x;
                             p.y = y;
                           });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double, double y)
                        { pointer_of(w).scene->orbit().move(std::pow(.9, y)); });
  glfwSetKeyCallback(window,
                     [](GLFWwindow* w, int key, int, int action, int)
                     {
                       Pointer& p = pointer_of(w);
                       if(action == GLFW_RELEASE)
                         return;
                       if(key == GLFW_KEY_UP || key == GLFW_KEY_DOWN)
                         p.scene->change_contrast(key == GLFW_KEY_UP ? 1.25 : .8);
                       if(key >= GLFW_KEY_1 && key <= GLFW_KEY_5)
                         p.scene->quantity = Quantity(key - GLFW_KEY_1);
                       if(key == GLFW_KEY_L)
                         p.scene->has_lod = !p.scene->has_lod;
                       p.scene->needs_range = p.scene->needs_range || key == GLFW_KEY_R;
                       p.wants_picture = p.wants_picture || key == GLFW_KEY_S;
                       if(key == GLFW_KEY_ESCAPE)
                         glfwSetWindowShouldClose(w, GLFW_TRUE);
                     });
}

int run(const Arguments& arguments)
{
  const std::string file =
      arguments.mesh.empty() ? support::data_file("meshes/elephant.off") : arguments.mesh;
  const Window window(arguments.width, arguments.height, "Curvature of " + file);
  Scene scene(file, arguments);
  Pointer pointer{&scene};
  listen(window.get(), pointer);

  double frame_ms = 0, start = glfwGetTime();
  for(int frame = 1; !glfwWindowShouldClose(window.get()); ++frame)
  {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window.get(), &width, &height);
    if(width == 0 || height == 0) // hidden
    {
      glfwWaitEvents();
      continue;
    }
    scene.draw(width, height);
    scene.write(width, height, frame_ms);
    const bool is_last = !arguments.screenshot.empty() && frame >= arguments.frames;
    if(is_last || pointer.wants_picture)
    {
      const std::string name = is_last ? arguments.screenshot : "viewer.png";
      const support::Image image = read_window(width, height);
      support::write_png(name, image);
      std::cout << "wrote " << name << '\n';
      pointer.wants_picture = false;
      if(is_last && is_blank(image))
        throw std::runtime_error(name + " is blank");
      if(is_last)
        return EXIT_SUCCESS;
    }
    glfwSwapBuffers(window.get());
    glFinish();
    const double now = glfwGetTime(), ms = 1e3 * (now - start);
    frame_ms = frame_ms == 0 ? ms : .9 * frame_ms + .1 * ms; // steady enough to be read
    start = now;
    glfwPollEvents();
  }
  return EXIT_SUCCESS;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    return run(parse(argc, argv));
  }
  catch(const std::exception& e)
  {
    std::cerr << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
