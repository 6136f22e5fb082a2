#include "tools/bench/scenes/transfer_scenes.h"

#include <numbers>

#include "tools/bench/scenes/mesh_patches.h"

namespace brume {

Scene bowl_scene(double to, Surface::Transfer transfer) {
  MeshArrays mesh;
  add_ball(mesh, 40, {0, 0, 0}, 1.0, to, true);
  Scene scene;
  Surface& surface = scene.surfaces.emplace_back();
  surface.mesh = to_mesh(mesh);
  surface.transfer = transfer;
  scene.camera = {{0.4, -0.3, 5.0}, {0, 0, 0}, {0, 1, 0}, 14.0};
  scene.film = {12, 12};
  return scene;
}

Scene ball_over_floor(Surface::Transfer transfer) {
  MeshArrays mesh;
  add_floor(mesh, 40, 1.0);
  add_ball(mesh, 32, {0.3, 0.1, 0.7}, 0.4, std::numbers::pi, false);
  Scene scene;
  Surface& surface = scene.surfaces.emplace_back();
  surface.mesh = to_mesh(mesh);
  surface.transfer = transfer;
  scene.camera = {{-1.2, -2.5, 2.6}, {0, 0, 0.2}, {0, 0, 1}, 34.0};
  scene.film = {16, 12};
  return scene;
}

}  // namespace brume
