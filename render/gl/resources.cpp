#include "render/gl/resources.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <glm/gtc/type_ptr.hpp>

#include "core/overloaded.h"
#include "render/gl/failures.h"
#include "render/gl/shader_source.h"

namespace brume::gl {
namespace {

std::atomic<std::size_t> live = 0;  // each context has a thread of its own

struct FormatNames {
  GLenum internal, channels;
};

FormatNames names_of(Texture::Format format) {
  switch (format) {
    case Texture::Format::r32f:
      return {GL_R32F, GL_RED};
    case Texture::Format::rgba32f:
      return {GL_RGBA32F, GL_RGBA};
    case Texture::Format::rgba8:
      return {GL_RGBA8, GL_RGBA};
  }
  return {};
}

std::string megabytes(std::size_t bytes) {
  return std::to_string((bytes >> 20) + 1) + " MiB";
}

void check_memory(const std::string& wanted) {
  if (failures().memory) throw OutOfMemory("out of device memory for " + wanted);
  check(("allocating " + wanted).c_str());
}

// The info log of an object; `get` is glGetShaderInfoLog or similar.
template <class Get>
std::string log_of(GLint length, Get get) {
  std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
  GLsizei written = 0;
  get(static_cast<GLsizei>(log.size()), &written, log.data());
  log.resize(static_cast<std::size_t>(written));
  return log;
}

}  // namespace

std::size_t live_objects() {
  return live;
}

Object::Object(Kind kind, unsigned name) : kind_(kind), name_(name) {
  if (name_ == 0) throw Error("OpenGL cannot create objects; the context may be lost");
  ++live;
}

void Object::reset() {
  if (name_ == 0) return;
  switch (kind_) {
    case Kind::buffer:
      glDeleteBuffers(1, &name_);
      break;
    case Kind::texture:
      glDeleteTextures(1, &name_);
      break;
    case Kind::program:
      glDeleteProgram(name_);
      break;
    case Kind::query:
      glDeleteQueries(1, &name_);
      break;
  }
  name_ = 0;
  --live;
}

void Object::abandon() {
  if (name_ == 0) return;
  name_ = 0;
  --live;
}

void Buffer::reserve(std::size_t bytes) {
  if (bytes <= bytes_ && object_) return;
  release();
  // With room to grow, so that media that are painted do not make a new one with every stroke.
  const std::size_t room = (bytes + bytes / 4 + 63) / 64 * 64 + 64;
  GLuint name = 0;
  glCreateBuffers(1, &name);
  Object made(Kind::buffer, name);
  glNamedBufferStorage(name, static_cast<GLsizeiptr>(room), nullptr, GL_DYNAMIC_STORAGE_BIT);
  check_memory(megabytes(room));
  object_ = std::move(made);
  bytes_ = room;
}

void HostBuffer::reserve(std::size_t bytes) {
  if (bytes <= bytes_ && object_) return;
  object_.reset();
  bytes_ = 0;
  GLuint name = 0;
  glCreateBuffers(1, &name);
  Object made(Kind::buffer, name);
  const auto size = static_cast<GLsizeiptr>(bytes);
  constexpr GLbitfield access = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
  glNamedBufferStorage(name, size, nullptr, access | GL_CLIENT_STORAGE_BIT);
  check_memory(megabytes(bytes));
  values_ = static_cast<const float*>(glMapNamedBufferRange(name, 0, size, access));
  if (!values_) throw OutOfMemory("out of memory for " + megabytes(bytes));
  object_ = std::move(made);
  bytes_ = bytes;
}

std::span<const float> HostBuffer::wait() {
  finish();
  return {values_, bytes_ / sizeof(float)};
}

void Buffer::upload_bytes(const void* data, std::size_t bytes) {
  reserve(bytes);
  if (bytes > 0) glNamedBufferSubData(name(), 0, static_cast<GLsizeiptr>(bytes), data);
}

void Buffer::download_bytes(void* data, std::size_t bytes) const {
  if (bytes > 0) glGetNamedBufferSubData(name(), 0, static_cast<GLsizeiptr>(bytes), data);
}

void Buffer::clear() {
  reserve(0);
  glClearNamedBufferData(name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
}

void Buffer::bind(unsigned binding) {
  reserve(0);
  GLint64 max_value = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &max_value);
  if (static_cast<GLint64>(bytes_) > max_value) {
    throw OutOfMemory("the device does not support storage blocks of " + megabytes(bytes_));
  }
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, name());
}

