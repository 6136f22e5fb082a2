#include <gtest/gtest.h>
#include <sys/resource.h>

#include "brume/at_time.h"
#include "brume/limits.h"
#include "core/io/gaussians/gaussian_file.h"
#include "core/io/scene/json_reader.h"
#include "core/io/scene/missing_files.h"
#include "core/io/scene/scene_file.h"
#include "core/scene/animation/particles.h"
#include "core/scene/mesh.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/input_error.h"
#include "tests/core/io/triangle_obj.h"

namespace brume {
namespace {

std::string scene_of(const std::string& members) {
  return R"({ "format": "brume-scene", "version": 1, )" + members + " }";
}

// `count` emitters, each of as many particles as one may have.
std::string emitters(int count, const std::string& more = "") {
  std::string text = R"("emitters": [ )";
  for (int i = 0; i < count; ++i) {
    if (i > 0) text += ", ";
    text += R"({ "position": [0, 0, 0], "rate": 1e9, "lifetime": 1e3 })";
  }
  return text + more + " ]";
}

long max_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;  // [KiB]
}

using SceneBudget = FolderTest;

TEST_F(SceneBudget, EmittersShareTheGaussiansOfTheScene) {
  const auto load = [&](const std::string& medium) {
    return load_scene(folder_.write("a.brume", scene_of(R"("medium": { )" + medium + " }")));
  };
  EXPECT_EQ(gaussian_count(load(emitters(100))), limits::gaussians);
  expect_error(
      [&] { load(emitters(300)); },
      {"a.brume: medium.emitters[100]: found 10100000 Gaussians", "allowed: at most 10000000"});
  const std::string gaussian =
      R"("gaussians": [ { "center": [0, 0, 0], "radius": 1, "density": 1 } ], )";
  expect_error([&] { load(gaussian + emitters(100)); }, "medium.emitters[99]");
}

TEST_F(SceneBudget, CountsAllParticlesThatAreEverThere) {
  Emitter emitter;
  emitter.rate = 7.0;
  emitter.lifetime = 2.3;
  std::size_t max_count = 0;
  for (int i = 0; i < 1000; ++i)
    max_count = std::max(max_count, particles_at(emitter, 0.01 * i).size());
  EXPECT_LE(max_count, max_particles(emitter));
  EXPECT_LE(max_particles(emitter), max_count + 1);
  // With keyframes, whatever is shown now.
  emitter.rate = 0.0;
  EXPECT_EQ(max_particles(emitter), 0u);
  emitter.keys.rate = {{.time = 0.0, .value = 3.0}, {.time = 2.0, .value = 9.0}};
  emitter.keys.lifetime = {{.time = 0.0, .value = 1.0}, {.time = 4.0, .value = 2.0}};
  EXPECT_EQ(max_particles(emitter), 19u);
  for (int i = 0; i < 1000; ++i) {
    EXPECT_LE(particles_at(emitter, 0.01 * i).size(), max_particles(emitter));
  }
  const std::string keyed = R"(, { "position": [0, 0, 0], "rate": 0,
      "keys": { "rate": [ { "time": 5, "value": 1e9 } ] } })";
  expect_error(
      [&] {
        load_scene(
            folder_.write("a.brume", scene_of(R"("medium": { )" + emitters(100, keyed) + " }")));
      },
      "medium.emitters[100]: found 10100000 Gaussians");
}

// Three are left to two frames of two.
TEST_F(SceneBudget, SequencesShareTheGaussiansOfTheScene) {
  const std::vector<Gaussian> two{{{0, 0, 0}, 1.0, 1.0}, {{1, 0, 0}, 1.0, 1.0}};
  write_gaussians(folder_ / "f_0.ply", two);
  write_gaussians(folder_ / "f_1.csv", two);
  write_gaussians(folder_ / "f_1.ply", two);
  const auto load = [&](const std::string& name, double left) {
    std::string last = R"(, { "position": [0, 0, 0], "lifetime": 1, "rate": )";
    last += std::to_string(100'000 - left - 1) + " }";
    return load_scene(folder_.write("a.brume", scene_of(R"("medium": { )" + emitters(99, last) +
                                                        R"(, "sequences": [ { "file": ")" + name +
                                                        R"(", "first": 0, "last": 1 } ] })")));
  };
  EXPECT_EQ(gaussian_count(load("f_%d.ply", 4)), limits::gaussians);
  const std::string error = error_of([&] { load("f_%d.ply", 3); });
  for (const char* part : {"a.brume: medium.sequences[0].file: ", "f_1.ply", "found 2 Gaussians",
                           "allowed: at most 1 in addition to the other Gaussians of the scene"}) {
    EXPECT_TRUE(contains(error, part)) << part << " in " << error;
  }
  std::filesystem::rename(folder_ / "f_0.ply", folder_ / "f_0.csv");
  expect_error([&] { load("f_%d.csv", 3); }, "f_1.csv: line 3: found too many Gaussians");
}

