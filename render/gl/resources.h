#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace brume::gl {

// What OpenGL refused: memory, a shader, a lost context. The frame is then made elsewhere.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};
// Another frame may need less.
class OutOfMemory : public Error {
 public:
  using Error::Error;
};

// Objects of the current context, each owned by one value: buffers, textures, programs, queries and
// fences.
// Everything here needs the context that made it to be current, destructors too.

// How many of them live: what leaks is seen there.
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
  // Its contexts are gone, and it with them.
  void abandon();
  [[nodiscard]] unsigned name() const { return name_; }
  explicit operator bool() const { return name_ != 0; }

 private:
  Kind kind_ = Kind::buffer;
  unsigned name_ = 0;  // 0: none
};

// Bytes on the device. Throws OutOfMemory where there is no memory for them.
class Buffer {
 public:
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  [[nodiscard]] unsigned name() const { return object_.name(); }

  // Makes room for that much, at least; what was in it may be lost.
  void reserve(std::size_t bytes);
  // Takes what is there, and has room for it.
  template <class T>
  void upload(std::span<const T> values) {
    upload_bytes(values.data(), values.size_bytes());
  }
  // Reads from the beginning on; waits for the device.
  template <class T>
  void download(std::span<T> values) const {
    download_bytes(values.data(), values.size_bytes());
  }
  // All bytes 0.
  void clear();
  void release() {
    object_.reset();
    bytes_ = 0;
  }
  // As shader storage block `binding` of the next dispatch. An empty one gets some bytes first.
  // Throws OutOfMemory where it is larger than a block may be.
  void bind(unsigned binding);

 private:
  void upload_bytes(const void* data, std::size_t bytes);
  void download_bytes(void* data, std::size_t bytes) const;

  Object object_;
  std::size_t bytes_ = 0;
};

// A 2-D texture without mipmaps, never interpolated. Throws OutOfMemory where there is no memory
// for it.
class Texture {
 public:
  enum class Format { r32f, rgba32f, rgba8 };

  [[nodiscard]] const glm::ivec2& size() const { return size_; }
  [[nodiscard]] unsigned name() const { return object_.name(); }

  // Makes it one of that size, unless it is; what was in it may be lost.
  void reserve(Format format, const glm::ivec2& size);
  // All texels; as many floats as the format has channels for each.
  void upload(std::span<const float> values);
  void download(std::span<float> values) const;
  void release() {
    object_.reset();
    size_ = glm::ivec2(0);
  }
  void abandon() { object_.abandon(); }
  // All channels of all texels.
  void fill(float value);
  void bind_image(unsigned unit) const;  // to read and to write

 private:
  Object object_;
  Format format_ = Format::r32f;
  glm::ivec2 size_{0};
};

// A compute shader. Throws Error with what the compiler says.
class Program {
 public:
  Program() = default;
  // See shader_source().
  explicit Program(const std::string& name);

  void set(const char* uniform, int value) const;
  void set(const char* uniform, unsigned value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, double value) const;
  void set(const char* uniform, std::span<const float> values) const;
  void set(const char* uniform, const glm::ivec2& value) const;
  void set(const char* uniform, const glm::vec2& value) const;
  void set(const char* uniform, const glm::vec3& value) const;
  void set(const char* uniform, const glm::dvec3& value) const;
  void set(const char* uniform, const glm::vec4& value) const;
  void set(const char* uniform, const glm::ivec4& value) const;
  // Runs it over so many work groups; what it writes is there for what comes after.
  void dispatch(std::size_t x, std::size_t y = 1) const;
  // Over that many in a row, at least: see shaders/linear.glsl.
  void dispatch_linear(std::size_t groups) const;

 private:
  [[nodiscard]] int location(const char* uniform) const;

  Object object_;
};

// Milliseconds that the device spends between begin() and end(), known some time later.
class Timer {
 public:
  void begin();
  void end();
  // Waits for the device.
  [[nodiscard]] double milliseconds() const;

 private:
  Object first_, last_;
};

// A point in what a context sends to the device, known to all contexts that share its objects.
class Fence {
 public:
  Fence() = default;
  ~Fence() { reset(); }
  Fence(const Fence&) = delete;
  Fence& operator=(const Fence&) = delete;

  // Here, instead of where it was.
  void set();
  // Until the device is there; then it is nowhere. Throws Error where the device does not answer.
  void wait();
  void abandon();  // as Object

 private:
  void reset();
  void* sync_ = nullptr;  // null: nowhere
};

// Until the device has done all that was sent.
void finish();

// Throws Error where the context is lost or OpenGL has reported an error since the last call.
void check(const char* what);

}  // namespace brume::gl
