// A plan may leave stages out, and where one is needed it is there.

#include "tools/bench/measure/plan_decisions.h"

#include <gtest/gtest.h>

#include "render/render_plan.h"

namespace brume {
namespace {

class PlanDecisions : public testing::TestWithParam<PlanDecision> {};

TEST_P(PlanDecisions, LeaveOutNothingThatIsSeen) {
  const PlanDecision& decision = GetParam();
  const Frame left_out = render_planned(decision.left_out, decision.method);
  const Frame made = render_planned(decision.made, decision.method);
  const Frame needed = render_planned(decision.needed, decision.method);

  ASSERT_TRUE(leaves_out(left_out, decision));
  EXPECT_FALSE(leaves_out(made, decision));
  EXPECT_FALSE(leaves_out(needed, decision));
  bool why_is_said = false;
  for (const SkippedStage& skipped : left_out.statistics.skipped) {
    why_is_said |= skipped.stage == decision.stage && skipped.why == decision.why;
  }
  EXPECT_TRUE(why_is_said);

  // A billionth of it, and what single precision and light tables of other bounds make of the rest.
  EXPECT_LT(max_change(left_out, made, needed), 2e-3);
  EXPECT_GT(max_change(left_out, needed, needed), 2e-2);
}

INSTANTIATE_TEST_SUITE_P(All, PlanDecisions, testing::ValuesIn(plan_decisions()),
                         [](const auto& instance) {
                           return std::string(to_string(instance.param.stage));
                         });

// No decision is missing here: all that plans of empty and of dark scenes leave out has its own.
TEST(PlanDecision, EachHasItsScenes) {
  StageSet known;
  for (const PlanDecision& decision : plan_decisions()) known.add(decision.stage);
  for (const PlanDecision& decision : plan_decisions()) {
    for (const Scene* scene : {&decision.left_out, &decision.made, &decision.needed}) {
      for (const AirlightMethod method : {AirlightMethod::paper, AirlightMethod::sliced,
                                          AirlightMethod::reference, AirlightMethod::path}) {
        Settings settings;
        settings.airlight = method;
        for (const SkippedStage& skipped : RenderPlan(*scene, scene->film, settings).skipped) {
          EXPECT_TRUE(known.has(skipped.stage)) << to_string(skipped.stage);
        }
      }
    }
  }
}

}  // namespace
}  // namespace brume
