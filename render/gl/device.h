#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace brume::gl {

// What a context runs on, and what of it the passes need.
struct Device {
  std::string name;  // GL_RENDERER
  int major = 0;     // of OpenGL
  int minor = 0;
  bool is_software = false;        // of the CPU, and no match for render/cpu
  std::int64_t storage_bytes = 0;  // the largest shader storage block
  std::int64_t shared_bytes = 0;   // of a work group
  int invocations = 0;             // of a work group
  int storage_blocks = 0;          // of a compute shader
  int texture_side = 0;            // [texels]
};

// That of the current context.
Device current_device();

// Whether a GL_RENDERER is one of the known software ones.
bool is_software_renderer(const std::string& name);

// Why the passes cannot run there; empty: they can.
std::string lack(const Device& device);

// What the driver has to say (KHR_debug): collects the messages of the context that is current when
// it is made, but for mere notifications. Goes before its context does.
class Messages {
 public:
  Messages();
  ~Messages();
  Messages(const Messages&) = delete;
  Messages& operator=(const Messages&) = delete;

  // All since the last call.
  std::vector<std::string> take();

 private:
  std::vector<std::string> messages_;
};

}  // namespace brume::gl
