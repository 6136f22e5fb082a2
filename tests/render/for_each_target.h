#pragma once

#include <gtest/gtest.h>
#include <hwy/targets.h>

namespace brume {

// Runs the body once for each instruction set that was compiled and that this machine has.
template <class Body>
void for_each_target(Body body) {
  int targets = 0;
  for (const auto target : hwy::SupportedAndGeneratedTargets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    body();
    ++targets;
  }
  hwy::SetSupportedTargetsForTest(0);
  EXPECT_GT(targets, 0);
}

}  // namespace brume
