// Animations of nodes as keys.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "brume/at_time.h"
#include "core/scene/animation/animation.h"
#include "core/scene/placement.h"
#include "tests/core/io/import/gltf_builder.h"
#include "tests/core/io/input_error.h"

namespace brume {
namespace {

const float root_half = std::sqrt(0.5f);

class GltfAnimation : public GltfTest {
 protected:
  using Json = GltfBuilder::Json;

  // Adds a channel to the first animation.
  void animate(std::size_t node, const char* path, const std::vector<float>& times,
               const std::vector<float>& values, const char* interpolation = "LINEAR") {
    Json& animation = builder_.json["animations"][0];
    const bool is_rotation = std::string(path) == "rotation";
    animation["samplers"].push_back(
        {{"input", builder_.add(times, "SCALAR")},
         {"output", builder_.add(values, is_rotation ? "VEC4" : "VEC3")},
         {"interpolation", interpolation}});
    animation["channels"].push_back({{"sampler", animation["samplers"].size() - 1},
                                     {"target", {{"node", node}, {"path", path}}}});
  }

  Scene read() {
    Scene scene;
    Surface& surface = scene.surfaces.emplace_back();
    surface.imported = GltfTest::read(builder_);
    surface.mesh = joined_mesh(chosen_parts(*surface.imported, {}));
    return scene;
  }
  const ImportedScene& imported(const Scene& scene) { return *scene.surfaces[0].imported; }
  // The place of the square's corner (1, 0, 0).
  static glm::dvec3 corner_at(const Scene& scene, double time) {
    return world_points(evaluate_at(scene, time).surfaces.at(0)).at(1);
  }
  // The last one.
  std::string warning() {
    read();
    return warnings_.empty() ? "" : warnings_.back();
  }
};

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-6) {
  EXPECT_LT(glm::distance(a, b), tolerance)
      << a.x << ' ' << a.y << ' ' << a.z << " for " << b.x << ' ' << b.y << ' ' << b.z;
}

TEST_F(GltfAnimation, MovesNodesOnStraightLines) {
  animate(0, "translation", {1, 3, 4}, {0, 0, 0, 4, 0, 0, 4, 2, 0});
  const Scene scene = read();
  EXPECT_TRUE(warnings_.empty());
  EXPECT_TRUE(is_animated(scene));
  EXPECT_EQ(last_moment(scene), 4.0);
  const PlacementKeys& keys = imported(scene).parts.at(0).keys;
  EXPECT_EQ(keys.translate.size(), 3u) << "no more than the file has";
  EXPECT_EQ(keys.rotate.size(), 1u);
  EXPECT_EQ(keys.scale.size(), 1u);
  expect_near(corner_at(scene, 0.0), {1, 0, 0});
  expect_near(corner_at(scene, 2.0), {3, 0, 0});
  expect_near(corner_at(scene, 3.5), {5, 1, 0});
  expect_near(corner_at(scene, 9.0), {5, 2, 0});
}

TEST_F(GltfAnimation, MovesWithinThePlacementOfItsSurface) {
  animate(0, "translation", {0, 1}, {0, 0, 0, 4, 0, 0});
  Scene scene = read();
  scene.surfaces[0].translate = {10, 0, 0};
  scene.surfaces[0].scale = 2.0;
  expect_near(corner_at(scene, 0.5), {16, 0, 0});
  scene.surfaces[0].copies.emplace().placements = std::make_shared<const CopyPlacements>(
      CopyPlacements{{{0, 0, 0}, {1, 0, 0, 0}, 1.0}, {{0, 5, 0}, {1, 0, 0, 0}, 1.0}});
  for (const double time : {0.5, 1.0}) {
    const Surface shown = evaluate_at(scene, time).surfaces.at(0);
    ASSERT_EQ(placement_count(shown), 3u);
    expect_near(placement_of(shown, 1).translate, {8.0 * time, 0, 0});
    expect_near(placement_of(shown, 2).translate, {8.0 * time, 5, 0});
    expect_near(corner_at(scene, time), {12.0 + 8.0 * time, 0, 0});
  }
}

TEST_F(GltfAnimation, DamagedFilesAreErrorsOrRead) {
  builder_.primitive()["attributes"]["COLOR_0"] =
      builder_.add({1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}, "VEC3");
  animate(0, "rotation", {0, 1}, {0, 0, 0, 1, 0, 0, root_half, root_half});
  animate(0, "scale", {0, 1}, {1, 1, 1, 2, 2, 2}, "STEP");
  const std::size_t refused = refused_damages(builder_.binary(), [&](const std::string& bytes) {
    std::vector<std::string> warnings;
    const auto scene = read_imported_scene(folder_.write("damaged.glb", bytes), warnings);
    for (const ImportedPart& part : scene->parts) placements_at(part, 0.5);
  });
  EXPECT_GT(refused, 100u);
}

TEST_F(GltfAnimation, MovesFlatNodes) {
  builder_.json["nodes"][0]["scale"] = {1, 1, 0};
  animate(0, "translation", {0, 1}, {0, 0, 0, 5, 0, 0});
  const Scene scene = read();
  expect_near(corner_at(scene, 0.0), {1, 0, 0});
  expect_near(corner_at(scene, 0.5), {3.5, 0, 0});
}

TEST_F(GltfAnimation, TurnsChildrenAroundTheirParents) {
  builder_.json["nodes"][0]["translation"] = {2, 0, 0};
  builder_.json["nodes"].push_back({{"name", "carousel"}, {"children", {0}}});
  builder_.json["scenes"][0]["nodes"] = {1};
  // Half a turn about z, from key to key by a right angle.
  animate(1, "rotation", {0, 1, 2}, {0, 0, 0, 1, 0, 0, root_half, root_half, 0, 0, 1, 0});
  const Scene scene = read();
  for (const double time : {0.0, 0.3, 0.5, 0.77, 1.0, 1.6, 2.0}) {
    const double angle = 0.5 * std::numbers::pi * time;
    // The arcs are of chords that are within 5e-4 of the way.
    expect_near(corner_at(scene, time), 3.0 * glm::dvec3(std::cos(angle), std::sin(angle), 0.0),
                4e-3);
  }
  EXPECT_GT(imported(scene).parts.at(0).keys.translate.size(), 10u);
  EXPECT_EQ(joined_mesh(chosen_parts(imported(scene), {}))->points[1], glm::vec3(3, 0, 0))
      << "as it is at 0 s";
}

TEST_F(GltfAnimation, HoldsSteps) {
  animate(0, "translation", {0, 1, 2}, {0, 0, 0, 5, 0, 0, 7, 0, 0}, "STEP");
  const Scene scene = read();
  const Keys<glm::dvec3>& keys = imported(scene).parts.at(0).keys.translate;
  ASSERT_EQ(keys.size(), 3u);
  EXPECT_EQ(keys[0].interpolation, Interpolation::constant);
  expect_near(corner_at(scene, 0.999), {1, 0, 0});
  expect_near(corner_at(scene, 1.0), {6, 0, 0});
  expect_near(corner_at(scene, 1.9), {6, 0, 0});
  expect_near(corner_at(scene, 2.5), {8, 0, 0});
}

TEST_F(GltfAnimation, StepsWithinMotionsJump) {
  builder_.json["nodes"].push_back({{"name", "cart"}, {"children", {0}}});
  builder_.json["scenes"][0]["nodes"] = {1};
  animate(0, "translation", {0, 1}, {0, 0, 0, 0, 5, 0}, "STEP");
  animate(1, "translation", {0, 2}, {0, 0, 0, 2, 0, 0});
  const Scene scene = read();
  expect_near(corner_at(scene, 0.9), {1.9, 0, 0}, 1e-4);
  expect_near(corner_at(scene, 1.0), {2.0, 5, 0}, 1e-4);
  expect_near(corner_at(scene, 1.5), {2.5, 5, 0}, 1e-4);
}

TEST_F(GltfAnimation, FollowsCubicSplines) {
  // From 0 to 1 with slopes 3 and 0: h(t) = 3 (t3 - 2 t2 + t) + 3 t2 - 2 t3.
  animate(0, "translation", {0, 1}, {0, 0, 0, 0, 0, 0, 3, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0},
          "CUBICSPLINE");
  const Scene scene = read();
  for (const double t : {0.1, 0.25, 0.6, 0.9}) {
    const double wanted = 3.0 * (t * t * t - 2.0 * t * t + t) + 3.0 * t * t - 2.0 * t * t * t;
    expect_near(corner_at(scene, t), {1.0 + wanted, 0, 0}, 2e-3);
  }
}

TEST_F(GltfAnimation, ScalesAndKeepsMirrorings) {
  builder_.json["nodes"][0]["scale"] = {-1, 2, 1};
  builder_.json["nodes"].push_back({{"name", "parent"}, {"children", {0}}});
  builder_.json["scenes"][0]["nodes"] = {1};
  animate(1, "scale", {0, 1}, {1, 1, 1, 3, 3, 3});
  const Scene scene = read();
  EXPECT_TRUE(warnings_.empty());
  expect_near(corner_at(scene, 0.0), {-1, 0, 0});
  expect_near(corner_at(scene, 0.5), {-2, 0, 0});
  expect_near(world_points(evaluate_at(scene, 1.0).surfaces[0]).at(2), {-3, 6, 0});
}

TEST_F(GltfAnimation, UnevenScalesAreAWarning) {
  animate(0, "scale", {0, 1}, {1, 1, 1, 1, 8, 1});
  const Scene scene = read();
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_TRUE(contains(warnings_[0], "keeps its proportions")) << warnings_[0];
  EXPECT_NEAR(imported(scene).parts.at(0).keys.scale.back().value /
                  imported(scene).parts.at(0).keys.scale.front().value,
              2.0, 1e-6);
}

TEST_F(GltfAnimation, HiddenNodesAreTiny) {
  animate(0, "scale", {0, 1, 2}, {0, 0, 0, 0, 0, 0, 1, 1, 1}, "STEP");
  const Scene scene = read();
  EXPECT_LT(glm::length(corner_at(scene, 0.5)), 1e-5);
  expect_near(corner_at(scene, 2.0), {1, 0, 0});
}

TEST_F(GltfAnimation, MovesCamerasAndLights) {
  builder_.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1.0}}}}};
  builder_.json["extensionsUsed"] = {"KHR_lights_punctual"};
  builder_.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "spot"}}};
  builder_.json["nodes"].push_back({{"name", "rig"}, {"camera", 0}});
  builder_.json["nodes"].back()["extensions"]["KHR_lights_punctual"]["light"] = 0;
  builder_.json["scenes"][0]["nodes"] = {0, 1};
  animate(1, "translation", {0, 2}, {0, 0, 5, 4, 0, 5});
  // Looks to -z, then to -x.
  animate(1, "rotation", {0, 2}, {0, 0, 0, 1, 0, root_half, 0, root_half});
  const Scene scene = read();
  EXPECT_TRUE(warnings_.empty());
  const NamedCamera& camera = imported(scene).cameras.at(0);
  expect_near(camera.camera.eye, {0, 0, 5});
  expect_near(value_at(camera.keys.eye, 1.0), {2, 0, 5});
  const glm::dvec3 middle = value_at(camera.keys.target, 1.0) - value_at(camera.keys.eye, 1.0);
  expect_near(glm::normalize(middle), {-std::sqrt(0.5), 0, -std::sqrt(0.5)}, 2e-3);
  EXPECT_TRUE(camera.keys.roll.empty()) << "its horizon is level";
  const Light& light = imported(scene).lights.at(0);
  expect_near(value_at(light.keys.position, 1.0), {2, 0, 5});
  expect_near(glm::normalize(value_at(light.keys.direction, 2.0)), {-1, 0, 0});
}

