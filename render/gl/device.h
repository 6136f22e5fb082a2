#pragma once

#include <cstdint>
#include <string>

namespace brume::gl {

// Properties of the device of a context.
struct Device {
  std::string name;  // GL_RENDERER
  int major = 0;     // of OpenGL
  int minor = 0;
  bool is_software = false;        // runs on the CPU, slower than render/cpu
  std::int64_t storage_bytes = 0;  // the largest shader storage block
  std::int64_t shared_bytes = 0;   // of a work group
  int invocations = 0;             // of a work group
  int storage_blocks = 0;          // of a compute shader
  int texture_side = 0;            // [texels]
};

// The device of the current context.
Device current_device();

// Whether a GL_RENDERER names a known software renderer.
bool is_software_renderer(const std::string& name);

// The missing feature that keeps the passes from running; empty: none.
std::string missing_feature(const Device& device);

}  // namespace brume::gl
