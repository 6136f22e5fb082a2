// The context, what it says of itself, and the objects that passes are made of.

#include "render/gl/device.h"

#include <epoxy/gl.h>

#include <glm/vec4.hpp>
#include <thread>
#include <vector>

#include "render/gl/resources.h"
#include "render/gl/shader_source.h"
#include "tests/render/gl/gl_frames.h"

namespace brume::gl {
namespace {

const Device able{"A GPU", 4, 6, false, 1 << 30, 49152, 1024, 16, 32768};

TEST(Device, RecognizesSoftwareRenderers) {
  for (const char* name : {"llvmpipe (LLVM 15.0.6, 256 bits)", "softpipe", "Software Rasterizer"}) {
    EXPECT_TRUE(is_software_renderer(name)) << name;
  }
  for (const char* name : {"NVIDIA H100 PCIe/PCIe/SSE2", "AMD Radeon RX 7900 (radeonsi)",
                           "Mesa Intel(R) Graphics (ADL GT2)"}) {
    EXPECT_FALSE(is_software_renderer(name)) << name;
  }
}

TEST(Device, ReportsMissingFeatures) {
  EXPECT_EQ(missing_feature(able), "");
  Device device = able;
  device.minor = 4;
  EXPECT_EQ(missing_feature(device), "OpenGL 4.5 is required, A GPU has 4.4");
  device = able;
  device.shared_bytes = 16384;
  EXPECT_EQ(missing_feature(device),
            "A GPU offers 16384 bytes shared by a work group; 32768 are required");
}

using InContext = GlTest;

TEST_F(InContext, RunsThePasses) {
  const Device device = current_device();
  EXPECT_NE(device.name, "");
  EXPECT_EQ(missing_feature(device), "");
}

TEST_F(InContext, ContextsThatShareSeeTheSameTextures) {
  const std::vector<float> values{1.0f, 2.0f, 3.0f, 4.0f};
  Texture texture;
  texture.reserve(Texture::Format::rgba32f, {1, 1});
  texture.upload(values);
  glFinish();
  std::vector<float> seen(4);
  std::thread([&] {
    const auto other = context_->create_sharing();
    ASSERT_TRUE(other && other->is_current());
    texture.download(seen);
  }).join();
  EXPECT_EQ(seen, values);
  EXPECT_TRUE(context_->is_current());
}

TEST_F(InContext, MessagesAreCollected) {
  glEnable(GL_TEXTURE_BINDING_2D);  // not something to enable
  EXPECT_NE(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  EXPECT_EQ(messages_->collect().size(), 1u);
  EXPECT_TRUE(messages_->collect().empty());
}

TEST_F(InContext, BuffersKeepWhatTheyTake) {
  std::vector<float> values(1000);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i);
  Buffer buffer;
  buffer.upload(std::span<const float>(values));
  const unsigned first = buffer.name();
  std::vector<float> back(values.size());
  buffer.download(std::span(back));
  EXPECT_EQ(back, values);
  // A little more fits into the same; much more does not.
  buffer.reserve(4100);
  EXPECT_EQ(buffer.name(), first);
  buffer.reserve(100'000);
  EXPECT_GE(buffer.bytes(), 100'000u);
  buffer.clear();
  buffer.download(std::span(back));
  EXPECT_EQ(back, std::vector<float>(values.size(), 0.0f));
  EXPECT_EQ(live_objects(), objects_ + 1);
}

TEST_F(InContext, BuffersThatShadersCannotReachAreRefused) {
  GLint64 max_bytes = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &max_bytes);
  constexpr GLint64 affordable = 1 << 28;
  if (max_bytes > affordable) return;  // of a GPU: more than a test should take
  Buffer buffer;
  buffer.reserve(static_cast<std::size_t>(max_bytes));  // and some room beyond
  EXPECT_THROW(buffer.bind(0), OutOfMemory);
}

TEST_F(InContext, TexturesKeepWhatTheyTake) {
  for (const glm::ivec2 size : {glm::ivec2(5, 3), glm::ivec2(64, 2)}) {
    std::vector<float> values(static_cast<std::size_t>(4 * size.x * size.y));
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = 0.5f * static_cast<float>(i);
    Texture texture;
    texture.reserve(Texture::Format::rgba32f, size);
    texture.upload(values);
    std::vector<float> back(values.size());
    texture.download(back);
    EXPECT_EQ(back, values);
    texture.fill(-1.0f);
    texture.download(back);
    EXPECT_EQ(back, std::vector<float>(values.size(), -1.0f));
  }
}

TEST_F(InContext, ObjectsGoWithTheirOwners) {
  const std::size_t before = live_objects();
  {
    Buffer buffer;
    buffer.reserve(10);
    Texture texture;
    texture.reserve(Texture::Format::r32f, {8, 8});
    Timer timer;
    timer.begin();
    timer.end();
    EXPECT_GE(timer.milliseconds(), 0.0);
    EXPECT_EQ(live_objects(), before + 4);
    const Buffer moved = std::move(buffer);
    EXPECT_EQ(live_objects(), before + 4);
  }
  EXPECT_EQ(live_objects(), before);
}

TEST_F(InContext, FailuresThrow) {
  EXPECT_THROW(shader_source("none.glsl"), Error);
  failures().shader = true;
  EXPECT_THROW(Program("composite.glsl"), Error);
  failures() = {};
  failures().memory = true;
  Buffer buffer;
  EXPECT_THROW(buffer.reserve(1000), OutOfMemory);
  failures() = {};
  failures().context = true;
  EXPECT_THROW(check("a test"), Error);
  failures() = {};
  EXPECT_NO_THROW(check("a test"));
  messages_->collect();  // of the broken shader
}

TEST_F(InContext, CompositeAttenuatesTheBackground) {
  const glm::ivec2 size(19, 9);  // no multiple of the work groups'
  const auto pixels = static_cast<std::size_t>(size.x * size.y);
  std::vector<glm::vec4> medium(pixels);
  std::vector<glm::vec4> surface(pixels);
  std::vector<float> distances(pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    const auto x = static_cast<float>(i) / static_cast<float>(pixels);
    medium[i] = {x, 2.0f * x, 0.0f, 1.0f - x};
    surface[i] = {1.0f, x, 3.0f, 0.0f};
    distances[i] = i % 2 == 0 ? 2.0f : -1.0f;
  }
  const auto upload = [&](Texture& texture, const std::vector<glm::vec4>& values) {
    texture.reserve(Texture::Format::rgba32f, size);
    texture.upload({&values[0].x, 4 * pixels});
  };
  Texture airlight;
  Buffer behind;
  Texture beauty;
  Texture depth;
  Buffer no_sky;
  upload(airlight, medium);
  behind.upload(std::span<const glm::vec4>(surface));
  beauty.reserve(Texture::Format::rgba32f, size);
  depth.reserve(Texture::Format::r32f, size);
  depth.upload(distances);
  const Program program("composite.glsl");
  program.set("film", size);
  program.bind("Sky", no_sky);
  program.bind("airlight", airlight);
  program.bind("Behind", behind);
  program.bind("beauty", beauty);
  program.bind("depths", depth);
  program.dispatch_over(size);
  check("composite");
  std::vector<glm::vec4> result(pixels);
  beauty.download({&result[0].x, 4 * pixels});
  for (std::size_t i = 0; i < pixels; ++i) {
    const glm::vec4& m = medium[i];
    const glm::vec4 s = i % 2 == 0 ? surface[i] : glm::vec4(0.0f);
    for (int c = 0; c < 3; ++c) EXPECT_FLOAT_EQ(result[i][c], m[c] + m.w * s[c]) << i;
    EXPECT_FLOAT_EQ(result[i].w, i % 2 == 0 ? 1.0f : 1.0f - m.w) << i;
  }
}

}  // namespace
}  // namespace brume::gl
