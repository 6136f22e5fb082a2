#include <array>
#include <cmath>
#include <numbers>

#include "tools/make_scenes/generated_files.h"
#include "tools/make_scenes/patch_mesh.h"
#include "tools/make_scenes/random.h"
#include "tools/make_scenes/sample_scene.h"
#include "tools/make_scenes/scenes.h"

namespace brume {
namespace {

constexpr double half = 3.0;         // of the court [u]
constexpr double wall_height = 2.3;  // u
constexpr double arch_height = 1.6;  // of the columns [u]
constexpr double arcade = 1.9;       // distance of the columns from the center [u]

void add_column(const glm::dvec3& foot, PatchMesh& mesh) {
  add_patch(
      16, 12,
      [&](double u, double v) {
        const double angle = -2.0 * std::numbers::pi * u;
        const double radius = 0.14 + 0.06 * std::pow(2.0 * v - 1.0, 8);
        return foot +
               glm::dvec3(radius * std::cos(angle), arch_height * v, radius * std::sin(angle));
      },
      mesh);
}

// A box that stands at y = low, without its bottom.
void add_step(double side, double low, double high, PatchMesh& mesh) {
  const glm::dvec3 up(0.0, high - low, 0.0);
  const std::array corners{glm::dvec3(-side, low, side), glm::dvec3(side, low, side),
                           glm::dvec3(side, low, -side), glm::dvec3(-side, low, -side)};
  for (std::size_t k = 0; k < 4; ++k) {
    add_rectangle(16, 3, corners[k], corners[(k + 1) % 4] - corners[k], up, mesh);
  }
  add_rectangle(16, 16, corners[0] + up, {2.0 * side, 0.0, 0.0}, {0.0, 0.0, -2.0 * side}, mesh);
}

// A court, open above and towards +z, with an arcade along its three walls and steps in the middle.
PatchMesh court() {
  PatchMesh mesh;
  add_rectangle(64, 64, {-half, 0.0, half}, {2.0 * half, 0.0, 0.0}, {0.0, 0.0, -2.0 * half}, mesh);
  // The walls, and over the arcade's columns a roof: from below, its edge, from above. Left, back
  // and right; each is seen from the middle as going from left to right.
  const double depth = half - arcade + 0.25;  // of the roof
  const std::array<std::array<glm::dvec3, 3>, 3> sides{{
      {glm::dvec3(-half, 0, half), glm::dvec3(0, 0, -1), glm::dvec3(1, 0, 0)},
      {glm::dvec3(-half, 0, -half), glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1)},
      {glm::dvec3(half, 0, -half), glm::dvec3(0, 0, 1), glm::dvec3(-1, 0, 0)},
  }};
  const glm::dvec3 up(0.0, 1.0, 0.0);
  for (const auto& [corner, along, inward] : sides) {
    const glm::dvec3 length = 2.0 * half * along;
    add_rectangle(48, 18, corner, length, wall_height * up, mesh);
    const glm::dvec3 edge = corner + depth * inward + arch_height * up;
    add_rectangle(48, 10, edge, length, -depth * inward, mesh);
    add_rectangle(48, 2, edge, length, 0.16 * up, mesh);
    add_rectangle(48, 10, edge + 0.16 * up, length, -depth * inward, mesh);
  }
  // The roof's ends.
  for (const double side : {-1.0, 1.0}) {
    add_rectangle(10, 2, {side * half, arch_height, half}, {-side * depth, 0.0, 0.0}, 0.16 * up,
                  mesh);
  }
  for (int i = 0; i < 5; ++i) {
    const double offset = arcade * (0.5 * i - 1.0);
    add_column({offset, 0.0, -arcade}, mesh);
    if (i == 0) continue;
    add_column({-arcade, 0.0, offset}, mesh);
    add_column({arcade, 0.0, offset}, mesh);
  }
  add_step(1.0, 0.0, 0.14, mesh);
  add_step(0.72, 0.14, 0.28, mesh);
  add_step(0.46, 0.28, 0.62, mesh);
  return mesh;
}

}  // namespace

void write_courtyard_scene(const std::filesystem::path& folder) {
  const PatchMesh mesh = court();
  write_mesh_ply(folder / "courtyard.ply", mesh.vertices, mesh.triangles);
  SampleScene scene;
  scene.camera = {{1.1, 3.1, 7.0}, {0.0, 0.75, 0.0}, {0.0, 1.0, 0.0}, 42.0};
  scene.environment = "../environments/dawn.exr";
  scene.lights = {{{-2.45, 1.15, -2.4}, {2.4, 1.3, 0.5}}};
  scene.surfaces = {{"courtyard.ply", {0.0, 0.0, 0.0}, 1.0, {0.78, 0.74, 0.68}},
                    {"../meshes/bunny.obj", {0.0, 0.62, 0.0}, 0.075, {0.72, 0.7, 0.68}}};
  for (SampleSurface& surface : scene.surfaces) surface.transfer = "interreflection";
  // Mist in the court, thicker below the arcade.
  HashRandom random(57);
  while (scene.gaussians.size() < 57) {
    const glm::dvec3 center(random.uniform(-2.8, 2.8), random.uniform(0.05, 0.75),
                            random.uniform(-2.8, 2.6));
    scene.gaussians.push_back({center, random.uniform(0.35, 0.7), random.uniform(0.08, 0.28)});
  }
  write_sample_scene(folder / "courtyard.brume", scene);
}

}  // namespace brume
