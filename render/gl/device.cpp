#include "render/gl/device.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>

namespace brume::gl {
namespace {

std::int64_t integer(GLenum name) {
  GLint64 value = 0;
  glGetInteger64v(name, &value);
  return value;
}

}  // namespace

Device current_device() {
  Device device;
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  device.name = name ? name : "";
  device.is_software = is_software_renderer(device.name);
  device.major = epoxy_gl_version() / 10;
  device.minor = epoxy_gl_version() % 10;
  if (!(device.major > 4 || (device.major == 4 && device.minor >= 3))) return device;
  device.storage_bytes = integer(GL_MAX_SHADER_STORAGE_BLOCK_SIZE);
  device.shared_bytes = integer(GL_MAX_COMPUTE_SHARED_MEMORY_SIZE);
  device.invocations = static_cast<int>(integer(GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS));
  device.storage_blocks = static_cast<int>(integer(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS));
  device.texture_side = static_cast<int>(integer(GL_MAX_TEXTURE_SIZE));
  return device;
}

bool is_software_renderer(const std::string& name) {
  constexpr std::array<std::string_view, 5> known{"llvmpipe", "softpipe", "swrast",
                                                  "Software Rasterizer", "SwiftShader"};
  return std::ranges::any_of(
      known, [&](std::string_view part) { return name.find(part) != std::string::npos; });
}

std::string missing_feature(const Device& device) {
  const auto has = std::to_string(device.major) + "." + std::to_string(device.minor);
  if (device.major < 4 || (device.major == 4 && device.minor < 5)) {
    return "OpenGL 4.5 is required, " + device.name + " has " + has;
  }
  const auto needs = [&](std::int64_t value, std::int64_t min_value, const char* what) {
    if (value >= min_value) return std::string();
    return device.name + " offers " + std::to_string(value) + " " + what + "; " +
           std::to_string(min_value) + " are required";
  };
  // Above what every OpenGL 4.5 has, where at all.
  for (const std::string& why : {
           needs(device.storage_bytes, std::int64_t{1} << 26, "bytes in a storage block"),
           needs(device.shared_bytes, 32768, "bytes shared by a work group"),
           needs(device.invocations, 1024, "invocations in a work group"),
           needs(device.storage_blocks, 8, "storage blocks"),
           needs(device.texture_side, 16384, "texels along a texture"),
       }) {
    if (!why.empty()) return why;
  }
  return {};
}

}  // namespace brume::gl
