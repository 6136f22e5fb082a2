#include "tests/render/gl/gl_test.h"

namespace brume::gl {

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