TEST_F(GltfAnimation, CamerasRoll) {
  builder_.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1.0}}}}};
  builder_.json["nodes"].push_back({{"name", "eye"}, {"camera", 0}});
  builder_.json["scenes"][0]["nodes"] = {0, 1};
  // About the way it looks, counterclockwise as seen from +z, behind it: its top leans to its left.
  animate(1, "rotation", {0, 1}, {0, 0, 0, 1, 0, 0, root_half, root_half});
  const Scene scene = read();
  const NamedCamera& camera = imported(scene).cameras.at(0);
  ASSERT_FALSE(camera.keys.roll.empty());
  EXPECT_NEAR(camera.keys.roll.back().value, -90.0, 1e-3);
}

TEST_F(GltfAnimation, OnlyTheFirstIsRead) {
  animate(0, "translation", {0, 1}, {0, 0, 0, 1, 0, 0});
  builder_.json["animations"].push_back(builder_.json["animations"][0]);
  builder_.json["animations"][0]["channels"].push_back(
      {{"sampler", 0}, {"target", {{"node", 0}, {"path", "pointer"}}}});
  read();
  ASSERT_EQ(warnings_.size(), 2u);
  EXPECT_TRUE(contains(warnings_[0], "animations: found 2; all but the first are left out"));
  EXPECT_TRUE(contains(warnings_[1], "animations of pointer are left out")) << warnings_[1];
}