namespace {

// Llvmpipe compiles programs anew where sides of images become, or are no longer, powers of two.
glm::ivec2 allocated(Texture::Format format, const glm::ivec2& size) {
  constexpr int longest = 16384;                      // that any device supports
  if (format == Texture::Format::rgba8) return size;  // whole pictures are handed on
  const auto rounded = [](int n) {
    while (n < longest && std::has_single_bit(static_cast<unsigned>(n))) ++n;
    return n;
  };
  return {rounded(size.x), rounded(size.y)};
}

}  // namespace

void Texture::reserve(Format format, const glm::ivec2& size) {
  if (object_ && format == format_ && size == size_) return;
  release();
  GLuint name = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &name);
  Object made(Kind::texture, name);
  const glm::ivec2 storage = allocated(format, size);
  glTextureStorage2D(name, 1, names_of(format).internal, storage.x, storage.y);
  check_memory("a texture of " + std::to_string(size.x) + " x " + std::to_string(size.y));
  object_ = std::move(made);
  format_ = format;
  size_ = size;
}

void Texture::upload(std::span<const float> values) {
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTextureSubImage2D(name(), 0, 0, 0, size_.x, size_.y, names_of(format_).channels, GL_FLOAT,
                      values.data());
}

void Texture::download(std::span<float> values) const {
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glGetTextureSubImage(name(), 0, 0, 0, 0, size_.x, size_.y, 1, names_of(format_).channels,
                       GL_FLOAT, static_cast<GLsizei>(values.size_bytes()), values.data());
}

void Texture::copy(HostBuffer& to, std::size_t offset) const {
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, to.name());
  const auto room =
      static_cast<GLsizei>(std::size_t{4} * sizeof(float) * static_cast<std::size_t>(size_.x) *
                           static_cast<std::size_t>(size_.y));
  glGetTextureSubImage(name(), 0, 0, 0, 0, size_.x, size_.y, 1, names_of(format_).channels,
                       GL_FLOAT, room, reinterpret_cast<void*>(offset));
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glFlush();
}

void Texture::fill(float value) {
  const std::array<float, 4> texel{value, value, value, value};
  glClearTexImage(name(), 0, names_of(format_).channels, GL_FLOAT, texel.data());
}

void Texture::bind_image(unsigned unit) const {
  glBindImageTexture(unit, name(), 0, GL_FALSE, 0, GL_READ_WRITE, names_of(format_).internal);
}

Program::Program(const std::string& name) : Program(name, shader_source(name)) {}

Program::Program(const std::string& name, const std::string& complete) {
  const std::string text = failures().shader ? "broken" : complete;
  const GLuint shader = glCreateShader(GL_COMPUTE_SHADER);
  const char* const source = text.c_str();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint compiled = 0;
  GLint length = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  const std::string compiler = log_of(length, [&](auto size, auto written, auto to) {
    glGetShaderInfoLog(shader, size, written, to);
  });
  object_ = Object(Kind::program, glCreateProgram());
  const GLuint program = object_.name();
  glAttachShader(program, shader);
  glLinkProgram(program);
  glDetachShader(program, shader);
  glDeleteShader(shader);
  if (!compiled) throw Error("the driver rejects shader " + name + ": " + compiler);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked) {
    std::array<GLint, 3> size{};
    glGetProgramiv(program, GL_COMPUTE_WORK_GROUP_SIZE, size.data());
    group_size_ = {size[0], size[1]};
    return;
  }
  glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
  throw Error("the driver rejects shader " + name + ": " +
              log_of(length, [&](auto size, auto written, auto to) {
                glGetProgramInfoLog(program, size, written, to);
              }));
}

int Program::location(const char* uniform) const {
  return glGetUniformLocation(object_.name(), uniform);
}

void Program::set(const char* uniform, const Uniform& value) const {
  const GLuint program = object_.name();
  const GLint place = location(uniform);
  std::visit(
      Overloaded{
          [&](int x) { glProgramUniform1i(program, place, x); },
          [&](unsigned x) { glProgramUniform1ui(program, place, x); },
          [&](float x) { glProgramUniform1f(program, place, x); },
          [&](double x) { glProgramUniform1d(program, place, x); },
          [&](const glm::vec2& v) { glProgramUniform2fv(program, place, 1, glm::value_ptr(v)); },
          [&](const glm::vec3& v) { glProgramUniform3fv(program, place, 1, glm::value_ptr(v)); },
          [&](const glm::vec4& v) { glProgramUniform4fv(program, place, 1, glm::value_ptr(v)); },
          [&](const glm::ivec2& v) { glProgramUniform2iv(program, place, 1, glm::value_ptr(v)); },
          [&](const glm::ivec4& v) { glProgramUniform4iv(program, place, 1, glm::value_ptr(v)); },
          [&](const glm::dvec3& v) { glProgramUniform3dv(program, place, 1, glm::value_ptr(v)); },
          [&](std::span<const float> values) {
            glProgramUniform1fv(program, place, static_cast<GLsizei>(values.size()), values.data());
          }},
      value);
}

