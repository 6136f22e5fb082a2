#include <gtest/gtest.h>

#include "brume/at_time.h"
#include "core/io/scene/gather.h"
#include "core/io/scene/scene_file.h"
#include "core/scene/cameras.h"
#include "tests/contains.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/input_error.h"

namespace brume {
namespace {

class CamerasAndOutput : public FolderTest {
 protected:
  [[nodiscard]] std::filesystem::path write(const std::string& members) const {
    return folder_.write("a.brume", R"({"format": "brume-scene", "version": 1, )" + members + "}");
  }
  void expect_refused(const std::string& members, const std::string& place) const {
    SCOPED_TRACE(members);
    const std::string error = error_of([&] { load_document(write(members)); });
    EXPECT_TRUE(contains(error, ": " + place));
    EXPECT_TRUE(contains(error, "allowed") || contains(error, "missing"));
  }
  [[nodiscard]] std::string saved(const Scene& scene) const {
    return document_to_json(scene, folder_.path());
  }
};

TEST_F(CamerasAndOutput, OfAPlainSceneAreNotWritten) {
  const std::string text = saved(load_scene(write(R"("camera": {"eye": [0, 0, 3]})")));
  for (const char* key : {"cameras", "\"name\"", "output", "frames_per_second", "aperture",
                          "focus_distance", "roll"}) {
    EXPECT_FALSE(contains(text, key));
  }
}

TEST_F(CamerasAndOutput, ComeBackWithTheirUnknownKeys) {
  const SceneDocument document = load_document(write(R"(
    "camera": {"name": "Wide", "eye": [0, 0, 3], "aperture": 0.1, "maker": "A", "focus_distance": 2,
               "keys": {"aperture": [{"time": 1, "value": 0.2}],
                        "focus_distance": [{"time": 2, "value": 5}]}},
    "cameras": [{"name": "Close", "eye": [1, 0, 0], "vertical_fov": 20, "maker": "B",
                 "keys": {"eye": [{"time": 1, "value": [2, 0, 0]}]}}],
    "output": {"file": "renders/shot.exr", "paths": 64, "denoise": "solved", "samples": 32,
               "shutter": [-0.25, 0.25], "exposure": -0.5, "layers": ["Z"],
               "quality": "high"},
    "timeline": {"last": 9, "frames_per_second": 24})"));
  const Scene& scene = document.scene;
  EXPECT_EQ(scene.camera_name, "Wide");
  ASSERT_EQ(scene.cameras.size(), 1U);
  EXPECT_EQ(scene.cameras[0].camera.vertical_fov, 20.0);
  EXPECT_EQ(scene.cameras[0].keys.eye.size(), 1U);
  EXPECT_EQ(scene.output.file, std::filesystem::canonical(folder_.path()) / "renders/shot.exr");
  EXPECT_EQ(scene.output.paths, 64);
  EXPECT_EQ(scene.output.denoise, Denoising::solved);
  EXPECT_EQ(scene.camera.aperture, 0.1);
  EXPECT_EQ(scene.camera.focus_distance, 2.0);
  EXPECT_EQ(scene.camera_keys.aperture.size(), 1U);
  EXPECT_EQ(scene.camera_keys.focus_distance.size(), 1U);
  EXPECT_EQ(scene.output.samples, 32);
  EXPECT_EQ(scene.output.shutter, (Shutter{-0.25, 0.25}));
  EXPECT_EQ(scene.output.exposure, -0.5);
  EXPECT_EQ(scene.output.layers, (OutputLayers{false, false, true}));
  EXPECT_EQ(scene.playback->frames_per_second, 24.0);
  save_document(document, folder_ / "b.brume");
  const SceneDocument loaded = load_document(folder_ / "b.brume");
  EXPECT_EQ(loaded.scene, scene);
  EXPECT_EQ(loaded.extras.unknown_keys, document.extras.unknown_keys);
  const std::string text = content_of(folder_ / "b.brume");
  EXPECT_TRUE(contains(text, R"("file": "renders/shot.exr")", R"("quality": "high")"));

  // A camera that is put in use takes its unknown keys along.
  SceneDocument other = document;
  ASSERT_TRUE(use_camera(other.scene, "Close"));
  save_document(other, folder_ / "c.brume");
  const std::string swapped = content_of(folder_ / "c.brume");
  EXPECT_LT(swapped.find(R"("maker": "B")"), swapped.find(R"("maker": "A")"));
  ASSERT_TRUE(use_camera(other.scene, "Wide"));
  EXPECT_EQ(other.scene, scene);
}

TEST_F(CamerasAndOutput, OrthographicOnesComeBackWithoutAnAngle) {
  std::vector<std::string> warnings;
  const SceneDocument document = load_document(write(R"(
    "camera": {"eye": [0, 0, 3], "height": 2.5, "aperture": 0,
               "keys": {"height": [{"time": 1, "value": 4}]}},
    "cameras": [{"name": "Map", "eye": [0, 9, 0], "up": [0, 0, -1], "height": 100}])"),
                                               &warnings);
  const Scene& scene = document.scene;
  EXPECT_EQ(scene.camera.height, 2.5);
  EXPECT_EQ(scene.camera_keys.height.size(), 1U);
  EXPECT_EQ(scene.cameras[0].camera.height, 100.0);
  EXPECT_EQ(evaluate_at(scene, 1.0).camera.height, 4.0);
  EXPECT_TRUE(warnings.empty());
  const std::string text = document_to_json(document, folder_.path());
  EXPECT_FALSE(contains(text, "vertical_fov"));
  EXPECT_FALSE(contains(text, "aperture"));
  const Scene again = load_scene(folder_.write("b.brume", text));
  EXPECT_EQ(again.camera, scene.camera);
  EXPECT_EQ(again.camera_keys, scene.camera_keys);
  EXPECT_EQ(again.cameras[0].camera, scene.cameras[0].camera);
}

// They are unknown as those of any value that is not there.
TEST_F(CamerasAndOutput, KeyframesOfAHeightThatIsNotThereAreUnknown) {
  std::vector<std::string> warnings;
  const SceneDocument height = load_document(
      write(R"("camera": {"keys": {"height": [{"time": 1, "value": 30}]}})"), &warnings);
  EXPECT_TRUE(height.scene.camera_keys.height.empty());
  EXPECT_EQ(warnings.size(), 1U);
}

TEST_F(CamerasAndOutput, RefuseMistakes) {
  expect_refused(R"("camera": {"vertical_fov": 40, "height": 2})", "camera.height: ");
  expect_refused(R"("camera": {"aperture": 0.1, "height": 2})", "camera.height: ");
  expect_refused(R"("camera": {"height": 2, "keys": {"vertical_fov": [{"time": 1, "value": 30}]}})",
                 "camera.height: found beside keys.vertical_fov; allowed: one of the two");
  expect_refused(R"("camera": {"height": 2, "keys": {"aperture": [{"time": 1, "value": 1}]}})",
                 "camera.height: found beside keys.aperture; allowed: one of the two");
  expect_refused(R"("cameras": [{"name": "A", "vertical_fov": 40, "height": 2}])",
                 "cameras[0].height: found beside vertical_fov");
  for (const char* name : {"1", "null", "[]", R"("")", R"("a\nb")"}) {
    expect_refused(std::string(R"("camera": {"name": )") + name + "}", "camera.name");
    expect_refused(std::string(R"("cameras": [{"name": )") + name + "}]", "cameras[0].name");
  }
  expect_refused(R"("cameras": [{"name": ")" + std::string(257, 'x') + R"("}])", "cameras[0].name");
  expect_refused(R"("cameras": [{}])", "cameras[0].name");
  expect_refused(R"("cameras": [{"name": "Camera"}])", "cameras[0].name");
  expect_refused(R"("cameras": [{"name": "A"}, {"name": "A"}])", "cameras[1].name");
  expect_refused(R"("cameras": [{"name": "A", "vertical_fov": 180}])", "cameras[0].vertical_fov");
  expect_refused(R"("cameras": [{"name": "A", "eye": [0, 0, 0]}])", "cameras[0].target");
  for (const char* eye : {"1", "[1, 2]", "[1, 2, 1e300]", "null"}) {
    expect_refused(std::string(R"("cameras": [{"name": "A", "eye": )") + eye + "}]",
                   "cameras[0].eye");
  }
  for (const char* cameras : {"1", "{}", "null"}) {
    expect_refused(std::string(R"("cameras": )") + cameras, "cameras");
  }
  for (const char* file : {"1", "null", R"("")", R"("..")", R"("a.jpg")", R"("a")", R"("b/")",
                           R"("a\u0000.png")", R"(".png")"}) {
    expect_refused(std::string(R"("output": {"file": )") + file + "}", "output.file");
  }
  for (const char* paths : {"0", "-1", "1.5", "1000001", R"("9")", "null"}) {
    expect_refused(std::string(R"("output": {"paths": )") + paths + "}", "output.paths");
  }
  for (const char* denoise : {"1", "null", R"("")", R"("path")"}) {
    expect_refused(std::string(R"("output": {"denoise": )") + denoise + "}", "output.denoise");
  }
  for (const char* samples : {"0", "-1", "1.5", "4097", R"("9")", "null"}) {
    expect_refused(std::string(R"("output": {"samples": )") + samples + "}", "output.samples");
  }
  for (const char* shutter :
       {"0.5", "[0]", "[0, 0]", "[0.5, 0]", R"(["0", "1"])", "null", "[0, 1, 2]", "{}"}) {
    expect_refused(std::string(R"("output": {"shutter": )") + shutter + "}", "output.shutter");
  }
  expect_refused(R"("output": {"shutter": [-3, 0]})", "output.shutter[0]");
  expect_refused(R"("output": {"shutter": [0, 1e300]})", "output.shutter[1]");
  for (const char* exposure : {"61", "-61", R"("0")", "null"}) {
    expect_refused(std::string(R"("output": {"exposure": )") + exposure + "}", "output.exposure");
  }
  for (const char* layer : {"1", "null", R"("depth")", R"("z")"}) {
    expect_refused(std::string(R"("output": {"layers": [)") + layer + "]}", "output.layers[0]");
  }
  expect_refused(R"("output": {"layers": ["Z", "Z"]})", "output.layers[1]");
  expect_refused(R"("output": {"layers": "Z"})", "output.layers");
  for (const char* rate : {"0", "0.5", "1001", R"("24")", "null"}) {
    expect_refused(std::string(R"("timeline": {"last": 9, "frames_per_second": )") + rate + "}",
                   "timeline.frames_per_second");
  }
}

TEST_F(CamerasAndOutput, GatheredScenesRenderIntoTheirOwnFolder) {
  Scene scene;
  scene.output.file = "/elsewhere/shot.png";
  ASSERT_TRUE(gather_scene(scene, folder_ / "all", "a", {}));
  EXPECT_TRUE(contains(content_of(folder_ / "all/a.brume"), R"("file": "shot.png")"));
}

TEST(Lens, FocalLengthAndFieldOfViewAgree) {
  const Film film{1920, 1080};
  // tan(fov / 2) = sensor height / (2 f)
  EXPECT_NEAR(vertical_fov(50.0, film), 22.895, 1e-3);
  EXPECT_NEAR(vertical_fov(18.0, {100, 100}), 90.0, 1e-12);
  for (const double fov : {1.0, 45.0, 120.0}) {
    EXPECT_NEAR(vertical_fov(focal_length(fov, film), film), fov, 1e-12);
  }
}

TEST(Lens, NewCamerasGetFreeNames) {
  Scene scene;
  EXPECT_EQ(free_camera_name(scene, "Camera"), "Camera 2");
  scene.cameras.emplace_back().name = "Camera 2";
  EXPECT_EQ(free_camera_name(scene, "Camera"), "Camera 3");
  EXPECT_EQ(free_camera_name(scene, "Wide"), "Wide");
}

// Tangents, and keyframes of surfaces, in scene files.

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
  EXPECT_TRUE(contains(saved, R"({ "time": 0.0, "value": 0.5 },)",
                       R"({ "time": 1.0, "value": 0.25, "interpolation": "linear" })"));
  const std::string surface = saved.substr(saved.find("\"surfaces\""));
  EXPECT_FALSE(contains(surface, "\"keys\""));
}

}  // namespace

}  // namespace brume
