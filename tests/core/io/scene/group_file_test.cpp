#include <gtest/gtest.h>

#include "brume/edits.h"
#include "core/io/scene/json_reader.h"
#include "core/io/scene/scene_file.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/input_error.h"

namespace brume {
namespace {

namespace fs = std::filesystem;

constexpr const char* head = R"({"format": "brume-scene", "version": 1, "medium": )";

std::string csv_scene(const std::string& groups) {
  return head + (R"({"groups": [)" + groups + R"(], "file": "fog.csv"}})");
}

using GroupFile = FolderTest;

TEST_F(GroupFile, KeepsEveryKey) {
  // The parent comes later.
  const fs::path file = folder_.write("a.brume", head + std::string(R"({
    "groups": [
      {"name": "wisps", "color": [1, 0.5, 0], "parent": "steam", "locked": true,
       "density_factor": 2, "density_offset": -0.5, "radius_factor": 0.5, "radius_offset": 0.1,
       "albedo_factor": [1, 0.5, 0.25], "albedo_offset": [0, 0.1, 0.2],
       "keys": {"density_factor": [{"time": 0, "value": 2}, {"time": 1, "value": 4}]}, "x": 1},
      {"name": "steam", "visible": false}],
    "gaussians": [{"center": [0, 0, 0], "radius": 1, "density": 1, "group": "steam"},
                  {"center": [0, 0, 0], "radius": 1, "density": 1},
                  {"center": [0, 0, 0], "radius": 1, "density": 1, "group": "wisps"}]}})"));
  const SceneDocument document = load_document(file);
  const Scene& scene = document.scene;
  ASSERT_EQ(scene.groups.size(), 2u);
  const Group& wisps = scene.groups[0];
  EXPECT_EQ(wisps.name, "wisps");
  EXPECT_EQ(wisps.color, glm::dvec3(1.0, 0.5, 0.0));
  EXPECT_EQ(wisps.parent, scene.groups[1].id);
  EXPECT_TRUE(wisps.visible && wisps.locked);
  EXPECT_EQ(wisps.density_factor, 2.0);
  EXPECT_EQ(wisps.density_offset, -0.5);
  EXPECT_EQ(wisps.radius_factor, 0.5);
  EXPECT_EQ(wisps.radius_offset, 0.1);
  EXPECT_EQ(wisps.albedo_factor, glm::dvec3(1.0, 0.5, 0.25));
  EXPECT_EQ(wisps.albedo_offset, glm::dvec3(0.0, 0.1, 0.2));
  EXPECT_EQ(wisps.keys.density_factor.size(), 2u);
  EXPECT_FALSE(scene.groups[1].visible);
  EXPECT_EQ(scene.medium.group(0), scene.groups[1].id);
  EXPECT_EQ(scene.medium.group(1), 0u);
  EXPECT_EQ(scene.medium.group(2), wisps.id);

