#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace brume {

// An OpenGL 4.5 core context without any window or display server (EGL surfaceless). Of a GPU where
// one answers, else of software.
class EglContext {
 public:
  enum class Devices { any, gpu };

  // Makes the context current. nullptr if there is none to be had; `problem` then says why. A
  // `debug` context tells more of what is wrong, and may be slower.
  static std::unique_ptr<EglContext> create(std::string* problem = nullptr, bool debug = false,
                                            Devices devices = Devices::any);
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  // In the calling thread; a context is current in one thread at a time.
  bool make_current();
  void done_current();
  [[nodiscard]] bool is_current() const;

  // Reads the first colour attachment of a framebuffer: RGBA bytes, rows from the bottom.
  void read_rgba(unsigned framebuffer, int width, int height, std::uint8_t* pixels);

 private:
  EglContext(void* display, void* context) : display_(display), context_(context) {}
  static std::unique_ptr<EglContext> create_on(void* display, bool debug, std::string& problem);

  void* display_;
  void* context_;
};

}  // namespace brume
