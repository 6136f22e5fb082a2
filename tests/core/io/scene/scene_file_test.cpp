#include "core/io/scene/scene_file.h"

#include <gtest/gtest.h>

#include <glm/gtc/quaternion.hpp>

#include "brume/at_time.h"
#include "brume/edits.h"
#include "core/io/gaussians/gaussian_file.h"
#include "core/io/image/image_file.h"
#include "core/io/scene/json_reader.h"
#include "core/scene/lights/radiance_map.h"
#include "core/scene/mesh.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/input_error.h"
#include "tests/core/io/scene/random_scene.h"
#include "tests/core/io/triangle_obj.h"

namespace brume {
namespace {

namespace fs = std::filesystem;

// The contract's own example, with the files it names beside it.
constexpr const char* example = R"({
  "format": "brume-scene", "version": 1,
  "camera": { "eye": [0, 0.5, 6], "target": [0, 0, 0], "up": [0, 1, 0], "vertical_fov": 40.0 },
  "film":   { "width": 800, "height": 600 },
  "medium": {
    "density": 0.0,
    "gaussians": [ { "center": [0, 0, 0], "radius": 0.35, "density": 1.25 } ],
    "file": "column.ply"
  },
  "lights": [ { "type": "point", "position": [2.5, 2, 1.5], "intensity": [60, 60, 60] } ],
  "environment": { "file": "dawn.exr", "intensity": 1.0, "rotation": 0.0 },
  "surfaces": [
    { "mesh": "bunny.obj", "translate": [0, 0, 0], "rotate": [1, 0, 0, 0], "scale": 1.0,
      "material": { "type": "diffuse", "reflectance": [0.5, 0.5, 0.5] } }
  ]
})";

const std::vector<Gaussian> column{{{0, 1, 0}, 0.5, 0.1}, {{0, 2, 0}, 0.7, 0.2}};

void write_example_files(const TemporaryFolder& folder) {
  folder.write("bunny.obj", triangle_obj);
  write_gaussians(folder / "column.ply", column);
  ImageLayers sky;
  sky.width = sky.height = 1;
  for (const char* name : {"R", "G", "B"}) sky.channels[name] = {1.0f};
  write_exr(folder / "dawn.exr", sky);
}

std::vector<Gaussian> gaussians_of(const MediumFile& file) {
  std::vector<Gaussian> gaussians;
  for (std::size_t i = 0; i < file.loaded.size(); ++i) {
    if (file.contains(file.loaded.ids()[i])) gaussians.push_back(file.loaded.gaussian(i));
  }
  return gaussians;
}

// Equal documents, where what is loaded from the same file counts as the same.
void expect_same(const SceneDocument& loaded, const SceneDocument& expected) {
  EXPECT_EQ(loaded.extras.unknown_keys, expected.extras.unknown_keys);
  const auto& file = loaded.extras.medium_file;
  ASSERT_EQ(file == nullptr, expected.extras.medium_file == nullptr);
  if (file) {
    EXPECT_EQ(file->file, expected.extras.medium_file->file);
    EXPECT_EQ(gaussians_of(*file), gaussians_of(*expected.extras.medium_file));
    EXPECT_EQ(file->first_id, expected.extras.medium_file->first_id);
  }
  Scene a = loaded.scene;
  const Scene& b = expected.scene;
  ASSERT_EQ(a.surfaces.size(), b.surfaces.size());
  for (std::size_t i = 0; i < a.surfaces.size(); ++i) {
    ASSERT_NE(a.surfaces[i].mesh, nullptr);
    EXPECT_EQ(a.surfaces[i].mesh->n_faces(), b.surfaces[i].mesh->n_faces());
    a.surfaces[i].mesh = b.surfaces[i].mesh;
  }
  ASSERT_EQ(a.environment.has_value(), b.environment.has_value());
  if (a.environment) {
    ASSERT_NE(a.environment->map == nullptr, a.environment->sky == std::nullopt);
    if (a.environment->map) {
      EXPECT_EQ(a.environment->map->pixels, b.environment->map->pixels);
    }
    a.environment->map = b.environment->map;
  }
  EXPECT_EQ(a, b);
}

Scene minimal() {
  Scene scene;
  scene.camera.eye = {0, 0, 3};
  return scene;
}

using SceneFile = FolderTest;

