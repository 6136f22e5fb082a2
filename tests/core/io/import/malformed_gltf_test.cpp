#include <gtest/gtest.h>

#include "core/io/import/imported_scene_file.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/import/gltf_builder.h"
#include "tests/core/io/input_error.h"

namespace brume {
namespace {

struct Mistake {
  std::string place;  // named by the error
  std::function<void(GltfBuilder&)> make;
  std::string said{};
};

const std::vector<Mistake>& mistakes() {
  static const std::vector<Mistake> all{
      {"asset", [](GltfBuilder& b) { b.json.erase("asset"); }},
      {"asset.version", [](GltfBuilder& b) { b.json["asset"]["version"] = "1.0"; }, "found 1.0"},
      {"extensionsRequired[0]",
       [](GltfBuilder& b) { b.json["extensionsRequired"] = {"KHR_draco_mesh_compression"}; },
       "found meshes compressed by KHR_draco_mesh_compression; allowed: others; export the scene "
       "again without Draco compression"},
      {"scene", [](GltfBuilder& b) { b.json["scene"] = 1; }},
      {"scenes[0].nodes", [](GltfBuilder& b) { b.json["scenes"][0]["nodes"] = {7}; }},
      {"nodes[0]", [](GltfBuilder& b) { b.json["nodes"][0]["children"] = {0}; }, "tree"},
      {"nodes[0].mesh", [](GltfBuilder& b) { b.json["nodes"][0]["mesh"] = 1; }},
      {"nodes[0].mesh", [](GltfBuilder& b) { b.json["nodes"][0]["mesh"] = "0"; }},
      {"nodes[0].matrix",
       [](GltfBuilder& b) {
         b.json["nodes"][0]["matrix"] = {1, 0};
       }},
      {"nodes[0].scale[1]",
       [](GltfBuilder& b) {
         b.json["nodes"][0]["scale"] = {1, 1e300, 1};
       }},
      {"nodes[0].rotation",
       [](GltfBuilder& b) {
         b.json["nodes"][0]["rotation"] = {0, 0, 0, 0};
       }},
      {"meshes[0].primitives[0].mode", [](GltfBuilder& b) { b.primitive()["mode"] = 7; }},
      {"meshes[0].primitives[0].attributes.POSITION",
       [](GltfBuilder& b) { b.primitive()["attributes"].erase("POSITION"); }},
      {"meshes[0].primitives[0].attributes.POSITION",
       [](GltfBuilder& b) { b.primitive()["attributes"]["POSITION"] = 2; }, "2 components"},
      {"meshes[0].primitives[0].attributes.POSITION",
       [](GltfBuilder& b) { b.primitive()["attributes"]["POSITION"] = 99; }},
      {"meshes[0].primitives[0].indices",
       [](GltfBuilder& b) {
         b.json["accessors"][0]["count"] = b.json["accessors"][1]["count"] =
             b.json["accessors"][2]["count"] = 3;
       },
       "vertex 3"},
      {"meshes[0].primitives[0].indices", [](GltfBuilder& b) { b.primitive()["indices"] = 0; },
       "unsigned integers"},
      {"meshes[0].primitives[0]",
       [](GltfBuilder& b) {
         const float nan = std::numeric_limits<float>::quiet_NaN();
         b.primitive()["attributes"]["POSITION"] =
             b.add({0, 0, 0, 1, 0, 0, 1, 1, nan, 0, 1, 0}, "VEC3");
       },
       "vertex 2: found nan"},
      {"meshes[0].primitives[0].material", [](GltfBuilder& b) { b.primitive()["material"] = 0; }},
      {"accessors[0].count", [](GltfBuilder& b) { b.json["accessors"][0]["count"] = 5; }},
      {"accessors[0].count", [](GltfBuilder& b) { b.json["accessors"][0]["count"] = 1e9; }},
      {"accessors[0].count",
       [](GltfBuilder& b) {
         b.json["accessors"][0].erase("bufferView");
         b.json["accessors"][0]["count"] = 1 << 24;
       }},
      {"accessors[0].componentType",
       [](GltfBuilder& b) { b.json["accessors"][0]["componentType"] = 5124; }},
      {"accessors[0].type", [](GltfBuilder& b) { b.json["accessors"][0]["type"] = "MAT4"; }},
      {"accessors[0].bufferView",
       [](GltfBuilder& b) { b.json["accessors"][0]["bufferView"] = -1; }},
      {"accessors[0].sparse.indices",
       [](GltfBuilder& b) { b.json["accessors"][0]["sparse"]["count"] = 1; }},
      {"bufferViews[0].byteLength",
       [](GltfBuilder& b) { b.json["bufferViews"][0]["byteLength"] = 1000000; }},
      {"bufferViews[0].buffer", [](GltfBuilder& b) { b.json["bufferViews"][0]["buffer"] = 1; }},
      {"materials[0].pbrMetallicRoughness.baseColorFactor",
       [](GltfBuilder& b) {
         b.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1}}}}}};
       }},
      {"materials[0].pbrMetallicRoughness.roughnessFactor",
       [](GltfBuilder& b) {
         b.json["materials"] = {{{"pbrMetallicRoughness", {{"roughnessFactor", "rough"}}}}};
       }},
      {"materials[0].normalTexture.index",
       [](GltfBuilder& b) {
         b.json["materials"] = {{{"normalTexture", {{"index", 0}}}}};
       }},
      {"cameras[0].perspective.yfov",
       [](GltfBuilder& b) {
         b.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 4}}}}};
         b.json["nodes"][0]["camera"] = 0;
       }},
      {"nodes[0].extensions.KHR_lights_punctual.light",
       [](GltfBuilder& b) {
         b.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
         b.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 1;
       }},
      {"extensions.KHR_lights_punctual.lights[0].spot.innerConeAngle",
       [](GltfBuilder& b) {
         b.json["extensions"]["KHR_lights_punctual"]["lights"] = {
             {{"type", "spot"}, {"spot", {{"innerConeAngle", "wide"}}}}};
         b.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
       }},
  };
  return all;
}

