// --seed, --error, and --stats of a sequence.

#include <nlohmann/json.hpp>

#include "tests/tools/command_line.h"

namespace brume {
namespace {

using Json = nlohmann::json;

class RenderStatistics : public CommandLine {
 protected:
  // The statistics that --stats writes.
  Json render(std::vector<std::string> more) {
    expect_done(joined(
        {"render", scene_, "--backend", "cpu", "--size", "8x6", "--stats", file("s.json")}, more));
    return Json::parse(content_of(folder_ / "s.json"));
  }
  ImageLayers traced(const char* image, std::vector<std::string> more) {
    seed_ = render(joined({"--airlight", "path:16", "-o", file(image)}, more))["seed"];
    return read_exr(folder_ / image);
  }

  Json seed_;
};

TEST_F(RenderStatistics, SeedsAreIndependentPictures) {
  const std::vector<float> first = traced("0.exr", {}).channels.at("R");
  EXPECT_EQ(seed_, 0);
  EXPECT_EQ(traced("0.exr", {"--seed", "0"}).channels.at("R"), first);
  const std::vector<float> other = traced("1.exr", {"--seed", "4294967295"}).channels.at("R");
  EXPECT_EQ(seed_, 4294967295);
  std::size_t different = 0;
  double sum = 0.0;
  double difference = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    different += static_cast<std::size_t>(first[i] != other[i]);
    sum += static_cast<double>(first[i]);
    difference += static_cast<double>(other[i] - first[i]);
  }
  EXPECT_GT(different, first.size() * 9 / 10);
  EXPECT_LT(std::abs(difference), 0.3 * sum);  // of 16 paths in 48 pixels
  for (const char* seed : {"-1", "4294967296", "1.5", "x"}) {
    expect_refused({"render", scene_, "-o", file("o.exr"), "--seed", seed}, {"--seed"});
  }
}

TEST_F(RenderStatistics, NoErrorIsMeasuredWhereNoneIsWanted) {
  for (const char* method : {"auto", "sliced"}) {
    SCOPED_TRACE(method);
    const std::vector<std::string> options{"--airlight",  method,         "-o",
                                           file("o.exr"), "--scattering", "single"};
    const auto error = [&](const char* wanted) {
      return render(joined(options, {"--error", wanted}))["error"];
    };
    EXPECT_TRUE(error("none").is_null());
    EXPECT_FALSE(read_exr(folder_ / "o.exr").metadata.contains("brume:error"));
    const Json quick = error("quick");
    EXPECT_GT(quick["pixels"], 0);
    EXPECT_LE(quick["blocks"]["low"], quick["blocks"]["median"]);
    EXPECT_LE(quick["blocks"]["median"], quick["blocks"]["high"]);
    EXPECT_TRUE(read_exr(folder_ / "o.exr").metadata.contains("brume:error"));
    EXPECT_TRUE(read_exr(folder_ / "o.exr").metadata.contains("brume:block_error"));
    EXPECT_EQ(render(options)["error"], quick) << "it is the default";
    EXPECT_GE(error("full")["pixels"], quick["pixels"]);
  }
  for (const char* wanted : {"some", "", "Full", "0"}) {
    expect_refused({"render", scene_, "-o", file("o.exr"), "--error", wanted},
                   {"--error", "allowed: none, quick, full"});
  }
}

// Whatever part of it a process renders, a shot has one setting, and its frames no error.
TEST_F(RenderStatistics, AutoChoosesOnceForAShot) {
  const auto frames = [&](const char* which, const std::vector<std::string>& more) {
    return render(joined({"--frames", which, "--fps", "10", "-o", file("f_%d.exr"), "--scattering",
                          "single", "--max-error", "0.01"},
                         more))["frames"];
  };
  const Json all = frames("0-3", {});
  ASSERT_EQ(all.size(), 4u);
  for (const Json& frame : all) {
    EXPECT_EQ(frame["airlight"], "sliced");
    EXPECT_EQ(frame["slices"], all[0]["slices"]);
    EXPECT_EQ(frame["airlight_scale"], 4);
    EXPECT_TRUE(frame["error"].is_null());
  }
  EXPECT_EQ(frames("3", {})[0]["slices"], all[3]["slices"]);
  EXPECT_GT(frames("3", {"--error", "quick"})[0]["error"]["pixels"], 0);
}

TEST_F(RenderStatistics, OfASequenceListItsFrames) {
  const std::vector<std::string> options = joined(
      words("--airlight sliced --scattering single --frames 3,0 --fps 10 -o"), {file("f_%d.exr")});
  const Json frames = render(options)["frames"];
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[0]["frame"], 3);
  EXPECT_EQ(frames[0]["time"], 0.3);
  EXPECT_EQ(frames[1]["frame"], 0);
  EXPECT_EQ(frames[1]["slices"], 24);
  EXPECT_TRUE(frames[1]["error"].is_null());
  EXPECT_GT(frames[1]["frame_ms"]["median"], 0.0);
  const std::vector<std::string> measured = joined(options, {"--error", "full"});
  EXPECT_GT(render(measured)["frames"][0]["error"]["pixels"], 0);
  // All are there already.
  EXPECT_TRUE(render(joined(measured, {"--skip-existing"}))["frames"].empty());
  expect_refused({"submit", "openjd", scene_, "--frames", "0", "-o", file("f_%d.exr"), "--stats",
                  file("s.json")},
                 {"--stats"});
}

}  // namespace
}  // namespace brume