TEST_F(SceneFile, LoadsTheExampleOfTheContract) {
  write_example_files(folder_);
  std::vector<std::string> warnings;
  const Scene scene = load_scene(folder_.write("a.brume", example), &warnings);
  EXPECT_EQ(scene.camera, (Camera{{0, 0.5, 6}, {0, 0, 0}, {0, 1, 0}, 40.0}));
  EXPECT_EQ(scene.film, (Film{800, 600}));
  ASSERT_EQ(scene.medium.size(), 3u);
  EXPECT_EQ(scene.medium.gaussian(0), (Gaussian{{0, 0, 0}, 0.35, 1.25}));
  EXPECT_EQ(scene.medium.gaussian(2), column[1]) << "those of the file come after the inline ones";
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.lights[0].intensity, glm::dvec3(60));
  EXPECT_EQ(scene.environment->file, folder_ / "dawn.exr");
  EXPECT_EQ(scene.environment->map->pixel(0, 0), glm::vec3(1.0f));
  ASSERT_EQ(scene.surfaces.size(), 1u);
  EXPECT_EQ(scene.surfaces[0].mesh->n_faces(), 1u);
  EXPECT_TRUE(warnings.empty());
}

TEST_F(SceneFile, HasTheDocumentedDefaults) {
  folder_.write("m.obj", triangle_obj);
  const Scene scene =
      load_scene(folder_.write_scene("a.brume", R"("medium": {}, "film": {}, "camera": {},
      "lights": [{"type": "point", "position": [1, 2, 3]}], "surfaces": [{"mesh": "m.obj"}])"));
  EXPECT_EQ(scene.camera, Camera{});
  EXPECT_EQ(scene.camera.vertical_fov, 45.0);
  EXPECT_EQ(scene.film, Film{});
  EXPECT_EQ(scene.medium, Medium{});
  EXPECT_EQ(scene.optics, MediumOptics{});
  EXPECT_EQ(scene.lights[0].intensity, glm::dvec3(1));
  EXPECT_TRUE(scene.lights[0].on);
  EXPECT_EQ(scene.surfaces[0].material, Material{});
  EXPECT_EQ(scene.surfaces[0].material.reflectance, glm::dvec3(0.5));
  EXPECT_EQ(scene.surfaces[0].rotate, glm::dquat(1, 0, 0, 0));
  EXPECT_FALSE(scene.environment);
}

TEST_F(SceneFile, SavesTheSameSceneInAnyFolder) {
  write_example_files(folder_);
  fs::create_directory(folder_ / "else where");
  const SceneDocument document = load_document(folder_.write("a.brume", example));
  for (const char* name : {"b.brume", "else where/c.brume"}) {
    SCOPED_TRACE(name);
    save_document(document, folder_ / name);
    expect_same(load_document(folder_ / name), document);
  }
  EXPECT_TRUE(contains(content_of(folder_ / "b.brume"), R"("mesh": "bunny.obj")"));
  EXPECT_TRUE(contains(content_of(folder_ / "else where/c.brume"), R"("mesh": "../bunny.obj")"));
}

TEST_F(SceneFile, RefersToTheMediumFileWhileItsGaussiansAreUnchanged) {
  write_example_files(folder_);
  SceneDocument document = load_document(folder_.write("a.brume", example));
  Medium& medium = document.scene.medium;
  const auto change = [&medium](std::size_t index) {
    const std::vector<GaussianId> ids{medium.ids()[index]};
    Gaussian after = medium.gaussian(index);
    after.radius *= 2.0;
    return MediumEdit::change(medium, ids, std::vector{after});
  };
  change(0).apply(medium);  // an inline one
  save_document(document, folder_ / "b.brume");
  EXPECT_TRUE(contains(content_of(folder_ / "b.brume"), "column.ply"));
  expect_same(load_document(folder_ / "b.brume"), document);

  const MediumEdit edit = change(1);  // one of the file
  edit.apply(medium);
  save_document(document, folder_ / "c.brume");
  EXPECT_FALSE(contains(content_of(folder_ / "c.brume"), "column.ply"));
  const SceneDocument loaded = load_document(folder_ / "c.brume");
  EXPECT_EQ(loaded.extras.medium_file, nullptr);
  EXPECT_EQ(loaded.scene.medium, medium);
  edit.inverted().apply(medium);
  EXPECT_EQ(document_to_json(document, folder_.path()), content_of(folder_ / "b.brume"));
  EXPECT_EQ(read_gaussians(folder_ / "column.ply"), column) << "the file itself is not touched";
}

TEST_F(SceneFile, KeepsTheIdsOfTheMediumFileThatAreAboveThoseBefore) {
  const auto ids_of = [&](const std::string& inline_gaussians, const std::string& file) {
    folder_.write("a.csv", file);
    const SceneDocument document = load_document(
        folder_.write("a.brume", R"({"format": "brume-scene", "version": 1, "medium": {"groups": [
                                    {"name": "g"}], "gaussians": [)" +
                                     inline_gaussians + R"(], "file": "a.csv"}})"));
    const Medium& medium = document.scene.medium;
    save_document(document, folder_ / "b.brume");
    EXPECT_TRUE(contains(content_of(folder_ / "b.brume"), "a.csv"));
    EXPECT_EQ(load_document(folder_ / "b.brume").scene.medium, medium);
    return std::vector(medium.ids().begin(), medium.ids().end());
  };
  const std::string one = R"({"center": [0, 0, 0], "radius": 1, "density": 1})";
  const std::string heading = "x,y,z,radius,density,id,group\n";
  using Ids = std::vector<GaussianId>;
  EXPECT_EQ(ids_of(one, heading + "1,0,0,1,1,7,1\n2,0,0,1,1,9,0\n"), (Ids{1, 7, 9}));
  EXPECT_EQ(ids_of("", heading + "1,0,0,1,1,9,0\n2,0,0,1,1,7,0\n"), (Ids{7, 9})) << "in any order";
  EXPECT_EQ(ids_of(one, heading + "1,0,0,1,1,1,0\n2,0,0,1,1,9,0\n"), (Ids{1, 2, 3})) << "taken";
  EXPECT_EQ(ids_of(one, heading + "1,0,0,1,1,7,0\n2,0,0,1,1,7,0\n"), (Ids{1, 2, 3})) << "twice";
  EXPECT_EQ(ids_of(one, heading + "1,0,0,1,1,left,1\n2,0,0,1,1,right,0\n"), (Ids{1, 2, 3}));
}

