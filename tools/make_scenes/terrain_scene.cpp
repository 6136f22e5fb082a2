#include <algorithm>
#include <cmath>

#include "tools/make_scenes/generated_files.h"
#include "tools/make_scenes/noise.h"
#include "tools/make_scenes/random.h"
#include "tools/make_scenes/sample_scene.h"
#include "tools/make_scenes/scenes.h"

namespace brume {
namespace {

constexpr int terrain_side = 256;      // vertices along an edge
constexpr double terrain_half = 12.0;  // u
constexpr std::size_t fog_count = 292;

// The height of the ground: hills with sharp crests, as 1 - |noise| has them, and fine relief.
double ground_height(double x, double z) {
  const double hills = fractal_noise(21, {0.16 * x + 3.5, 0.5, 0.16 * z + 1.5}, 5);
  const double crests = 1.0 - std::abs(fractal_noise(40, {0.1 * x, 0.5, 0.1 * z + 7.3}, 4));
  return 2.6 * hills + 2.4 * crests * crests - 2.0;
}

void write_terrain(const std::filesystem::path& file) {
  std::vector<glm::dvec3> vertices;
  vertices.reserve(terrain_side * terrain_side);
  const auto coordinate = [](int i) { return terrain_half * (2.0 * i / (terrain_side - 1) - 1.0); };
  for (int row = 0; row < terrain_side; ++row) {
    for (int column = 0; column < terrain_side; ++column) {
      const double x = coordinate(column);
      const double z = coordinate(row);
      vertices.emplace_back(x, ground_height(x, z), z);
    }
  }
  std::vector<std::array<std::uint16_t, 3>> triangles;
  for (int row = 0; row + 1 < terrain_side; ++row) {
    for (int column = 0; column + 1 < terrain_side; ++column) {
      const auto corner = static_cast<std::uint16_t>(row * terrain_side + column);
      const auto right = static_cast<std::uint16_t>(corner + 1);
      const auto below = static_cast<std::uint16_t>(corner + terrain_side);
      const auto across = static_cast<std::uint16_t>(below + 1);
      triangles.push_back({corner, below, right});
      triangles.push_back({right, below, across});
    }
  }
  write_mesh_ply(file, vertices, triangles);
}

// Fog gathers where the ground is low: the lower half of random positions are used.
std::vector<Gaussian> ground_fog_gaussians() {
  HashRandom random(292);
  std::vector<Gaussian> gaussians;
  while (gaussians.size() < fog_count) {
    const double x = random.uniform(-10.0, 10.0);
    const double z = random.uniform(-11.0, 9.0);
    const double height = ground_height(x, z);
    const double patch = fractal_noise(60, {0.25 * x, 0.5, 0.25 * z}, 2);
    if (height > random.uniform(-1.2, 0.2) || patch < -0.15) continue;
    const double radius = random.uniform(0.35, 0.9);
    const double lift = random.uniform(0.05, 0.45);
    gaussians.push_back({{x, height + lift, z}, radius, random.uniform(0.2, 0.6)});
  }
  return gaussians;
}

}  // namespace

void write_terrain_scene(const std::filesystem::path& folder) {
  write_terrain(folder / "terrain.ply");
  SampleScene scene;
  scene.camera = {{0.0, 4.6, 13.0}, {0.0, -0.3, 0.0}, {0.0, 1.0, 0.0}, 40.0};
  scene.gaussians = ground_fog_gaussians();
  scene.lights = {{{-15.0, 9.0, -9.0}, {2300.0, 1600.0, 950.0}},
                  {{14.0, 11.0, 9.0}, {260.0, 380.0, 600.0}}};
  scene.surfaces = {{"terrain.ply", {0.0, 0.0, 0.0}, 1.0, {0.2, 0.18, 0.14}}};
  write_sample_scene(folder / "ground_fog.brume", scene);
}

}  // namespace brume