using MalformedGltf = FolderTest;

TEST_F(MalformedGltf, NamesThePlace) {
  for (const Mistake& mistake : mistakes()) {
    GltfBuilder builder;
    mistake.make(builder);
    const std::filesystem::path file = folder_.write("scene.glb", builder.binary());
    std::vector<std::string> warnings;
    const std::string error = error_of([&] { read_imported_scene(file, warnings); });
    EXPECT_TRUE(error.starts_with(file.string() + ": " + mistake.place)) << error;
    EXPECT_TRUE(contains(error, mistake.said));
  }
}

TEST_F(MalformedGltf, TruncatedAnywhereIsRefused) {
  std::vector<std::string> warnings;
  const auto read = [&](const std::string& bytes) {
    read_imported_scene(folder_.write("scene.glb", bytes), warnings);
  };
  expect_truncations_refused(GltfBuilder().binary(), read, 7, 4);
}

// Points, which are left out, of a mesh that many nodes share: a small file, and no end to it.
TEST_F(MalformedGltf, NodesWithTooManyPrimitivesAreRefused) {
  GltfBuilder builder;
  GltfBuilder::Json points = builder.primitive();
  points["mode"] = 0;
  builder.json["meshes"][0]["primitives"] = std::vector(2048, points);
  builder.json["nodes"] = std::vector<GltfBuilder::Json>(513, {{"mesh", 0}});
  builder.json.erase("scene");
  builder.json.erase("scenes");
  const auto file = folder_.write("scene.glb", builder.binary());
  std::vector<std::string> warnings;
  expect_error([&] { read_imported_scene(file, warnings); },
               "nodes[512]: found more than 1048576 primitives");
}

TEST_F(MalformedGltf, ABufferThatIsMissingIsNamed) {
  const auto file = folder_.write("scene.gltf", GltfBuilder().text("gone.bin"));
  std::vector<std::string> warnings;
  expect_error([&] { read_imported_scene(file, warnings); },
               "buffers[0].uri: " + (folder_ / "gone.bin").string());
}

TEST_F(MalformedGltf, OtherFormatsAreRefused) {
  std::vector<std::string> warnings;
  const auto error = error_of([&] { read_imported_scene(folder_.write("a.dae", "x"), warnings); });
  EXPECT_TRUE(contains(error, "allowed: .gltf, .glb, .obj, .fbx"));
}

}  // namespace
}  // namespace brume
