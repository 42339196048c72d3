#include <boost/test/unit_test.hpp>

#include "raise_to.h"

#include <Shape_characteristics/screen_space/OpenGL/Ambient_occlusion_pass.h>

#include "../../examples/support/Offscreen_context.h"
#include "../../examples/support/gl_program.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(ambient_occlusion_pass)

namespace SC = Shape_characteristics;

namespace {

support::Offscreen_context& context()
{
  static support::Offscreen_context c;
  c.make_current();
  return c;
}

constexpr int width = 37, height = 23; // no multiples of a work group

// principal curvatures of random sizes, and some pixels without
struct Curvatures
{
  GLuint name = 0;
  std::vector<float> values;

  Curvatures()
  {
    const float infinity = std::numeric_limits<float>::infinity(),
                nan = std::numeric_limits<float>::quiet_NaN();
    std::mt19937 random(1);
    std::uniform_real_distribution<float> mantissa(-1, 1), exponent(-4, 4);
    for(int i = 0; i < width * height; ++i)
    {
      const float a = mantissa(random) * std::exp2(exponent(random)),
                  b = mantissa(random) * std::exp2(exponent(random));
      values.insert(values.end(), {std::min(a, b), std::max(a, b), 0, 0});
    }
    for(std::size_t i = 0; i < 4; ++i)
      values[4 * i] = nan;
    values[4 * 4 + 1] = infinity;
    values[4 * 5] = -infinity;
    values[4 * 6] = values[4 * 6 + 1] = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    // with the filters that textures have by default, and that need more levels
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, values.data());
  }
  ~Curvatures() { glDeleteTextures(1, &name); }
};

struct Pair
{
  float min_curvature, max_curvature;
};

std::vector<float> read(unsigned texture)
{
  std::vector<float> light(std::size_t(width * height));
  glBindTexture(GL_TEXTURE_2D, texture);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RED, GL_FLOAT, light.data());
  return light;
}

} // namespace

BOOST_AUTO_TEST_CASE(the_same_as_the_mappings_on_the_CPU)
{
  context();
  const Curvatures curvatures;
  for(const SC::Shader_stage stage : {SC::Shader_stage::FRAGMENT, SC::Shader_stage::COMPUTE})
  {
    SC::Ambient_occlusion_pass pass(stage);
    const auto check = [&](const auto& mapping)
    {
      const std::vector<float> light = read(pass(curvatures.name, width, height, mapping, 0.25f));
      double largest = 0;
      for(std::size_t i = 0; i < light.size(); ++i)
        if(i < 6)
          BOOST_TEST(light[i] == 0.25f);
        else
          test_support::raise_to(
              largest,
              std::abs(mapping(Pair{curvatures.values[4 * i], curvatures.values[4 * i + 1]}) - light[i]));
      BOOST_TEST_MESSAGE("largest difference to the CPU: " << largest);
      BOOST_TEST(largest < 0x1p-20);
    };
    check(SC::Two_part_ambient_occlusion(3.));
    check(SC::Two_part_ambient_occlusion(0.5, 0.6, 0.05, 0.1));
    check(SC::Hattori_ambient_occlusion(0.3));
    check(SC::Griffin_ambient_occlusion(0.7));
    check(SC::Griffin_ambient_occlusion(1., 0.5, -0.1, 0.02));
    // NaN unless something else is asked for
    const std::vector<float> light =
        read(pass(curvatures.name, width, height, SC::Hattori_ambient_occlusion(1.)));
    BOOST_TEST(std::isnan(light[0]));
    BOOST_TEST(light[6] == 1);
  }
  BOOST_TEST(glGetError() == GLenum(GL_NO_ERROR));
}

