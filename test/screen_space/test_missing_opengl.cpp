#include <boost/test/unit_test.hpp>

#include "says.h"

#include <Shape_characteristics/screen_space/OpenGL/G_buffer_renderer.h>
#include <Shape_characteristics/screen_space/OpenGL/Screen_space_curvature_pass.h>
#include <Shape_characteristics/screen_space/OpenGL/Sphere_fit_mean_curvature_pass.h>
#include <Shape_characteristics/screen_space/OpenGL/read_g_buffer.h>
#include <Shape_characteristics/screen_space/OpenGL/read_screen_space_curvatures.h>

#include "../../examples/support/Offscreen_context.h" // tells the build what to link

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(missing_opengl)

namespace SC = Shape_characteristics;

namespace {

template <typename Function>
void check_error(const Function& function, const std::string& words)
{
  BOOST_CHECK_EXCEPTION(function(), std::runtime_error, test_support::says(words));
}

void check_all(const std::string& words)
{
  const SC::Camera camera(SC::Camera::look_at({0., 0., 3.}, {0., 0., 0.}, {0., 1., 0.}),
                          SC::Camera::perspective(1., 1., 1., 5.));
  check_error([] { SC::G_buffer_renderer renderer; }, words);
  check_error([] { SC::Screen_space_curvature_pass pass; }, words);
  check_error([] { SC::Screen_space_curvature_pass pass(SC::Shader_stage::COMPUTE); }, words);
  check_error([] { SC::Sphere_fit_mean_curvature_pass pass; }, words);
  check_error([] { SC::read_screen_space_curvatures(1, 10, 10); }, words);
  std::vector<float> depths, normals;
  check_error(
      [&] {
        SC::read_g_buffer(SC::G_buffer_textures{10, 10, 1, 2, camera}, depths, normals);
      },
      words);
}

} // namespace

BOOST_AUTO_TEST_CASE(no_context)
{
  check_all("no OpenGL context is current");
}

BOOST_AUTO_TEST_CASE(an_old_context)
{
  // Mesa pretends to have no more than OpenGL 3.3
  setenv("MESA_GL_VERSION_OVERRIDE", "3.3", 1);
  const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if(!client || std::string(client).find("EGL_MESA_platform_surfaceless") == std::string::npos)
  {
    BOOST_TEST_MESSAGE("skipped: no surfaceless platform of Mesa");
    return;
  }
  const EGLDisplay display =
      eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  BOOST_TEST_REQUIRE(eglInitialize(display, nullptr, nullptr));
  BOOST_TEST_REQUIRE(eglBindAPI(EGL_OPENGL_API));
  const EGLint config_wishes[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT,
                                  EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  BOOST_TEST_REQUIRE((eglChooseConfig(display, config_wishes, &config, 1, &count) && count > 0));
  const EGLint wishes[] = {EGL_CONTEXT_MAJOR_VERSION,
                           3,
                           EGL_CONTEXT_MINOR_VERSION,
                           3,
                           EGL_CONTEXT_OPENGL_PROFILE_MASK,
                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                           EGL_NONE};
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, wishes);
  BOOST_TEST_REQUIRE(bool(context != EGL_NO_CONTEXT));
  BOOST_TEST_REQUIRE(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context));
  if(epoxy_gl_version() < 43)
    check_all("OpenGL 4.3 or later is needed, the current context has 3.3");
  else
    BOOST_TEST_MESSAGE("skipped: this driver can't be made to have less than OpenGL 4.3");
  eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display, context);
}

BOOST_AUTO_TEST_SUITE_END()
