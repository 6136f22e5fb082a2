// brume render --scattering.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/contains.h"
#include "tests/tools/command_line.h"

namespace brume {
namespace {

using Json = nlohmann::json;

// The error is of all of the light, against paths.
TEST_F(CommandLine, MeasuresAllOrdersOfScattering) {
  const auto stats_of = [&](const char* scattering) {
    expect_done({"render", scene_, "-o", file("o.exr"), "--stats", file("s.json"), "--size", "8x6",
                 "--airlight", "sliced", "--scattering", scattering});
    return Json::parse(content_of(folder_ / "s.json"));
  };
  const Json single = stats_of("single");
  EXPECT_TRUE(single["scattering"].is_null());
  const Json multiple = stats_of("multiple");
  EXPECT_GT(multiple["scattering"]["sweeps"], 0);
  EXPECT_LT(multiple["scattering"]["residual"], 1e-3);
  // A light in fog beside a surface, the hardest of what the grid holds.
  EXPECT_LT(multiple["error"]["low"], 0.1);
  EXPECT_LE(multiple["error"]["low"], multiple["error"]["rel_rmse"]);
  EXPECT_LE(multiple["error"]["rel_rmse"], multiple["error"]["high"]);
  const ProgramResult wrong =
      run_brume({"render", scene_, "-o", file("w.exr"), "--scattering", "twice"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_TRUE(contains(wrong.err, "--scattering: found twice; allowed: single, multiple"));
}

}  // namespace
}  // namespace brume