TEST_F(GltfAnimation, OnesWithWrongSamplersAreLeftOut) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto warning_with = [&](const std::vector<float>& times, const std::vector<float>& values,
                                const char* interpolation = "LINEAR") {
    builder_ = GltfBuilder();
    animate(0, "translation", times, values, interpolation);
    return warning();
  };
  const std::string place = "scene.glb: animations[0].samplers[0].";
  EXPECT_TRUE(contains(
      warning_with({1, 1}, {0, 0, 0, 1, 0, 0}),
      place +
          "input: found the time 1 after 1; allowed: ascending times; the animation is left out"));
  EXPECT_TRUE(contains(warning_with({1, nan}, {0, 0, 0, 1, 0, 0}), place + "input: found nan"));
  EXPECT_TRUE(contains(warning_with({0, 1}, {0, 0, 0, nan, 0, 0}), place + "output: found nan"));
  EXPECT_TRUE(contains(warning_with({0, 1}, {0, 0, 0}),
                       place + "output: found 1 values for 2 times; allowed: 2"));
  EXPECT_TRUE(contains(warning_with({0, 1}, {0, 0, 0, 1, 0, 0}, "CUBICSPLINE"),
                       place + "output: found 2 values for 2 times; allowed: 6"));
  EXPECT_TRUE(contains(warning_with({0, 1}, {0, 0, 0, 1, 0, 0}, "BEZIER"),
                       place + "interpolation: found BEZIER"));
  builder_.json["animations"][0]["samplers"][0]["interpolation"] = "LINEAR";
  builder_.json["animations"][0]["samplers"][0]["output"] = 77;
  EXPECT_TRUE(contains(warning(), place + "output: found 77"));
  builder_.json["animations"][0]["channels"][0]["sampler"] = 3;
  EXPECT_TRUE(contains(warning(), "animations[0].channels[0].sampler: found 3"));
  builder_.json["animations"][0]["channels"][0]["target"]["node"] = 3;
  EXPECT_TRUE(contains(warning(), "animations[0].channels[0].target.node: found 3"));
}

