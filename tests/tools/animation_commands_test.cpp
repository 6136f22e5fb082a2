// Scenes that move, on the command line.

#include <nlohmann/json.hpp>

#include "tests/tools/command_line.h"

namespace brume {
namespace {

using AnimationCommands = CommandLine;
using Json = nlohmann::json;

TEST_F(AnimationCommands, RendersTheMomentOfItsKeys) {
  Json moving = Json::parse(scene_text);
  const auto keys = [](const Json& from, const Json& to) {
    return Json::array({{{"time", 1}, {"value", from}}, {{"time", 3}, {"value", to}}});
  };
  moving["camera"]["keys"] = {{"eye", keys({0, 0, 5}, {4, 0, 5})}};
  moving["medium"]["keys"] = {{"density", keys(0.0, 0.2)}};
  moving["lights"][0]["keys"] = {{"position", keys({2, 2, 2}, {-2, 2, 2})},
                                 {"intensity", keys({0, 0, 60}, {60, 0, 0})}};
  Json still = Json::parse(scene_text);
  still["camera"]["eye"] = {2, 0, 5};
  still["medium"]["density"] = 0.1;
  still["lights"][0]["position"] = {0, 2, 2};
  still["lights"][0]["intensity"] = {30, 0, 30};
  const std::string moving_scene = folder_.write("moving.brume", moving.dump()).string();
  const std::string still_scene = folder_.write("still.brume", still.dump()).string();
  const auto render = [&](const std::string& scene, const char* time, const char* image) {
    const ProgramResult result =
        run_brume({"render", scene, "--airlight", "sliced", "--time", time, "-o", file(image)});
    EXPECT_EQ(result.exit_code, 0) << result.err;
  };
  render(moving_scene, "2", "moving.exr");
  render(still_scene, "0", "still.exr");
  render(moving_scene, "1", "earlier.exr");
  EXPECT_EQ(run_brume({"compare", file("moving.exr"), file("still.exr"), "--max-rel-rmse", "0"})
                .exit_code,
            0);
  EXPECT_EQ(run_brume({"compare", file("earlier.exr"), file("still.exr"), "--max-rel-rmse", "0.1"})
                .exit_code,
            1);
}

}  // namespace
}  // namespace brume
