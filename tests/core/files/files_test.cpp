#include "brume/files.h"

#include <gtest/gtest.h>

#include <limits>

#include "brume/error.h"
#include "brume/mesh_arrays.h"
#include "core/io/disk/file_bytes.h"
#include "tests/contains.h"
#include "tests/core/io/folder_test.h"

namespace brume {
namespace {

class Files : public FolderTest {
 protected:
  TemporaryFolder folder_;
};

TEST_F(Files, SceneKeepsUnknownKeysWhereverItsObjectsMove) {
  const auto file = folder_.write_scene(
      "s.brume", R"("lights": [ { "type": "point", "position": [0, 1, 0], "gobo": "leaves" } ])");
  std::vector<std::string> warnings;
  SceneFile scene = load_scene_file(file, &warnings);
  EXPECT_EQ(warnings.size(), 1u);
  scene.scene.lights.insert(scene.scene.lights.begin(), Light{});
  const auto saved = folder_.path() / "t.brume";
  save_scene_file(scene, saved);
  const SceneFile again = load_scene_file(saved);
  EXPECT_EQ(again.scene.lights.size(), 2u);
  EXPECT_TRUE(contains(read_bytes(saved), "\"gobo\": \"leaves\""));
  // A scene alone has none.
  save_scene(scene.scene, saved);
  EXPECT_FALSE(contains(read_bytes(saved), "gobo"));
}

TEST_F(Files, SavingRefusesWhatAFileCannotHold) {
  const auto refusal = [this](const Scene& scene) {
    try {
      save_scene(scene, folder_.path() / "s.brume");
    } catch (const DomainError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  Scene scene;
  scene.surfaces.emplace_back().mesh =
      to_mesh({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, {{0, 1, 2}}});
  EXPECT_TRUE(refusal(scene).starts_with("surfaces[0].mesh: it is in memory alone"));
  scene = {};
  scene.medium.set_homogeneous_density(-1.0);
  EXPECT_TRUE(refusal(scene).starts_with("medium.density: found -1"));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "s.brume"));
}

TEST_F(Files, GaussiansKeepTheirIds) {
  const std::vector<Gaussian> two{{{0, 0, 0}, 1, 1}, {{1, 0, 0}, 1, 1}};
  const std::vector<GaussianNumber> ids{9, 2};
  for (const char* name : {"a.ply", "a.csv"}) {
    save_gaussians(two, folder_.path() / name, ids);
    std::vector<GaussianNumber> found;
    EXPECT_EQ(load_gaussians(folder_.path() / name, {}, nullptr, &found), two);
    EXPECT_EQ(found, ids);
  }
  EXPECT_THROW(save_gaussians(two, folder_.path() / "a.csv", std::span(ids).first(1)), DomainError);
}

TEST_F(Files, VolumeOfAMediumHasItsDensity) {
  Medium medium;
  medium.append({{0.2, 0.0, 0.0}, 0.5, 2.0});
  const auto file = folder_.path() / "m.vdb";
  save_volume(medium, 0.1, file);
  const DensityGrid grid = load_volume(file);
  EXPECT_NEAR(grid.at(grid.to_voxel({0.2, 0.0, 0.0})), 2.0, 1e-6);
  EXPECT_THROW(save_volume(medium, 1e-9, file), DomainError);
  EXPECT_THROW(save_volume(medium, 0.0, file), DomainError);
  EXPECT_THROW(save_volume(medium, std::numeric_limits<double>::infinity(), file), DomainError);
  EXPECT_THROW(static_cast<void>(load_volume(file, "smoke")), InputError);
}

TEST_F(Files, WarningsOfMeshesReachTheCaller) {
  const auto file = folder_.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n");
  std::vector<std::string> warnings;
  EXPECT_EQ(load_surface(file, &warnings).mesh_file, file);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(warnings[0].starts_with(file.string() + ": line 5: found a face")) << warnings[0];
}

TEST_F(Files, ANamelessFileIsAnErrorOfInput) {
  EXPECT_THROW(save_scene({}, ""), InputError);
  EXPECT_THROW(static_cast<void>(load_surface("")), InputError);
  EXPECT_THROW(static_cast<void>(load_environment("")), InputError);
}

TEST_F(Files, GaussiansAreReadAsTheyWereWritten) {
  const std::vector<Gaussian> gaussians{{{1, 2, 3}, 0.1, 0.2}, {{4, 5, 6}, 0.3, 0.4}};
  for (const char* name : {"g.ply", "g.csv"}) {
    save_gaussians(gaussians, folder_.path() / name);
    EXPECT_EQ(load_gaussians(folder_.path() / name), gaussians);
  }
  Gaussian flat{{1, 2, 3}, 1.0, 0.5};
  flat.set_radii({1.0, 1.0, 0.1}, glm::dquat(1.0, 0.0, 0.0, 0.0));
  save_gaussians(std::vector{flat}, folder_.path() / "g.glb");
  const Gaussian back = load_gaussians(folder_.path() / "g.glb").at(0);
  EXPECT_NEAR(back.density, flat.density, 1e-6);
  const Gaussian denser = load_gaussians(folder_.path() / "g.glb", {OpacityAlong::shortest}).at(0);
  EXPECT_NEAR(denser.density / back.density, std::cbrt(0.1) / 0.1, 1e-6);
}

}  // namespace
}  // namespace brume
