#include <cmath>
#include <numbers>

#include "tools/make_scenes/generated_files.h"
#include "tools/make_scenes/patch_mesh.h"
#include "tools/make_scenes/random.h"
#include "tools/make_scenes/sample_scene.h"
#include "tools/make_scenes/scenes.h"

namespace brume {
namespace {

constexpr double wall = 0.2;   // thickness [u]
constexpr double quad = 0.25;  // size of a mesh's quads [u]

// A room from -2 to 2, 0 to 2.6 and -2.5 to 2.5 with a window in the wall at x = 2.
PatchMesh room() {
  PatchMesh mesh;
  const glm::dvec3 low(-2.0, 0.0, -2.5);
  const glm::dvec3 high(2.0, 2.6, 2.5);
  const glm::dvec3 outer_low = low - wall;
  const glm::dvec3 outer_high = high + wall;
  add_box(outer_low, {outer_high.x, low.y, outer_high.z}, quad, mesh);
  add_box({outer_low.x, high.y, outer_low.z}, outer_high, quad, mesh);
  add_box({outer_low.x, low.y, outer_low.z}, {low.x, high.y, outer_high.z}, quad, mesh);
  add_box({low.x, low.y, outer_low.z}, {high.x, high.y, low.z}, quad, mesh);
  add_box({low.x, low.y, high.z}, {high.x, high.y, outer_high.z}, quad, mesh);
  // Around the window.
  const glm::dvec3 window_low(high.x, 0.8, -0.9);
  const glm::dvec3 window_high(outer_high.x, 2.1, 0.9);
  add_box({high.x, low.y, outer_low.z}, {outer_high.x, high.y, window_low.z}, quad, mesh);
  add_box({high.x, low.y, window_high.z}, {outer_high.x, high.y, outer_high.z}, quad, mesh);
  add_box({high.x, low.y, window_low.z}, {outer_high.x, window_low.y, window_high.z}, quad, mesh);
  add_box({high.x, window_high.y, window_low.z}, {outer_high.x, high.y, window_high.z}, quad, mesh);
  return mesh;
}

constexpr double tunnel_radius = 1.3;  // u
constexpr double tunnel_wall = 0.7;    // height below the vault [u]
constexpr double tunnel_end = -9.0;    // z; its mouth is at 0

// The tunnel's outline, larger by `beyond`, from one foot over the vault to the other.
glm::dvec3 outline(double t, double beyond, double z) {
  const double radius = tunnel_radius + beyond;
  const double arc = std::numbers::pi * radius;
  const double length = 2.0 * tunnel_wall + arc;
  double s = t * length;
  if (s < tunnel_wall) return {-radius, s, z};
  s -= tunnel_wall;
  if (s > arc) return {radius, tunnel_wall - (s - arc), z};
  const double angle = std::numbers::pi - s / radius;
  return {radius * std::cos(angle), tunnel_wall + radius * std::sin(angle), z};
}

// A vaulted tunnel with one mouth, under a mound, and the ground in front of it.
PatchMesh tunnel() {
  PatchMesh mesh;
  constexpr double mound = 0.6;  // over the vault [u]
  const auto vault = [&](double beyond, bool inward, double end) {
    add_patch(
        28, 36, [&](double u, double v) { return outline(inward ? 1.0 - u : u, beyond, v * end); },
        mesh);
  };
  vault(0.0, true, tunnel_end);
  vault(mound, false, tunnel_end - mound);
  // The portal, and the ends of tunnel and mound.
  add_patch(
      28, 3, [&](double u, double v) { return outline(1.0 - u, v * mound, 0.0); }, mesh);
  for (const double beyond : {0.0, mound}) {
    const double z = tunnel_end - beyond;
    add_patch(
        28, 6,
        [&](double u, double v) {
          const glm::dvec3 edge = outline(beyond > 0.0 ? 1.0 - u : u, beyond, z);
          return glm::dvec3(v * edge.x, edge.y, z);
        },
        mesh);
  }
  add_box({-4.0, -wall, tunnel_end - mound}, {4.0, 0.0, 6.0}, 2.0 * quad, mesh);
  return mesh;
}

SampleScene indoors(const char* mesh, const glm::dvec3& reflectance) {
  SampleScene scene;
  scene.albedo = 0.95;
  scene.environment = "../environments/dawn.exr";
  scene.surfaces = {{mesh, {0.0, 0.0, 0.0}, 1.0, reflectance}};
  return scene;
}

}  // namespace

void write_interior_scenes(const std::filesystem::path& folder) {
  const PatchMesh room_mesh = room();
  write_mesh_ply(folder / "room.ply", room_mesh.vertices, room_mesh.triangles);
  SampleScene scene = indoors("room.ply", {0.72, 0.7, 0.66});
  scene.camera = {{-1.7, 1.5, 2.2}, {0.9, 1.1, -0.6}, {0.0, 1.0, 0.0}, 65.0};
  HashRandom random(21);
  for (int i = 0; i < 24; ++i) {
    const double x = random.uniform(-1.6, 1.6);
    const double y = random.uniform(0.3, 2.2);
    const double z = random.uniform(-2.1, 2.1);
    scene.gaussians.push_back({{x, y, z}, random.uniform(0.5, 0.8), random.uniform(0.1, 0.3)});
  }
  write_sample_scene(folder / "room.brume", scene);

  const PatchMesh tunnel_mesh = tunnel();
  write_mesh_ply(folder / "tunnel.ply", tunnel_mesh.vertices, tunnel_mesh.triangles);
  scene = indoors("tunnel.ply", {0.5, 0.48, 0.45});
  scene.camera = {{0.5, 1.2, -7.5}, {-0.1, 1.0, 0.0}, {0.0, 1.0, 0.0}, 50.0};
  for (int i = 0; i < 26; ++i) {
    const double x = random.uniform(-0.9, 0.9);
    const double y = random.uniform(0.2, 1.5);
    const double z = -8.0 + 0.4 * i;
    scene.gaussians.push_back({{x, y, z}, random.uniform(0.5, 0.8), random.uniform(0.1, 0.25)});
  }
  write_sample_scene(folder / "tunnel.brume", scene);
}

}  // namespace brume
