#pragma once

namespace brume::gl {

// Interface of an OpenGL 4.5 core context.
class Context {
 public:
  virtual ~Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  // In the calling thread; a context is current in one thread at a time. False on failure.
  virtual bool make_current() = 0;
  virtual void done_current() = 0;
  [[nodiscard]] virtual bool is_current() const = 0;

 protected:
  Context() = default;
};

}  // namespace brume::gl
