#include "tests/render/gl/gl_frames.h"

#include <epoxy/gl.h>

#include <string_view>
#include <utility>

#include "tests/render/test_scenes.h"

namespace brume::gl {
namespace {

void next_message(GLenum, GLenum type, GLuint, GLenum severity, GLsizei length, const GLchar* text,
                  const void* to) {
  if (severity == GL_DEBUG_SEVERITY_NOTIFICATION || type == GL_DEBUG_TYPE_PERFORMANCE) return;
  auto& messages = *static_cast<std::vector<std::string>*>(const_cast<void*>(to));
  // A driver that complains in every call must not fill the memory.
  constexpr std::size_t max_value = 1000;
  if (messages.size() >= max_value) return;
  messages.emplace_back(
      text, length >= 0 ? static_cast<std::size_t>(length) : std::string_view(text).size());
}

}  // namespace

Messages::Messages() {
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(next_message, &messages_);
}

Messages::~Messages() {
  glDebugMessageCallback(nullptr, nullptr);
}

std::vector<std::string> Messages::collect() {
  return std::exchange(messages_, {});
}

Settings quick_slices() {
  Settings settings = sliced_settings({}, 12);
  settings.optical_depth_table = {48, 24};
  settings.shadow_cells = 96;
  settings.source_grid = {200, 12};
  settings.mirrors = false;  // the device has none
  return settings;
}

void GlFrames::SetUp() {
  std::string problem;
  objects_ = live_objects();
  gl_ = GlRenderer::create(nullptr, problem, true);
  ASSERT_TRUE(gl_) << problem;
  ASSERT_TRUE(gl_->context().make_current());
  messages_ = std::make_unique<Messages>();
  gl_->context().done_current();
}

void GlFrames::TearDown() {
  failures() = {};
  if (!gl_) return;
  ASSERT_TRUE(gl_->context().make_current());
  for (const std::string& message : messages_->collect()) ADD_FAILURE() << message;
  messages_.reset();
  gl_.reset();
  EXPECT_EQ(live_objects(), objects_) << "objects were left over";
}

Frame GlFrames::render(const Scene& scene, const Settings& settings) {
  return *gl_->render(scene, scene.camera, scene.film, settings);
}

Frame GlFrames::render_on_device(const Scene& scene, const Settings& settings,
                                 const std::string& what) {
  Frame frame = render(scene, settings);
  EXPECT_EQ(frame.statistics.backend, "gl") << what;
  for (const SkippedStage& stage : frame.statistics.on_cpu) {
    EXPECT_NE(stage.stage, Stage::frame) << what << ": " << stage.why;
  }
  return frame;
}

void GlFrames::expect_backends_agree(const Scene& scene, Scattering scattering) {
  Settings settings = quick_slices();
  settings.source_grid = {2000, 24};
  settings.scattering = scattering;
  // The CPU solves for both; the device looks up whatever that is.
  settings.scattering_limits = {.degree = 3, .light_degree = 5, .sweeps = 4};
  const Frame cpu = render_frame(scene, settings);
  const Frame gl = render_on_device(scene, settings, "frame");
  EXPECT_LE(rel_rmse(gl.airlight, cpu.airlight), 2e-3);
  EXPECT_LE(rel_rmse(gl.beauty, cpu.beauty), 2e-3);
}

void GlTest::SetUp() {
  std::string problem;
  context_ = EglContext::create(&problem, true);
  ASSERT_TRUE(context_) << problem;
  messages_ = std::make_unique<Messages>();
  objects_ = live_objects();
}

void GlTest::TearDown() {
  if (!context_) return;
  failures() = {};
  ASSERT_TRUE(context_->make_current());
  expect_no_messages();
  EXPECT_EQ(live_objects(), objects_) << "objects were left over";
  messages_.reset();
}

void GlTest::expect_no_messages() {
  for (const std::string& message : messages_->collect()) ADD_FAILURE() << message;
}

}  // namespace brume::gl
