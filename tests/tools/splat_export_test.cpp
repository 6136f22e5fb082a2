// brume export to and from the files of programs of Gaussian splatting.

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "core/io/gaussians/gaussian_file.h"
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
  EXPECT_TRUE(contains(stage, "def ParticleField3DGaussianSplat"));
  EXPECT_TRUE(contains(stage, "def Volume \"Fog\""));
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

}  // namespace
}  // namespace brume
