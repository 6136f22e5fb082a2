// Tangents, and keyframes of surfaces, in scene files.

#include <gtest/gtest.h>

#include "core/io/scene/scene_file.h"
#include "tests/contains.h"
#include "tests/core/io/temporary_folder.h"

namespace brume {
namespace {

constexpr const char* tangents_scene_text = R"({ "format": "brume-scene", "version": 1,
  "medium": { "keys": { "density": [
    { "time": 0, "value": 0.1, "out": 2.5 },
    { "time": 1, "value": 0.2, "interpolation": "constant", "in": -1, "out": -1, "aligned": true },
    { "time": 2, "value": 0.3, "weight": 7 } ] } },
  "surfaces": [ { "primitive": { "type": "box" }, "material": { "type": "phong" }, "keys": {
    "translate": [ { "time": 0, "value": [1, 2, 3], "out": [0, 1, 0] } ],
    "rotate": [ { "time": 0, "value": [1, 0, 0, 0] },
                { "time": 1, "value": [0, 0, 2.0005, 0], "in": [1, 2] } ],
    "scale": [ { "time": 0, "value": 2 } ],
    "reflectance": [ { "time": 0, "value": [0.1, 0.2, 0.3] } ],
    "specular": [ { "time": 0, "value": [0.1, 0.2, 0.3] } ],
    "exponent": [ { "time": 0, "value": 20 } ],
    "roughness": [ { "time": 0, "value": 1 } ] } } ] })";

std::string with_unit_quaternion() {
  std::string scene = tangents_scene_text;
  return scene.replace(scene.find("2.0005"), 6, "1.0005");
}

TEST(TangentsFile, AreReadWrittenAndReadAgain) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.brume", with_unit_quaternion());
  std::vector<std::string> warnings;
  const SceneDocument document = load_document(file, &warnings);
  const Keys<double>& density = document.scene.density_keys;
  ASSERT_EQ(density.size(), 3u);
  EXPECT_EQ(density[0].out, 2.5);
  EXPECT_EQ(density[0].in, std::nullopt);
  EXPECT_FALSE(density[0].aligned);
  EXPECT_EQ(density[1].in, -1.0);
  EXPECT_TRUE(density[1].aligned);
  EXPECT_EQ(density[1].interpolation, Interpolation::constant);
  const SurfaceKeys& keys = document.scene.surfaces[0].keys;
  EXPECT_EQ(keys.translate[0].out, glm::dvec3(0, 1, 0));
  ASSERT_EQ(keys.rotate.size(), 2u);
  EXPECT_NEAR(glm::length(keys.rotate[1].value), 1.0, 1e-15);
  EXPECT_EQ(keys.exponent[0].value, 20.0);
  // A tangent of a rotation, a weight, and keyframes of what a surface has not are unknown: kept.
  EXPECT_EQ(warnings.size(), 3u);
  save_document(document, folder / "b.brume");
  const SceneDocument loaded = load_document(folder / "b.brume");
  EXPECT_EQ(loaded.extras.unknown_keys, document.extras.unknown_keys);
  EXPECT_EQ(loaded.scene.density_keys, density);
  EXPECT_EQ(loaded.scene.surfaces[0].keys, keys);
  EXPECT_EQ(document_to_json(loaded, folder.path()), document_to_json(document, folder.path()));
}

// Keyframes without tangents, and surfaces without keyframes, are saved as they always were.
TEST(TangentsFile, LeaveOtherFilesAsTheyWere) {
  const TemporaryFolder folder;
  SceneDocument document;
  document.scene.density_keys = {{0.0, 0.5}, {1.0, 0.25, Interpolation::linear}};
  Surface& box = document.scene.surfaces.emplace_back();
  box.primitive = Primitive{};
  box.mesh = mesh_of(*box.primitive);
  const std::string saved = document_to_json(document, folder.path());
  EXPECT_TRUE(contains(saved, R"({ "time": 0.0, "value": 0.5 },)"));
  EXPECT_TRUE(contains(saved, R"({ "time": 1.0, "value": 0.25, "interpolation": "linear" })"));
  const std::string surface = saved.substr(saved.find("\"surfaces\""));
  EXPECT_FALSE(contains(surface, "\"keys\""));
}

}  // namespace
}  // namespace brume
