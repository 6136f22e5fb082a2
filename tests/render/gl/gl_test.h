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

}  // namespace brume::gl
