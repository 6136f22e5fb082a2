#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace brume {

// An OpenGL 4.5 core context without any window or display server (EGL surfaceless).
class EglContext {
 public:
  // nullptr if there is none to be had; `problem` then says why.
  static std::unique_ptr<EglContext> create(std::string* problem = nullptr);
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  bool make_current();
  void done_current();
  [[nodiscard]] bool is_current() const;

  // Reads the first colour attachment of a framebuffer: RGBA bytes, rows from the bottom.
  void read_rgba(unsigned framebuffer, int width, int height, std::uint8_t* pixels);

 private:
  EglContext(void* display, void* context) : display_(display), context_(context) {}

  void* display_;
  void* context_;
};

}  // namespace brume
