#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "render/gl/context.h"

namespace brume {

// An OpenGL 4.5 core context without window or display server (EGL surfaceless), on a GPU if there
// is one, else in software.
class EglContext final : public gl::Context {
 public:
  enum class Devices { any, gpu };

  // Creates a context and makes it current. nullptr on failure, with the reason in `problem`.
  // `debug` contexts report more errors and may be slower.
  static std::unique_ptr<EglContext> create(std::string* problem = nullptr, bool debug = false,
                                            Devices devices = Devices::any);
  // A context of the same device that shares buffers, textures and fences, made current in the
  // calling thread, which must differ from the first one's. nullptr and `problem` as in create().
  [[nodiscard]] std::unique_ptr<EglContext> create_sharing(std::string* problem = nullptr) const;
  ~EglContext() override;

  bool make_current() override;
  void done_current() override;
  [[nodiscard]] bool is_current() const override;

  // Reads the first colour attachment of a framebuffer: RGBA bytes, rows from the bottom.
  void read_rgba(unsigned framebuffer, int width, int height, std::uint8_t* pixels);

 private:
  EglContext(void* display, void* context) : display_(display), context_(context) {}
  // `shared`: a context of that display, or null.
  static std::unique_ptr<EglContext> create_on(void* display, void* shared, bool debug,
                                               std::string& problem);

  void* display_;
  void* context_;
};

}  // namespace brume
