#include "render/gl/egl_context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>
#include <cstring>
#include <vector>

namespace brume {
namespace {

bool is_software(EGLDeviceEXT device) {
  const char* extensions = eglQueryDeviceStringEXT(device, EGL_EXTENSIONS);
  return extensions && std::strstr(extensions, "EGL_MESA_device_software");
}

// Candidate displays, GPUs first: Mesa's surfaceless platform may be software where another driver
// has a GPU.
std::vector<EGLDisplay> displays(EglContext::Devices wanted) {
  std::vector<EGLDisplay> found;
  std::vector<EGLDisplay> last;
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration")) {
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (!eglQueryDevicesEXT(devices.size(), devices.data(), &count)) count = 0;
    for (EGLint k = 0; k < count; ++k) {
      const EGLDeviceEXT device = devices[static_cast<std::size_t>(k)];
      EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
      (is_software(device) ? last : found).push_back(display);
    }
  }
  if (wanted == EglContext::Devices::gpu) return found;
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    found.push_back(
        eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  }
  found.insert(found.end(), last.begin(), last.end());
  return found;
}

}  // namespace

std::unique_ptr<EglContext> EglContext::create(std::string* problem, bool debug, Devices devices) {
  std::string why;
  std::unique_ptr<EglContext> result;
  if (!epoxy_has_egl()) {
    why = "there is no EGL library";
  } else {
    why = devices == Devices::gpu ? "EGL finds no GPU" : "EGL finds no display";
    for (EGLDisplay display : displays(devices)) {
      if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) continue;
      result = create_on(display, EGL_NO_CONTEXT, debug, why);
      if (result) break;
    }
  }
  if (!result && problem) *problem = why;
  return result;
}

std::unique_ptr<EglContext> EglContext::create_sharing(std::string* problem) const {
  std::string why;
  auto result = create_on(display_, context_, false, why);
  if (!result && problem) *problem = why;
  return result;
}

std::unique_ptr<EglContext> EglContext::create_on(void* display, void* shared, bool debug,
                                                  std::string& problem) {
  const auto fail = [&problem](const char* why) {
    problem = why;
    return nullptr;
  };
  if (!eglBindAPI(EGL_OPENGL_API)) return fail("EGL does not support desktop OpenGL");
  constexpr std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                         EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config{};
  EGLint configs = 0;
  eglChooseConfig(display, wanted.data(), &config, 1, &configs);
  // One that tells when it is lost, where the driver has such.
  EGLContext context = EGL_NO_CONTEXT;
  for (const EGLint strategy : {EGL_LOSE_CONTEXT_ON_RESET, EGL_NO_RESET_NOTIFICATION}) {
    const std::array<EGLint, 11> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                            4,
                                            EGL_CONTEXT_MINOR_VERSION,
                                            5,
                                            EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                            EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY,
                                            strategy,
                                            debug ? EGL_CONTEXT_OPENGL_DEBUG : EGL_NONE,
                                            EGL_TRUE,
                                            EGL_NONE};
    context =
        eglCreateContext(display, configs > 0 ? config : EGLConfig{}, shared, attributes.data());
    if (context != EGL_NO_CONTEXT) break;
  }
  if (context == EGL_NO_CONTEXT) return fail("the driver does not support OpenGL 4.5 core");
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