  save_document(document, folder_ / "b.brume");
  const SceneDocument again = load_document(folder_ / "b.brume");
  EXPECT_EQ(again.scene, scene);
  EXPECT_EQ(document_to_json(again, folder_.path()), content_of(folder_ / "b.brume"));
  EXPECT_TRUE(contains(content_of(folder_ / "b.brume"), R"("x": 1)"));
}

TEST_F(GroupFile, WithoutGroupsSaysNothingOfThem) {
  Scene scene;
  scene.medium.append({{}, 1.0, 1.0});
  EXPECT_FALSE(contains(document_to_json(scene, "/"), "group"));
}

// While its Gaussians are unchanged, the file of the medium keeps their groups.
TEST_F(GroupFile, MediumFileHasAColumnOfGroups) {
  folder_.write("fog.csv", "x,y,z,radius,density,group\n0,0,0,1,1,2\n0,0,0,1,1,0\n0,0,0,1,1,1\n");
  const std::string text = csv_scene(R"({"name": "a"}, {"name": "b"})");
  SceneDocument document = load_document(folder_.write("a.brume", text));
  Scene& scene = document.scene;
  ASSERT_EQ(scene.medium.size(), 3u);
  EXPECT_EQ(scene.medium.group(0), scene.groups[1].id);
  EXPECT_EQ(scene.medium.group(1), 0u);
  EXPECT_EQ(scene.medium.group(2), scene.groups[0].id);
  EXPECT_TRUE(contains(document_to_json(document, folder_.path()), "fog.csv"));

  // With the first group gone, 2 would be another one.
  const Group first = scene.groups[0];
  scene.groups.erase(scene.groups.begin());
  EXPECT_FALSE(contains(document_to_json(document, folder_.path()), "fog.csv"));
  scene.groups.insert(scene.groups.begin(), first);
  EXPECT_TRUE(contains(document_to_json(document, folder_.path()), "fog.csv"));

  Gaussian moved = scene.medium.gaussian(1);
  moved.group = 1;
  MediumEdit::change(scene.medium, std::vector{scene.medium.ids()[1]}, std::vector{moved})
      .apply(scene.medium);
  EXPECT_FALSE(contains(document_to_json(document, folder_.path()), "fog.csv"));
}

TEST_F(GroupFile, MediumFileOfPlyHasGroupsToo) {
  folder_.write("fog.ply",
                "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                "property float z\nproperty float radius\nproperty float density\n"
                "property uchar group\nend_header\n0 0 0 1 1 1\n0 0 0 1 1 0\n");
  const Scene scene = load_scene(folder_.write(
      "a.brume", head + std::string(R"({"groups": [{"name": "a"}], "file": "fog.ply"}})")));
  EXPECT_EQ(scene.medium.group(0), 1u);
  EXPECT_EQ(scene.medium.group(1), 0u);
}

TEST_F(GroupFile, RefusesAGroupThatTheSceneDoesNotHave) {
  folder_.write("fog.csv", "x,y,z,radius,density,group\n0,0,0,1,1,0\n0,0,0,1,1,2\n");
  const fs::path file = folder_.write("a.brume", csv_scene(R"({"name": "a"})"));
  expect_error([&] { load_scene(file); }, {"medium.file", "Gaussian 1", "from 0 to 1"});
  // In a scene without groups it is a column like others.
  EXPECT_EQ(load_scene(folder_.write("b.brume", csv_scene(""))).medium.size(), 2u);
}

constexpr const char* text_of_splines = R"({"format": "brume-scene", "version": 1, "medium": {
  "splines": [
    {"name": "trail", "points": [[0, 0, 0], [1, 2, 3]], "radius": 0.2, "density": 3,
     "spacing": 0.5, "scatter": 0.25, "falloff": 0.75, "flow": 0.5, "jitter": 1, "stretch": 3, "seed": -7,
     "mirror_y": true, "mirror_center": [0, 1, 0], "albedo": [1, 0.5, 0.25],
     "emission": [0, 0, 2], "x": 1},
    {"name": "wisp", "points": [[0, 1, 0]], "radius": 1, "density": 0}],
  "gaussians": [
    {"center": [0, 0, 0], "radius": 1, "density": 1, "spline": "wisp"},
    {"center": [1, 0, 0], "radius": 1, "density": 1},
    {"center": [2, 0, 0], "radius": 1, "density": 1, "spline": "trail"},
    {"center": [3, 0, 0], "radius": 1, "density": 1, "spline": "wisp"}]}})";

TEST(SplineFile, KeepsEveryKey) {
  const TemporaryFolder folder;
  const SceneDocument document = load_document(folder.write("a.brume", text_of_splines));
  const Scene& scene = document.scene;
  ASSERT_EQ(scene.splines.size(), 2u);
  const PaintedSpline& trail = scene.splines[0];
  EXPECT_EQ(trail.name, "trail");
  EXPECT_EQ(trail.points, (std::vector<glm::dvec3>{{0, 0, 0}, {1, 2, 3}}));
  EXPECT_EQ(trail.brush, (Paintbrush{.radius = 0.2,
                                     .density = 3.0,
                                     .spacing = 0.5,
                                     .scatter = 0.25,
                                     .falloff = 0.75,
                                     .flow = 0.5,
                                     .jitter = 1.0,
                                     .stretch = 3.0}));
  EXPECT_EQ(trail.seed, -7);
  EXPECT_EQ(trail.mirrors, (MirrorPlanes{{false, true, false}, {0, 1, 0}}));
  EXPECT_EQ(trail.optics.albedo, glm::dvec3(1, 0.5, 0.25));
  EXPECT_EQ(trail.optics.emission, glm::dvec3(0, 0, 2));
  const auto ids = scene.medium.ids();
  EXPECT_EQ(trail.gaussians, std::vector{ids[2]});
  EXPECT_EQ(scene.splines[1].gaussians, (std::vector{ids[0], ids[3]}));
  EXPECT_NE(trail.id, scene.splines[1].id);

  save_document(document, folder / "b.brume");
  const SceneDocument again = load_document(folder / "b.brume");
  EXPECT_EQ(again.scene, scene);
  EXPECT_EQ(document_to_json(again, folder.path()), content_of(folder / "b.brume"));
  EXPECT_TRUE(contains(content_of(folder / "b.brume"), R"("x": 1)"));
}

// Gaussians that have been deleted since are not looked for.
TEST(SplineFile, ForgetsDeletedGaussians) {
  const TemporaryFolder folder;
  SceneDocument document = load_document(folder.write("a.brume", text_of_splines));
  Medium& medium = document.scene.medium;
  MediumEdit::remove(medium, std::vector{medium.ids()[0]}).apply(medium);
  save_document(document, folder / "b.brume");
  const Scene again = load_scene(folder / "b.brume");
  EXPECT_EQ(again.splines[1].gaussians, std::vector{again.medium.ids()[2]});
}

TEST(SplineFile, WithoutSplinesSaysNothingOfThem) {
  Scene scene;
  scene.medium.append({{}, 1.0, 1.0});
  EXPECT_FALSE(contains(document_to_json(scene, "/"), "spline"));
}

}  // namespace

}  // namespace brume
