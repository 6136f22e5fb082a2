// brume export to and from the files of programs of Gaussian splatting.

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
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

class SplatExport : public CommandLine {
 protected:
  SplatExport() {
    Gaussian g{{1.0, 2.0, 3.0}, 1.0, 0.5};
    g.set_radii({1.0, 0.5, 0.25}, {0.8, 0.6, 0.0, 0.0});
    write_gaussians(file("a.ply"), std::vector{g, Gaussian{{0.0, 0.0, 0.0}, 2.0, 0.25}});
  }

  void expect_same(const char* name, double tolerance) {
    const std::vector<Gaussian> expected = read_gaussians(file("a.ply"));
    const std::vector<Gaussian> found = read_gaussians(file(name));
    ASSERT_EQ(found.size(), expected.size()) << name;
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_LT(glm::length(found[i].center - expected[i].center), tolerance) << name;
      EXPECT_LT(glm::length(found[i].radii() - expected[i].radii()), tolerance) << name;
      EXPECT_NEAR(found[i].density, expected[i].density, tolerance) << name;
    }
  }
};

TEST_F(SplatExport, PlyThereAndBack) {
  expect_done({"export", file("a.ply"), "-o", file("b.ply"), "--splats"});
  expect_same("b.ply", 1e-6);
  for (const char* along : {"shortest", "mean", "longest"}) {
    expect_done(
        {"export", file("a.ply"), "-o", file("c.ply"), "--splats", "--opacity-along", along});
    expect_done({"export", file("c.ply"), "-o", file("d.ply"), "--opacity-along", along});
    expect_same("d.ply", 1e-6);
  }
  // It is as opaque along its longest radius, and so denser by longest over mean along the others.
  expect_done({"export", file("c.ply"), "-o", file("e.ply"), "--opacity-along", "mean"});
  EXPECT_NEAR(read_gaussians(file("e.ply")).at(0).density, 1.0, 1e-6);
}

TEST_F(SplatExport, GltfThereAndBack) {
  for (const char* name : {"b.glb", "b.gltf"}) {
    expect_done({"export", file("a.ply"), "-o", file(name)});
    expect_same(name, 2e-6);
    expect_done({"export", file(name), "-o", file("c.ply")});
    expect_same("c.ply", 2e-6);
    const ProgramResult info = expect_done({"info", file(name)});
    EXPECT_TRUE(contains(info.out, "  gaussians: 2\n"));
  }
  folder_.write_scene("s.brume", R"("medium": { "file": "b.glb" })");
  expect_done({"export", file("s.brume"), "-o", file("d.ply")});
  expect_same("d.ply", 2e-6);
}

TEST_F(SplatExport, StagesHaveSplatsToo) {
  expect_done({"export", scene_, "-o", file("a.usda"), "--splats", "--voxel", "0.2"});
  std::ifstream in(file("a.usda"));
  const std::string stage{std::istreambuf_iterator<char>(in), {}};
  EXPECT_TRUE(contains(stage, "def ParticleField3DGaussianSplat", "def Volume \"Fog\""));
}

TEST_F(SplatExport, SequencesOfSplats) {
  write_gaussians(file("s_1.ply"), read_gaussians(file("a.ply")));
  write_gaussians(file("s_2.ply"), {});
  expect_done({"export", file("s_%d.ply"), "--frames", "1-2", "-o", file("s_%d.glb")});
  expect_same("s_1.glb", 2e-6);
  EXPECT_TRUE(read_gaussians(file("s_2.glb")).empty());
}

// Captures have y down: splats of the PLY are turned by half about z.
TEST_F(SplatExport, SplatsOfPlyMayHaveYDown) {
  expect_done({"export", file("a.ply"), "-o", file("down.ply"), "--splats", "--y-down"});
  const Gaussian down = read_gaussians(file("down.ply")).at(0);
  EXPECT_LT(glm::length(down.center - glm::dvec3(-1.0, -2.0, 3.0)), 1e-6);
  expect_done({"export", file("down.ply"), "-o", file("up.csv"), "--y-down"});
  expect_same("up.csv", 1e-6);
}

TEST_F(SplatExport, KeepsIds) {
  const std::vector<Gaussian> two{{{0, 0, 0}, 1, 1}, {{1, 0, 0}, 1, 1}};
  const std::vector<GaussianNumber> ids{4000000000, 3};
  const auto ids_of = [&](const char* name) {
    std::vector<GaussianNumber> found;
    read_gaussians(file(name), &found);
    return found;
  };
  write_gaussians(file("ids.csv"), two, ids);
  expect_done({"export", file("ids.csv"), "-o", file("b.ply")});
  expect_done({"export", file("b.ply"), "-o", file("c.ply"), "--splats"});
  expect_done({"export", file("c.ply"), "-o", file("d.csv")});
  for (const char* name : {"b.ply", "c.ply", "d.csv"}) EXPECT_EQ(ids_of(name), ids) << name;

  folder_.write_scene("s.brume", R"("medium": { "gaussians": [
    { "center": [0, 0, 0], "radius": 1, "density": 1, "id": 5 },
    { "center": [1, 0, 0], "radius": 1, "density": 1 } ] })");
  expect_done({"export", file("s.brume"), "-o", file("s.csv")});
  EXPECT_EQ(ids_of("s.csv"), (std::vector<GaussianNumber>{5, 6}));
  expect_done({"export", file("a.ply"), "-o", file("none.csv")});
  EXPECT_TRUE(ids_of("none.csv").empty());
  // A column of another program's.
  folder_.write("words.csv", "id,x,y,z,radius,density\npuff,1,2,3,1,1\n");
  expect_done({"export", file("words.csv"), "-o", file("e.csv")});
  EXPECT_TRUE(ids_of("e.csv").empty());
}

