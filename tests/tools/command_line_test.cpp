#include <gtest/gtest.h>
#include <sched.h>
#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "core/io/gaussians/gaussian_file.h"
#include "core/io/image/image_file.h"
#include "tests/contains.h"
#include "tests/tools/command_line.h"

namespace brume {
namespace {

using Json = nlohmann::json;

TEST_F(CommandLine, HelpAndVersion) {
  const std::string version = run_brume({"--version"}).out;
  EXPECT_TRUE(version.starts_with("brume " BRUME_VERSION "\n")) << version;
  EXPECT_TRUE(contains(version, "compiler", "vector instructions", "Embree", "OpenVDB"));
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"-h"}, {"render", "-h"}, {"compare", "--help"}}) {
    const ProgramResult result = expect_done(arguments);
    EXPECT_TRUE(contains(result.out, "Usage"));
    EXPECT_EQ(result.err, "");
  }
}

TEST_F(CommandLine, RefusesBadUsageInOneLineWithASuggestion) {
  const std::string out = file("o.exr");
  expect_refused({}, {"render"});
  expect_refused({"rendr", scene_}, {"rendr", "did you mean render?"});
  expect_refused({"comapre"}, {"did you mean compare?"});
  expect_refused({"xyzzy"}, {"unknown subcommand xyzzy"});
  expect_refused({"render", scene_, "--ouput", out}, {"--ouput", "did you mean --output?"});
  expect_refused({"render", scene_, "-o", out, "--thread=2"}, {"did you mean --threads?"});
  expect_refused({"render", scene_, "-q", out}, {"unknown option -q"});
  expect_refused({"render", scene_}, {"--output"});
  expect_refused({"render", "-o", out}, {"SCENE"});
  expect_refused({"render", scene_, "two.brume", "-o", out}, {"two.brume"});
  expect_refused({"render", scene_, "-o", out, "--threads", "many"}, {"--threads", "many"});
  expect_refused({"render", scene_, "-o", out, "--threads", "0"}, {"--threads"});
  expect_refused({"render", scene_, "-o", out, "--repeat", "-1"}, {"--repeat"});
  expect_refused({"render", scene_, "-o", out, "--size", "10x16385"}, {"--size", "WIDTHxHEIGHT"});
  expect_refused({"render", scene_, "-o", out, "--airlight", "papr"},
                 {"allowed: auto, paper, sliced, reference, path:N"});
  expect_refused({"render", scene_, "-o", out, "--airlight", "path:8", "--airlight-scale", "2"},
                 {"--airlight-scale: path is never interpolated"});
  expect_refused({"render", scene_, "-o", out, "--backend", "vulkan"}, {"allowed: auto, cpu, gl"});
  expect_refused({"info", file("smoke.vdb")}, {"smoke.vdb", "no such file"});
  std::ofstream(file("a.txt")) << "no scene\n";
  expect_refused({"info", file("a.txt")}, {"allowed: .brume, .ply"});
  expect_refused({"line one\nline two"}, {"unknown subcommand"});
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(CommandLine, RefusesNumbersThatAreNotFiniteOrOutOfRange) {
  const std::string out = file("o.png");
  const auto refuse = [&](const std::string& option, const std::string& value,
                          const std::string& allowed) {
    expect_refused({"render", scene_, "-o", out, option + "=" + value},
                   {option + ": found " + value, "allowed: " + allowed});
  };
  // Each kind of check once with all values.
  for (const char* value : {"nan", "-inf", "1e300", "x"}) {
    refuse("--exposure", value, "a number from -100 to 100");
    refuse("--tolerance", value, "a number from 1e-12 to 1");
    refuse("--slices", value, "a whole number from 4 to 256");
  }
  refuse("--threads", "1025", "a whole number from 1 to 1024");
  refuse("--repeat", "nan", "a number from 1 to 1e+06");
  expect_refused({"compare", "a.exr", "b.exr", "--max-rel-rmse=-1"},
                 {"--max-rel-rmse: found -1", "a number from 0 to 1e+12"});
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(CommandLine, RefusesOutputsBeforeItRenders) {
  // The scene does not exist: an error about the output shows that it was looked at first.
  const std::string none = file("none.brume");
  expect_refused({"render", none, "-o", file("o.jpg")}, {"o.jpg", ".exr, .png"});
  expect_refused({"render", none, "-o", file("floor.obj/o.exr")},
                 {"floor.obj/o.exr", "cannot be written"});
  expect_refused({"render", none, "-o", file("o.exr"), "--stats", file("floor.obj/s.json")},
                 {"floor.obj/s.json", "cannot be written"});
  expect_refused({"render", none, "-o", file("o.exr"), "--stats", file("o.exr")}, {"same file"});
  std::filesystem::create_directory(folder_ / "dir.exr");
  expect_refused({"render", none, "-o", file("dir.exr")}, {"dir.exr", "folder"});
  expect_refused({"render", none, "-o", file("o.exr")}, {"none.brume", "no such file"});
}

TEST_F(CommandLine, RendersAllLayersToExr) {
  for (const char* airlight : {"paper", "sliced:24", "reference", "path:4"}) {
    SCOPED_TRACE(airlight);
    const bool is_sliced = std::string(airlight).starts_with("sliced");
    const ProgramResult result = expect_done(
        joined({"render", scene_, "-o", file("o.exr"), "--airlight", airlight, "--backend", "cpu"},
               words(is_sliced ? "--scattering single" : "")));
    EXPECT_EQ(result.out + result.err, "");
    const ImageLayers image = read_exr(folder_ / "o.exr");
    EXPECT_EQ(image.width, 24);
    EXPECT_EQ(image.height, 18);
    std::vector<std::string> names;
    for (const auto& [name, values] : image.channels) names.push_back(name);
    EXPECT_EQ(names, (std::vector<std::string>{"A", "B", "G", "R", "Z", "airlight.B", "airlight.G",
                                               "airlight.R", "transmittance.B", "transmittance.G",
                                               "transmittance.R"}));
    EXPECT_GT(*std::max_element(image.channels.at("R").begin(), image.channels.at("R").end()),
              0.0f);
    EXPECT_EQ(image.metadata.at("brume:scene"), std::filesystem::path(scene_).filename());
    EXPECT_EQ(image.metadata.at("brume:version"), BRUME_VERSION);
    EXPECT_EQ(image.metadata.at("brume:airlight"), airlight);
    EXPECT_EQ(image.metadata.at("brume:backend"), "cpu");
    // OpenEXR reserves this name for an int.
    EXPECT_FALSE(image.metadata.contains("version"));
  }
}

TEST_F(CommandLine, AcceptsTheOptionsOfPaper) {
  const std::map<std::string, std::vector<std::string>> cases{
      {"paper", {}},
      {"paper+mean", {"--paper-mean"}},
      {"paper+energy", {"--paper-energy"}},
      {"paper+mean+energy", {"--paper-energy", "--paper-mean"}}};
  std::set<std::vector<float>> pictures;
  for (const auto& [name, options] : cases) {
    expect_done(joined({"render", scene_, "-o", file("o.exr"), "--airlight", "paper"}, options));
    const ImageLayers image = read_exr(folder_ / "o.exr");
    EXPECT_EQ(image.metadata.at("brume:airlight"), name);
    EXPECT_TRUE(pictures.insert(image.channels.at("airlight.R")).second) << name;
  }
}

TEST_F(CommandLine, RendersAirlightAtLowerResolution) {
  for (const char* scale : {"1", "2", "4"}) {
    expect_done({"render", scene_, "-o", file("o.exr"), "--stats", file("s.json"), "--size",
                 "40x30", "--airlight", "sliced", "--scattering", "single", "--error", "none",
                 "--airlight-scale", scale});
    const auto stats = nlohmann::json::parse(content_of(folder_ / "s.json"));
    EXPECT_EQ(stats["airlight_scale"], std::stoi(scale));
    EXPECT_GT(stats["exact_pixels"], 0);
  }
  EXPECT_EQ(run_brume({"render", scene_, "-o", file("n.exr"), "--airlight-scale", "3"}).exit_code,
            2);
  const ProgramResult reference = run_brume(
      {"render", scene_, "-o", file("n.exr"), "--airlight", "reference", "--airlight-scale", "2"});
  EXPECT_EQ(reference.exit_code, 2);
  EXPECT_TRUE(contains(reference.err, "--airlight-scale"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "n.exr"));
}

TEST_F(CommandLine, RendersToPng) {
  expect_done({"render", scene_, "-o", file("o.PNG"), "--size", "7x5", "--exposure", "-1.5",
               "--airlight", "paper"});
  const std::string png = content_of(folder_ / "o.PNG");
  EXPECT_TRUE(png.starts_with("\x89PNG"));
  EXPECT_TRUE(contains(png, "Software", "Brume " BRUME_VERSION, "brume:scene", "brume:version",
                       "brume:airlight", "paper", "brume:backend", "brume:exposure", "-1.5",
                       "brume:view_transform"));
  EXPECT_FALSE(contains(png, folder_.path().string())) << "a path of this machine";
}

TEST_F(CommandLine, PngsHaveEightOrSixteenBits) {
  const auto bits = [&](std::vector<std::string> options) {
    expect_done(joined(
        {"render", scene_, "-o", file("o.png"), "--size", "7x5", "--airlight", "paper"}, options));
    return int{content_of(folder_ / "o.png")[24]};  // in the header
  };
  EXPECT_EQ(bits({}), 8);
  EXPECT_EQ(bits({"--bits", "8"}), 8);
  EXPECT_EQ(bits({"--bits", "16"}), 16);
  expect_refused({"render", scene_, "-o", file("o.png"), "--bits", "12"}, {"--bits", "8,16"});
  expect_refused({"render", scene_, "-o", file("o.exr"), "--bits", "16"},
                 {"--bits", "allowed for .png"});
}

TEST_F(CommandLine, OneNumberIsTheLongerSide) {
  expect_done({"render", scene_, "-o", file("o.png"), "--size", "12", "--airlight", "paper"});
  // The film has 24 x 18 pixels. A PNG's sides follow the name of its first chunk.
  const std::string png = content_of(folder_ / "o.png");
  EXPECT_EQ(png.substr(16, 8), std::string("\0\0\0\x0c\0\0\0\x09", 8));
}

TEST_F(CommandLine, RendersPngsInViewsOfOpenColorIO) {
  const auto render = [&](const char* name, const std::vector<std::string>& options) {
    expect_done(joined({"render", scene_, "-o", file(name), "--airlight", "paper"}, options));
    return content_of(folder_ / name);
  };
  const std::string neutral = render("a.png", {});
  const std::string aces = render("b.png", {"--color-config", "aces"});
  EXPECT_TRUE(contains(neutral, "Khronos PBR Neutral, sRGB"));
  EXPECT_TRUE(contains(aces, "ACES 1.0 SDR, sRGB"));
  const auto refuse = [&](const char* name, const std::vector<std::string>& options,
                          const std::vector<std::string>& parts) {
    expect_refused(joined({"render", scene_, "-o", file(name)}, options), parts);
  };
  refuse("c.exr", {"--view", "Un-tone-mapped"}, {"--view", "allowed for .png"});
  refuse("c.png", {"--view", "Film"}, {"aces", "Film", "allowed: ACES 1.0 SDR, Un-tone-mapped"});
  refuse("c.png", {"--color-config", file("none.ocio")}, {"none.ocio"});
}

TEST_F(CommandLine, WritesTheStatisticsOfTheContract) {
  expect_done({"render", scene_, "-o", file("o.exr"), "--stats", file("s.json"), "--repeat", "3",
               "--threads", "1", "--size", "8x6", "--airlight", "paper", "--backend", "cpu"});
  const auto stats = nlohmann::ordered_json::parse(content_of(folder_ / "s.json"));
  std::vector<std::string> keys;
  for (const auto& [key, value] : stats.items()) keys.push_back(key);
  EXPECT_EQ(keys, (std::vector<std::string>{
                      "version",   "scene",          "time",         "size",    "backend",
                      "device",    "airlight",       "slices",       "seed",    "airlight_scale",
                      "samples",   "sampled_pixels", "exact_pixels", "threads", "repeat",
                      "frame_ms",  "first_frame_ms", "transfer_ms",  "stages",  "skipped",
                      "gaussians", "pairs",          "scattering",   "error",   "noise"}));
  EXPECT_EQ(stats["version"], BRUME_VERSION);
  EXPECT_EQ(stats["scene"], scene_);
  EXPECT_EQ(stats["size"], Json::array({8, 6}));
  EXPECT_EQ(stats["backend"], "cpu");
  EXPECT_NE(stats["device"], "");
  EXPECT_EQ(stats["airlight"], "paper");
  EXPECT_EQ(stats["threads"], 1);
  EXPECT_EQ(stats["repeat"], 3);
  EXPECT_GT(stats["error"]["rel_rmse"], 0.0);
  EXPECT_GT(stats["error"]["pixels"], 0);
  EXPECT_TRUE(stats["slices"].is_null());
  EXPECT_TRUE(stats["noise"].is_null());
  EXPECT_LE(stats["frame_ms"]["min"], stats["frame_ms"]["median"]);
  EXPECT_LE(stats["frame_ms"]["median"], stats["frame_ms"]["max"]);
  EXPECT_GT(stats["first_frame_ms"], 0.0);
  ASSERT_FALSE(stats["stages"].empty());
  EXPECT_TRUE(stats["stages"][0]["name"].is_string());
  EXPECT_TRUE(stats["stages"][0]["ms"].is_number());
  for (const auto& skipped : stats["skipped"]) {
    EXPECT_TRUE(skipped["stage"].is_string());
    EXPECT_TRUE(skipped["why"].is_string());
  }
  EXPECT_EQ(stats["gaussians"]["total"], 2);
  EXPECT_TRUE(stats["pairs"]["light"].is_number());
  EXPECT_TRUE(stats["pairs"]["view"].is_number());
}

TEST_F(CommandLine, TellsTheNoiseOfPaths) {
  expect_done({"render", scene_, "-o", file("o.exr"), "--stats", file("s.json"), "--size", "8x6",
               "--airlight", "path:16", "--backend", "cpu"});
  const auto stats = nlohmann::json::parse(content_of(folder_ / "s.json"));
  EXPECT_EQ(stats["airlight"], "path:16");
  EXPECT_TRUE(stats["error"].is_null());
  EXPECT_EQ(stats["noise"]["paths"], 16);
  EXPECT_GT(stats["noise"]["airlight"], 0.0);
  EXPECT_LT(stats["noise"]["airlight"], 1.0);
  EXPECT_GT(stats["noise"]["picture"], 0.0);
  const ImageLayers image = read_exr(folder_ / "o.exr");
  EXPECT_NEAR(std::stod(image.metadata.at("brume:noise")), stats["noise"]["picture"], 1e-3);
}

TEST_F(CommandLine, RendersWithOpenGl) {
  const auto run = [&](const std::vector<std::string>& options) {
    const ProgramResult result = expect_done(
        joined({"render", scene_, "-o", file("o.exr"), "--stats", file("s.json")}, options));
    const auto stats = Json::parse(content_of(folder_ / "s.json"));
    EXPECT_EQ(read_exr(folder_ / "o.exr").metadata.at("brume:backend"),
              stats["backend"].get<std::string>());
    return std::pair(result.err, stats);
  };
  const auto [silent, stats] =
      run({"--airlight", "sliced", "--scattering", "single", "--backend", "gl"});
  EXPECT_EQ(silent, "");
  EXPECT_EQ(stats["backend"], "gl");
  EXPECT_NE(stats["device"], "");
  EXPECT_LT(stats["error"]["rel_rmse"], 0.02);
  // Methods that it lacks are the CPU's, with a word.
  const auto [warning, other] = run({"--airlight", "path:8", "--backend", "gl"});
  EXPECT_TRUE(contains(warning, "backend gl: rendered on the CPU: "));
  EXPECT_EQ(other["backend"], "cpu");
  EXPECT_EQ(other["on_cpu"][0]["stage"], "frame");
  // Unasked, only a GPU is used.
  const auto [nothing, automatic] =
      run({"--airlight", "sliced", "--scattering", "single", "--backend", "auto"});
  EXPECT_EQ(nothing, "");
  EXPECT_FALSE(contains(automatic["device"].get<std::string>(), "llvmpipe"));
}

// Reports what auto chose and measured, which meets the bound: a quick measurement need not decide.
TEST_F(CommandLine, ChoosesByMeasuredError) {
  const auto stats_of = [&](const char* max_error) {
    const ProgramResult result = expect_done(
        {"render", scene_, "-o", file("o.exr"), "--stats", file("s.json"), "--size", "16x12",
         "--scattering", "single", "--max-error", max_error, "--error", "full"});
    EXPECT_EQ(result.err, "");
    return Json::parse(content_of(folder_ / "s.json"));
  };
  const Json loose = stats_of("0.2");
  const Json tight = stats_of("0.002");
  EXPECT_EQ(loose["airlight"], "sliced");
  EXPECT_LE(loose["error"]["rel_rmse"], 0.2);
  EXPECT_LE(tight["error"]["rel_rmse"], 0.002);
  EXPECT_LE(tight["error"]["low"], tight["error"]["rel_rmse"]);
  EXPECT_LE(tight["error"]["rel_rmse"], tight["error"]["high"]);
  EXPECT_LE(loose["slices"], tight["slices"]);
}

// The frame that is timed is a moved one, also where just one frame is asked for.
TEST_F(CommandLine, TimesAMovedFrame) {
  expect_done({"render", scene_, "-o", file("o.exr"), "--stats", file("s.json"), "--size", "2x2",
               "--airlight", "sliced", "--slices", "32", "--scattering", "single"});
  const Json stats = Json::parse(content_of(folder_ / "s.json"));
  EXPECT_EQ(stats["repeat"], 1);
  EXPECT_EQ(stats["frame_ms"]["min"], stats["frame_ms"]["max"]);
}

TEST_F(CommandLine, ReportsTheNumberOfThreads) {
  const auto threads = [&](const std::vector<std::string>& more) {
    const ProgramResult result =
        expect_done(joined({"render", scene_, "-o", file("o.exr"), "--stats", file("s.json"),
                            "--size", "2x2", "--airlight", "paper", "--error", "none"},
                           more));
    EXPECT_EQ(result.err, "");
    return Json::parse(content_of(folder_ / "s.json"))["threads"].get<int>();
  };
  cpu_set_t allowed;
  ASSERT_EQ(sched_getaffinity(0, sizeof allowed, &allowed), 0);
  EXPECT_EQ(threads({"--threads", "1024"}), threads({}));
  EXPECT_LE(threads({}), CPU_COUNT(&allowed));
  EXPECT_EQ(threads({"--threads", "1"}), 1);

  // The program inherits what this thread may use.
  cpu_set_t one;
  CPU_ZERO(&one);
  for (int cpu = 0; CPU_COUNT(&one) == 0; ++cpu) {
    if (CPU_ISSET(cpu, &allowed)) CPU_SET(cpu, &one);
  }
  ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
  EXPECT_EQ(threads({}), 1);
  EXPECT_EQ(threads({"--threads", "2"}), 1);
  EXPECT_EQ(sched_setaffinity(0, sizeof allowed, &allowed), 0);
}

TEST_F(CommandLine, WarnsOnStandardError) {
  const std::string scene =
      folder_.write_scene("w.brume", R"("mystery": 1, "film": {"width": 2, "height": 2})");
  const ProgramResult result = expect_done({"render", scene, "-o", file("o.exr")});
  EXPECT_TRUE(result.err.starts_with("brume: warning: ")) << result.err;
  EXPECT_TRUE(contains(result.err, "mystery: unknown key"));
}

// In the cache folder of the user, from one run to the next.
TEST_F(CommandLine, CachesRadianceTransfer) {
  Json scene = Json::parse(scene_text);
  scene["surfaces"][0]["transfer"] = "interreflection";
  const std::string with_transfer = folder_.write("t.brume", scene.dump());
  ASSERT_EQ(setenv("XDG_CACHE_HOME", file("cache").c_str(), 1), 0);
  const auto render = [&](const std::string& what) {
    ProgramResult result =
        run_brume({"render", what, "-o", file("o.exr"), "--stats", file("s.json"), "--airlight",
                   "sliced", "--scattering", "single"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    result.out = content_of(folder_ / "o.exr");
    return result;
  };
  const auto kept = [&] {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "cache" / "brume")) {
      files.push_back(entry.path());
    }
    return files;
  };
  const ProgramResult without = render(scene_);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "cache"));
  const Json skipped = Json::parse(content_of(folder_ / "s.json"))["skipped"];
  EXPECT_TRUE(std::ranges::any_of(skipped, [](const Json& s) {
    return s["stage"] == "transfer" && s["why"] == "no surface requests it";
  }));

  const ProgramResult first = render(with_transfer);
  EXPECT_EQ(first.err, "");
  EXPECT_NE(first.out, without.out);
  const Json stats = Json::parse(content_of(folder_ / "s.json"));
  EXPECT_GT(stats["transfer_ms"], 0.0);
  for (const char* stage : {"transfer", "surfaces"}) {
    EXPECT_TRUE(std::ranges::any_of(stats["stages"], [&](const Json& s) {
      return s["name"] == stage;
    })) << stage;
  }
  ASSERT_EQ(kept().size(), 1u);
  const std::filesystem::path cached = kept()[0];
  const std::string content = content_of(cached);
  const auto made = std::filesystem::last_write_time(cached);
  EXPECT_EQ(render(with_transfer).err, "");
  EXPECT_EQ(std::filesystem::last_write_time(cached), made) << "read, not made again";

  folder_.write("cache/brume/" + cached.filename().string(), content.substr(0, 100));
  const ProgramResult broken = render(with_transfer);
  EXPECT_TRUE(broken.err.starts_with("brume: warning: " + cached.string())) << broken.err;
  EXPECT_EQ(std::ranges::count(broken.err, '\n'), 1);
  EXPECT_EQ(broken.out.size(), first.out.size());
  EXPECT_EQ(content_of(cached), content) << "replaced";
  ASSERT_EQ(unsetenv("XDG_CACHE_HOME"), 0);
}

}  // namespace
}  // namespace brume
