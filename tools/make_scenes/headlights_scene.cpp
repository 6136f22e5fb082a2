#include <cmath>
#include <numbers>

#include "tools/make_scenes/generated_files.h"
#include "tools/make_scenes/patch_mesh.h"
#include "tools/make_scenes/random.h"
#include "tools/make_scenes/sample_scene.h"
#include "tools/make_scenes/scenes.h"

namespace brume {
namespace {

// The road runs along z, from the camera into the dark.
constexpr double road_half = 2.6;  // u
constexpr double near_end = 9.0;
constexpr double far_end = -22.0;
constexpr double house_front = -4.6;   // x
constexpr double window_height = 1.5;  // of its center

const glm::dvec3 car(1.0, 0.0, -3.6);  // the middle of its front, on the road

PatchMesh road() {
  PatchMesh mesh;
  const glm::dvec3 along(0.0, 0.0, far_end - near_end);
  add_rectangle(40, 160, {-road_half, 0.0, near_end}, {2.0 * road_half, 0.0, 0.0}, along, mesh);
  return mesh;
}

// Pavements, a house with a window, poles of street lights, and the car.
PatchMesh town() {
  PatchMesh mesh;
  const glm::dvec3 along(0.0, 0.0, far_end - near_end);
  const glm::dvec3 kerb(0.0, 0.14, 0.0);
  for (const double side : {-1.0, 1.0}) {
    const glm::dvec3 edge(side * road_half, 0.0, near_end);
    add_rectangle(60, 2, edge, along, kerb, mesh);
    add_rectangle(60, 8, edge + kerb, along, {side * 2.0, 0.0, 0.0}, mesh);
  }
  // Around the window, which is open.
  const auto wall = [&](double z, double length, double low, double high) {
    add_box({house_front - 0.3, low, z - length}, {house_front, high, z}, 0.4, mesh);
  };
  wall(near_end, near_end + 0.9, 0.0, 5.0);
  wall(-2.5, 7.0, 0.0, 5.0);
  wall(-0.9, 1.6, 0.0, window_height - 0.7);
  wall(-0.9, 1.6, window_height + 0.7, 5.0);
  // The room behind it.
  add_box({house_front - 1.4, 0.0, -4.0}, {house_front - 1.2, 3.0, 0.6}, 0.2, mesh);
  for (const double z : {-2.0, -12.0}) {
    add_box({road_half + 0.5, 0.0, z - 0.06}, {road_half + 0.62, 4.4, z + 0.06}, 0.2, mesh);
    add_box({road_half - 0.9, 4.4, z - 0.06}, {road_half + 0.62, 4.5, z + 0.06}, 0.2, mesh);
  }
  const double length = 3.6;
  add_box({car.x - 0.85, 0.28, car.z - length}, {car.x + 0.85, 0.85, car.z}, 0.2, mesh);
  add_box({car.x - 0.7, 0.85, car.z - 0.75 * length}, {car.x + 0.7, 1.4, car.z - 0.9}, 0.2, mesh);
  for (const double x : {-0.85, 0.6}) {
    for (const double z : {-0.9, -3.1}) {
      add_box({car.x + x, 0.0, car.z + z}, {car.x + x + 0.25, 0.5, car.z + z + 0.5}, 0.2, mesh);
    }
  }
  return mesh;
}

}  // namespace

void write_headlights_scene(const std::filesystem::path& folder) {
  const PatchMesh wet = road();
  const PatchMesh dry = town();
  write_mesh_ply(folder / "headlights_road.ply", wet.vertices, wet.triangles);
  write_mesh_ply(folder / "headlights_town.ply", dry.vertices, dry.triangles);
  SampleScene scene;
  scene.camera = {{-0.5, 1.45, 5.2}, {-0.75, 1.6, -4.0}, {0.0, 1.0, 0.0}, 50.0};
  scene.anisotropy = 0.5;
  scene.surfaces = {{"headlights_road.ply", {0.0, 0.0, 0.0}, 1.0, {0.035, 0.036, 0.04}, 0.35, 60.0},
                    {"headlights_town.ply", {0.0, 0.0, 0.0}, 1.0, {0.24, 0.21, 0.19}}};
  for (const double side : {-0.6, 0.6}) {
    scene.lights.push_back(spot(car + glm::dvec3(side, 0.62, 0.05),
                                {0.05 - 0.35 * side, -0.09, 1.0}, {80.0, 72.0, 60.0}, 6.0, 24.0));
  }
  for (const double z : {-2.0, -12.0}) {
    scene.lights.push_back(
        spot({road_half - 0.85, 4.35, z}, {-0.1, -1.0, 0.0}, {150.0, 75.0, 24.0}, 15.0, 62.0));
  }
  SampleLight window{{house_front - 0.2, window_height, -1.7}, {40.0, 24.0, 11.0}};
  window.directions = {{0.0, {1.0, -0.1, 0.15}}};
  window.width = 1.5;
  window.height = 1.3;
  scene.lights.push_back(window);
  // Mist on the wet road, haze around the street lights.
  HashRandom random(83);
  while (scene.gaussians.size() < 90) {
    const double height = std::pow(random.uniform(0.0, 1.0), 1.7) * 4.2;
    const glm::dvec3 center(random.uniform(-4.2, 3.6), 0.2 + height, random.uniform(-13.0, 3.5));
    scene.gaussians.push_back({center, random.uniform(0.7, 1.4), random.uniform(0.015, 0.06)});
  }
  write_sample_scene(folder / "headlights.brume", scene);
}

}  // namespace brume