TEST_F(GltfAnimation, InstancesMoveWithTheirNode) {
  builder_.json["nodes"][0]["scale"] = {2, 2, 2};
  builder_.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
      {"TRANSLATION", builder_.add({0, 0, 0, 5, 0, 0}, "VEC3")}};
  animate(0, "translation", {0, 1}, {0, 0, 0, 0, 8, 0});
  const Scene scene = read();
  EXPECT_TRUE(warnings_.empty());
  const auto place_at = [&](double time, std::size_t copy) {
    const Scene shown = evaluate_at(scene, time);
    EXPECT_EQ(shown.surfaces.size(), 1u);
    EXPECT_EQ(placement_count(shown.surfaces[0]), 2u);
    return placement_of(shown.surfaces[0], copy).point_to_world({1, 0, 0});
  };
  expect_near(place_at(0.0, 0), {2, 0, 0});
  expect_near(place_at(0.5, 0), {2, 4, 0});
  expect_near(place_at(0.5, 1), {12, 4, 0});
  EXPECT_EQ(evaluate_at(scene, 0.5).surfaces[0].placed_copies,
            evaluate_at(scene, 0.5).surfaces[0].placed_copies);
  // Those that are stretched are meshes of their own, and move as well.
  builder_.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["SCALE"] =
      builder_.add({1, 1, 1, 3, 1, 1}, "VEC3");
  const Scene stretched = evaluate_at(read(), 0.5);
  ASSERT_EQ(stretched.surfaces.size(), 2u);
  expect_near(world_points(stretched.surfaces[1]).at(1), {16, 4, 0});
}

