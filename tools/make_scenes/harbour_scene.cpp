#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "tools/make_scenes/generated_files.h"
#include "tools/make_scenes/patch_mesh.h"
#include "tools/make_scenes/random.h"
#include "tools/make_scenes/sample_scene.h"
#include "tools/make_scenes/scenes.h"

namespace brume {
namespace {

// Water in front, the quay to the right, two boats beside it.
constexpr double quay_edge = 2.4;    // x
constexpr double quay_height = 0.7;  // u above the water
constexpr double house_wall = 4.6;   // x of the warehouse's front
const glm::dvec3 near_boat(-0.3, 0.0, -3.6);
const glm::dvec3 far_boat(-3.6, 0.0, -10.5);
constexpr double pole_places[] = {0.2, -5.4, -11.0};  // z

PatchMesh water() {
  PatchMesh mesh;
  add_rectangle(90, 120, {-16.0, 0.0, 6.0}, {32.0, 0.0, 0.0}, {0.0, 0.0, -34.0}, mesh);
  return mesh;
}

// A hull that narrows to its bow, with a cabin, a funnel and a mast; the bow towards +z.
void add_boat(const glm::dvec3& at, double size, PatchMesh& mesh) {
  const auto half_width = [](double s) { return 0.62 * std::sqrt(std::max(1.0 - s * s * s, 0.0)); };
  const auto along = [](double s) { return -1.7 + 3.4 * s; };
  for (const double side : {-1.0, 1.0}) {
    add_patch(
        30, 6,
        [&](double u, double v) {
          const double s = side > 0.0 ? u : 1.0 - u;
          const double height = std::lerp(-0.05, 0.55 + 0.25 * s * s, v);
          return at +
                 size * glm::dvec3(side * half_width(s) * std::lerp(0.7, 1.0, v), height, along(s));
        },
        mesh);
  }
  add_patch(
      12, 30,
      [&](double u, double v) {
        return at + size * glm::dvec3((2.0 * u - 1.0) * half_width(1.0 - v),
                                      0.45 + 0.2 * (1.0 - v) * (1.0 - v), along(1.0 - v));
      },
      mesh);
  const auto add = [&](const glm::dvec3& low, const glm::dvec3& high) {
    add_box(at + size * low, at + size * high, 0.15 * size, mesh);
  };
  add({-0.62, -0.05, -1.75}, {0.62, 0.55, -1.68});
  add({-0.38, 0.45, -1.1}, {0.38, 1.25, 0.1});
  add({-0.44, 1.25, -1.2}, {0.44, 1.31, 0.2});
  add({-0.13, 1.31, -0.95}, {0.13, 1.75, -0.69});
  add({-0.03, 1.31, -0.1}, {0.03, 2.9, -0.04});
}

PatchMesh harbour() {
  PatchMesh mesh;
  add_box({quay_edge, -0.2, -26.0}, {14.0, quay_height, 6.0}, 0.5, mesh);
  add_box({house_wall, quay_height, -15.0}, {10.0, 5.2, -2.2}, 0.4, mesh);
  add_box({house_wall - 0.15, 5.2, -15.2}, {10.2, 5.4, -2.0}, 0.4, mesh);
  for (const double z : {-5.2, -9.4}) {  // doors
    add_box({house_wall - 0.06, quay_height, z - 0.9}, {house_wall, 2.6, z + 0.9}, 0.3, mesh);
  }
  for (const double z : pole_places) {
    const double x = quay_edge + 0.5;
    add_box({x - 0.05, quay_height, z - 0.05}, {x + 0.05, 4.1, z + 0.05}, 0.25, mesh);
    add_box({x - 0.45, 4.1, z - 0.05}, {x + 0.05, 4.18, z + 0.05}, 0.2, mesh);
  }
  HashRandom random(5);
  for (int k = 0; k < 9; ++k) {  // boxes on the quay
    const double size = random.uniform(0.22, 0.42);
    const double x = random.uniform(3.3, 4.0);
    const double z = random.uniform(-8.0, 2.0);
    add_box({x, quay_height, z}, {x + size, quay_height + size, z + size}, 0.2, mesh);
  }
  // A crane far away.
  add_box({3.2, quay_height, -20.0}, {3.8, 9.0, -19.4}, 0.5, mesh);
  add_box({-4.5, 8.4, -19.9}, {4.6, 8.8, -19.5}, 0.5, mesh);
  add_boat(near_boat, 1.0, mesh);
  add_boat(far_boat, 1.25, mesh);
  return mesh;
}

// The profile of a street light: most along its quay, little to the sides, and nothing up.
std::string street_light_ies() {
  std::string text =
      "IESNA:LM-63-2002\n[TEST] invented by brume-make-scenes\n[LUMINAIRE] street light\n"
      "TILT=NONE\n1 -1 1 19 4 1 2 0 0 0\n1 1 100\n";
  for (int polar = 0; polar <= 90; polar += 5) text += std::to_string(polar) + " ";
  text += "\n0 30 60 90\n";
  for (int azimuth = 0; azimuth <= 90; azimuth += 30) {
    const double along = azimuth / 90.0;
    for (int polar = 0; polar <= 90; polar += 5) {
      const double peak = 30.0 + 32.0 * along;  // degrees
      const double width = polar < peak ? 38.0 : 12.0;
      const double off = (polar - peak) / width;
      const double value = (400.0 + 800.0 * along) * std::exp(-off * off);
      text += std::to_string(static_cast<int>(std::round(value))) + " ";
    }
    text += "\n";
  }
  return text;
}

// Neon in a tube along a path, whose points are this far apart.
void add_tube(const std::function<glm::dvec3(double)>& path, int points, const glm::dvec3& emission,
              std::vector<Gaussian>& gaussians) {
  for (int k = 0; k < points; ++k) {
    gaussians.push_back({path((k + 0.5) / points), 0.045, 6.0, {glm::dvec3(0.05), emission}});
  }
}

// A fish above waves, on the warehouse.
void add_sign(std::vector<Gaussian>& gaussians) {
  const glm::dvec3 middle(house_wall - 0.14, 3.9, -4.6);
  const auto on_wall = [&](double along, double up) { return middle + glm::dvec3(0.0, up, along); };
  const glm::dvec3 pink(30.0, 2.2, 8.0);
  const glm::dvec3 cyan(1.6, 14.0, 20.0);
  add_tube(
      [&](double s) {
        const double turn = std::numbers::pi * (0.13 + 1.74 * s);
        return on_wall(0.75 * std::cos(turn) - 0.1, 0.36 * std::sin(turn));
      },
      44, pink, gaussians);
  add_tube([&](double s) { return on_wall(0.62 + 0.33 * s, 0.15 - 0.45 * s); }, 9, pink, gaussians);
  add_tube([&](double s) { return on_wall(0.62 + 0.33 * s, -0.15 + 0.45 * s); }, 9, pink,
           gaussians);
  add_tube([&](double s) { return on_wall(0.95, 0.3 - 0.6 * s); }, 9, pink, gaussians);
  add_tube([&](double s) { return on_wall(2.4 * s - 1.2, -0.72 + 0.1 * std::sin(20.0 * s)); }, 50,
           cyan, gaussians);
}

void add_funnel_smoke(std::vector<Gaussian>& gaussians) {
  HashRandom random(12);
  const glm::dvec3 root = near_boat + glm::dvec3(0.0, 1.8, -0.82);
  constexpr int puffs = 34;
  for (int k = 0; k < puffs; ++k) {
    const double share = (k + 0.5) / puffs;
    const double radius = 0.09 + 0.5 * share;
    const glm::dvec3 place(-2.6 * share * share - 0.5 * share, 2.2 * std::sqrt(share),
                           -1.4 * share);
    gaussians.push_back({root + place + 0.6 * radius * random.in_ball(),
                         radius,
                         0.5 / (radius * (1.0 + 5.0 * share)),
                         {glm::dvec3(0.5, 0.47, 0.44), {}}});
  }
}

SampleLight lantern(const glm::dvec3& position, const glm::dvec3& intensity) {
  return {position, intensity};
}

}  // namespace

void write_harbour_scene(const std::filesystem::path& folder) {
  const PatchMesh sea = water();
  const PatchMesh dry = harbour();
  write_mesh_ply(folder / "harbour_water.ply", sea.vertices, sea.triangles);
  write_mesh_ply(folder / "harbour_town.ply", dry.vertices, dry.triangles);
  write_bytes(folder / "street_light.ies", street_light_ies());
  SampleScene scene;
  scene.camera = {{-1.5, 2.1, 5.4}, {0.75, 1.75, -4.0}, {0.0, 1.0, 0.0}, 46.0};
  scene.anisotropy = 0.4;
  scene.surfaces = {{"harbour_water.ply", {0.0, 0.0, 0.0}, 1.0, {0.012, 0.02, 0.026}, 0.5, 90.0},
                    {"harbour_town.ply", {0.0, 0.0, 0.0}, 1.0, {0.26, 0.24, 0.22}}};
  for (const double z : pole_places) {
    SampleLight light = lantern({quay_edge + 0.1, 4.05, z}, {30.0, 17.0, 6.5});
    light.profile = "street_light.ies";
    scene.lights.push_back(light);
  }
  const glm::dvec3 red(5.0, 0.35, 0.2);
  const glm::dvec3 green(0.25, 4.5, 0.9);
  const glm::dvec3 white(3.0, 2.8, 2.3);
  for (const auto& [boat, size] : {std::pair(near_boat, 1.0), std::pair(far_boat, 1.25)}) {
    scene.lights.push_back(lantern(boat + size * glm::dvec3(0.5, 1.42, 0.15), green));
    scene.lights.push_back(lantern(boat + size * glm::dvec3(-0.5, 1.42, 0.15), red));
    scene.lights.push_back(lantern(boat + size * glm::dvec3(0.1, 2.75, 0.0), white));
  }
  scene.lights.push_back(lantern({house_wall - 0.4, 3.0, -9.4}, {0.6, 2.2, 9.0}));
  scene.lights.push_back(lantern({3.5, 9.2, -19.4}, {14.0, 0.8, 0.5}));
  add_sign(scene.gaussians);
  add_funnel_smoke(scene.gaussians);
  HashRandom random(47);
  for (int k = 0; k < 90; ++k) {  // mist on the water
    const double height = 0.15 + 3.4 * std::pow(random.uniform(), 2.2);
    const double x = random.uniform(-9.0, 3.4);
    const double z = random.uniform(-18.0, 3.0);
    const double radius = random.uniform(0.8, 1.7);
    scene.gaussians.push_back({{x, height, z}, radius, random.uniform(0.012, 0.05)});
  }
  write_sample_scene(folder / "harbour.brume", scene);
}

}  // namespace brume
