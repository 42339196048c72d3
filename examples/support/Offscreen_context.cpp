#include "Offscreen_context.h"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <cstring>
#include <stdexcept>
#include <vector>

namespace support {

namespace {

bool has_word(const char* words, const char* word)
{
  const std::size_t length = std::strlen(word);
  for(const char* at = words; at && (at = std::strstr(at, word)); at += length)
    if((at == words || at[-1] == ' ') && (at[length] == ' ' || at[length] == '\0'))
      return true;
  return false;
}

std::string egl_error()
{
  switch(eglGetError())
  {
  case EGL_SUCCESS:
    return "no reason given";
  case EGL_NOT_INITIALIZED:
    return "EGL_NOT_INITIALIZED";
  case EGL_BAD_ACCESS:
    return "EGL_BAD_ACCESS";
  case EGL_BAD_ALLOC:
    return "EGL_BAD_ALLOC";
  case EGL_BAD_ATTRIBUTE:
    return "EGL_BAD_ATTRIBUTE";
  case EGL_BAD_CONFIG:
    return "EGL_BAD_CONFIG";
  case EGL_BAD_MATCH:
    return "EGL_BAD_MATCH";
  case EGL_BAD_PARAMETER:
    return "EGL_BAD_PARAMETER";
  default:
    return "an EGL error";
  }
}

struct Opened
{
  EGLContext context = EGL_NO_CONTEXT;
  EGLSurface surface = EGL_NO_SURFACE;
};

// Opens a context on an initialised display and makes it current; says why it could not.
std::string open_context(EGLDisplay display, Opened& opened)
{
  if(!eglBindAPI(EGL_OPENGL_API))
    return "it has no desktop OpenGL";
  const EGLint config_wishes[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT,
                                  EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if(!eglChooseConfig(display, config_wishes, &config, 1, &count) || count == 0)
    return "it has no configuration for desktop OpenGL";
  const EGLint context_wishes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                   4,
                                   EGL_CONTEXT_MINOR_VERSION,
                                   3,
                                   EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                   EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                   EGL_NONE};
  opened.context = eglCreateContext(display, config, EGL_NO_CONTEXT, context_wishes);
  if(opened.context == EGL_NO_CONTEXT)
    return "it has no OpenGL 4.3 core profile (" + egl_error() + ")";
  if(!has_word(eglQueryString(display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context"))
  {
    const EGLint size[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
    opened.surface = eglCreatePbufferSurface(display, config, size);
  }
  if(!eglMakeCurrent(display, opened.surface, opened.surface, opened.context))
  {
    const std::string why = "its context cannot be made current (" + egl_error() + ")";
    if(opened.surface != EGL_NO_SURFACE)
      eglDestroySurface(display, opened.surface);
    eglDestroyContext(display, opened.context);
    return why;
  }
  return {};
}

} // namespace

Offscreen_context::Offscreen_context()
{
  // libepoxy ends the program when the library is missing; this way the caller gets an exception.
  if(!dlopen("libEGL.so.1", RTLD_LAZY | RTLD_GLOBAL))
    throw std::runtime_error(
        "Offscreen_context: libEGL.so.1 is missing (on Debian: apt install libegl1 libgl1-mesa-dri)");

  struct Candidate
  {
    std::string name;
    EGLDisplay display;
  };
  std::vector<Candidate> candidates;
  const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if(has_word(client, "EGL_EXT_platform_base"))
  {
    const auto add_surfaceless = [&]
    {
      if(has_word(client, "EGL_MESA_platform_surfaceless"))
        candidates.push_back(
            {"Mesa's surfaceless platform",
             eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)});
    };
    EGLDeviceEXT devices[16];
    EGLint count = 0;
    if(!has_word(client, "EGL_EXT_platform_device") ||
       !(has_word(client, "EGL_EXT_device_enumeration") || has_word(client, "EGL_EXT_device_base")) ||
       !eglQueryDevicesEXT(16, devices, &count))
      count = 0;
    const bool tells_kinds =
        has_word(client, "EGL_EXT_device_query") || has_word(client, "EGL_EXT_device_base");
    for(const bool is_hardware : {true, false})
    {
      for(EGLint i = 0; i < count; ++i)
        if((tells_kinds && !has_word(eglQueryDeviceStringEXT(devices[i], EGL_EXTENSIONS),
                                     "EGL_MESA_device_software")) == is_hardware)
          candidates.push_back({"EGL device " + std::to_string(i),
                                eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr)});
      if(is_hardware)
        add_surfaceless();
    }
  }
  candidates.push_back({"the default display", eglGetDisplay(EGL_DEFAULT_DISPLAY)});

  std::string failures;
  for(const Candidate& candidate : candidates)
  {
    std::string why;
    if(candidate.display == EGL_NO_DISPLAY)
      why = "there is none";
    else if(!eglInitialize(candidate.display, nullptr, nullptr))
      why = "it cannot be initialised (" + egl_error() + ")";
    else
    {
      Opened opened;
      why = open_context(candidate.display, opened);
      if(why.empty())
      {
        display_ = candidate.display;
        context_ = opened.context;
        surface_ = opened.surface;
        return;
      }
    }
    failures += "\n  " + candidate.name + ": " + why;
  }
  throw std::runtime_error("Offscreen_context: no OpenGL 4.3 without a window here (on Debian, apt install "
                           "libgl1-mesa-dri gives a software renderer). Tried:" +
                           failures);
}

Offscreen_context::~Offscreen_context()
{
  if(eglGetCurrentContext() == context_)
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  if(surface_ != EGL_NO_SURFACE)
    eglDestroySurface(display_, surface_);
  eglDestroyContext(display_, context_);
  // The display stays initialised: all contexts of the process share it, and terminating it would end them.
}

void Offscreen_context::make_current() const
{
  if(eglGetCurrentContext() == context_)
    return;
  if(!eglBindAPI(EGL_OPENGL_API) || !eglMakeCurrent(display_, surface_, surface_, context_))
    throw std::runtime_error("Offscreen_context: the context cannot be made current (" + egl_error() + ")");
}

std::string Offscreen_context::description() const
{
  make_current();
  const auto text = [](GLenum name)
  {
    const GLubyte* s = glGetString(name);
    return s ? std::string(reinterpret_cast<const char*>(s)) : std::string();
  };
  return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

} // namespace support
