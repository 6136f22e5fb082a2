#pragma once

#include <cstddef>
#include <glm/ext/vector_int4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

namespace brume::gl {

// An OpenGL failure: out of memory, shader compilation, lost context. The caller falls back to the
// CPU.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};
// Later frames may need less.
class OutOfMemory : public Error {
 public:
  using Error::Error;
};

// RAII wrappers of OpenGL objects: buffers, textures, programs, queries and fences. The creating
// context must be current for all operations, including destruction.

// Number of live objects, to detect leaks.
std::size_t live_objects();

enum class Kind { buffer, texture, program, query };

class Object {
 public:
  Object() = default;
  Object(Kind kind, unsigned name);
  ~Object() { reset(); }
  Object(Object&& other) noexcept : kind_(other.kind_), name_(std::exchange(other.name_, 0u)) {}
  Object& operator=(Object&& other) noexcept {
    std::swap(kind_, other.kind_);
    std::swap(name_, other.name_);
    return *this;
  }

  void reset();
  // Drops the name without deleting: its contexts are destroyed.
  void abandon();
  [[nodiscard]] unsigned name() const { return name_; }
  explicit operator bool() const { return name_ != 0; }

 private:
  Kind kind_ = Kind::buffer;
  unsigned name_ = 0;  // 0: none
};

// A storage buffer. Throws OutOfMemory.
class Buffer {
 public:
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  [[nodiscard]] unsigned name() const { return object_.name(); }

  // Ensures a capacity; the content may be lost.
  void reserve(std::size_t bytes);
  // Replaces the content, growing if needed.
  template <class T>
  void upload(std::span<const T> values) {
    upload_bytes(values.data(), values.size_bytes());
  }
  // Reads from the start; waits for the device.
  template <class T>
  void download(std::span<T> values) const {
    download_bytes(values.data(), values.size_bytes());
  }
  // Fills with zeros.
  void clear();
  void release() {
    object_.reset();
    bytes_ = 0;
  }
  // Binds as shader storage block `binding`. Empty buffers are allocated first. Throws OutOfMemory
  // if larger than a block may be.
  void bind(unsigned binding);

 private:
  void upload_bytes(const void* data, std::size_t bytes);
  void download_bytes(void* data, std::size_t bytes) const;

  Object object_;
  std::size_t bytes_ = 0;
};

// A buffer in the memory of the host, into which the device copies.
class HostBuffer {
 public:
  [[nodiscard]] unsigned name() const { return object_.name(); }
  // Ensures a capacity; the content may be lost. Throws OutOfMemory.
  void reserve(std::size_t bytes);
  // Waits for all that has been submitted.
  [[nodiscard]] std::span<const float> wait();

 private:
  Object object_;
  std::size_t bytes_ = 0;
  const float* values_ = nullptr;
};

// A 2-D texture without mipmaps, nearest sampling. Throws OutOfMemory.
class Texture {
 public:
  enum class Format { r32f, rgba32f, rgba8 };

  [[nodiscard]] const glm::ivec2& size() const { return size_; }
  [[nodiscard]] unsigned name() const { return object_.name(); }

  // Ensures format and size; the content may be lost.
  void reserve(Format format, const glm::ivec2& size);
  // All texels, channels interleaved.
  void upload(std::span<const float> values);
  void download(std::span<float> values) const;
  // Copies all texels as floats to so many bytes from the start, without waiting.
  void copy(HostBuffer& to, std::size_t offset) const;
  void release() {
    object_.reset();
    size_ = glm::ivec2(0);
  }
  void abandon() { object_.abandon(); }
  // Sets all channels of all texels.
  void fill(float value);
  void bind_image(unsigned unit) const;  // read and write

 private:
  Object object_;
  Format format_ = Format::r32f;
  glm::ivec2 size_{0};
};

// The value of a uniform of a shader.
using Uniform = std::variant<int, unsigned, float, double, glm::vec2, glm::vec3, glm::vec4,
                             glm::ivec2, glm::ivec4, glm::dvec3, std::span<const float>>;

// A compute program. Throws Error with the compiler's log.
class Program {
 public:
  Program() = default;
  // See shader_source().
  explicit Program(const std::string& name);
  // A complete shader, named in messages.
  Program(const std::string& name, const std::string& complete);

  void set(const char* uniform, const Uniform& value) const;
  // Binds what a shader calls so: a storage block or an image. What the compiler has removed is
  // ignored, as uniforms are.
  void bind(const char* block, Buffer& buffer) const;
  void bind(const char* image, const Texture& texture) const;
  // Dispatches work groups, followed by a memory barrier.
  void dispatch(std::size_t x, std::size_t y = 1) const;
  // Dispatches at least that many work groups in a linear order; see shaders/linear.glsl.
  void dispatch_linear(std::size_t groups) const;
  // The same for at least that many invocations.
  void dispatch_over(const glm::ivec2& invocations) const;
  void dispatch_linear_over(std::size_t invocations) const;
  // Invocations of a work group along each axis.
  [[nodiscard]] const glm::ivec2& group_size() const { return group_size_; }

 private:
  [[nodiscard]] int location(const char* uniform) const;

  Object object_;
  glm::ivec2 group_size_{1};
};

// GPU time between begin() and end(), available asynchronously.
class Timer {
 public:
  void begin();
  void end();
  // Waits for the result.
  [[nodiscard]] double milliseconds() const;

 private:
  Object first_, last_;
};

// A fence in a command stream, visible to all contexts that share objects.
class Fence {
 public:
  Fence() = default;
  ~Fence() { reset(); }
  Fence(const Fence&) = delete;
  Fence& operator=(const Fence&) = delete;

  // Places the fence here, replacing the previous one.
  void set();
  // Waits for the fence, then removes it. Throws Error if the device does not respond.
  void wait();
  void abandon();  // as Object

 private:
  void reset();
  void* sync_ = nullptr;  // null: not set
};

// Waits until all submitted commands have completed.
void finish();

// Throws Error where the context is lost or OpenGL has reported an error since the last call.
void check(const char* what);

}  // namespace brume::gl
