#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "render/gl/device.h"
#include "render/gl/egl_context.h"
#include "render/gl/failures.h"
#include "render/gl/resources.h"

namespace brume::gl {

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
