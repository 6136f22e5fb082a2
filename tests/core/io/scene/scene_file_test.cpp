#include "core/io/scene/scene_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/gtc/quaternion.hpp>
#include <random>

#include "core/io/gaussians/gaussian_file.h"
#include "core/io/image/image_file.h"
#include "core/medium/medium_edit.h"
#include "core/scene/mesh.h"
#include "core/scene/radiance_map.h"
#include "tests/core/io/input_error.h"
#include "tests/core/io/temporary_folder.h"

namespace brume {
namespace {

namespace fs = std::filesystem;

constexpr const char* triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

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
  folder.write("bunny.obj", triangle);
  write_gaussians(folder / "column.ply", column);
  ImageLayers sky;
  sky.width = sky.height = 1;
  for (const char* name : {"R", "G", "B"}) sky.channels[name] = {1.0f};
  write_exr(folder / "dawn.exr", sky);
}

// Equal scenes, where what is loaded from the same file counts as the same.
void expect_same(Scene a, const Scene& b) {
  ASSERT_EQ(a.surfaces.size(), b.surfaces.size());
  for (std::size_t i = 0; i < a.surfaces.size(); ++i) {
    ASSERT_NE(a.surfaces[i].mesh, nullptr);
    EXPECT_EQ(a.surfaces[i].mesh->n_faces(), b.surfaces[i].mesh->n_faces());
    a.surfaces[i].mesh = b.surfaces[i].mesh;
  }
  ASSERT_EQ(a.medium_file == nullptr, b.medium_file == nullptr);
  ASSERT_EQ(a.environment.has_value(), b.environment.has_value());
  if (a.environment) {
    ASSERT_NE(a.environment->map, nullptr);
    EXPECT_EQ(a.environment->map->pixels, b.environment->map->pixels);
    a.environment->map = b.environment->map;
  }
  if (a.medium_file) {
    EXPECT_EQ(a.medium_file->file, b.medium_file->file);
    EXPECT_EQ(a.medium_file->gaussians, b.medium_file->gaussians);
    EXPECT_EQ(a.medium_file->ids, b.medium_file->ids);
    a.medium_file = b.medium_file;
  }
  EXPECT_EQ(a, b);
}

Scene minimal() {
  Scene scene;
  scene.camera.eye = {0, 0, 3};
  return scene;
}

TEST(SceneFile, LoadsTheExampleOfTheContract) {
  const TemporaryFolder folder;
  write_example_files(folder);
  std::vector<std::string> warnings;
  const Scene scene = load_scene(folder.write("a.brume", example), &warnings);
  EXPECT_EQ(scene.camera, (Camera{{0, 0.5, 6}, {0, 0, 0}, {0, 1, 0}, 40.0}));
  EXPECT_EQ(scene.film, (Film{800, 600}));
  ASSERT_EQ(scene.medium.size(), 3u);
  EXPECT_EQ(scene.medium.gaussian(0), (Gaussian{{0, 0, 0}, 0.35, 1.25}));
  EXPECT_EQ(scene.medium.gaussian(2), column[1]) << "those of the file come after the inline ones";
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.lights[0].intensity, glm::dvec3(60));
  EXPECT_EQ(scene.environment->file, folder / "dawn.exr");
  EXPECT_EQ(scene.environment->map->pixel(0, 0), glm::vec3(1.0f));
  ASSERT_EQ(scene.surfaces.size(), 1u);
  EXPECT_EQ(scene.surfaces[0].mesh->n_faces(), 1u);
  EXPECT_TRUE(warnings.empty());
}

