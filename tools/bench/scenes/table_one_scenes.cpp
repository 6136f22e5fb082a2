#include "tools/bench/scenes/table_one_scenes.h"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <numbers>
#include <vector>

#include "core/io/disk/installed_files.h"
#include "core/io/image/radiance_map_file.h"
#include "tools/bench/scenes/benchmark_meshes.h"
#include "tools/bench/scenes/benchmark_scenes.h"
#include "tools/bench/scenes/hash_random.h"

namespace brume {
namespace {

using std::numbers::pi;

Surface surface(MeshBuilder& mesh, const glm::dvec3& reflectance) {
  Surface result;
  result.mesh = mesh.finish();
  result.material.reflectance = reflectance;
  return result;
}

// An environment of resources/environments, and radiance transfer for it.
void light_by(const char* environment, double intensity, double rotation, Scene& scene) {
  Environment& sky = scene.environment.emplace();
  sky.map = read_radiance_map(resources_folder() / "environments" / environment);
  sky.intensity = intensity;
  sky.rotation = rotation;
  for (Surface& s : scene.surfaces) s.transfer = Surface::Transfer::interreflection;
}

// A floor at height y.
MeshBuilder::Place level(double half, double y) {
  return [=](double u, double v) {
    return glm::dvec3(half * (2.0 * u - 1.0), y, half * (2.0 * v - 1.0));
  };
}

}  // namespace

Scene statue_scene() {
  Scene scene;
  scene.camera = {{1.2, 1.5, 3.6}, {0.0, 0.95, 0.0}, {0, 1, 0}, 36.0};
  MeshBuilder stone;
  stone.box({-0.5, 0.0, -0.5}, {0.5, 0.35, 0.5}, 40);
  const auto bumps = [](double u, double v) {
    return 0.012 * std::sin(18 * pi * u) * std::sin(14 * pi * v) +
           0.006 * std::sin(46 * pi * u + 9.0 * v);
  };
  // Body and head: surfaces of revolution, embossed.
  stone.grid(200, 160, true, [&](double u, double v) {
    const double r = 0.05 + 0.36 * std::pow(std::sin(pi * (0.08 + 0.84 * v)), 0.7) * (1 - 0.35 * v);
    const double x = (r + bumps(u, v)) * std::cos(2 * pi * u);
    return glm::dvec3(x, 0.34 + 0.95 * v, (r + bumps(u, v)) * std::sin(2 * pi * u) + 0.12 * v * v);
  });
  stone.grid(128, 96, true, [&](double u, double v) {
    const double r = 0.23 * std::sin(pi * v) * (1.0 + 2.0 * bumps(u, v));
    const double snout = 0.14 * std::pow(std::max(std::sin(2 * pi * u), 0.0), 4) * std::sin(pi * v);
    return glm::dvec3(r * std::cos(2 * pi * u), 1.42 + 0.25 * std::cos(pi * v),
                      0.16 + r * std::sin(2 * pi * u) + snout);
  });
  for (const double side : {-1.0, 1.0}) {
    stone.grid(80, 80, false, [&](double u, double v) {
      const double rib = 0.03 * std::cos(10 * pi * v) * u;
      return glm::dvec3(side * (0.15 + 0.85 * u), 0.65 + 0.35 * u + 0.75 * v * (1 - 0.55 * u * u),
                        -0.2 - 0.3 * std::sin(0.5 * pi * u) + rib);
    });
    stone.grid(32, 24, true, [&](double u, double v) {
      const double r = 0.055 * (1.0 - 0.95 * v);
      return glm::dvec3(side * (0.12 + 0.12 * v * v) + r * std::cos(2 * pi * u), 1.58 + 0.26 * v,
                        0.12 + r * std::sin(2 * pi * u));
    });
  }
  MeshBuilder ground;
  ground.sheet(78054 - stone.size(), level(6.0, 0.0));
  scene.surfaces = {surface(stone, {0.6, 0.57, 0.5}), surface(ground, {0.35, 0.37, 0.33})};

  HashRandom random(1);
  std::vector<Gaussian> fog;
  for (int i = 0; i < 34; ++i) {
    const double angle = 2 * pi * i / 34.0 + random.uniform(-0.1, 0.1);
    const double r = random.uniform(0.5, 1.5);
    const double y = random.uniform(0.1, 1.3);
    fog.push_back({{r * std::cos(angle), y, r * std::sin(angle)}, random.uniform(0.3, 0.6), 1.0});
  }
  scene.medium = with_depth(fog, 2.0);
  scene.lights = {{{2.5, 3.2, 1.0}, {28, 25, 20}, {}},
                  {{-2.6, 2.4, 1.6}, {9, 13, 24}, {}},
                  {{-0.6, 2.6, -2.6}, {24, 21, 18}, {}}};
  return scene;
}

Scene open_box_scene() {
  Scene scene;
  scene.camera = {{0.25, 1.35, 3.1}, {0.0, 0.42, 0.0}, {0, 1, 0}, 32.0};
  MeshBuilder things;
  things.ellipsoid({-0.35, 0.25, -0.25}, glm::dvec3(0.25), 32);
  things.box({0.15, 0.0, -0.55}, {0.55, 0.6, -0.15}, 12);
  things.cylinder({0.2, 0.0, 0.35}, {0.2, 0.35, 0.35}, 0.16, 48);
  MeshBuilder walls;
  // Open at the front and above.
  const std::size_t wall = (8901 - things.size()) / 4;
  walls.sheet(wall, [](double u, double v) { return glm::dvec3(-0.8, v, 1.6 * u - 0.8); });
  walls.sheet(wall, [](double u, double v) { return glm::dvec3(0.8, v, 1.6 * u - 0.8); });
  walls.sheet(wall, [](double u, double v) { return glm::dvec3(1.6 * u - 0.8, v, -0.8); });
  walls.sheet(8901 - things.size() - 3 * wall, level(0.8, 0.0));
  scene.surfaces = {surface(things, {0.7, 0.45, 0.3}), surface(walls, {0.55, 0.58, 0.6})};

  HashRandom random(2);
  std::vector<Gaussian> fog;
  for (int i = 0; i < 3008; ++i) {
    const double x = random.uniform(-0.8, 0.8);
    const double z = random.uniform(-0.8, 0.8);
    const double top = 0.5 + 0.2 * std::sin(4.0 * x + 1.0) * std::cos(5.0 * z);
    fog.push_back({{x, random.uniform(0.0, top), z}, random.uniform(0.03, 0.07), 1.0});
  }
  scene.medium = with_depth(fog, 3.0);
  scene.lights = {{{0.5, 2.2, 0.9}, {11, 10.5, 9.5}, {}}};
  return scene;
}

Scene terrain_scene() {
  const auto height = [](double x, double z) {
    return 0.9 * std::sin(0.55 * x + 0.4) * std::cos(0.5 * z) + 0.35 * std::sin(1.3 * x - 0.8 * z) +
           0.12 * std::sin(3.1 * x + 1.0) * std::sin(2.7 * z) +
           0.03 * std::sin(9.0 * x) * std::sin(8.0 * z + x);
  };
  Scene scene;
  scene.camera = {{0.5, 3.2, 10.0}, {0.0, 0.2, 0.0}, {0, 1, 0}, 42.0};
  MeshBuilder ground;
  ground.sheet(65047, [&](double u, double v) {
    const double x = 20.0 * u - 10.0;
    const double z = 20.0 * v - 10.0;
    return glm::dvec3(x, height(x, z), z);
  });
  scene.surfaces = {surface(ground, {0.22, 0.25, 0.15})};

  HashRandom random(3);
  std::vector<Gaussian> fog;
  // Patches in the valleys.
  for (const glm::dvec2& patch : {glm::dvec2(-2.6, 2.4), glm::dvec2(0.8, -0.8),
                                  glm::dvec2(3.2, 3.8), glm::dvec2(-4.5, -3.0)}) {
    for (int i = 0; i < 73; ++i) {
      const double x = patch.x + random.uniform(-1.8, 1.8);
      const double z = patch.y + random.uniform(-1.5, 1.5);
      const double y = height(x, z) + random.uniform(0.05, 0.5);
      fog.push_back({{x, y, z}, random.uniform(0.25, 0.6), 1.0});
    }
  }
  scene.medium = with_depth(fog, 4.0);
  scene.lights = {{{-16.0, 18.0, 4.0}, {2600, 2400, 2100}, {}}};
  light_by("dawn.exr", 1.0, 0.0, scene);
  return scene;
}

Scene city_scene() {
  Scene scene;
  scene.camera = {{-5.5, 4.2, 7.5}, {0.0, 0.6, 0.0}, {0, 1, 0}, 40.0};
  HashRandom random(4);
  MeshBuilder blocks;
  for (int i = 0; i < 12; ++i) {
    for (int j = 0; j < 12; ++j) {
      const double x = i - 5.5;
      const double z = j - 5.5;
      const double width = random.uniform(0.22, 0.36);
      const double depth = random.uniform(0.22, 0.36);
      const double top = 0.4 + random.uniform(0.1, 2.2) * std::exp(-0.04 * (x * x + z * z));
      blocks.box({x - width, 0.0, z - depth}, {x + width, top, z + depth}, 9);
    }
  }
  // One mesh: the blocks take light from the ground.
  blocks.sheet(77226 - blocks.size(), level(9.0, 0.0));
  scene.surfaces = {surface(blocks, {0.33, 0.31, 0.29})};

  // Patches in the streets.
  std::vector<Gaussian> fog;
  for (int i = 0; i < 353; ++i) {
    constexpr std::array patches{glm::dvec2(-3.0, 3.0), glm::dvec2(0.5, 0.5), glm::dvec2(3.5, 2.5),
                                 glm::dvec2(-3.5, -2.5), glm::dvec2(2.5, -3.5)};
    const glm::dvec2& patch = patches[static_cast<std::size_t>(i) % patches.size()];
    const double x = patch.x + random.uniform(-1.5, 1.5);
    const double z = patch.y + random.uniform(-1.5, 1.5);
    fog.push_back({{x, random.uniform(0.1, 1.0), z}, random.uniform(0.25, 0.6), 1.0});
  }
  scene.medium = with_depth(fog, 4.0);
  scene.lights = {{{-14.0, 18.0, -2.0}, {2400, 2200, 1900}, {}}};
  light_by("sunset.exr", 1.0, 0.0, scene);
  return scene;
}

Scene machine_scene() {
  Scene scene;
  scene.camera = {{0.9, 1.15, 2.9}, {0.0, 0.52, 0.0}, {0, 1, 0}, 36.0};
  MeshBuilder metal;
  MeshBuilder rubber;
  for (const double x : {-0.8, 0.8}) {
    rubber.grid(128, 24, true, [&](double u, double v) {
      const double r = 0.36 + 0.07 * std::cos(2 * pi * v);
      return glm::dvec3(x + r * std::cos(2 * pi * u), 0.43 + r * std::sin(2 * pi * u),
                        0.07 * std::sin(2 * pi * v));
    });
    metal.cylinder({x, 0.43, -0.1}, {x, 0.43, 0.1}, 0.07, 48);
    metal.cylinder({x, 0.43, -0.015}, {x, 0.43, 0.015}, 0.16, 64);
    for (int k = 0; k < 16; ++k) {
      const double angle = 2 * pi * k / 16.0;
      metal.cylinder({x, 0.43, 0.0}, {x + 0.3 * std::cos(angle), 0.43 + 0.3 * std::sin(angle), 0.0},
                     0.008, 16);
    }
  }
  metal.box({-0.22, 0.26, -0.13}, {0.26, 0.5, 0.13}, 24);
  metal.ellipsoid({0.12, 0.86, 0.0}, {0.32, 0.13, 0.15}, 48);
  metal.ellipsoid({0.66, 0.95, 0.0}, {0.1, 0.11, 0.11}, 32);
  rubber.ellipsoid({-0.38, 0.82, 0.0}, {0.34, 0.07, 0.13}, 40);
  // Two banks of cooling fins.
  for (const double lean : {-0.6, 0.6}) {
    const glm::dvec3 axis(std::sin(lean), std::cos(lean), 0.0);
    const glm::dvec3 base(0.02 + 0.1 * lean, 0.45, 0.0);
    metal.cylinder(base, base + 0.3 * axis, 0.07, 48);
    for (int k = 1; k <= 9; ++k) {
      metal.cylinder(base + 0.03 * k * axis, base + (0.03 * k + 0.01) * axis, 0.11, 48);
    }
  }
  for (const double z : {-0.13, 0.13}) {
    metal.cylinder({0.8, 0.43, z}, {0.58, 1.05, z}, 0.022, 32);
    metal.cylinder({0.58, 1.05, z}, {0.5, 1.12, 2.6 * z}, 0.015, 24);
    metal.cylinder({-0.8, 0.43, z}, {-0.15, 0.36, z}, 0.02, 32);
    metal.cylinder({-0.8, 0.43, z}, {-0.5, 0.8, z}, 0.018, 32);
    metal.cylinder({-0.15, 0.36, z}, {0.5, 0.92, 0.5 * z}, 0.02, 32);
    metal.tube(
        [&](double v) {
          return glm::dvec3(0.2 - 1.15 * v, 0.3 - 0.12 * std::sin(pi * std::min(2 * v, 1.0)),
                            1.5 * z);
        },
        0.04, 40, 48);
  }
  metal.box({-0.95, 0.0, -0.6}, {-0.85, 0.12, -0.5}, 12);
  metal.ellipsoid({0.95, 0.1, -0.55}, glm::dvec3(0.1), 24);
  MeshBuilder ground;
  ground.sheet(44430 - metal.size() - rubber.size(), level(5.0, 0.0));
  scene.surfaces = {surface(metal, {0.62, 0.6, 0.58}), surface(rubber, {0.16, 0.15, 0.15}),
                    surface(ground, {0.4, 0.38, 0.36})};
  Material& shiny = scene.surfaces[0].material;
  shiny.type = Material::Type::phong;
  shiny.reflectance *= 0.5;
  shiny.specular = glm::dvec3(0.45);
  shiny.exponent = 30.0;

  HashRandom random(5);
  std::vector<Gaussian> steam;
  for (int i = 0; i < 1223; ++i) {
    // Three outlets: the two pipes, whose steam is blown backwards, and the engine's.
    const int outlet = i % 3;
    const double age = std::pow(random.uniform(0.0, 1.0), 0.8);
    const glm::dvec3 source =
        outlet == 2 ? glm::dvec3(0.0, 0.6, 0.12) : glm::dvec3(-0.95, 0.3, outlet == 0 ? -0.2 : 0.2);
    const glm::dvec3 drift =
        outlet == 2 ? glm::dvec3(-0.5, 0.7, 0.15) : glm::dvec3(-0.45, 0.5, 0.0);
    const glm::dvec3 swirl(0.08 * std::sin(9.0 * age + outlet), 0.0, 0.08 * std::cos(8.0 * age));
    const double radius = 0.025 + 0.075 * age;
    const glm::dvec3 center = source + age * (drift + swirl) + random.point(0.02 + 0.16 * age);
    steam.push_back({center, radius, std::pow(0.025 / radius, 2.0)});
  }
  scene.medium = with_depth(steam, 3.0);
  scene.lights = {{{-1.6, 2.6, 1.6}, {30, 28, 25}, {}}};
  light_by("sunset.exr", 1.0, 90.0, scene);
  return scene;
}

Scene TableOneScene::make() const {
  Scene scene = with_lights();
  if (!has_lights) scene.lights.clear();
  return scene;
}

}  // namespace brume
