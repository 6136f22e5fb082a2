#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "brume/scene.h"
#include "render/gl/device.h"
#include "render/gl/egl_context.h"
#include "render/gl/failures.h"
#include "render/gl/resources.h"
#include "render/gl_renderer.h"

namespace brume::gl {

// Both backends make tables alike; small ones are quicker.
Settings quick_slices();

// Collects driver messages (KHR_debug) of the context current at construction, except
// notifications. Must be destroyed before the context.
class Messages {
 public:
  Messages();
  ~Messages();
  Messages(const Messages&) = delete;
  Messages& operator=(const Messages&) = delete;

  // Messages since the last call.
  std::vector<std::string> collect();

 private:
  std::vector<std::string> messages_;
};

// A renderer whose driver's messages are failures.
class GlFrames : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;
  Frame render(const Scene& scene, const Settings& settings);
  // A frame that the device has made.
  Frame render_on_device(const Scene& scene, const Settings& settings, const std::string& what);
  // That few slices and a grid differ by at most 2e-3 between the backends.
  void expect_backends_agree(const Scene& scene, Scattering scattering);

  std::unique_ptr<GlRenderer> gl_;
  std::unique_ptr<Messages> messages_;
  std::size_t objects_ = 0;
};

// A context for a test, in which every message of the driver and every object that is left over is
// a failure.
class GlTest : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;
  // Fails for what the driver has said since it was last asked.
  void expect_no_messages();

  std::unique_ptr<EglContext> context_;
  std::unique_ptr<Messages> messages_;
  std::size_t objects_ = 0;  // at the beginning
};

enum class TestedBackend { cpu, device };

// What is promised of a stage on both backends; `State` has the objects of a context.
template <class State>
class BothBackends : public GlTest {
 protected:
  State& device() {
    if (!device_) device_ = std::make_unique<State>();
    return *device_;
  }
  void TearDown() override {
    device_.reset();
    GlTest::TearDown();
  }

 private:
  std::unique_ptr<State> device_;
};

}  // namespace brume::gl
