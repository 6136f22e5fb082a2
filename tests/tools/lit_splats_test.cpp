// brume export --lit and --web: fog with its light, for viewers of splats.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "core/io/disk/file_bytes.h"
#include "core/io/gaussians/gaussian_file.h"
#include "core/io/import/uri.h"
#include "core/io/ply.h"
#include "tests/contains.h"
#include "tests/tools/command_line.h"

namespace brume {
namespace {

using Json = nlohmann::json;

class LitSplats : public CommandLine {
 protected:
  LitSplats() {
    const Json scene = {
        {"format", "brume-scene"},
        {"version", 1},
        {"camera", {{"eye", {0, 0, 5}}, {"target", {0, 0.5, 0}}, {"vertical_fov", 40}}},
        {"film", {{"width", 400}, {"height", 200}}},
        {"medium",
         {{"gaussians",
           {{{"center", {0.5, 1, 0}}, {"radii", {1, 0.5, 0.25}}, {"density", 4}},
            {{"center", {-1, 0, 0}}, {"radius", 0.3}, {"density", 0.5}}}}}},
        {"lights", {{{"type", "point"}, {"position", {0, 6, 0}}, {"intensity", {300, 150, 60}}}}}};
    folder_.write("lit.brume", scene.dump());
  }

  // The red of the first splat for a viewer that looks along w, of bands 0 and 1.
  static double red(const std::string& bytes, const glm::dvec3& w) {
    const PlyFile ply("splats", bytes);
    double value = 0.0;
    ply.for_each_row([&](const PlyFile::Element& vertices, std::uint64_t row, const auto& values) {
      if (row != 0) return;
      const auto of = [&](const char* name) { return values.scalars[*vertices.property(name)]; };
      value = 0.5 + 0.28209479 * of("f_dc_0") +
              0.48860251 * (-w.y * of("f_rest_0") + w.z * of("f_rest_1") - w.x * of("f_rest_2"));
    });
    return value;
  }
};

TEST_F(LitSplats, AreBrightOnTheSideOfTheLight) {
  expect_done({"export", file("lit.brume"), "-o", file("lit.ply"), "--lit"});
  const std::string bytes = read_bytes(file("lit.ply"));
  EXPECT_GT(red(bytes, {0, -1, 0}), 1.3 * red(bytes, {0, 1, 0}));
  const std::vector<Gaussian> found = read_gaussians(file("lit.ply"));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_LT(glm::length(found[0].radii() - glm::dvec3(1, 0.5, 0.25)), 1e-6);
  // Brighter by an exposure.
  expect_done({"export", file("lit.brume"), "-o", file("b.ply"), "--lit", "--exposure", "1"});
  EXPECT_GT(red(read_bytes(file("b.ply")), {0, 0, -1}), 1.1 * red(bytes, {0, 0, -1}));
}

TEST_F(LitSplats, TurnWithTheirLight) {
  expect_done({"export", file("lit.brume"), "-o", file("lit.ply"), "--lit", "--y-down"});
  const std::string bytes = read_bytes(file("lit.ply"));
  EXPECT_GT(red(bytes, {0, 1, 0}), 1.3 * red(bytes, {0, -1, 0}));
  EXPECT_LT(glm::length(read_gaussians(file("lit.ply"))[0].center - glm::dvec3(-0.5, -1, 0)), 1e-6);
}

TEST_F(LitSplats, APageHoldsAllThatItShows) {
  expect_done({"export", file("lit.brume"), "-o", file("fog.html"), "--web"});
  const std::string page = read_bytes(file("fog.html"));
  EXPECT_TRUE(contains(page, "<title>fog</title>"));
  const std::string mark = "id=\"sse-bootstrap\">";
  const std::size_t begin = page.find(mark) + mark.size();
  const Json content = Json::parse(page.substr(begin, page.find("</script>", begin) - begin));
  const auto splats = decoded_data_uri(content.at("contentUrl").get<std::string>());
  ASSERT_TRUE(splats);
  EXPECT_TRUE(splats->starts_with("ply\n"));
  EXPECT_NE(splats->find("element vertex 2\n"), std::string::npos);
  const Json camera = content.at("settings").at("cameras").at(0).at("initial");
  EXPECT_EQ(camera.at("position"), Json({0.0, 0.0, 5.0}));
  // The angle of the longer side, which is twice the other.
  EXPECT_NEAR(camera.at("fov").get<double>(), 72.1, 0.1);
}

TEST_F(LitSplats, RefuseWhatHasNoLight) {
  expect_done({"export", file("lit.brume"), "-o", file("a.ply")});
  expect_refused({"export", file("a.ply"), "-o", file("b.ply"), "--lit"}, {"a.ply", ".brume"});
  expect_refused({"export", file("lit.brume"), "-o", file("b.ply"), "--web"}, {"--web", ".html"});
  expect_refused({"export", file("lit.brume"), "-o", file("b.csv"), "--lit"}, {"--lit", ".ply"});
  expect_refused({"export", file("lit.brume"), "-o", file("b.ply"), "--exposure", "1"},
                 {"--exposure", "--lit"});
  expect_refused({"export", file("lit.brume"), "-o", file("b.ply"), "--y-down"}, {"--y-down"});
}

}  // namespace
}  // namespace brume