TEST(SceneFile, HasTheDocumentedDefaults) {
  const TemporaryFolder folder;
  folder.write("m.obj", triangle);
  const Scene scene = load_scene(folder.write(
      "a.brume", R"({"format": "brume-scene", "version": 1, "medium": {}, "film": {}, "camera": {},
      "lights": [{"type": "point", "position": [1, 2, 3]}], "surfaces": [{"mesh": "m.obj"}]})"));
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

// `on` came later than other programs that read scenes: it is written only where it says something.
TEST(SceneFile, WritesWhichLightsAreOff) {
  const TemporaryFolder folder;
  Scene scene;
  scene.lights = {{{1, 2, 3}, {4, 5, 6}, {}, true}, {{1, 2, 3}, {4, 5, 6}, {}, false}};
  save_scene(scene, folder / "a.brume");
  const Scene loaded = load_scene(folder / "a.brume");
  EXPECT_TRUE(loaded.lights[0].on);
  EXPECT_FALSE(loaded.lights[1].on);
  const std::string text = content_of(folder / "a.brume");
  EXPECT_TRUE(contains(text, R"("on": false)"));
  EXPECT_FALSE(contains(text, R"("on": true)"));
}

TEST(SceneFile, SavesTheSameSceneInAnyFolder) {
  const TemporaryFolder folder;
  write_example_files(folder);
  fs::create_directory(folder / "else where");
  const Scene scene = load_scene(folder.write("a.brume", example));
  for (const char* name : {"b.brume", "else where/c.brume"}) {
    SCOPED_TRACE(name);
    save_scene(scene, folder / name);
    expect_same(load_scene(folder / name), scene);
  }
  EXPECT_TRUE(contains(content_of(folder / "b.brume"), R"("mesh": "bunny.obj")"));
  EXPECT_TRUE(contains(content_of(folder / "else where/c.brume"), R"("mesh": "../bunny.obj")"));
}

TEST(SceneFile, PreservesUnknownKeysAndWarnsOncePerKind) {
  const TemporaryFolder folder;
  write_example_files(folder);
  const fs::path file = folder.write("a.brume", R"({
    "format": "brume-scene", "version": 1, "author": {"name": "\u00e9", "tags": [1, null, 2.5e-7]},
    "camera": {"lens": "x"}, "film": {"gamma": 2},
    "medium": {"kind": 1, "gaussians": [
      {"center": [0, 0, 0], "radius": 1, "density": 1, "colour": "red", "9": []},
      {"center": [0, 0, 0], "radius": 1, "density": 1},
      {"center": [0, 0, 0], "radius": 1, "density": 1, "colour": "blue"}],
      "noise": {"amplitude": 0, "octaves": 3}},
    "lights": [{"type": "point", "position": [0, 0, 0], "name": "sun"}],
    "environment": {"file": "dawn.exr", "blur": 1},
    "surfaces": [{"mesh": "bunny.obj", "name": "b", "material": {"roughness": 0.5}}]})");
  std::vector<std::string> warnings;
  const Scene scene = load_scene(file, &warnings);
  for (const char* kind :
       {"author", "camera.lens", "film.gamma", "medium.kind", "medium.gaussians[].colour",
        "medium.gaussians[].9", "medium.noise.octaves", "lights[].name", "environment.blur",
        "surfaces[].name", "surfaces[].material.roughness"}) {
    EXPECT_EQ(std::count_if(warnings.begin(), warnings.end(),
                            [&](const std::string& warning) {
                              return contains(warning, std::string(": ") + kind + ": unknown key");
                            }),
              1)
        << kind;
  }
  EXPECT_EQ(warnings.size(), 11u);
  EXPECT_EQ(scene.unknown_gaussians.size(), 2u);
  save_scene(scene, folder / "b.brume");
  expect_same(load_scene(folder / "b.brume"), scene);
  const std::string text = content_of(folder / "b.brume");
  EXPECT_TRUE(contains(text, R"("colour": "blue")"));
  EXPECT_TRUE(contains(text, "2.5e-07"));
}

TEST(SceneFile, RefersToTheMediumFileWhileItsGaussiansAreUnchanged) {
  const TemporaryFolder folder;
  write_example_files(folder);
  Scene scene = load_scene(folder.write("a.brume", example));
  const auto change = [&](std::size_t index) {
    const std::vector<GaussianId> ids{scene.medium.ids()[index]};
    Gaussian after = scene.medium.gaussian(index);
    after.radius *= 2.0;
    MediumEdit::change(scene.medium, ids, std::vector{after}).apply(scene.medium);
  };
  change(0);  // an inline one
  save_scene(scene, folder / "b.brume");
  EXPECT_TRUE(contains(content_of(folder / "b.brume"), "column.ply"));
  expect_same(load_scene(folder / "b.brume"), scene);

  change(1);  // one of the file
  save_scene(scene, folder / "c.brume");
  EXPECT_FALSE(contains(content_of(folder / "c.brume"), "column.ply"));
  const Scene loaded = load_scene(folder / "c.brume");
  EXPECT_EQ(loaded.medium_file, nullptr);
  EXPECT_EQ(loaded.medium, scene.medium);
  EXPECT_EQ(read_gaussians(folder / "column.ply"), column) << "the file itself is not touched";
}

