#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "tools/make_scenes/generated_files.h"
#include "tools/make_scenes/patch_mesh.h"
#include "tools/make_scenes/random.h"
#include "tools/make_scenes/sample_scene.h"
#include "tools/make_scenes/scenes.h"

namespace brume {
namespace {

// In decimetres. One candle burns, the other was just put out.
const glm::dvec3 burning(-0.35, 0.0, 0.0);  // the middle of its foot
const glm::dvec3 smoking(0.75, 0.0, -0.25);
constexpr double burning_height = 1.15;
constexpr double smoking_height = 0.8;

// A point of a profile that is turned about the vertical through a candle's foot.
struct Ring {
  double radius;
  double height;
};

void add_turned(const glm::dvec3& foot, std::span<const Ring> profile, PatchMesh& mesh) {
  for (std::size_t k = 0; k + 1 < profile.size(); ++k) {
    add_patch(
        40, 4,
        [&](double u, double v) {
          const double radius = std::lerp(profile[k].radius, profile[k + 1].radius, v);
          const double turn = 2.0 * std::numbers::pi * u;
          return foot + glm::dvec3(radius * std::sin(turn),
                                   std::lerp(profile[k].height, profile[k + 1].height, v),
                                   radius * std::cos(turn));
        },
        mesh);
  }
}

// Wax with a hollow around its wick.
void add_candle(const glm::dvec3& foot, double height, PatchMesh& mesh) {
  const Ring wax[] = {{0.2, 0.08},           {0.2, height - 0.03},   {0.185, height},
                      {0.15, height - 0.01}, {0.06, height - 0.045}, {0.0, height - 0.05}};
  add_turned(foot, wax, mesh);
}

void add_dish(const glm::dvec3& foot, PatchMesh& mesh) {
  const Ring dish[] = {{0.0, 0.02},  {0.3, 0.02}, {0.42, 0.12},
                       {0.45, 0.12}, {0.33, 0.0}, {0.0, 0.0}};
  add_turned(foot, dish, mesh);
  const Ring wick[] = {{0.014, 0.0}, {0.012, 0.12}, {0.0, 0.13}};
  const double height = foot == burning ? burning_height : smoking_height;
  add_turned(foot + glm::dvec3(0.0, height - 0.06, 0.0), wick, mesh);
}

// From the blue at the wick over white-hot soot to the orange tip. Soot absorbs what it does not
// emit.
void add_flame(std::vector<Gaussian>& gaussians) {
  const glm::dvec3 root = burning + glm::dvec3(0.0, burning_height + 0.02, 0.0);
  const auto add = [&](double height, double radius, double density, const glm::dvec3& emission) {
    const double sway = 0.02 * std::sin(5.0 * height);
    gaussians.push_back(
        {root + glm::dvec3(sway, height, 0.0), radius, density, {glm::dvec3(0.02), emission}});
  };
  add(0.02, 0.036, 0.15, {0.2, 0.5, 2.2});
  add(0.06, 0.042, 0.15, {1.6, 1.3, 1.8});
  constexpr int steps = 12;
  for (int k = 0; k < steps; ++k) {
    const double share = (k + 0.5) / steps;
    const double radius = 0.052 * std::sqrt(std::sin(std::numbers::pi * std::sqrt(share)));
    const double green = std::lerp(0.62, 0.34, share);
    const double blue = std::lerp(0.26, 0.05, share);
    const double strength = 9.0 * (1.0 - 0.55 * share);
    add(0.08 + 0.36 * share, std::max(radius, 0.02), 0.3, strength * glm::dvec3(1.0, green, blue));
  }
}

// A thread that begins to wind, and spreads.
void add_smoke(std::vector<Gaussian>& gaussians) {
  HashRandom random(31);
  const glm::dvec3 root = smoking + glm::dvec3(0.0, smoking_height + 0.08, 0.0);
  gaussians.push_back({root - glm::dvec3(0.0, 0.02, 0.0),
                       0.016,
                       40.0,
                       {glm::dvec3(0.1), {9.0, 1.6, 0.2}}});  // embers at the wick
  constexpr int steps = 150;
  for (int k = 0; k < steps; ++k) {
    const double share = (k + 0.5) / steps;
    const double height = 2.15 * share;
    const double winding = 0.24 * std::pow(share, 1.5);
    const double turn = 7.5 * share + 1.3 * std::sin(9.0 * share);
    const double radius = 0.022 + 0.13 * std::pow(share, 1.4);
    const glm::dvec3 place(winding * std::sin(turn), height, winding * std::cos(1.3 * turn));
    const glm::dvec3 stray = 0.7 * std::pow(share, 2.0) * radius * random.in_ball();
    const double density = 0.34 / (radius * (1.0 + 2.0 * share));
    gaussians.push_back({root + place + stray, radius, density, {glm::dvec3(0.72, 0.75, 0.8), {}}});
  }
}

}  // namespace

void write_candle_scene(const std::filesystem::path& folder) {
  PatchMesh wax;
  add_candle(burning, burning_height, wax);
  add_candle(smoking, smoking_height, wax);
  PatchMesh brass;
  add_dish(burning, brass);
  add_dish(smoking, brass);
  PatchMesh room;
  add_rectangle(24, 16, {-4.0, 0.0, 2.6}, {8.0, 0.0, 0.0}, {0.0, 0.0, -4.4}, room);
  add_rectangle(24, 16, {-4.0, 0.0, -1.8}, {8.0, 0.0, 0.0}, {0.0, 4.6, 0.0}, room);
  write_mesh_ply(folder / "candle_wax.ply", wax.vertices, wax.triangles);
  write_mesh_ply(folder / "candle_brass.ply", brass.vertices, brass.triangles);
  write_mesh_ply(folder / "candle_room.ply", room.vertices, room.triangles);

  SampleScene scene;
  scene.camera = {{0.5, 1.75, 5.4}, {0.25, 1.42, 0.0}, {0.0, 1.0, 0.0}, 34.0};
  scene.homogeneous_density = 0.004;
  scene.surfaces = {{"candle_wax.ply", {0.0, 0.0, 0.0}, 1.0, {0.82, 0.72, 0.55}, 0.06, 30.0},
                    {"candle_brass.ply", {0.0, 0.0, 0.0}, 1.0, {0.22, 0.15, 0.06}, 0.4, 40.0},
                    {"candle_room.ply", {0.0, 0.0, 0.0}, 1.0, {0.3, 0.2, 0.14}}};
  // Light of the flame beyond that of its Gaussians, which a grid knows only coarsely.
  scene.lights = {{burning + glm::dvec3(0.0, burning_height + 0.25, 0.0), {17.0, 8.6, 2.9}},
                  // A third one, behind who looks.
                  {{2.6, 2.3, 4.2}, {9.0, 5.2, 2.3}}};
  add_flame(scene.gaussians);
  add_smoke(scene.gaussians);
  write_sample_scene(folder / "candle.brume", scene);
}

}  // namespace brume