// A mesh of 90,000 triangles, placed as often as surfaces may be.
TEST_F(SceneBudget, SurfacesShareTheMemoryOfTheScene) {
  constexpr int side = 213;
  std::string mesh;
  for (int i = 0; i < side * side; ++i) {
    mesh += "v " + std::to_string(i % side) + " " + std::to_string(i / side) + " 0\n";
  }
  for (int y = 0; y + 1 < side; ++y) {
    for (int x = 0; x + 1 < side; ++x) {
      const int at = 1 + y * side + x;
      mesh += "f " + std::to_string(at) + " " + std::to_string(at + 1) + " " +
              std::to_string(at + side + 1) + " " + std::to_string(at + side) + "\n";
    }
  }
  folder_.write("grid.obj", mesh);
  std::string surfaces = R"("surfaces": [ { "mesh": "grid.obj" })";
  for (std::size_t i = 1; i < limits::surfaces; ++i) surfaces += R"(, { "mesh": "grid.obj" })";
  expect_error([&] { load_scene(folder_.write("a.brume", scene_of(surfaces + " ]"))); },
               {"a.brume: surfaces[", "bytes of memory so far; allowed: at most 8589934592"});
}

// Three bytes of text each, and sixteen times that of memory.
TEST_F(SceneBudget, BoundsTheMemoryOfUnknownKeys) {
  std::string values = "{}";
  for (int i = 1; i < 8'000'000; ++i) values += ",{}";
  const std::string text = scene_of(R"("mystery": [)" + values + "]");
  const long before = max_memory();
  expect_error([&] { parse_json("a.brume", text); },
               "a.brume: mystery: the values up to here take more than");
  EXPECT_LT(max_memory() - before, 15 * static_cast<long>(text.size() / 1024));
}

// These are as dense as they can be written.
TEST_F(SceneBudget, ReadsManyGaussiansWithoutDecimals) {
  std::string values = R"({"center":[0,0,0],"radius":1,"density":1})";
  const std::string one = "," + values;
  for (int i = 1; i < 300'000; ++i) values += one;
  const Scene scene =
      load_scene(folder_.write("a.brume", scene_of(R"("medium":{"gaussians":[)" + values + "]}")));
  EXPECT_EQ(scene.medium.size(), 300'000u);
}

namespace fs = std::filesystem;

constexpr const char* scene_text = R"({
  "format": "brume-scene", "version": 1,
  "medium": { "file": "column.ply",
              "gaussians": [ { "center": [1, 2, 3], "radius": 0.5, "density": 1 } ],
              "sequences": [ { "file": "steam_%02d.csv", "first": 3, "last": 5 } ] },
  "environment": { "file": "sky/dawn.exr", "intensity": 3 },
  "surfaces": [
    { "mesh": "meshes/a.obj", "translate": [1, 0, 0],
      "material": { "type": "measured", "file": "gold.binary" } },
    { "mesh": "meshes/a.obj", "scale": 2 } ]
})";

bool is_visible(const TriangleMesh& mesh) {
  return mesh.points[0] != mesh.points[1];
}

class MissingFilesTest : public FolderTest {
 protected:
  fs::path scene_ = folder_.write("scene.brume", scene_text);
  MissingFiles missing_;
};

TEST_F(MissingFilesTest, AreAnErrorByDefault) {
  expect_error([&] { load_scene(scene_); }, "column.ply");
}

TEST_F(MissingFilesTest, AreListedOnce) {
  load_document(scene_, nullptr, missing_);
  EXPECT_EQ(missing_.missing,
            (std::vector<fs::path>{folder_ / "column.ply", folder_ / "steam_%02d.csv",
                                   folder_ / "sky/dawn.exr", folder_ / "meshes/a.obj",
                                   folder_ / "gold.binary"}));
}