TEST_F(SplatExport, ReadsFilesWithZUp) {
  for (const char* name : {"up.csv", "up.ply"}) {
    expect_done({"export", file("a.ply"), "-o", file("splats.ply"), "--splats"});
    expect_done({"export", file("splats.ply"), "-o", file(name), "--up", "z"});
    const Gaussian up = read_gaussians(file(name)).at(0);
    EXPECT_LT(glm::length(up.center - glm::dvec3(1.0, 3.0, -2.0)), 1e-6);
  }
  expect_done({"export", file("a.ply"), "-o", file("b.ply"), "--up", "z"});
  EXPECT_EQ(read_gaussians(file("b.ply")).at(0).center, glm::dvec3(1.0, 3.0, -2.0));
  expect_done({"export", file("a.ply"), "-o", file("c.ply"), "--up", "z", "--splats", "--y-down"});
  EXPECT_EQ(read_gaussians(file("c.ply")).at(0).center, glm::dvec3(-1.0, -3.0, -2.0));
  expect_refused({"export", scene_, "-o", file("b.ply"), "--up", "z"}, {"--up"});
}

TEST_F(SplatExport, TellsOfSplatsThatAreLeftOut) {
  folder_.write("bad.ply",
                "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                "property float z\nproperty float opacity\nproperty float scale_0\nend_header\n"
                "0 0 0 0 -1\nnan 0 0 0 -1\n0 0 0 0 -1\n");
  for (const ProgramResult& result :
       {run_brume({"export", file("bad.ply"), "-o", file("good.csv")}),
        run_brume({"info", file("bad.ply")})}) {
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_TRUE(contains(result.err, "1 of 3 splats left out"));
  }
  EXPECT_EQ(read_gaussians(file("good.csv")).size(), 2u);
}

TEST_F(SplatExport, ColoursOfSplatsBecomeAlbedos) {
  std::vector<Gaussian> gaussians = read_gaussians(file("a.ply"));
  gaussians[0].optics.albedo = glm::dvec3(0.9, 0.5, 0.1);
  write_splats(file("colours.ply"), gaussians);
  expect_done({"export", file("colours.ply"), "-o", file("albedos.csv"), "--colors"});
  const auto albedo = read_gaussians(file("albedos.csv")).at(0).optics.albedo;
  ASSERT_TRUE(albedo.has_value());
  EXPECT_LT(glm::length(*albedo - glm::dvec3(0.9, 0.5, 0.1)), 1e-6);
  expect_done({"export", file("colours.ply"), "-o", file("none.csv")});
  EXPECT_FALSE(read_gaussians(file("none.csv")).at(0).optics.albedo.has_value());
  expect_refused({"export", file("a.ply"), "-o", file("b.ply"), "--splats", "--colors"},
                 {"--colors: only for splats that are read"});
}

TEST_F(SplatExport, FramesAreSimplifiedToo) {
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 8; ++i) gaussians.push_back({{0.01 * i, 0.0, 0.0}, 1.0, 0.5});
  for (const char* name : {"s_1.ply", "s_2.ply"}) write_gaussians(file(name), gaussians);
  expect_done({"export", file("s_%d.ply"), "--frames", "1-2", "-o", file("t_%d.ply"), "--simplify",
               "0.05"});
  for (const char* name : {"t_1.ply", "t_2.ply"}) {
    EXPECT_LT(read_gaussians(file(name)).size(), gaussians.size());
  }
}

TEST_F(SplatExport, RefusesWhatHasNoEffect) {
  const std::string ply = file("a.ply");
  expect_refused({"export", ply, "-o", file("b.csv"), "--splats"},
                 {"--splats: only for .ply and .usda"});
  expect_refused({"export", ply, "-o", file("b.ply"), "--opacity-along", "x"},
                 {"--opacity-along", "shortest"});
  for (const std::string& other : {ply, scene_}) {
    expect_refused({"export", other, "-o", file("b.csv"), "--opacity-along", "mean"},
                   {"--opacity-along: only for splats"});
    expect_refused({"export", other, "-o", file("b.csv"), "--y-down"},
                   {"--y-down: only for splats"});
    expect_refused({"export", other, "-o", file("b.glb"), "--y-down"},
                   {"--y-down: only for splats"});
  }
}

// brume export --lit and --web: fog with its light, for viewers of splats.

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
