#include <gtest/gtest.h>

#include "brume/edits.h"
#include "core/io/scene/scene_file.h"
#include "tests/core/io/input_error.h"
#include "tests/core/io/temporary_folder.h"

namespace brume {
namespace {

namespace fs = std::filesystem;

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