TEST(SceneFile, DropsTheMediumFileWhenOneOfItsGaussiansIsRemoved) {
  const TemporaryFolder folder;
  write_example_files(folder);
  Scene scene = load_scene(folder.write("a.brume", example));
  MediumEdit::remove(scene.medium, std::vector{scene.medium.ids()[2]}).apply(scene.medium);
  save_scene(scene, folder / "b.brume");
  EXPECT_EQ(load_scene(folder / "b.brume").medium.size(), 2u);
}

TEST(SceneFile, ReadsAMeshOnce) {
  const TemporaryFolder folder;
  folder.write("m.obj", triangle);
  const Scene scene = load_scene(folder.write("a.brume", R"({"format": "brume-scene", "version": 1,
    "surfaces": [{"mesh": "m.obj"}, {"mesh": "./m.obj", "scale": 2}]})"));
  EXPECT_EQ(scene.surfaces[0].mesh, scene.surfaces[1].mesh);
}

TEST(SceneFile, FindsFilesRelativeToTheSceneThroughLinkedFolders) {
  const TemporaryFolder folder;
  folder.write("real/meshes/m.obj", triangle);
  folder.write("real/scenes/a.brume", R"({"format": "brume-scene", "version": 1,
    "surfaces": [{"mesh": "../meshes/m.obj"}]})");
  fs::create_directory_symlink(folder / "real/scenes", folder / "linked");
  const Scene scene = load_scene(folder / "linked/a.brume");
  save_scene(scene, folder / "linked/b.brume");
  expect_same(load_scene(folder / "real/scenes/b.brume"), scene);
}

TEST(SceneFile, AcceptsAByteOrderMarkAndWholeNumbersWithAPoint) {
  const TemporaryFolder folder;
  const Scene scene = load_scene(folder.write(
      "a.brume",
      "\xef\xbb\xbf{\"format\": \"brume-scene\", \"version\": 1.0, \"film\": {\"width\": 64.0}}"));
  EXPECT_EQ(scene.film.width, 64);
}

TEST(SceneFile, NormalisesARotationOnceOnly) {
  const TemporaryFolder folder;
  folder.write("m.obj", triangle);
  const Scene scene = load_scene(folder.write("a.brume", R"({"format": "brume-scene", "version": 1,
    "surfaces": [{"mesh": "m.obj", "rotate": [0.5003, 0.5, 0.5, 0.5]}]})"));
  EXPECT_NEAR(glm::length(scene.surfaces[0].rotate), 1.0, 1e-15);
  save_scene(scene, folder / "b.brume");
  expect_same(load_scene(folder / "b.brume"), scene);
}

TEST(SceneFile, RefusesToSaveWhatCouldNotBeLoaded) {
  const TemporaryFolder folder;
  folder.write("a.brume", "old");
  Scene scene = minimal();
  scene.camera.eye.x = std::nan("");
  EXPECT_TRUE(contains(error_of([&] { save_scene(scene, folder / "a.brume"); }), "not finite"));
  scene = minimal();
  scene.extra_json = "no JSON";
  EXPECT_THROW(save_scene(scene, folder / "a.brume"), InputError);
  EXPECT_EQ(content_of(folder / "a.brume"), "old");
  EXPECT_EQ(folder.entry_count(), 1u);
}

// Deep unknown values: neither loading nor laying the text out may take exponential time.
TEST(SceneFile, PreservesNestedUnknownValues) {
  const TemporaryFolder folder;
  const std::string deep =
      std::string(60, '[') + "\"" + std::string(200, 'x') + "\"" + std::string(60, ']');
  const Scene scene = load_scene(
      folder.write("a.brume", R"({"format": "brume-scene", "version": 1, "deep": )" + deep + "}"));
  save_scene(scene, folder / "b.brume");
  expect_same(load_scene(folder / "b.brume"), scene);
}

class RandomScene {
 public:
  RandomScene(unsigned seed, const TemporaryFolder& folder) : random_(seed), folder_(folder) {}