TEST_F(SceneFile, DropsTheMediumFileWhenOneOfItsGaussiansIsRemoved) {
  write_example_files(folder_);
  SceneDocument document = load_document(folder_.write("a.brume", example));
  Medium& medium = document.scene.medium;
  MediumEdit::remove(medium, std::vector{medium.ids()[2]}).apply(medium);
  save_document(document, folder_ / "b.brume");
  EXPECT_EQ(load_scene(folder_ / "b.brume").medium.size(), 2u);
}

TEST_F(SceneFile, ReadsAMeshOnce) {
  folder_.write("m.obj", triangle_obj);
  const Scene scene = load_scene(folder_.write_scene(
      "a.brume", R"("surfaces": [{"mesh": "m.obj"}, {"mesh": "./m.obj", "scale": 2}])"));
  EXPECT_EQ(scene.surfaces[0].mesh, scene.surfaces[1].mesh);
}

TEST_F(SceneFile, FindsFilesRelativeToTheSceneThroughLinkedFolders) {
  folder_.write("real/meshes/m.obj", triangle_obj);
  folder_.write_scene("real/scenes/a.brume", R"("surfaces": [{"mesh": "../meshes/m.obj"}])");
  fs::create_directory_symlink(folder_ / "real/scenes", folder_ / "linked");
  const Scene scene = load_scene(folder_ / "linked/a.brume");
  save_document(scene, folder_ / "linked/b.brume");
  expect_same(load_document(folder_ / "real/scenes/b.brume"), scene);
}

TEST_F(SceneFile, AcceptsAByteOrderMarkAndWholeNumbersWithAPoint) {
  const Scene scene = load_scene(folder_.write(
      "a.brume",
      "\xef\xbb\xbf{\"format\": \"brume-scene\", \"version\": 1.0, \"film\": {\"width\": 64.0}}"));
  EXPECT_EQ(scene.film.width, 64);
}

TEST_F(SceneFile, NormalisesARotationOnceOnly) {
  folder_.write("m.obj", triangle_obj);
  const Scene scene = load_scene(folder_.write_scene(
      "a.brume", R"("surfaces": [{"mesh": "m.obj", "rotate": [0.5003, 0.5, 0.5, 0.5]}])"));
  EXPECT_NEAR(glm::length(scene.surfaces[0].rotate), 1.0, 1e-15);
  save_document(scene, folder_ / "b.brume");
  expect_same(load_document(folder_ / "b.brume"), scene);
}