void Program::bind(const char* block, Buffer& buffer) const {
  const GLuint index = glGetProgramResourceIndex(object_.name(), GL_SHADER_STORAGE_BLOCK, block);
  if (index == GL_INVALID_INDEX) return;
  constexpr GLenum property = GL_BUFFER_BINDING;
  GLint binding = 0;
  glGetProgramResourceiv(object_.name(), GL_SHADER_STORAGE_BLOCK, index, 1, &property, 1, nullptr,
                         &binding);
  buffer.bind(static_cast<unsigned>(binding));
}

void Program::bind(const char* image, const Texture& texture) const {
  const GLint uniform = location(image);
  if (uniform < 0) return;
  GLint unit = 0;
  glGetUniformiv(object_.name(), uniform, &unit);
  texture.bind_image(static_cast<unsigned>(unit));
}

void Program::dispatch_linear(std::size_t groups) const {
  constexpr std::size_t across = 32768;
  dispatch(std::min(groups, across), (groups + across - 1) / across);
}

void Program::dispatch_over(const glm::ivec2& invocations) const {
  const glm::ivec2 groups = (invocations + group_size_ - 1) / group_size_;
  dispatch(static_cast<std::size_t>(groups.x), static_cast<std::size_t>(groups.y));
}

void Program::dispatch_linear_over(std::size_t invocations) const {
  const auto size = static_cast<std::size_t>(group_size_.x);
  dispatch_linear((invocations + size - 1) / size);
}

void Program::dispatch(std::size_t x, std::size_t y) const {
  if (x == 0 || y == 0) return;
  glUseProgram(object_.name());
  glDispatchCompute(static_cast<GLuint>(x), static_cast<GLuint>(y), 1);
  glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

void Timer::begin() {
  const auto make = [](Object& query) {
    if (query) return;
    GLuint name = 0;
    glCreateQueries(GL_TIMESTAMP, 1, &name);
    query = Object(Kind::query, name);
  };
  make(first_);
  make(last_);
  glQueryCounter(first_.name(), GL_TIMESTAMP);
}

void Timer::end() {
  glQueryCounter(last_.name(), GL_TIMESTAMP);
}

double Timer::milliseconds() const {
  GLuint64 first = 0;
  GLuint64 last = 0;
  glGetQueryObjectui64v(first_.name(), GL_QUERY_RESULT, &first);
  glGetQueryObjectui64v(last_.name(), GL_QUERY_RESULT, &last);
  return 1e-6 * static_cast<double>(last - first);
}

void Fence::set() {
  reset();
  sync_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  if (!sync_) return;  // the context is lost, and there is nothing to wait for
  ++live;
  glFlush();  // or else another context would wait for ever
}

void Fence::wait() {
  if (!sync_) return;
  constexpr GLuint64 patience = 10'000'000'000;  // nanoseconds
  const GLenum answer = glClientWaitSync(static_cast<GLsync>(sync_), 0, patience);
  reset();
  if (answer == GL_TIMEOUT_EXPIRED || answer == GL_WAIT_FAILED) {
    throw Error("the device does not respond");
  }
}

void Fence::reset() {
  if (!sync_) return;
  glDeleteSync(static_cast<GLsync>(sync_));
  abandon();
}

void Fence::abandon() {
  if (!sync_) return;
  sync_ = nullptr;
  --live;
}

void finish() {
  glFinish();
}

void check(const char* what) {
  const GLenum reset = failures().context ? GL_UNKNOWN_CONTEXT_RESET : glGetGraphicsResetStatus();
  if (reset != GL_NO_ERROR) throw Error(std::string("the context was lost at ") + what);
  const GLenum error = glGetError();
  if (error == GL_OUT_OF_MEMORY)
    throw Error(std::string("the device ran out of memory at ") + what);
  if (error != GL_NO_ERROR) {
    throw Error("OpenGL error " + std::to_string(error) + " at " + what);
  }
}

}  // namespace brume::gl