TEST_F(MissingFilesTest, PreserveTheirReferences) {
  const SceneDocument document = load_document(scene_, nullptr, missing_);
  const Scene& scene = document.scene;
  EXPECT_EQ(scene.medium.size(), 1u);
  EXPECT_FALSE(is_visible(*scene.surfaces.at(0).mesh));
  EXPECT_EQ(scene.sequences.at(0).frames->size(), 3u);
  save_document(document, folder_ / "saved.brume");
  const std::string saved = content_of(folder_ / "saved.brume");
  for (const char* text :
       {"\"column.ply\"", "\"steam_%02d.csv\"", "\"sky/dawn.exr\"", "\"meshes/a.obj\"",
        "\"gold.binary\"", "\"measured\"", "\"intensity\": 3"}) {
    EXPECT_TRUE(contains(saved, text)) << text << " in\n" << saved;
  }
  MissingFiles again;
  const SceneDocument loaded = load_document(folder_ / "saved.brume", nullptr, again);
  EXPECT_EQ(again.missing, missing_.missing);
  EXPECT_EQ(document_to_json(loaded, folder_.path()), saved);
}

// Archives of macOS and programs of Windows leave such names.
TEST(SceneReferences, FilesNamedAlikeAreFound) {
  const TemporaryFolder folder;
  const fs::path mesh = folder.write("Gera\u0308te/Stuhl.obj", triangle_obj);
  for (const char* name :
       {"Ger\u00e4te/Stuhl.obj", "geräte/stuhl.OBJ", "Gera\u0308te\\\\Stuhl.obj"}) {
    const fs::path scene = folder.write("a.brume", std::string(
                                                       R"({ "format": "brume-scene", "version": 1,
          "surfaces": [ { "mesh": ")") + name + R"(" } ] })");
    EXPECT_EQ(load_scene(scene).surfaces.at(0).mesh_file, mesh) << name;
    MissingFiles missing;
    load_document(scene, nullptr, missing);
    EXPECT_TRUE(missing.missing.empty()) << name;
  }
}

TEST(SceneReferences, WarnsOfFacesThatAreLeftOut) {
  const TemporaryFolder folder;
  folder.write("a.obj", std::string(triangle_obj) + "f 1 2 99\n");
  const fs::path scene =
      folder.write_scene("a.brume", R"("surfaces": [ { "mesh": "a.obj" }, { "mesh": "a.obj" } ])");
  std::vector<std::string> warnings;
  load_scene(scene, &warnings);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(contains(warnings[0], "surfaces[].mesh: " + (folder / "a.obj").string()));
}

TEST_F(MissingFilesTest, AreReadFromTheirNewPlace) {
  const fs::path mesh = folder_.write("elsewhere/b.obj", triangle_obj);
  folder_.write("elsewhere/steam_03.csv", "x,y,z,radius,density\n1,2,3,0.5,1\n");
  folder_.write("elsewhere/steam_04.csv", "x,y,z,radius,density\n1,2,3,0.5,1\n");
  missing_.found[folder_ / "meshes/a.obj"] = mesh;
  missing_.found[folder_ / "steam_%02d.csv"] = folder_ / "elsewhere/steam_%02d.csv";
  const Scene without = load_document(scene_, nullptr, missing_).scene;
  EXPECT_EQ(without.surfaces.at(1).mesh_file, mesh);
  EXPECT_TRUE(is_visible(*without.surfaces.at(1).mesh));
  // One frame is still missing: the sequence is, where it was looked for.
  EXPECT_EQ(missing_.missing.at(1), folder_ / "elsewhere/steam_%02d.csv");
  folder_.write("elsewhere/steam_05.csv", "x,y,z,radius,density\n1,2,3,0.5,1\n");
  const Scene found = load_document(scene_, nullptr, missing_).scene;
  EXPECT_EQ(found.sequences.at(0).frames->frame(2)->gaussians.size(), 1u);
}

TEST_F(MissingFilesTest, OtherMistakesStayErrors) {
  folder_.write("column.ply", "no ply");
  expect_error([&] { load_document(scene_, nullptr, missing_); }, "column.ply");
}

}  // namespace

}  // namespace brume
