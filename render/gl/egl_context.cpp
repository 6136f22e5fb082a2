#include "app/viewport/egl_context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>

namespace brume {
namespace {

// Mesa's surfaceless platform first; other drivers offer their devices instead.
EGLDisplay open_display() {
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    EGLDisplay display =
        eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr)) return display;
  }
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration")) return EGL_NO_DISPLAY;
  std::array<EGLDeviceEXT, 8> devices{};
  EGLint count = 0;
  if (!eglQueryDevicesEXT(devices.size(), devices.data(), &count)) return EGL_NO_DISPLAY;
  for (EGLint k = 0; k < count; ++k) {
    EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT,
                                                  devices[static_cast<std::size_t>(k)], nullptr);
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr)) return display;
  }
  return EGL_NO_DISPLAY;
}

}  // namespace

std::unique_ptr<EglContext> EglContext::create(std::string* problem) {
  const auto fail = [problem](const char* why) {
    if (problem) *problem = why;
    return nullptr;
  };
  if (!epoxy_has_egl()) return fail("there is no EGL library");
  EGLDisplay display = open_display();
  if (display == EGL_NO_DISPLAY) return fail("EGL offers no display");
  if (!eglBindAPI(EGL_OPENGL_API)) return fail("EGL offers no desktop OpenGL");
  constexpr std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                         EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config{};
  EGLint configs = 0;
  eglChooseConfig(display, wanted.data(), &config, 1, &configs);
  constexpr std::array<EGLint, 7> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                             4,
                                             EGL_CONTEXT_MINOR_VERSION,
                                             5,
                                             EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                             EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                             EGL_NONE};
  EGLContext context = eglCreateContext(display, configs > 0 ? config : EGLConfig{}, EGL_NO_CONTEXT,
                                        attributes.data());
  if (context == EGL_NO_CONTEXT) return fail("the driver has no OpenGL 4.5 core");
  std::unique_ptr<EglContext> result(new EglContext(display, context));
  if (!result->make_current()) return fail("the driver needs a window to draw");
  return result;
}

EglContext::~EglContext() {
  if (is_current()) done_current();
  eglDestroyContext(display_, context_);
}

bool EglContext::make_current() {
  if (is_current()) return true;
  eglBindAPI(EGL_OPENGL_API);
  return eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
}

void EglContext::done_current() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

bool EglContext::is_current() const {
  return eglGetCurrentContext() == context_;
}

void EglContext::read_rgba(unsigned framebuffer, int width, int height, std::uint8_t* pixels) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
}

}  // namespace brume