TEST_F(SceneFile, RefusesToSaveWhatCouldNotBeLoaded) {
  folder_.write("a.brume", "old");
  Scene scene = minimal();
  scene.camera.eye.x = std::nan("");
  expect_error([&] { save_document(scene, folder_ / "a.brume"); }, "not finite");
  SceneDocument document = minimal();
  document.extras.unknown_keys.add("", "no JSON");
  EXPECT_THROW(save_document(document, folder_ / "a.brume"), InputError);
  EXPECT_EQ(content_of(folder_ / "a.brume"), "old");
  EXPECT_EQ(folder_.entry_count(), 1u);
}

TEST_F(SceneFile, StoresThePlaybackRange) {
  const auto load = [&](const std::string& timeline) {
    return load_scene(folder_.write(
        "a.brume", R"({"format": "brume-scene", "version": 1, "timeline": )" + timeline + "}"));
  };
  const Scene scene = load(R"({"first": 3, "last": 9, "loop": false})");
  ASSERT_TRUE(scene.playback);
  EXPECT_EQ(scene.playback->first, 3);
  EXPECT_EQ(scene.playback->last, 9);
  EXPECT_FALSE(scene.playback->loops);
  save_document(scene, folder_ / "b.brume");
  EXPECT_EQ(load_scene(folder_ / "b.brume"), scene);
  EXPECT_TRUE(load(R"({"last": 0})").playback->loops);
  for (const char* bad : {R"({"first": 3, "last": 2})", R"({"first": 3})", R"({"last": 1e9})"}) {
    EXPECT_TRUE(contains(error_of([&] { load(bad); }), "timeline.last")) << bad;
  }
}

TEST_F(SceneFile, SequencesCarryAlbedoAndEmission) {
  const std::vector<GaussianNumber> ids{7, 3};
  const GaussianOptics first{glm::dvec3(0.25, 0.5, 1.0), {8, 0, 0}};
  const GaussianOptics second{glm::dvec3(0.75, 0.5, 1.0), {0, 0, 4}};
  for (const std::string type : {"ply", "csv"}) {
    const auto write = [&](const char* number, const GaussianOptics& optics) {
      const std::vector<Gaussian> gaussians{{{}, 1.0, 1.0, optics}, {{}, 1.0, 1.0}};
      write_gaussians(folder_ / (number + type), gaussians, ids);
    };
    write("s_1.", first);
    write("s_2.", second);
    const std::string text =
        R"({"format": "brume-scene", "version": 1, "medium": {"sequences": [
           {"file": "s_%d.)" +
        type + R"(", "first": 1, "last": 2, "frames_per_second": 1}]}})";
    const Scene scene = load_scene(folder_.write("a.brume", text));
    EXPECT_EQ(evaluate_at(scene, 0.0).medium.optics(1), first) << type;
    EXPECT_EQ(evaluate_at(scene, 1.0).medium.optics(1), second) << type;
    const Medium halfway = evaluate_at(scene, 0.5).medium;
    EXPECT_EQ(halfway.optics(1), (GaussianOptics{glm::dvec3(0.5, 0.5, 1.0), {4, 0, 2}})) << type;
    EXPECT_EQ(halfway.optics(0), GaussianOptics()) << type;
  }
}