BOOST_AUTO_TEST_CASE(sizes_change_and_may_be_zero)
{
  context();
  const Curvatures curvatures;
  SC::Ambient_occlusion_pass pass;
  const SC::Hattori_ambient_occlusion mapping(0.3);
  BOOST_TEST(pass(curvatures.name, 0, height, mapping) == 0u);
  BOOST_TEST(pass(curvatures.name, width, 0, mapping) == 0u);
  BOOST_CHECK_THROW(pass(curvatures.name, -1, height, mapping), std::invalid_argument);
  BOOST_CHECK_THROW(pass(curvatures.name, width, -1, mapping), std::invalid_argument);
  BOOST_CHECK_THROW(pass(curvatures.name, width + 1, height, mapping), std::invalid_argument);
  BOOST_CHECK_THROW(pass(0, width, height, mapping), std::invalid_argument);
  pass(curvatures.name, 5, 3, mapping);
  const std::vector<float> light = read(pass(curvatures.name, width, height, mapping));
  BOOST_TEST(light[6] == 1);
  BOOST_TEST(glGetError() == GLenum(GL_NO_ERROR));
}

BOOST_AUTO_TEST_CASE(what_it_changes_it_gives_back)
{
  context();
  const Curvatures curvatures;
  for(const SC::Shader_stage stage : {SC::Shader_stage::FRAGMENT, SC::Shader_stage::COMPUTE})
  {
    SC::Ambient_occlusion_pass pass(stage);
    GLuint other = 0;
    glGenTextures(1, &other);
    glActiveTexture(GL_TEXTURE1);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, other);
    glActiveTexture(GL_TEXTURE1);
    glViewport(1, 2, 3, 4);
    glEnable(GL_BLEND);
    glUseProgram(0);
    pass(curvatures.name, width, height, SC::Two_part_ambient_occlusion(1.));
    GLint viewport[4], texture = 0, active = 0, program = 1, framebuffer = 1;
    glGetIntegerv(GL_VIEWPORT, viewport);
    glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
    glGetIntegerv(GL_CURRENT_PROGRAM, &program);
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
    BOOST_TEST(active == GL_TEXTURE1);
    glActiveTexture(GL_TEXTURE0);
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &texture);
    BOOST_TEST(GLuint(texture) == other);
    BOOST_TEST(viewport[0] == 1);
    BOOST_TEST(viewport[3] == 4);
    BOOST_TEST(glIsEnabled(GL_BLEND) == GL_TRUE);
    BOOST_TEST(program == 0);
    BOOST_TEST(framebuffer == 0);
    glDisable(GL_BLEND);
    glDeleteTextures(1, &other);
  }
}

// the file as it is, without C++: alone, and as a library beside the one for curvatures
BOOST_AUTO_TEST_CASE(the_shader_stands_alone)
{
  context();
  const std::filesystem::path folder = std::filesystem::path(__FILE__).parent_path() /
                                       "../../include/Shape_characteristics/screen_space/OpenGL/shaders";
  const auto text_of = [&](const std::string& name)
  {
    std::ifstream file(folder / name);
    BOOST_REQUIRE(file.good());
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  const std::string occlusion = text_of("ambient_occlusion.glsl"),
                    curvature = text_of("screen_space_curvature.glsl"),
                    over_the_picture = "#version 430 core\nvoid main() { gl_Position = vec4(0); }\n";
  for(const char* mapping : {"", "#define SC_MAPPING 1\n", "#define SC_MAPPING 2\n"})
  {
    const std::string head = std::string("#version 430 core\n") + mapping;
    const std::string both =
        head + "#define SC_LIBRARY\n" + curvature + occlusion +
        "layout(location = 0) out float light;\n"
        "void main() { light = sc_ambient_occlusion(sc_curvature(ivec2(gl_FragCoord.xy))); }\n";
    const unsigned programs[] = {
        support::gl_program({{GL_VERTEX_SHADER, over_the_picture}, {GL_FRAGMENT_SHADER, head + occlusion}}),
        support::gl_program({{GL_COMPUTE_SHADER, head + "#define SC_COMPUTE\n" + occlusion}}),
        support::gl_program({{GL_VERTEX_SHADER, over_the_picture}, {GL_FRAGMENT_SHADER, both}})};
    for(const unsigned program : programs)
    {
      BOOST_TEST(glGetUniformLocation(program, "sc_occlusion") >= 0);
      glDeleteProgram(program);
    }
  }
  BOOST_TEST(glGetError() == GLenum(GL_NO_ERROR));
}

BOOST_AUTO_TEST_SUITE_END()
