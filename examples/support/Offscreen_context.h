#ifndef SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_OFFSCREEN_CONTEXT_H
#define SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_OFFSCREEN_CONTEXT_H

#include <string>

namespace support {

/// An OpenGL core context without a window, through EGL: neither a display nor a GPU is needed, Mesa's
/// software renderer will do.
///
/// Tried in this order: each EGL device that is a GPU, Mesa's surfaceless platform, each other EGL device, the
/// default display; the first that gives OpenGL 4.3 or later is taken. OpenGL functions are called through `<epoxy/gl.h>`.
class Offscreen_context
{
public:
  /// Makes the context and makes it the calling thread's current one. Throws `std::runtime_error` that
  /// says what was tried and how each failed.
  Offscreen_context();
  ~Offscreen_context();
  Offscreen_context(const Offscreen_context&) = delete;
  Offscreen_context& operator=(const Offscreen_context&) = delete;

  /// Makes it the calling thread's current context. It may be current in one thread at a time.
  void make_current() const;

  /// The renderer's name and the version of OpenGL, for the user to read.
  std::string description() const;

private:
  void* display_ = nullptr;
  void* context_ = nullptr;
  void* surface_ = nullptr; // a pixel buffer where a context cannot be current without any surface
};

} // namespace support

#endif
