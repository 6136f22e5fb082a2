// The hard cases of resources/hard_cases, on the CPU, against what their pixels are, which was
// computed elsewhere to eleven digits.

#include "tools/bench/measure/hard_cases.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/render/test_scenes.h"

namespace brume {
namespace {

const std::vector<HardCase>& hard_cases() {
  static const std::vector<HardCase> cases = load_hard_cases();
  return cases;
}

class HardCases : public testing::TestWithParam<HardCase> {};

TEST_P(HardCases, MatchTheGoldenValues) {
  const HardCase& hard_case = GetParam();
  const HardCaseErrors errors = measure_hard_case(hard_case);
  EXPECT_LE(errors.reference.airlight, hard_case_reference_bound);
  EXPECT_LE(errors.sliced.airlight, hard_case.bound);
  EXPECT_LE(errors.paper, hard_case_paper_bound);
  EXPECT_TRUE(errors.automatic.airlight <= hard_case_max_error || errors.automatic.is_told)
      << "auto is off by " << errors.automatic.airlight << " and does not tell";
  EXPECT_LE(errors.reference.transmittance, hard_case_transmittance_bound);
  EXPECT_LE(errors.sliced.transmittance, hard_case_transmittance_bound);
}

TEST_P(HardCases, AreFiniteInEveryLayer) {
  for (const AirlightMethod method : {AirlightMethod::paper, AirlightMethod::sliced,
                                      AirlightMethod::reference, AirlightMethod::path}) {
    for (const int scale : {1, 4}) {
      Settings settings;
      settings.airlight = method;
      settings.paths = 2;
      settings.airlight_scale = scale;
      expect_finite(render_frame(GetParam().scene, settings));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, HardCases, testing::ValuesIn(hard_cases()), [](const auto& instance) {
  std::string name = instance.param.name;
  std::ranges::replace(name, '.', '_');
  return name;
});

TEST(HardCase, BoundsAboveOnePercentHaveAReason) {
  EXPECT_GE(hard_cases().size(), 40u);
  for (const HardCase& hard_case : hard_cases()) {
    EXPECT_EQ(hard_case.bound > 0.01, !hard_case.why.empty()) << hard_case.name;
    EXPECT_FALSE(hard_case.breaks.empty() || hard_case.remedy.empty()) << hard_case.name;
  }
}

}  // namespace
}  // namespace brume
