#include <gtest/gtest.h>

#include <algorithm>

#include "brume/edits.h"
#include "core/io/image/image_file.h"
#include "core/io/scene/json_reader.h"
#include "core/io/scene/scene_file.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/input_error.h"
#include "tests/core/io/scene/random_scene.h"

namespace brume {
namespace {

namespace fs = std::filesystem;

void write_files(const TemporaryFolder& folder) {
  folder.write("bunny.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  folder.write("smoke_1.csv", "x,y,z,radius,density\n1,2,3,0.5,1\n");
  ImageLayers sky;
  sky.width = sky.height = 1;
  for (const char* name : {"R", "G", "B"}) sky.channels[name] = {1.0f};
  write_exr(folder / "dawn.exr", sky);
}

// Adds an unknown key to every object within.
void add_everywhere(Json& value, int& count) {
  if (!value.is_structured()) return;
  for (Json& member : value) add_everywhere(member, count);
  if (value.is_object()) value["later\n"] = Json{++count, {{"a", nullptr}}, "\"x\\"};
}

using UnknownKeys = FolderTest;

TEST_F(UnknownKeys, ArePreservedAndWarnedOfOncePerKind) {
  write_files(folder_);
  const fs::path file =
      folder_.write_scene("a.brume", R"("author": {"name": "\u00e9", "tags": [1, null, 2.5e-7]},
    "camera": {"lens": "x"}, "film": {"gamma": 2},
    "medium": {"kind": 1, "gaussians": [
      {"center": [0, 0, 0], "radius": 1, "density": 1, "colour": "red", "9": []},
      {"center": [0, 0, 0], "radius": 1, "density": 1},
      {"center": [0, 0, 0], "radius": 1, "density": 1, "colour": "blue"}],
      "noise": {"amplitude": 0, "octaves": 3},
      "sequences": [{"file": "smoke_%d.csv", "first": 1, "last": 1, "loops": true}]},
    "timeline": {"last": 2, "speed": 2},
    "lights": [{"type": "point", "position": [0, 0, 0], "owner": "sun"}],
    "environment": {"file": "dawn.exr", "blur": 1},
    "surfaces": [{"mesh": "bunny.obj", "owner": "b", "material": {"roughness": 0.5}}])");
  std::vector<std::string> warnings;
  const SceneDocument document = load_document(file, &warnings);
  for (const char* kind :
       {"author", "camera.lens", "film.gamma", "medium.kind", "medium.gaussians[].colour",
        "medium.gaussians[].9", "medium.noise.octaves", "medium.sequences[].loops",
        "timeline.speed", "lights[].owner", "environment.blur", "surfaces[].owner",
        "surfaces[].material.roughness"}) {
    EXPECT_EQ(std::count_if(warnings.begin(), warnings.end(),
                            [&](const std::string& warning) {
                              return contains(warning, std::string(": ") + kind + ": unknown key");
                            }),
              1)
        << kind;
  }
  EXPECT_EQ(warnings.size(), 13u);
  save_document(document, folder_ / "b.brume");
  const SceneDocument loaded = load_document(folder_ / "b.brume");
  EXPECT_EQ(loaded.extras.unknown_keys, document.extras.unknown_keys);
  EXPECT_EQ(document_to_json(loaded, folder_.path()), content_of(folder_ / "b.brume"));
  const std::string text = content_of(folder_ / "b.brume");
  EXPECT_TRUE(contains(text, R"("colour": "blue")", "2.5e-07"));
}

// Deep unknown values: neither loading nor laying the text out may take exponential time.
TEST_F(UnknownKeys, MayBeDeeplyNested) {
  const std::string deep =
      std::string(60, '[') + "\"" + std::string(200, 'x') + "\"" + std::string(60, ']');
  const SceneDocument document = load_document(
      folder_.write("a.brume", R"({"format": "brume-scene", "version": 1, "deep": )" + deep + "}"));
  save_document(document, folder_ / "b.brume");
  const SceneDocument loaded = load_document(folder_ / "b.brume");
  EXPECT_EQ(loaded.extras.unknown_keys, document.extras.unknown_keys);
  EXPECT_EQ(document_to_json(loaded, folder_.path()), content_of(folder_ / "b.brume"));
}

TEST_F(UnknownKeys, OfEveryObjectComeBack) {
  write_files(folder_);
  int count = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = RandomScene(seed, folder_).make();
    Json json = Json::parse(document_to_json(scene, folder_.path()));
    add_everywhere(json, count);
    const fs::path file = folder_.write("a.brume", json.dump());
    const std::string saved = document_to_json(load_document(file), folder_.path());
    EXPECT_EQ(Json::parse(saved).dump(1), json.dump(1));
  }
}

// Edits of the objects of a scene by someone who does not know of unknown keys.
TEST_F(UnknownKeys, FollowTheirObject) {
  write_files(folder_);
  SceneDocument document = load_document(folder_.write_scene("a.brume", R"("medium": {"gaussians": [
      {"center": [0, 0, 0], "radius": 1, "density": 1, "name": "g0"},
      {"center": [1, 0, 0], "radius": 1, "density": 1, "name": "g1"}]},
    "lights": [
      {"type": "point", "position": [0, 0, 0], "name": "l0"},
      {"type": "point", "position": [1, 0, 0]},
      {"type": "point", "position": [2, 0, 0], "name": "l2", "keys": {"name": "k2", "intensity": [
        {"time": 0, "value": [1, 1, 1], "name": "t0"}, {"time": 1, "value": [2, 2, 2]},
        {"time": 2, "value": [3, 3, 3], "name": "t2"}]}}],
    "surfaces": [{"mesh": "bunny.obj", "name": "s0", "material": {"name": "m0"}},
                 {"mesh": "bunny.obj", "material": {"name": "m1"}}])"));
  const auto saved = [&] { return Json::parse(document_to_json(document, folder_.path())); };
  const Json before = saved();
  const SceneDocument untouched = document;
  const auto name = [](const Json& object) { return object.value("name", ""); };