TEST_F(SceneFile, NamesSequencesAndReadsTheirFrames) {
  fs::create_directory(folder_ / "smoke");
  const std::vector<GaussianNumber> ids{7, 3};
  write_gaussians(folder_ / "smoke/s_011.ply", column, ids);
  write_gaussians(folder_ / "smoke/s_012.ply", column);
  const char* text = R"({"format": "brume-scene", "version": 1, "medium": {"sequences": [
    {"file": "smoke/s_%03d.ply", "first": 11, "last": 12, "start": 0.5}]}})";
  const Scene scene = load_scene(folder_.write("a.brume", text));
  ASSERT_EQ(scene.sequences.size(), 1u);
  const SequenceFrames& frames = *scene.sequences[0].frames;
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(*frames.frame(0), (SequenceFrame{{3, 7}, {column[1], column[0]}})) << "ordered by id";
  EXPECT_EQ(*frames.frame(1), (SequenceFrame{{0, 1}, column})) << "without ids by line";
  EXPECT_EQ(scene.sequences[0].frames_per_second, 30.0);
  EXPECT_EQ(scene.sequences[0].start, 0.5);
  save_document(scene, folder_ / "smoke/b.brume");
  EXPECT_TRUE(contains(content_of(folder_ / "smoke/b.brume"), R"("file": "s_%03d.ply")"));
  Scene loaded = load_scene(folder_ / "smoke/b.brume");
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(*loaded.sequences[0].frames->frame(i), *frames.frame(i));
  }
  loaded.sequences[0].frames = scene.sequences[0].frames;
  EXPECT_EQ(loaded, scene);

  const auto refusal = [&](const std::string& sequence) {
    return error_of([&] {
      load_scene(folder_.write(
          "bad.brume", R"({"format": "brume-scene", "version": 1, "medium": {"sequences": [)" +
                           sequence + "]}}"));
    });
  };
  EXPECT_TRUE(
      contains(refusal(R"({"file": "smoke/s_%03d.ply", "first": 11, "last": 13})"), "s_013.ply"));
  EXPECT_TRUE(contains(refusal(R"({"file": "smoke/s_011.ply"})"), "medium.sequences[0].file"));
  EXPECT_TRUE(contains(refusal(R"({"file": "smoke/s_%03d.ply", "first": 12, "last": 11})"),
                       "medium.sequences[0].last"));
  EXPECT_TRUE(
      contains(refusal(R"({"file": "smoke/s_%03d.ply", "first": 11, "frames_per_second": 0})"),
               "frames_per_second"));
  EXPECT_TRUE(
      contains(refusal(R"({"file": "s_%03d.ply", "last": 2000000})"), "medium.sequences[0].last"));
  const std::vector<GaussianNumber> twice{3, 3};
  write_gaussians(folder_ / "smoke/s_012.csv", column, twice);
  EXPECT_TRUE(contains(refusal(R"({"file": "smoke/s_%03d.csv", "first": 12, "last": 12})"),
                       "the id 3 twice"));
}

TEST_F(SceneFile, RandomScenesComeBackTheSame) {
  write_example_files(folder_);
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = RandomScene(seed, folder_).make();
    save_document(scene, folder_ / "a.brume");
    Scene loaded = load_scene(folder_ / "a.brume");
    for (Surface& surface : loaded.surfaces) surface.mesh = nullptr;
    if (loaded.environment) loaded.environment->map = nullptr;
    ASSERT_EQ(document_to_json(loaded, folder_.path()), content_of(folder_ / "a.brume"));
    ASSERT_TRUE(loaded == scene) << content_of(folder_ / "a.brume");
  }
}

// Ids stay what they were where Gaussians were removed; a file tells only what they skip.
TEST_F(SceneFile, KeepsTheIdsOfGaussians) {
  Scene scene;
  for (int i = 0; i < 6; ++i) scene.medium.append({{1.0 * i, 0.0, 0.0}, 1.0, 1.0});
  save_document({scene}, folder_ / "whole.brume");
  EXPECT_FALSE(contains(content_of(folder_ / "whole.brume"), "\"id\""));
  const std::vector<GaussianId> removed{1, 4};
  MediumEdit::remove(scene.medium, removed).apply(scene.medium);
  save_document({scene}, folder_ / "edited.brume");
  const Scene loaded = load_scene(folder_ / "edited.brume");
  EXPECT_EQ(loaded.medium, scene.medium);
  const Json json = Json::parse(content_of(folder_ / "edited.brume"));
  const Json& gaussians = json["medium"]["gaussians"];
  EXPECT_EQ(gaussians[0]["id"], 2);
  EXPECT_FALSE(gaussians[1].contains("id"));
  EXPECT_EQ(gaussians[2]["id"], 5);
}

// Before there were ids, the key was another program's: what is no id is kept as it is.
TEST_F(SceneFile, KeepsWhatIsNoIdAsAnUnknownKey) {
  const auto file = folder_.write_scene("a.brume", R"("medium": { "gaussians": [
      { "center": [0, 0, 0], "radius": 1, "density": 1, "id": 7 },
      { "center": [1, 0, 0], "radius": 1, "density": 1, "id": "puff" },
      { "center": [2, 0, 0], "radius": 1, "density": 1, "id": 3 } ] })");
  std::vector<std::string> warnings;
  const SceneDocument document = load_document(file, &warnings);
  EXPECT_EQ(document.scene.medium.ids()[0], 7u);
  EXPECT_EQ(document.scene.medium.ids()[2], 9u);
  EXPECT_EQ(warnings.size(), 1u);
  save_document(document, folder_ / "b.brume");
  const Json saved = Json::parse(content_of(folder_ / "b.brume"))["medium"]["gaussians"];
  EXPECT_EQ(saved[0]["id"], 7);
  EXPECT_EQ(saved[1]["id"], "puff");
  EXPECT_EQ(saved[2]["id"], 3);
}

}  // namespace
}  // namespace brume
