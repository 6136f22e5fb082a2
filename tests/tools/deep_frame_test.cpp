#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/io/image/image_file.h"
#include "tests/contains.h"
#include "tests/tools/command_line.h"

namespace brume {
namespace {

// Deep frames as OpenImageIO's oiiotool reads, flattens and holds them out.
class DeepFrames : public CommandLine {
 protected:
  DeepFrames() {
    write_scene("fog.brume", "");
    folder_.write("wall.obj", "v -20 -20 0\nv 20 -20 0\nv 20 20 0\nv -20 20 0\nf 1 2 3 4\n");
  }

  void write_scene(const char* name, const std::string& surfaces) const {
    folder_.write(name, R"({ "format": "brume-scene", "version": 1,
      "camera": { "eye": [0, 0, 5], "target": [0, 0, 0] }, "film": { "width": 24, "height": 18 },
      "medium": { "density": 0.02, "gaussians": [
        { "center": [0, 0, 0], "radius": 1, "density": 0.5 },
        { "center": [1, 0, 0], "radius": 0.5, "density": 2 } ] },
      "lights": [ { "type": "point", "position": [1, 2, 4], "intensity": [30, 20, 10] } ],
      "surfaces": [)" + surfaces +
                            "] }");
  }
  void render(const char* scene, const char* image, std::vector<std::string> options = {}) const {
    options = joined(words("--airlight sliced --slices 64 --scattering single"), options);
    const ProgramResult result =
        expect_done(joined({"render", file(scene), "-o", file(image)}, options));
    ASSERT_EQ(result.err, "");
  }
  void oiiotool(const std::string& arguments) const {
    const std::string command = "cd " + quoted(folder_.path().string()) + " && " +
                                quoted(BRUME_OIIOTOOL) + " " + arguments + " >oiio.txt 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0) << command << content_of(folder_ / "oiio.txt");
  }
  [[nodiscard]] std::vector<float> channel(const char* image, const char* name) const {
    return read_exr(folder_ / image).channels.at(name);
  }
};

// The largest difference, relative to b's rms.
double max_difference(const std::vector<float>& a, const std::vector<float>& b) {
  EXPECT_EQ(a.size(), b.size());
  double sum = 0.0;
  double worst = 0.0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    sum += static_cast<double>(b[i]) * static_cast<double>(b[i]);
    worst = std::max(worst, std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])));
  }
  return worst / std::sqrt(sum / static_cast<double>(b.size()));
}

TEST_F(DeepFrames, FlattenedAreTheFlatFrame) {
  write_scene("floor.brume", R"({ "mesh": "floor.obj" })");
  render("floor.brume", "a.deep.exr", {"--stats", file("a.json")});
  render("floor.brume", "flat.exr", {"--samples", "1"});  // deep pixels are single rays
  oiiotool("a.deep.exr --flatten -o flattened.exr");
  for (const char* name : {"R", "G", "B", "A"}) {
    // The deep frame has twice the slices; at the edge of the floor they differ most.
    EXPECT_LT(max_difference(channel("flattened.exr", name), channel("flat.exr", name)), 2e-3);
  }
  const auto json = nlohmann::json::parse(content_of(folder_ / "a.json"));
  const double samples = json.at("deep").at("samples_per_pixel");
  EXPECT_GT(samples, 2.0);
  EXPECT_LT(samples, 16.0);
  EXPECT_EQ(json.at("deep").at("bytes"), std::filesystem::file_size(folder_ / "a.deep.exr"));
}

// The renderer's own tests hold walls elsewhere (DeepRenderer).
TEST_F(DeepFrames, HeldOutAreTheFrameWithAWall) {
  render("fog.brume", "fog.deep.exr", {"--deep-error", "0.02"});
  oiiotool("fog.deep.exr --flatten -o flattened.exr");
  const std::vector<float> all = channel("flattened.exr", "R");
  write_scene(
      "wall.brume",
      R"({ "mesh": "wall.obj", "translate": [0, 0, 0.3], "material": { "reflectance": [0, 0, 0] } })");
  render("wall.brume", "wall.exr");
  oiiotool("wall.exr --ch R=0,G=0,B=0,A,Z -d float --deepen -o wall.deep.exr");
  oiiotool("fog.deep.exr wall.deep.exr --deepholdout --flatten -o held.exr");
  const std::vector<float> held = channel("held.exr", "R");
  const std::vector<float> alpha = channel("held.exr", "A");
  const std::vector<float> airlight = channel("wall.exr", "airlight.R");
  const std::vector<float> transmittance = channel("wall.exr", "transmittance.R");
  double rms = 0.0;
  for (const float value : all) rms += static_cast<double>(value) * static_cast<double>(value);
  rms = std::sqrt(rms / static_cast<double>(all.size()));
  for (std::size_t i = 0; i < held.size(); ++i) {
    const double scale = std::max(rms, static_cast<double>(all[i]));
    EXPECT_NEAR(held[i], airlight[i], (0.02 + 0.004) * scale) << i;
    EXPECT_NEAR(1.0f - alpha[i], transmittance[i], 0.02 + 1e-3) << i;
  }
}

TEST_F(DeepFrames, HaveTheChannelsOfTheSpecification) {
  render("fog.brume", "grey.deep.exr");
  oiiotool("--info -v grey.deep.exr");
  const std::string info = content_of(folder_ / "oiio.txt");
  EXPECT_TRUE(contains(info, "6 channel, deep float", "R, G, B, A, Z, ZBack",
                       R"(compression: "zips")", R"(brume:deep_error: "0.01")"));
  std::string colored = content_of(folder_ / "fog.brume");
  colored.replace(colored.find("\"density\": 0.02"), 15, R"("albedo": [0.9, 0.6, 0.6])");
  folder_.write("colored.brume", colored);
  render("colored.brume", "colored.deep.exr");
  oiiotool("--info -v colored.deep.exr");
  EXPECT_TRUE(contains(content_of(folder_ / "oiio.txt"), "R, G, B, A, AR, AG, AB, Z, ZBack"));
}

TEST_F(DeepFrames, RefuseWhatTheyAreNotMadeBy) {
  const std::string deep = file("a.deep.exr");
  expect_refused({"render", scene_, "-o", deep, "--airlight", "paper"},
                 {"--airlight", "paper", "auto, sliced"});
  expect_refused({"render", scene_, "-o", deep, "--layers", "lights"}, {"--layers", "flat EXR"});
  expect_refused({"render", scene_, "-o", file("a.exr"), "--deep-error", "0.1"},
                 {"--deep-error", ".deep.exr"});
  expect_refused({"render", scene_, "-o", deep, "--deep-error", "0"}, {"--deep-error", "1e-05"});
  EXPECT_FALSE(std::filesystem::exists(deep));
}

}  // namespace
}  // namespace brume
