// Skinned meshes at rest and in motion (glTF 2.0, 3.7.3.3).

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <span>

#include "brume/surface.h"
#include "core/math/normals.h"
#include "tests/core/io/import/gltf_builder.h"
#include "tests/core/io/input_error.h"

namespace brume {
namespace {

using Json = GltfBuilder::Json;

std::vector<float> matrix(float scale, const glm::vec3& move) {
  return {scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, 0, move.x, move.y, move.z, 1};
}

// The square, skinned to two joints: nodes 1 and 2.
class GltfSkin : public GltfTest {
 protected:
  GltfSkin() {
    builder_.json["nodes"][0]["skin"] = 0;
    builder_.json["nodes"][0]["translation"] = {10, 0, 0};  // which is ignored
    builder_.json["nodes"][0]["scale"] = {3, 3, 3};
    builder_.json["nodes"].push_back({{"name", "root"}, {"children", {2}}});
    builder_.json["nodes"].push_back({{"name", "tip"}});
    builder_.json["scenes"][0]["nodes"] = {0, 1};
    builder_.json["skins"] = {{{"joints", {1, 2}}}};
    set_attribute("JOINTS_0", builder_.add_integers<std::uint8_t>(
                                  {0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4"));
    set_attribute("WEIGHTS_0",
                  builder_.add({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4"));
  }

  void set_attribute(const char* name, std::size_t accessor) {
    builder_.primitive()["attributes"][name] = accessor;
  }
  void set_inverse_binds(const std::vector<float>& first, const std::vector<float>& second) {
    std::vector<float> both = first;
    both.insert(both.end(), second.begin(), second.end());
    const std::size_t accessor = builder_.add(both, "VEC4");
    builder_.json["accessors"][accessor]["type"] = "MAT4";
    builder_.json["accessors"][accessor]["count"] = 2;
    builder_.json["skins"][0]["inverseBindMatrices"] = accessor;
  }

  MeshArrays read() { return mesh_of(builder_); }
  std::string error() {
    return error_of([&] { GltfTest::read(builder_); });
  }
};

void expect_points(const MeshArrays& mesh, const std::vector<glm::vec3>& points) {
  ASSERT_EQ(mesh.points.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_LT(glm::distance(mesh.points[i], points[i]), 1e-6f)
        << i << ": " << mesh.points[i].x << " " << mesh.points[i].y << " " << mesh.points[i].z;
  }
}

TEST_F(GltfSkin, PutsPointsWhereJointsAreNotWhereTheNodeIs) {
  expect_points(read(), {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  EXPECT_TRUE(warnings_.empty());
  builder_.json["nodes"][1]["translation"] = {0, 0, 5};
  builder_.json["nodes"][2]["translation"] = {0, 2, 0};
  expect_points(read(), {{0, 0, 5}, {1, 0, 5}, {1, 3, 5}, {0, 3, 5}});
  EXPECT_TRUE(warnings_.empty());
}

TEST_F(GltfSkin, UndoesTheBindPose) {
  builder_.json["nodes"][1]["scale"] = {0.5, 0.5, 0.5};
  builder_.json["nodes"][2]["translation"] = {0, 2, 0};
  set_inverse_binds(matrix(2, {0, 0, 0}), matrix(2, {0, -2, 0}));
  expect_points(read(), {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
}

TEST_F(GltfSkin, WeighsJoints) {
  builder_.json["nodes"][2]["translation"] = {0, 0, 4};
  set_attribute("JOINTS_0", builder_.add_integers<std::uint16_t>(
                                {0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, "VEC4"));
  // The weights are normalized bytes; the last vertex has none: its first joint has it.
  const std::size_t weights = builder_.add_integers<std::uint8_t>(
      {255, 0, 0, 0, 0, 255, 0, 0, 51, 204, 0, 0, 0, 0, 0, 0}, "VEC4");
  builder_.json["accessors"][weights]["normalized"] = true;
  set_attribute("WEIGHTS_0", weights);
  const std::vector<glm::vec3> points{{0, 0, 0}, {1, 0, 4}, {1, 1, 3.2f}, {0, 1, 0}};
  expect_points(read(), points);
  builder_.json["accessors"][weights].erase("normalized");  // their sum is what counts
  expect_points(read(), points);
}

TEST_F(GltfSkin, HasMoreThanFourJoints) {
  builder_.json["nodes"][2]["translation"] = {0, 0, 4};
  set_attribute("JOINTS_1", builder_.add_integers<std::uint8_t>(
                                {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4"));
  set_attribute("WEIGHTS_1",
                builder_.add({1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0}, "VEC4"));
  expect_points(read(), {{0, 0, 2}, {1, 0, 0}, {1, 1, 4}, {0, 1, 4}});
}

TEST_F(GltfSkin, TakesSparseWeights) {
  builder_.json["nodes"][2]["translation"] = {0, 0, 4};
  const std::size_t weights = builder_.primitive()["attributes"]["WEIGHTS_0"];
  const std::uint8_t vertex = 3;
  const std::array<float, 4> replaced{0, 1, 0, 0};
  builder_.json["accessors"][weights]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", builder_.add_view(&vertex, 1)}, {"componentType", 5121}}},
      {"values", {{"bufferView", builder_.add_view(replaced.data(), 16)}}}};
  expect_points(read(), {{0, 0, 0}, {1, 0, 0}, {1, 1, 4}, {0, 1, 0}});
}

TEST_F(GltfSkin, TurnsNormalsAndKeepsTheSideOfMirroredOnes) {
  const double s = std::sqrt(0.5);
  builder_.json["nodes"][1]["rotation"] = {s, 0, 0, s};  // from z to -y
  for (const double x : {1.0, -1.0}) {
    builder_.json["nodes"][1]["scale"] = {x, 2, 1};
    const MeshArrays mesh = read();
    for (const glm::uvec3& t : mesh.triangles) {
      EXPECT_LT(glm::distance(mesh.normals[t.x], glm::vec3(0, -1, 0)), 1e-6f);
      EXPECT_LT(area_normal(mesh.points, t).y, 0.0);
    }
  }
}

TEST_F(GltfSkin, MeshesWithoutNormalsAreFlatWhereTheyAre) {
  builder_.primitive()["attributes"].erase("NORMAL");
  builder_.json["nodes"][2]["translation"] = {0, 0, 1};
  const MeshArrays mesh = read();
  ASSERT_EQ(mesh.points.size(), 6u);
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 normal = glm::normalize(area_normal(mesh.points, t));
    for (int k = 0; k < 3; ++k) {
      EXPECT_LT(glm::distance(glm::dvec3(mesh.normals[t[k]]), normal), 1e-6);
    }
  }
}

TEST_F(GltfSkin, IsLeftOutWhereItsJointsAreInAnotherScene) {
  builder_.json["scenes"][0]["nodes"] = {0};
  expect_points(read(), {{10, 0, 0}, {13, 0, 0}, {13, 3, 0}, {10, 3, 0}});
  EXPECT_TRUE(contains(warnings_.at(0), "joints that are not in the scene"));
}

TEST_F(GltfSkin, PrimitivesWithoutJointsAreWhereTheNodeIs) {
  builder_.primitive()["attributes"].erase("JOINTS_0");
  expect_points(read(), {{10, 0, 0}, {13, 0, 0}, {13, 3, 0}, {10, 3, 0}});
  // They move with it, too.
  builder_.json["animations"] = {
      {{"samplers",
        {{{"input", builder_.add({0, 1}, "SCALAR")},
          {"output", builder_.add({10, 0, 0, 20, 0, 0}, "VEC3")}}}},
       {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}};
  read();
  Surface surface;
  surface.imported = read_imported_scene(folder_ / "scene.glb", warnings_);
  const Surface shown = shown_surfaces(std::span(&surface, 1), 0.5).at(0);
  EXPECT_LT(glm::distance(world_points(shown).at(0), glm::dvec3(15, 0, 0)), 1e-6);
}

TEST_F(GltfSkin, IsLeftOutWhereItIsWrong) {
  const auto expect_left_out = [&](const std::string& what) {
    expect_points(read(), {{10, 0, 0}, {13, 0, 0}, {13, 3, 0}, {10, 3, 0}});
    ASSERT_EQ(warnings_.size(), 1u);
    EXPECT_TRUE(contains(warnings_[0], what)) << warnings_[0];
    EXPECT_TRUE(warnings_[0].ends_with("; it is left out")) << warnings_[0];
  };
  builder_.json["skins"][0]["joints"] = {1};
  expect_left_out(
      "meshes[0].primitives[0].attributes.JOINTS_0: vertex 2: found the joint 1; allowed: 0 to 0");
  builder_.json["skins"][0]["joints"] = {1, 7};
  expect_left_out("nodes[0].skin: skins[0].joints: found 7");
  builder_.json["skins"][0]["joints"] = Json::array();
  expect_left_out("skins[0].joints");
  builder_.json["skins"][0]["joints"] = {1, 2, 1};
  set_inverse_binds(matrix(1, {0, 0, 0}), matrix(1, {0, 0, 0}));
  expect_left_out("found 2 matrices for 3 joints");
  builder_.json["skins"][0]["inverseBindMatrices"] = 0;
  expect_left_out(R"(accessors[0].type: found "VEC3"; allowed: "MAT4")");
  builder_.json["skins"][0].erase("inverseBindMatrices");
  set_attribute("WEIGHTS_0", builder_.add({1, 0, 0, 0}, "VEC4"));
  expect_left_out("attributes.WEIGHTS_0: found 1 values; allowed: 4, one for each vertex");
}

// The joint `tip` turns by 90 degrees about z in 2 s.
TEST_F(GltfSkin, MovesWithItsJoints) {
  builder_.json["nodes"][2]["translation"] = {0, 2, 0};
  builder_.json["animations"] = {
      {{"samplers",
        {{{"input", builder_.add({1, 3}, "SCALAR")},
          {"output", builder_.add({0, 0, 0, 1, 0, 0, 0.70710678f, 0.70710678f}, "VEC4")}}}},
       {"channels", {{{"sampler", 0}, {"target", {{"node", 2}, {"path", "rotation"}}}}}}}};
  for (const bool has_normals : {true, false}) {
    if (!has_normals) builder_.primitive()["attributes"].erase("NORMAL");
    read();
    EXPECT_TRUE(warnings_.empty());
    Surface surface;
    surface.imported = read_imported_scene(folder_ / "scene.glb", warnings_);
    const auto mesh_at = [&](double time) {
      return to_arrays(*shown_surfaces(std::span(&surface, 1), time).at(0).mesh);
    };
    const auto expect_tip = [&](double time, double degrees) {
      const MeshArrays mesh = mesh_at(time);
      const double angle = glm::radians(degrees);
      const glm::dvec3 x(std::cos(angle), std::sin(angle), 0.0);
      const glm::dvec3 y(-x.y, x.x, 0.0);
      // The corner (1, 1, 0).
      EXPECT_LT(glm::distance(glm::dvec3(mesh.points.at(2)), glm::dvec3(0, 2, 0) + x + y), 2e-3)
          << time;
      EXPECT_EQ(mesh.points.at(1), glm::vec3(1, 0, 0)) << "which the other joint has";
      ASSERT_EQ(mesh.normals.size(), mesh.points.size());
      EXPECT_LT(glm::distance(mesh.normals.at(2), glm::vec3(0, 0, 1)), 1e-6f);
    };
    expect_tip(0.0, 0.0);
    expect_tip(1.7, 31.5);
    expect_tip(2.0, 45.0);
    expect_tip(5.0, 90.0);
    EXPECT_EQ(shown_surfaces(std::span(&surface, 1), 2.5).at(0).mesh,
              shown_surfaces(std::span(&surface, 1), 2.5).at(0).mesh)
        << "what is shown again is the same, which caches compare";
  }
}

TEST_F(GltfSkin, StaysWhereItsAnimationLeavesTheScene) {
  builder_.json["nodes"][1]["scale"] = {10, 10, 10};
  set_inverse_binds(matrix(0.1f, {0, 0, 0}), matrix(0.1f, {0, 0, 0}));
  builder_.json["animations"] = {
      {{"samplers",
        {{{"input", builder_.add({0, 1}, "SCALAR")},
          {"output", builder_.add({0, 0, 0, 5e11f, 0, 0}, "VEC3")}}}},
       {"channels", {{{"sampler", 0}, {"target", {{"node", 2}, {"path", "translation"}}}}}}}};
  const MeshArrays mesh = read();
  expect_points(mesh, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_TRUE(contains(warnings_[0], "the animation of a node: found ")) << warnings_[0];
}

TEST_F(GltfSkin, RefusesPointsThatAreNoNumbers) {
  set_inverse_binds(matrix(std::numeric_limits<float>::quiet_NaN(), {0, 0, 0}),
                    matrix(1, {0, 0, 0}));
  EXPECT_TRUE(contains(error(), "vertex 0: found nan"));
}

}  // namespace
}  // namespace brume
