#include <gtest/gtest.h>
#include <sys/resource.h>

#include "brume/at_time.h"
#include "brume/limits.h"
#include "core/io/gaussians/gaussian_file.h"
#include "core/io/scene/json_reader.h"
#include "core/io/scene/scene_file.h"
#include "core/scene/animation/particles.h"
#include "tests/core/io/input_error.h"
#include "tests/core/io/temporary_folder.h"

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

TEST(SceneBudget, EmittersShareTheGaussiansOfTheScene) {
  const TemporaryFolder folder;
  const auto load = [&](const std::string& medium) {
    return load_scene(folder.write("a.brume", scene_of(R"("medium": { )" + medium + " }")));
  };
  EXPECT_EQ(gaussian_count(load(emitters(100))), limits::gaussians);
  expect_error(
      [&] { load(emitters(300)); },
      {"a.brume: medium.emitters[100]: found 10100000 Gaussians", "allowed: at most 10000000"});
  const std::string gaussian =
      R"("gaussians": [ { "center": [0, 0, 0], "radius": 1, "density": 1 } ], )";
  expect_error([&] { load(gaussian + emitters(100)); }, "medium.emitters[99]");
}

TEST(SceneBudget, CountsAllParticlesThatAreEverThere) {
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
  const TemporaryFolder folder;
  const std::string keyed = R"(, { "position": [0, 0, 0], "rate": 0,
      "keys": { "rate": [ { "time": 5, "value": 1e9 } ] } })";
  expect_error(
      [&] {
        load_scene(
            folder.write("a.brume", scene_of(R"("medium": { )" + emitters(100, keyed) + " }")));
      },
      "medium.emitters[100]: found 10100000 Gaussians");
}

// Three are left to two frames of two.
TEST(SceneBudget, SequencesShareTheGaussiansOfTheScene) {
  const TemporaryFolder folder;
  const std::vector<Gaussian> two{{{0, 0, 0}, 1.0, 1.0}, {{1, 0, 0}, 1.0, 1.0}};
  write_gaussians(folder / "f_0.ply", two);
  write_gaussians(folder / "f_1.csv", two);
  write_gaussians(folder / "f_1.ply", two);
  const auto load = [&](const std::string& name, double left) {
    std::string last = R"(, { "position": [0, 0, 0], "lifetime": 1, "rate": )";
    last += std::to_string(100'000 - left - 1) + " }";
    return load_scene(folder.write("a.brume", scene_of(R"("medium": { )" + emitters(99, last) +
                                                       R"(, "sequences": [ { "file": ")" + name +
                                                       R"(", "first": 0, "last": 1 } ] })")));
  };
  EXPECT_EQ(gaussian_count(load("f_%d.ply", 4)), limits::gaussians);
  const std::string error = error_of([&] { load("f_%d.ply", 3); });
  for (const char* part : {"a.brume: medium.sequences[0].file: ", "f_1.ply", "found 2 Gaussians",
                           "allowed: at most 1 in addition to the other Gaussians of the scene"}) {
    EXPECT_TRUE(contains(error, part)) << part << " in " << error;
  }
  std::filesystem::rename(folder / "f_0.ply", folder / "f_0.csv");
  expect_error([&] { load("f_%d.csv", 3); }, "f_1.csv: line 3: found too many Gaussians");
}

// A mesh of 90,000 triangles, placed as often as surfaces may be.
TEST(SceneBudget, SurfacesShareTheMemoryOfTheScene) {
  const TemporaryFolder folder;
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
  folder.write("grid.obj", mesh);
  std::string surfaces = R"("surfaces": [ { "mesh": "grid.obj" })";
  for (std::size_t i = 1; i < limits::surfaces; ++i) surfaces += R"(, { "mesh": "grid.obj" })";
  expect_error([&] { load_scene(folder.write("a.brume", scene_of(surfaces + " ]"))); },
               {"a.brume: surfaces[", "bytes of memory so far; allowed: at most 8589934592"});
}

// Three bytes of text each, and sixteen times that of memory.
TEST(SceneBudget, BoundsTheMemoryOfUnknownKeys) {
  std::string values = "{}";
  for (int i = 1; i < 8'000'000; ++i) values += ",{}";
  const std::string text = scene_of(R"("mystery": [)" + values + "]");
  const long before = max_memory();
  expect_error([&] { parse_json("a.brume", text); },
               "a.brume: mystery: the values up to here take more than");
  EXPECT_LT(max_memory() - before, 15 * static_cast<long>(text.size() / 1024));
}

// These are as dense as they can be written.
TEST(SceneBudget, ReadsManyGaussiansWithoutDecimals) {
  std::string values = R"({"center":[0,0,0],"radius":1,"density":1})";
  const std::string one = "," + values;
  for (int i = 1; i < 300'000; ++i) values += one;
  const TemporaryFolder folder;
  const Scene scene =
      load_scene(folder.write("a.brume", scene_of(R"("medium":{"gaussians":[)" + values + "]}")));
  EXPECT_EQ(scene.medium.size(), 300'000u);
}

}  // namespace
}  // namespace brume