  std::vector<Light>& lights = document.scene.lights;
  lights.erase(lights.begin());
  std::swap(lights[0], lights[1]);
  lights.push_back(lights[0]);
  lights.insert(lights.begin(), Light{});
  lights[1].keys.intensity[2].time = 0.5;
  std::rotate(lights[1].keys.intensity.begin() + 1, lights[1].keys.intensity.begin() + 2,
              lights[1].keys.intensity.end());
  std::vector<Surface>& surfaces = document.scene.surfaces;
  surfaces[1].material.type = Material::Type::phong;
  std::swap(surfaces[0], surfaces[1]);
  Medium& medium = document.scene.medium;
  const MediumEdit removal = MediumEdit::remove(medium, std::vector{medium.ids()[0]});
  removal.apply(medium);
  medium.append({{5, 5, 5}, 1.0, 1.0});

  Json json = saved();
  ASSERT_EQ(json["lights"].size(), 4u);
  for (const auto& [k, expected] : {std::pair(0, ""), {1, "l2"}, {2, ""}, {3, "l2"}}) {
    EXPECT_EQ(name(json["lights"][k]), expected) << k;
  }
  const Json& keys = json["lights"][1]["keys"];
  EXPECT_EQ(name(keys), "k2");
  for (const auto& [k, expected] : {std::pair(0, "t0"), {1, "t2"}, {2, ""}}) {
    EXPECT_EQ(name(keys["intensity"][k]), expected) << k;
  }
  EXPECT_EQ(name(json["surfaces"][0]), "");
  EXPECT_EQ(name(json["surfaces"][0]["material"]), "m1");
  EXPECT_EQ(name(json["surfaces"][1]), "s0");
  EXPECT_EQ(name(json["surfaces"][1]["material"]), "m0");
  EXPECT_EQ(name(json["medium"]["gaussians"][0]), "g1");
  EXPECT_EQ(name(json["medium"]["gaussians"][1]), "");

  lights = untouched.scene.lights;
  surfaces = untouched.scene.surfaces;
  MediumEdit::remove(medium, std::vector{medium.ids().back()}).apply(medium);
  removal.inverted().apply(medium);
  EXPECT_EQ(saved(), before);
}

}  // namespace
}  // namespace brume