TEST_F(GltfAnimation, NodesThatMoveShareTheirMesh) {
  builder_.json["nodes"].push_back({{"mesh", 0}, {"translation", {7, 0, 0}}});
  builder_.json["scenes"][0]["nodes"] = {0, 1};
  animate(0, "translation", {0, 1}, {0, 0, 0, 0, 8, 0});
  const Scene scene = read();
  ASSERT_EQ(imported(scene).parts.size(), 2u);
  EXPECT_EQ(imported(scene).parts[0].mesh, imported(scene).parts[1].mesh);
  const Scene shown = evaluate_at(scene, 0.5);
  expect_near(world_points(shown.surfaces.at(0)).at(1), {1, 4, 0});
  expect_near(world_points(shown.surfaces.at(1)).at(1), {8, 0, 0});
}

TEST_F(GltfAnimation, MorphsWhileItMoves) {
  builder_.primitive()["targets"] = {
      {{"POSITION", builder_.add({0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0}, "VEC3")}}};
  animate(0, "translation", {0, 1}, {0, 0, 0, 0, 8, 0});
  animate(0, "weights", {0, 1, 2}, {0, 1, 0});
  builder_.json["accessors"].back()["type"] = "SCALAR";
  builder_.json["accessors"].back()["count"] = 3;
  expect_near(corner_at(read(), 0.5), {1.5, 4.0, 0.0});
}

TEST_F(GltfAnimation, MorphTargetsThatAreNoNumbersStayAsAtTheBeginning) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  builder_.primitive()["targets"] = {
      {{"POSITION", builder_.add({0, 0, 0, nan, 0, 0, 1, 0, 0, 0, 0, 0}, "VEC3")}}};
  animate(0, "weights", {0, 1, 2}, {0, 1, 0});
  builder_.json["accessors"].back()["type"] = "SCALAR";
  builder_.json["accessors"].back()["count"] = 3;
  expect_near(corner_at(read(), 1.0), {1, 0, 0});
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_TRUE(contains(warnings_[0], "meshes[0].primitives[0]: the animation of a node: found nan"))
      << warnings_[0];
}

TEST_F(GltfAnimation, MorphTargetsHaveTheWeightsOfTheTime) {
  builder_.primitive()["targets"] = {
      {{"POSITION", builder_.add({0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0}, "VEC3")}},
      {{"POSITION", builder_.add({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3")}}};
  const auto corner = [&] { return glm::dvec3(read().surfaces[0].mesh->points.at(1)); };
  expect_near(corner(), {1, 0, 0});
  builder_.json["meshes"][0]["weights"] = {0.5, 0.0};
  expect_near(corner(), {1.5, 0, 0});
  builder_.json["nodes"][0]["weights"] = {0.0, 2.0};
  expect_near(corner(), {1, 0, 2});
  EXPECT_TRUE(warnings_.empty());
  builder_.json["animations"][0]["samplers"] = {
      {{"input", builder_.add({-1, 0, 1}, "SCALAR")},
       {"output", builder_.add({0, 0, 1, 3, 0, 0}, "SCALAR")}}};
  builder_.json["animations"][0]["channels"] = {
      {{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}};
  expect_near(corner(), {2, 0, 3});
  EXPECT_TRUE(warnings_.empty());
  const Scene scene = read();
  for (const double time : {-2.0, -0.5, 0.0, 0.25, 2.0}) {
    const double first = time < 0.0 ? std::max(0.0, 1.0 + time) : std::max(0.0, 1.0 - time);
    expect_near(corner_at(scene, time), {1.0 + first, 0.0, 3.0 * first});
  }
  EXPECT_TRUE(has_keys(scene));
  EXPECT_EQ(last_key_time(scene), 1.0);
  builder_.json["animations"][0]["samplers"][0]["output"] = builder_.add({0, 0, 1, 3, 0}, "SCALAR");
  EXPECT_TRUE(contains(warning(), "output: found 5 values for 3 times"));
  builder_.json.erase("animations");
  builder_.primitive()["targets"][1]["POSITION"] = builder_.add({0, 0, 1}, "VEC3");
  expect_near(corner(), {1, 0, 0});
  EXPECT_TRUE(contains(warnings_.at(0), "targets[1].POSITION: found 1 values; allowed: 4"));
}

}  // namespace
}  // namespace brume