  Scene make() {
    Scene scene;
    scene.camera = {point(), point(), point(), number(1e-3, 179.0)};
    scene.film = {whole(1, 16384), whole(1, 16384)};
    scene.medium.set_homogeneous_density(maybe() ? number(0.0, 10.0) : 0.0);
    for (int i = whole(0, 30); i > 0; --i) {
      const GaussianId id =
          scene.medium.append({point(), std::exp(number(-20, 20)), std::exp(number(-30, 20))});
      if (const ExtraJson keys = extra_json(); !keys.empty()) scene.unknown_gaussians[id] = keys;
    }
    if (maybe()) scene.optics.albedo = {number(0.01, 1), 1.0, number(0.01, 1)};
    if (maybe()) scene.optics.anisotropy = number(-0.95, 0.95);
    if (maybe()) {
      scene.optics.noise = {number(0, 1), number(0, 9), point(), whole(-1000, 1000), extra_json()};
    }
    for (int i = whole(0, 3); i > 0; --i) {
      scene.emitters.push_back({.position = point(),
                                .rate = number(0, 1e4),
                                .lifetime = number(0, 9),
                                .velocity = point(),
                                .spread = number(0, 9),
                                .acceleration = point(),
                                .radius = {number(0.1, 1), number(0.1, 9)},
                                .density = {number(0, 1), number(0, 9)},
                                .seed = whole(-1000, 1000),
                                .extra_json = extra_json()});
    }
    for (int i = whole(0, 5); i > 0; --i) {
      scene.lights.push_back(
          {point(), {number(0, 90), 0.0, number(0, 1e9)}, extra_json(), maybe()});
    }
    if (maybe())
      scene.environment = {folder_ / "dawn.exr", nullptr, number(0, 3), number(-720, 720),
                           extra_json()};
    for (int i = whole(0, 3); i > 0; --i) {
      Surface surface;
      surface.mesh_file = folder_ / "bunny.obj";
      surface.translate = point();
      surface.rotate =
          glm::normalize(glm::dquat(number(0.1, 1), number(-1, 1), number(-1, 1), number(-1, 1)));
      surface.scale = std::exp(number(-5, 5));
      surface.material.type = maybe() ? Material::Type::phong : Material::Type::diffuse;
      surface.material.reflectance = {number(0, 1), number(0, 1), 1.0};
      if (surface.material.type == Material::Type::phong) {
        surface.material.specular = {0.0, number(0, 1), number(0, 1)};
        surface.material.exponent = number(0, 1000);
      }
      surface.material.extra_json = extra_json();
      surface.transfer = static_cast<Surface::Transfer>(whole(0, 2));
      surface.extra_json = extra_json();
      scene.surfaces.push_back(surface);
    }
    keys(scene.camera_keys.eye, 1e6);
    keys(scene.camera_keys.vertical_fov, 179.0);
    keys(scene.density_keys, 9.0);
    keys(scene.optics.keys.albedo, 1.0);
    keys(scene.optics.noise.keys.amplitude, 2.0);
    for (PointLight& light : scene.lights) {
      keys(light.keys.position, 1e6);
      keys(light.keys.intensity, 1e9);
      light.keys.extra_json = extra_json();
    }
    if (scene.environment) keys(scene.environment->keys.rotation, 720.0);
    scene.camera_keys.extra_json = extra_json();
    scene.optics.keys.extra_json = extra_json();
    scene.extra_json = extra_json();
    scene.unknown_camera = extra_json();
    scene.unknown_film = extra_json();
    scene.unknown_medium = extra_json();
    return scene;
  }

 private:
  double number(double min_value, double max_value) {
    return std::uniform_real_distribution<double>(min_value, max_value)(random_);
  }
  int whole(int min_value, int max_value) {
    return std::uniform_int_distribution<int>(min_value, max_value)(random_);
  }
  bool maybe() { return whole(0, 1) == 0; }
  glm::dvec3 point() { return {number(-1e6, 1e6), number(-1, 1), number(-1e-6, 1e-6)}; }
  double below(double max_value, double) { return number(0.01, max_value); }
  glm::dvec3 below(double max_value, const glm::dvec3&) {
    return {number(0.01, max_value), number(0.01, max_value), number(0.01, max_value)};
  }
  template <class T>
  void keys(Keys<T>& keys, double max_value) {
    double time = number(-9, 9);
    for (int i = maybe() ? whole(0, 4) : 0; i > 0; --i, time += number(1e-3, 5)) {
      keys.push_back(
          {time, below(max_value, T{}), static_cast<Interpolation>(whole(0, 1)), extra_json()});
    }
  }
  ExtraJson extra_json() {
    if (maybe()) return {};
    std::string text = R"({"later\n)";
    text += std::to_string(whole(0, 99));
    return text + R"(":[{"a":null},true,"\"x\\"]})";
  }

  std::mt19937 random_;
  const TemporaryFolder& folder_;
};

