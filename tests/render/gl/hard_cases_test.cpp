// The hard cases of resources/hard_cases on the device.

#include "tools/bench/measure/hard_cases.h"

#include <gtest/gtest.h>

#include "render/gl_renderer.h"

namespace brume {
namespace {

TEST(GlHardCases, MatchTheGoldenValues) {
  std::string problem;
  const std::unique_ptr<GlRenderer> gl = GlRenderer::create(nullptr, problem, true);
  ASSERT_TRUE(gl) << problem;
  for (const HardCase& hard_case : load_hard_cases()) {
    const HardCaseError error = sliced_error(*gl, hard_case);
    EXPECT_LE(error.airlight, hard_case.bound) << hard_case.name;
    EXPECT_LE(error.transmittance, hard_case_transmittance_bound) << hard_case.name;
  }
}

}  // namespace
}  // namespace brume
