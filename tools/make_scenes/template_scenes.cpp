// The templates of the editor's start page: empty of things, but lit and with fog. Lengths are in
// metres.

#include <cmath>

#include "tools/make_scenes/generated_files.h"
#include "tools/make_scenes/noise.h"
#include "tools/make_scenes/patch_mesh.h"
#include "tools/make_scenes/random.h"
#include "tools/make_scenes/sample_scene.h"
#include "tools/make_scenes/scenes.h"

namespace brume {
namespace {

constexpr double template_quad = 0.5;  // size of quads [u]

void write_mesh(const std::filesystem::path& file, const PatchMesh& mesh) {
  write_mesh_ply(file, mesh.vertices, mesh.triangles);
}

SampleLight sun(const glm::dvec3& direction, const glm::dvec3& irradiance) {
  SampleLight light;
  light.intensity = irradiance;
  light.directions = {{0.0, direction}};
  light.is_directional = true;
  return light;
}

// A floor of 6 x 5 and walls 2.8 high, with a window in the left wall.
PatchMesh template_room() {
  PatchMesh mesh;
  constexpr double thick = 0.25;
  const glm::dvec3 low(-3.0, 0.0, -2.5);
  const glm::dvec3 high(3.0, 2.8, 2.5);
  const auto box = [&](const glm::dvec3& a, const glm::dvec3& b) {
    add_box(a, b, template_quad, mesh);
  };
  box({low.x - thick, -thick, low.z - thick}, {high.x + thick, 0.0, high.z + thick});
  box({low.x - thick, high.y, low.z - thick}, {high.x + thick, high.y + thick, high.z + thick});
  box({low.x - thick, 0.0, low.z - thick}, {high.x + thick, high.y, low.z});
  box({low.x - thick, 0.0, high.z}, {high.x + thick, high.y, high.z + thick});
  box({high.x, 0.0, low.z}, {high.x + thick, high.y, high.z});
  // Around the window, which has one bar.
  const double outside = low.x - thick;
  box({outside, 0.0, low.z}, {low.x, high.y, -1.3});
  box({outside, 0.0, 0.7}, {low.x, high.y, high.z});
  box({outside, 0.0, -1.3}, {low.x, 0.9, 0.7});
  box({outside, 2.4, -1.3}, {low.x, high.y, 0.7});
  box({outside + 0.1, 0.9, -0.34}, {low.x - 0.1, 2.4, -0.26});
  return mesh;
}

PatchMesh table() {
  PatchMesh mesh;
  add_box({-0.8, 0.72, -0.45}, {0.8, 0.77, 0.45}, template_quad, mesh);
  for (const double x : {-0.74, 0.68}) {
    for (const double z : {-0.39, 0.33}) {
      add_box({x, 0.0, z}, {x + 0.06, 0.72, z + 0.06}, template_quad, mesh);
    }
  }
  return mesh;
}

void write_room(const std::filesystem::path& folder) {
  write_mesh(folder / "room.ply", template_room());
  write_mesh(folder / "table.ply", table());
  SampleScene scene;
  scene.camera = {{1.6, 1.5, 2.3}, {-0.7, 1.05, -1.0}, {0.0, 1.0, 0.0}, 58.0};
  scene.environment = "../environments/dawn.exr";
  scene.anisotropy = 0.3;
  scene.homogeneous_density = 0.03;
  scene.surfaces = {{"room.ply", {0.0, 0.0, 0.0}, 1.0, {0.72, 0.69, 0.64}},
                    {"table.ply", {0.2, 0.0, -0.9}, 1.0, {0.4, 0.26, 0.16}}};
  scene.lights = {sun({1.0, -0.62, -0.12}, {14.0, 11.5, 8.5}), {{2.3, 1.7, -1.9}, {3.0, 2.1, 1.2}}};
  HashRandom random(5);
  for (int i = 0; i < 24; ++i) {
    const double x = random.uniform(-2.8, 2.2);
    const double y = random.uniform(0.2, 2.4);
    const double z = random.uniform(-2.2, 1.0);
    scene.gaussians.push_back({{x, y, z}, random.uniform(0.5, 0.9), random.uniform(0.03, 0.09)});
  }
  write_sample_scene(folder / "room.brume", scene);
}

constexpr int land_side = 112;      // vertices along an edge
constexpr double land_half = 60.0;  // u

// Hills around a valley that runs along z.
double land_height(double x, double z) {
  const double course = x - 7.0 * fractal_noise(8, {0.02 * z + 4.0, 0.5, 2.5}, 2);
  const double valley = 1.0 - std::exp(-course * course / 450.0);
  const double hills = 0.5 + fractal_noise(12, {0.022 * x + 1.5, 0.5, 0.022 * z + 9.5}, 5);
  const double relief = fractal_noise(31, {0.12 * x, 0.5, 0.12 * z}, 3);
  return valley * (4.0 + 20.0 * hills) + 0.7 * relief;
}

PatchMesh land() {
  PatchMesh mesh;
  add_patch(
      land_side - 1, land_side - 1,
      [](double u, double v) {
        const double x = land_half * (2.0 * u - 1.0);
        const double z = land_half * (1.0 - 2.0 * v);
        return glm::dvec3(x, land_height(x, z), z);
      },
      mesh);
  return mesh;
}

void write_landscape(const std::filesystem::path& folder) {
  write_mesh(folder / "landscape.ply", land());
  SampleScene scene;
  scene.camera = {{3.0, 13.0, 58.0}, {-1.0, 5.0, 0.0}, {0.0, 1.0, 0.0}, 42.0};
  scene.environment = "../environments/dawn.exr";
  scene.environment_intensity = 0.35;
  scene.anisotropy = 0.4;
  scene.homogeneous_density = 0.0012;
  scene.surfaces = {{"landscape.ply", {0.0, 0.0, 0.0}, 1.0, {0.2, 0.23, 0.13}}};
  scene.lights = {sun({0.85, -0.4, -0.1}, {7.0, 5.2, 3.2})};
  // Mist where the land is low.
  HashRandom random(14);
  while (scene.gaussians.size() < 70) {
    const double x = random.uniform(-45.0, 45.0);
    const double z = random.uniform(-55.0, 35.0);
    const double height = land_height(x, z);
    if (height > random.uniform(1.0, 7.0)) continue;
    const double radius = random.uniform(3.5, 7.0);
    scene.gaussians.push_back(
        {{x, height + 0.25 * radius, z}, radius, random.uniform(0.004, 0.014)});
  }
  write_sample_scene(folder / "landscape.brume", scene);
}

PatchMesh stage_set() {
  PatchMesh mesh;
  add_box({-14.0, -0.2, -6.0}, {14.0, 0.0, 14.0}, 1.0, mesh);
  add_box({-6.0, 0.0, -4.0}, {6.0, 0.9, 2.5}, template_quad, mesh);
  add_box({-14.0, 0.0, -6.0}, {14.0, 9.0, -5.6}, 1.0, mesh);
  for (int step = 0; step < 3; ++step) {
    const double z = 2.5 + 0.35 * (2 - step);
    add_box({-1.2, 0.0, z}, {1.2, 0.225 * (step + 1), z + 0.35}, template_quad, mesh);
  }
  // A portal that carries the lights.
  for (const double x : {-6.3, 6.0})
    add_box({x, 0.0, -0.2}, {x + 0.3, 6.3, 0.1}, template_quad, mesh);
  add_box({-6.3, 6.3, -0.2}, {6.3, 6.6, 0.1}, template_quad, mesh);
  return mesh;
}

void write_stage(const std::filesystem::path& folder) {
  write_mesh(folder / "stage.ply", stage_set());
  SampleScene scene;
  scene.camera = {{0.0, 2.4, 14.5}, {0.0, 2.9, 0.0}, {0.0, 1.0, 0.0}, 40.0};
  scene.anisotropy = 0.35;
  scene.homogeneous_density = 0.008;
  scene.surfaces = {{"stage.ply", {0.0, 0.0, 0.0}, 1.0, {0.16, 0.15, 0.15}}};
  struct Beam {
    double x;
    glm::dvec3 color;
  };
  for (const auto& [x, color] : {Beam{-4.5, {0.3, 0.5, 1.0}}, Beam{-1.5, {1.0, 0.8, 0.55}},
                                 Beam{1.5, {1.0, 0.8, 0.55}}, Beam{4.5, {1.0, 0.35, 0.6}}}) {
    const glm::dvec3 position(x, 6.2, 0.0);
    scene.lights.push_back(
        spot(position, glm::dvec3(-0.35 * x, 0.9, -0.6) - position, 900.0 * color, 8.0, 13.0));
  }
  // From the hall, so that what stands on the stage has a front.
  scene.lights.push_back(
      spot({0.0, 6.5, 14.0}, {0.0, -4.4, -14.0}, {1100.0, 1000.0, 850.0}, 15.0, 25.0));
  HashRandom random(9);
  for (int i = 0; i < 40; ++i) {
    const double x = random.uniform(-6.0, 6.0);
    const double y = random.uniform(0.6, 6.0);
    const double z = random.uniform(-4.0, 1.5);
    scene.gaussians.push_back({{x, y, z}, random.uniform(1.0, 2.0), random.uniform(0.008, 0.025)});
  }
  write_sample_scene(folder / "stage.brume", scene);
}

constexpr double street_near = 14.0;  // z of its ends
constexpr double street_far = -50.0;
constexpr double road_half_width = 3.2;
constexpr double house_line = 6.0;  // x of the fronts, either side

PatchMesh street_road() {
  PatchMesh mesh;
  add_rectangle(16, 96, {-road_half_width, 0.0, street_near}, {2.0 * road_half_width, 0.0, 0.0},
                {0.0, 0.0, street_far - street_near}, mesh);
  return mesh;
}

// Pavements, houses of several heights with recessed windows, and poles of lights.
PatchMesh street_houses() {
  PatchMesh mesh;
  HashRandom random(31);
  for (const double side : {-1.0, 1.0}) {
    const auto box = [&](double near_x, double far_x, double y0, double y1, double z0, double z1) {
      const double a = side * near_x;
      const double b = side * far_x;
      add_box({std::min(a, b), y0, z0}, {std::max(a, b), y1, z1}, 2.0, mesh);
    };
    box(road_half_width, house_line, 0.0, 0.14, street_far, street_near);
    for (double z = street_near; z > street_far + 6.0;) {
      const double width = random.uniform(6.0, 9.0);
      const int floors = 2 + static_cast<int>(random.uniform(0.0, 3.0));
      const double back = house_line + 0.25;
      box(back, house_line + 6.0, 0.0, 3.0 * floors + 0.6, z - width, z);
      // Piers and bands in front of the wall leave the windows.
      const int bays = static_cast<int>(width / 2.2);
      const double bay = width / bays;
      for (int k = 0; k <= bays; ++k) {
        const double at = z - k * bay;
        box(house_line, back, 0.0, 3.0 * floors + 0.6, std::max(at - 0.5, z - width),
            std::min(at + 0.5, z));
      }
      for (int k = 0; k <= floors; ++k) {
        box(house_line, back, std::max(0.14, 3.0 * k - 0.5), 3.0 * k + 0.6, z - width, z);
      }
      z -= width;
    }
    for (double z = side < 0.0 ? 4.0 : -3.0; z > street_far; z -= 14.0) {
      box(4.1, 4.22, 0.0, 5.2, z - 0.06, z + 0.06);
      box(2.8, 4.22, 5.2, 5.3, z - 0.06, z + 0.06);
    }
  }
  return mesh;
}

void write_street(const std::filesystem::path& folder) {
  write_mesh(folder / "street_road.ply", street_road());
  write_mesh(folder / "street_houses.ply", street_houses());
  SampleScene scene;
  scene.camera = {{0.9, 1.65, 11.0}, {-0.5, 2.1, -6.0}, {0.0, 1.0, 0.0}, 50.0};
  scene.environment = "../environments/dawn.exr";
  scene.environment_intensity = 0.12;
  scene.anisotropy = 0.5;
  scene.homogeneous_density = 0.006;
  scene.surfaces = {{"street_road.ply", {0.0, 0.0, 0.0}, 1.0, {0.05, 0.05, 0.055}, 0.25, 40.0},
                    {"street_houses.ply", {0.0, 0.0, 0.0}, 1.0, {0.3, 0.26, 0.23}}};
  for (const double side : {-1.0, 1.0}) {
    for (double z = side < 0.0 ? 4.0 : -3.0; z > -36.0; z -= 14.0) {
      scene.lights.push_back(
          spot({side * 2.85, 5.15, z}, {-0.15 * side, -1.0, 0.0}, {130.0, 84.0, 40.0}, 20.0, 70.0));
    }
  }
  // Mist on the ground, thinner above.
  HashRandom random(47);
  for (int i = 0; i < 60; ++i) {
    const double height = std::pow(random.uniform(), 2.0) * 4.0;
    const double x = random.uniform(-5.0, 5.0);
    const double z = random.uniform(-34.0, 5.0);
    scene.gaussians.push_back(
        {{x, 0.3 + height, z}, random.uniform(1.2, 2.6), random.uniform(0.015, 0.05)});
  }
  write_sample_scene(folder / "street.brume", scene);
}

}  // namespace

void write_template_scenes(const std::filesystem::path& folder) {
  write_room(folder);
  write_landscape(folder);
  write_stage(folder);
  write_street(folder);
}

}  // namespace brume