TEST(SceneFile, StoresThePlaybackRange) {
  const TemporaryFolder folder;
  const auto load = [&](const std::string& timeline) {
    return load_scene(folder.write(
        "a.brume", R"({"format": "brume-scene", "version": 1, "timeline": )" + timeline + "}"));
  };
  const Scene scene = load(R"({"first": 3, "last": 9, "loop": false, "speed": 2})");
  ASSERT_TRUE(scene.playback);
  EXPECT_EQ(scene.playback->first, 3);
  EXPECT_EQ(scene.playback->last, 9);
  EXPECT_FALSE(scene.playback->loops);
  save_scene(scene, folder / "b.brume");
  EXPECT_EQ(load_scene(folder / "b.brume"), scene);
  EXPECT_TRUE(contains(content_of(folder / "b.brume"), R"("speed": 2)"));
  EXPECT_TRUE(load(R"({"last": 0})").playback->loops);
  for (const char* bad : {R"({"first": 3, "last": 2})", R"({"first": 3})", R"({"last": 1e9})"}) {
    EXPECT_TRUE(contains(error_of([&] { load(bad); }), "timeline.last")) << bad;
  }
}

TEST(SceneFile, NamesSequencesAndReadsTheirFrames) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "smoke");
  const std::vector<GaussianNumber> ids{7, 3};
  write_gaussians(folder / "smoke/s_011.ply", column, ids);
  write_gaussians(folder / "smoke/s_012.ply", column);
  const char* text = R"({"format": "brume-scene", "version": 1, "medium": {"sequences": [
    {"file": "smoke/s_%03d.ply", "first": 11, "last": 12, "start": 0.5, "loops": true}]}})";
  const Scene scene = load_scene(folder.write("a.brume", text));
  ASSERT_EQ(scene.sequences.size(), 1u);
  const std::vector<SequenceFrame>& frames = *scene.sequences[0].frames;
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[0], (SequenceFrame{{3, 7}, {column[1], column[0]}})) << "ordered by id";
  EXPECT_EQ(frames[1], (SequenceFrame{{0, 1}, column})) << "without ids by line";
  EXPECT_EQ(scene.sequences[0].frames_per_second, 30.0);
  EXPECT_EQ(scene.sequences[0].start, 0.5);
  save_scene(scene, folder / "smoke/b.brume");
  EXPECT_TRUE(contains(content_of(folder / "smoke/b.brume"), R"("file": "s_%03d.ply")"));
  EXPECT_TRUE(contains(content_of(folder / "smoke/b.brume"), R"("loops": true)"));
  Scene loaded = load_scene(folder / "smoke/b.brume");
  EXPECT_EQ(*loaded.sequences[0].frames, frames);
  loaded.sequences[0].frames = scene.sequences[0].frames;
  EXPECT_EQ(loaded, scene);

  const auto refusal = [&](const std::string& sequence) {
    return error_of([&] {
      load_scene(folder.write(
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
  write_gaussians(folder / "smoke/s_012.csv", column, twice);
  EXPECT_TRUE(contains(refusal(R"({"file": "smoke/s_%03d.csv", "first": 12, "last": 12})"),
                       "the id 3 twice"));
}

TEST(SceneFile, RandomScenesComeBackTheSame) {
  const TemporaryFolder folder;
  write_example_files(folder);
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = RandomScene(seed, folder).make();
    save_scene(scene, folder / "a.brume");
    Scene loaded = load_scene(folder / "a.brume");
    for (Surface& surface : loaded.surfaces) surface.mesh = nullptr;
    if (loaded.environment) loaded.environment->map = nullptr;
    ASSERT_EQ(scene_to_json(loaded, folder.path()), content_of(folder / "a.brume"));
    ASSERT_TRUE(loaded == scene) << content_of(folder / "a.brume");
  }
}

}  // namespace
}  // namespace brume
